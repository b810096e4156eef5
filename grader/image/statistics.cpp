#include "image/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ggrade {

ErrorStatistics errorStatistics(const Image& a, const Image& b, float fail, float warn) {
  if (a.empty() || !sameSize(a, b) || a.channels() != b.channels())
    throw std::invalid_argument("errorStatistics: the images differ in size or channels");
  ErrorStatistics result;
  double sum = 0, squares = 0, peak = 1;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const auto p = a.pixel(x, y), q = b.pixel(x, y);
      double pixelError = 0;
      for (std::size_t c = 0; c < p.size(); ++c) {
        const double error = std::abs(double(p[c]) - double(q[c]));
        sum += error;
        squares += error * error;
        peak = std::max({peak, std::abs(double(p[c])), std::abs(double(q[c]))});
        pixelError = std::max(pixelError, error);
        if (error > result.maxError) {
          result.maxError = error;
          result.maxX = x;
          result.maxY = y;
          result.maxChannel = int(c);
        }
      }
      if (pixelError > double(fail)) ++result.failPixels;
      if (pixelError > double(warn)) ++result.warnPixels;
    }
  const double values = double(a.values().size());
  result.meanError = sum / values;
  result.rmsError = std::sqrt(squares / values);
  result.psnr = 20 * std::log10(peak / result.rmsError);
  return result;
}

} // namespace ggrade
