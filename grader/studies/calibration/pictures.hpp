#pragma once
/// \file
/// Submissions that are pictures only, without any pass: what someone could hand over who has
/// understood nothing, or who has the pictures of another scene.

#include "rubric/evidence.hpp"

#include <string>
#include <vector>

namespace ggrade::calibration {

struct PictureKind {
  std::string name, title;
};

const std::vector<PictureKind>& pictureKinds();

/// The frames of scene `index` as this kind has them, of the sizes and times that are wanted. `all`
/// are the reference's frames by scene; `isPublic` says which of them a student knows.
std::vector<rubric::RawFrame> pictures(const std::string& kind,
                                       const std::vector<std::vector<rubric::RawFrame>>& all,
                                       const std::vector<bool>& isPublic, std::size_t index);

} // namespace ggrade::calibration
