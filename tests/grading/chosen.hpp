#pragma once
/// \file
/// Which patches of the catalogue every run of the tests grades.

#include "tool.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace tool {

/// Of every part other ways to right answers, as many as differ in kind, and a mistake for each
/// pass or kind of item that no test with numbers of its own is about (see grade_faults_test.cpp,
/// grade_shadow_test.cpp, grade_bloom_test.cpp).
inline constexpr auto kChosen = std::to_array<std::string_view>({
    // clang-format off
    "mirror_depth_texture", "mirror_direct_state_access", "mirror_floor_first",
    "mirror_front_face", "mirror_half_floats", "mirror_inverse_transpose", "mirror_made_anew",
    "mirror_model_mirrored", "mirror_texture_2048", "mirror_texture_512", "mirror_window_sized",
    "mirror_light_and_normal", "mirror_texture_not_bound",
    "shadow_depth_32f", "shadow_floor_in_map", "shadow_manual_comparison", "shadow_map_2048",
    "shadow_map_512", "shadow_wide_frustum",
    "shadow_normal_inwards", "shadow_outside_dark", "shadow_pcf_lopsided", "shadow_typed_in_size",
    "bloom_clamped", "bloom_depth_texture", "bloom_filter_13", "bloom_filter_5x5",
    "bloom_filter_dual", "bloom_one_framebuffer", "bloom_quad_strip", "bloom_rgba32f",
    "bloom_weight_at_the_end",
    "bloom_one_level", "bloom_threshold_typed_in", "bloom_wrap_repeat",
    "targets_array_texture", "targets_cleared_alike", "targets_no_cut",
    "figure_fewer_passes", "figure_ids_not_cleared", "figure_occlusion_inverted",
    "shadow_volume_two_passes", "shadow_volume_light_set_once", "shadow_volume_no_caps",
    "ssao_inverse_projection", "ssao_no_blur", "ssao_typed_in_radius",
    "antialias_luma_from_colours", "antialias_texture_gather", "antialias_rows_for_columns",
    "motion_blur_backwards", "motion_blur_velocity_rgba16f", "motion_blur_no_division",
    "afterglow_blended_by_max", "afterglow_copied_back", "afterglow_mixed",
    // clang-format on
});

/// Those of the catalogue that are, or aren't, among them.
inline std::vector<Catalogued> chosen(bool among) {
  std::vector<Catalogued> all = catalogue();
  std::erase_if(all, [&](const Catalogued& one) {
    return (std::ranges::find(kChosen, one.program.name) != kChosen.end()) != among;
  });
  return all;
}

} // namespace tool
