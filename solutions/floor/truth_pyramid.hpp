#pragma once
// The bloom's pyramid in double precision: its filters as exact sums over source pixels.

#include "truth/blur.hpp"

#include <vector>

namespace floor_truth {

using namespace ggrade;

/// A filter between two levels: a sum of separable ones.
struct LevelFilter {
  struct Term {
    double weight;
    truth::Axis across, down;
  };
  std::vector<Term> terms;
};

/// quality.bloom_filter: 0 the lecture's 5 x 5, 1 dual filter, 2 thirteen samples and a tent,
/// 3 area-weighted tent.
struct Size {
  int width, height;
};
LevelFilter downFilter(int kind, Size from, Size to, truth::Edge edge);
LevelFilter upFilter(int kind, Size from, Size to, truth::Edge edge);
truth::Light apply(const truth::Light& light, const LevelFilter& filter);

/// Sizes of `count` levels, each half of the one before, rounded down, at least 1.
std::vector<Size> levelSizes(Size scene, int count);

/// NaN and what is below 0 become 0, what a half float can't hold 65504.
truth::Light finite(truth::Light light);

/// The bright pass at half the size: of the mean about each pixel (area-weighted, edges mirrored)
/// what exceeds the threshold, in the same hue. At 2 to 1 that mean is the lecture's four samples
/// at 0.75 texels. Without the weight of the levels.
truth::Light brightPass(const truth::Light& scene, double threshold);

/// Level 0 at the end: every level of `bright` times 1/count, blurred on its way down and up.
truth::Light levelSum(const truth::Light& bright, int count, int kind, truth::Edge edge);

/// Variance across and down of each level's way down from level 0 and up again, square pixels of
/// level 0.
struct Variances {
  double across, down;
};
std::vector<Variances> levelVariances(Size largest, int count, int kind, truth::Edge edge);

/// The same sum with an exact Gaussian of its variance in place of each level's way.
truth::Light gaussianSum(const truth::Light& bright, int count, int kind, truth::Edge edge);

/// Comparison of found light with what it should be; all 0 if it is the same.
struct LightErrors {
  double greatest;  ///< of |found - wanted| / max(wanted, 1e-3), over pixels and channels
  double mean;      ///< of the same
  double energy;    ///< |sum of found / sum of wanted - 1|
  double misplaced; ///< sum of |found - wanted| / sum of wanted
};
LightErrors compareLight(const truth::Light& found, const truth::Light& wanted);

} // namespace floor_truth
