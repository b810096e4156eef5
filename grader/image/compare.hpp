#pragma once
/// \file
/// The comparison that scores are made of: two-sided and spatially tolerant.

#include "image/mask.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace ggrade {

/// The published tolerances: what a grade allows by default, and what `ggrade compare` uses.
/// Three steps of 8 bits pass and four do not; the half keeps rounding out of the decision.
inline constexpr float kTolerance = 3.5f / 255.0f;
/// Pixels that an edge may move in any direction.
inline constexpr int kRadius = 1;

/// What comparisons of this process allow unless told otherwise.
struct Tolerances {
  float tolerance = kTolerance;
  int radius = kRadius;
};
/// The published ones, everywhere but in a judge that `ggrade calibrate` asks what others would do.
/// Set it before anything is compared.
Tolerances& tolerances();

/// Side in pixels of the window in which errors are counted.
inline constexpr int kWindowSide = 32;
inline constexpr int kMaxRadius = 64;

struct CompareOptions {
  float tolerance = tolerances().tolerance; ///< in the images' units, 0 or more
  int radius = tolerances().radius;         ///< pixels, 0 to kMaxRadius
  const Mask* mask =
      nullptr; ///< pixels to judge; null judges all. Neighbours outside it still count.
  /// How many leading channels to compare; 0 compares all and then wants equal counts. A window's
  /// alpha cannot be seen: compare 3 channels of a frame.
  int channels = 0;
  int windowSide = kWindowSide;
};

/// Whether two images could be compared at all.
enum class ComparisonStatus {
  compared,
  sizesDiffer,
  channelsDiffer,
  studentNotFinite,
  referenceNotFinite,
  nothingToCompare ///< an image or the mask is empty
};

/// One pixel and how far it lies off.
struct PixelDifference {
  int x = 0, y = 0, channel = 0;
  std::array<float, 4> student{}, reference{}; ///< channels that do not exist are 0
  float error = 0; ///< how far outside the other image's neighbourhood range, before the tolerance
};

/// What `compare` found. Unless `status` is `compared` the numbers read as entirely wrong (share
/// 1), so that forgetting to look at the status never passes a submission.
struct Comparison {
  ComparisonStatus status = ComparisonStatus::nothingToCompare;
  std::string message;   ///< one sentence: why nothing was compared, or the numbers
  double wrongShare = 1; ///< of the judged pixels, 0 to 1
  std::size_t wrongPixels = 0;
  std::size_t judgedPixels = 0;
  Window densest; ///< where most pixels are wrong; its share is of the window's area
  std::optional<PixelDifference> worst; ///< empty if every pixel lies inside the ranges
  double meanAbsoluteError =
      0; ///< |student - reference|, pixel by pixel, over judged pixels and channels
  double meanDifference = 0; ///< student - reference: above 0, the student's image is brighter
  Mask wrong;                ///< empty unless compared
  std::optional<NonFinite> nonFinite;

  bool compared() const { return status == ComparisonStatus::compared; }
};

/// Compares a student's image with the reference. A pixel is wrong if, in any channel, the
/// student's value lies outside the range of the reference's values within `radius` pixels widened
/// by `tolerance`, or the reference's value lies outside the student's range widened likewise. The
/// second half catches what is missing: a thin line that the student did not draw lies inside the
/// reference's range everywhere.
///
/// Images that cannot be compared give a status and a message, never an exception. Throws
/// std::invalid_argument for options that make no sense, a mask of another size than the reference
/// included.
Comparison compare(const Image& student, const Image& reference,
                   const CompareOptions& options = {});

/// `compare` with whichever of several right images comes closest.
struct BestComparison {
  Comparison comparison;
  std::size_t reference = 0; ///< which one, counted from 0
};

/// Compares with one reference after the other until one fits without a wrong pixel; else the one
/// with the smallest wrong share wins, the first of equals. References that cannot be compared are
/// passed over; if none can, the first one's refusal is returned. Throws like `compare`, and
/// std::invalid_argument without any reference. Pointers must not be null.
BestComparison compareWithBest(const Image& student, std::span<const Image* const> references,
                               const CompareOptions& options = {});

} // namespace ggrade
