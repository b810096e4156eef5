#include "image/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

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

namespace {

constexpr int kWindow = 11;
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

std::vector<double> gaussian(int side) {
  const int size = std::min(kWindow, side % 2 == 1 ? side : side - 1);
  std::vector<double> weights(std::size_t(std::max(size, 1)));
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double d = double(i) - double(weights.size() - 1) / 2;
    sum += weights[i] = std::exp(-d * d / (2 * kSigma * kSigma));
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

void lumaRow(const Image& image, int y, std::vector<double>& luma) {
  luma.resize(std::size_t(image.width()));
  for (int x = 0; x < image.width(); ++x) {
    const auto p = image.pixel(x, y);
    luma[std::size_t(x)] =
        p.size() == 1   ? double(p[0])
        : p.size() == 2 ? 0.5 * (double(p[0]) + double(p[1]))
                        : 0.2989 * double(p[0]) + 0.5870 * double(p[1]) + 0.1140 * double(p[2]);
  }
}

// out[i] = sum of weights[k] in[i + k]
void filterRow(const std::vector<double>& in, std::span<const double> weights,
               std::vector<double>& out) {
  out.assign(in.size() - weights.size() + 1, 0.0);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double weight = weights[k];
    const double* from = in.data() + k;
    double* __restrict to = out.data();
    for (std::size_t i = 0; i < out.size(); ++i) to[i] += weight * from[i];
  }
}

// Local moments of the pair: mean a, mean b, mean a*a, mean b*b, mean a*b.
constexpr std::size_t kMoments = 5;
using MomentRows = std::array<std::vector<double>, kMoments>;

// The moments of row y, filtered along the row.
void momentRows(const Image& a, const Image& b, int y, std::span<const double> weights,
                MomentRows& rows) {
  std::vector<double> p, q, product(std::size_t(a.width()));
  lumaRow(a, y, p);
  lumaRow(b, y, q);
  const auto filterProduct = [&](const std::vector<double>& u, const std::vector<double>& v,
                                 std::vector<double>& out) {
    for (std::size_t i = 0; i < u.size(); ++i) product[i] = u[i] * v[i];
    filterRow(product, weights, out);
  };
  filterRow(p, weights, rows[0]);
  filterRow(q, weights, rows[1]);
  filterProduct(p, p, rows[2]);
  filterProduct(q, q, rows[3]);
  filterProduct(p, q, rows[4]);
}

// For equal images numerator and denominator are the same sums of the same numbers: the quotient
// is 1.
double rowSum(const MomentRows& m) {
  double sum = 0;
  for (std::size_t i = 0; i < m[0].size(); ++i) {
    const double aa = m[0][i] * m[0][i], bb = m[1][i] * m[1][i], ab = m[0][i] * m[1][i];
    const double varianceA = m[2][i] - aa, varianceB = m[3][i] - bb, covariance = m[4][i] - ab;
    sum += ((2 * ab + kC1) * (2 * covariance + kC2)) /
           ((aa + bb + kC1) * (varianceA + varianceB + kC2));
  }
  return sum;
}

} // namespace

double ssim(const Image& a, const Image& b) {
  if (a.empty() || !sameSize(a, b))
    throw std::invalid_argument("ssim: the images are " + a.sizeText() + " and " + b.sizeText());
  const auto across = gaussian(a.width()), down = gaussian(a.height());
  std::vector<MomentRows> ring(down.size()); // row y in slot y % size
  MomentRows filtered;
  double sum = 0;
  std::size_t count = 0;
  for (int y = 0; y < a.height(); ++y) {
    momentRows(a, b, y, across, ring[std::size_t(y) % ring.size()]);
    if (std::size_t(y) + 1 < ring.size()) continue;
    const std::size_t top = std::size_t(y) + 1 - ring.size();
    for (std::size_t moment = 0; moment < kMoments; ++moment) {
      auto& out = filtered[moment];
      out.assign(ring[0][moment].size(), 0.0);
      for (std::size_t k = 0; k < down.size(); ++k) {
        const double weight = down[k];
        const double* from = ring[(top + k) % ring.size()][moment].data();
        double* __restrict to = out.data();
        for (std::size_t i = 0; i < out.size(); ++i) to[i] += weight * from[i];
      }
    }
    sum += rowSum(filtered);
    count += filtered[0].size();
  }
  return sum / double(count);
}

} // namespace ggrade
