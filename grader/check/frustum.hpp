#pragma once
/// \file
/// The frustum that a pass draws depths with, such as a shadow map's, told right or wrong by the
/// points that it is there for.

#include "trace/trace.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

namespace ggrade::check {

/// What the frustum of the first pass that draws depths alone has to hold.
struct Frustum {
  std::string todo; ///< in which its matrices are made; empty: there is no such thing
  /// Uniforms of that pass whose product, in this order, gives clip space from world space.
  std::vector<std::string> matrices;
  std::vector<std::array<double, 3>> points; ///< on what the reference draws; world space
  /// Part of each axis of normalized device coordinates that the points take in the reference.
  std::array<double, 3> extent{};
};

/// Fills `points` and `extent` from the reference's first frame. Returns false if it has no such
/// pass.
bool takePoints(Frustum& frustum, const trace::Trace& reference);

/// What is wrong with the frustum of a program's first frame, a sentence; empty: nothing, or there
/// is no such pass, or it draws without these matrices.
std::string frustumFault(const Frustum& frustum, const trace::Trace& trace);

void to_json(nlohmann::json& json, const Frustum& frustum);
void from_json(const nlohmann::json& json, Frustum& frustum);

} // namespace ggrade::check
