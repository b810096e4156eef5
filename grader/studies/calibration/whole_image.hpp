#pragma once
/// \file
/// What people compare renderings with instead of a rubric: one number for a pair of pictures.

#include "calibration/programs.hpp"
#include "rubric/evidence.hpp"

namespace ggrade::calibration {

/// One of them, 0 for equal pictures, more for worse ones.
struct WholeImage {
  std::string name;
  double (*measure)(const Image& student, const Image& reference);
};

const std::vector<WholeImage>& wholeImages();

/// All of them, by name: the worst picture of the hidden scenes counts. Nothing if one of their
/// pictures is missing or of another size: there is nothing to measure then.
std::map<std::string, PictureError>
measurePictures(const std::vector<rubric::SceneFolders>& scenes);

} // namespace ggrade::calibration
