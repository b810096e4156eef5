#pragma once
/// \file
/// A solution drawn in a scene, with everything that its passes left: for tests of what scenes may
/// ask for at most.

#include "grading/program.hpp"
#include "image/image.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace extremes {

using ggrade::Image;
using nlohmann::json;

/// The scene of these parts of an assignment with `patch` merged over it; all parts if none is
/// named.
json sceneOf(const std::string& assignment, std::vector<std::string> parts, const json& patch);

/// What came of a run.
struct Drawn {
  std::vector<Image> frames; ///< of the window; RGBA, 0 to 1
  ggrade::trace::Trace trace;
  std::vector<ggrade::channel::ReplacementAnswer> replacements;

  /// The passes of the first frame whose draws can sample a texture through the uniform, in order.
  std::vector<std::uint32_t> sampling(const std::string& uniform) const;
  /// The pass that left what the first such pass sampled. Throws std::runtime_error if there is
  /// none.
  std::uint32_t writerOf(const std::string& uniform) const;
  /// What a pass left in colour attachment 0, or where it has none in its depth attachment. Throws
  /// std::runtime_error if that was not a texture.
  Image leftBy(std::uint32_t pass) const;
};

/// Draws the assignment's solution, as it was built with the tests and trusted (not in the
/// sandbox), one frame a time. Whatever the scene, it is a failure of the test unless every frame
/// comes, GL has nothing to say and the program prints what it should, and every texture that any
/// pass of any frame wrote holds finite values only (the window and the other renderbuffers can
/// hold no others). What `replacements` put in place may be anything.
///   prints: all that the program should write to stdout and stderr
Drawn draw(const std::string& assignment, const json& scene,
           const std::vector<double>& times = {0.21},
           const std::vector<ggrade::channel::PassPixels>& replacements = {},
           const testing::Matcher<std::string>& prints = "");

/// What the program says where it refuses a scene; a failure of the test if it draws instead.
std::string refusal(const std::string& assignment, const json& scene);

/// Colours put in place of what a pass leaves in colour attachment 0: 4 channels, for a texture of
/// `format` that holds floats.
ggrade::channel::PassPixels colors(std::uint32_t pass, std::uint32_t format, const Image& values);

/// Share of pixels with a channel of RGB that differs by more than `by`; 1 if the sizes differ.
double differing(const Image& a, const Image& b, float by = 1.01f / 255);

/// The largest difference of any channel of RGB between two pixels.
float distance(std::span<const float> a, std::span<const float> b);

} // namespace extremes
