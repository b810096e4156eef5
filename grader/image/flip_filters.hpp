#pragma once
/// \file
/// FLIP's filters and how they are applied. Apart from flip.hpp so that tests can look at them.

#include <cstddef>
#include <span>
#include <vector>

namespace ggrade::flip {

/// A filter along one line. `weights[i]` belongs to the pixels `i` before and `i` after.
struct LineFilter {
  /// What a weight multiplies.
  enum class Kind {
    even,  ///< before + after
    odd,   ///< after - before
    second ///< (before - centre) + (after - centre): exactly 0 where nothing changes
  };

  Kind kind = Kind::even;
  std::vector<float> weights; ///< the first, of the centre itself, is used by even filters only

  int radius() const { return int(weights.size()) - 1; }
};

/// Contrast sensitivity (section 4.1.1 of the paper): each plane of YCxCz is blurred by what the
/// eye cannot resolve. Every 2D filter is a product of two line filters; that of Cz is a sum of
/// two.
struct SpatialFilters {
  LineFilter y, cx, cz1, cz2;
};

/// Feature detection (section 4.2): a Gaussian as wide as what the eye takes for an edge or a
/// point, and its first and second derivative, whose positive and negative weights each sum to 1.
struct FeatureFilters {
  LineFilter gauss, edge, point;
};

/// Weights are computed in double precision. Trailing weights that are too small to move a sum of
/// floats are left out.
SpatialFilters spatialFilters(double pixelsPerDegree);
FeatureFilters featureFilters(double pixelsPerDegree);
/// Pixels beyond which neither of the filters reaches.
int filterReach(double pixelsPerDegree);

/// `width x height` floats, row after row.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;

  Plane() = default;
  Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}
  float* row(int y) { return values.data() + std::size_t(y) * std::size_t(width); }
  const float* row(int y) const { return values.data() + std::size_t(y) * std::size_t(width); }
};

/// Filters along the rows; beyond the border the outermost pixel repeats.
Plane alongRows(const Plane& in, const LineFilter& filter);
/// Row `y` of the plane filtered along the columns, to `out[0..width)`.
void alongColumns(const Plane& in, const LineFilter& filter, int y, float* out);

} // namespace ggrade::flip
