#include "calibration/whole_image.hpp"

#include "image/compare.hpp"
#include "image/flip.hpp"
#include "image/statistics.hpp"

#include <algorithm>

#include <time.h>

namespace ggrade::calibration {

const std::vector<WholeImage>& wholeImages() {
  static const std::vector<WholeImage> all = {
      {"RMSE", [](const Image& student,
                  const Image& reference) { return errorStatistics(student, reference).rmsError; }},
      {"1 - SSIM",
       [](const Image& student, const Image& reference) { return 1 - ssim(student, reference); }},
      {"FLIP, mean", [](const Image& student,
                        const Image& reference) { return ldrFlip(student, reference).mean; }},
      {"pixels that differ",
       [](const Image& student, const Image& reference) {
         return double(errorStatistics(student, reference, kTolerance).failPixels) /
                double(reference.pixelCount());
       }},
      {"wrong pixels",
       [](const Image& student, const Image& reference) {
         return compare(student, reference).wrongShare;
       }},
      {"densest window", [](const Image& student, const Image& reference) {
         return compare(student, reference).densest.share;
       }}};
  return all;
}

namespace {

/// Processor time of this thread, in milliseconds.
double cpuMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

} // namespace

std::map<std::string, PictureError>
measurePictures(const std::vector<rubric::SceneFolders>& scenes) {
  std::map<std::string, PictureError> all;
  std::size_t pictures = 0;
  for (const rubric::SceneFolders& scene : scenes) {
    if (scene.isPublic) continue;
    const auto student = rubric::readFrames(scene.student);
    const auto reference = rubric::readFrames(scene.reference);
    if (student.size() < reference.size()) return {};
    for (std::size_t i = 0; i < reference.size(); ++i) {
      const Image a = rubric::toImage(student[i]), b = rubric::toImage(reference[i]);
      if (!sameSize(a, b)) return {};
      ++pictures;
      for (const WholeImage& one : wholeImages()) {
        const double start = cpuMs();
        const double error = one.measure(a, b);
        PictureError& sum = all[one.name];
        sum.ms += cpuMs() - start;
        sum.worst = std::max(sum.worst, error);
      }
    }
  }
  for (auto& [name, sum] : all) sum.ms /= double(pictures);
  return all;
}

} // namespace ggrade::calibration
