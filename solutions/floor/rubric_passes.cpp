#include "rubric_passes.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace floor_rubric {

namespace {

// Many times what a right program has. A program that claims thousands of matrices must not keep
// the judge busy for hours.
constexpr std::size_t kMostMatrices = 24;

/// The two pixels that a target pixel lies between along one axis, and how near to the second.
struct Between {
  int first, second;
  double share;
};

std::vector<Between> betweens(int from, int to) {
  std::vector<Between> all;
  for (int i = 0; i < to; ++i) {
    const double at = std::clamp((i + 0.5) * from / to - 0.5, 0.0, double(from - 1));
    const int first = int(at);
    all.push_back({first, std::min(first + 1, from - 1), at - first});
  }
  return all;
}

std::vector<glm::dmat4> firstThatDiffer(const std::vector<glm::dmat4>& matrices) {
  std::vector<glm::dmat4> distinct;
  for (const glm::dmat4& matrix : matrices)
    if (distinct.size() < kMostMatrices && std::ranges::find(distinct, matrix) == distinct.end())
      distinct.push_back(matrix);
  return distinct;
}

} // namespace

Image resampled(const Image& image, int width, int height, int channels) {
  const std::vector<Between> across = betweens(image.width(), width);
  const std::vector<Between> down = betweens(image.height(), height);
  Image out(width, height, channels);
  for (int y = 0; y < height; ++y) {
    const Between& v = down[std::size_t(y)];
    const float* upper = image.row(v.first).data();
    const float* lower = image.row(v.second).data();
    float* to = out.row(y).data();
    for (const Between& u : across) {
      const int first = u.first * image.channels(), second = u.second * image.channels();
      for (int c = 0; c < channels; ++c) {
        const double top = upper[first + c] + u.share * (upper[second + c] - upper[first + c]);
        const double bottom = lower[first + c] + u.share * (lower[second + c] - lower[first + c]);
        *to++ = float(top + v.share * (bottom - top));
      }
    }
  }
  return out;
}

std::vector<glm::dmat4> matricesOf(const trace::Trace& trace, const trace::StepRecord& step) {
  std::vector<glm::dmat4> all;
  std::set<std::string> seen;
  for (const trace::MatrixRecord& record : trace.matricesOf(step)) {
    if (!seen.insert(record.name).second) continue;
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = double(record.values[i]);
    all.push_back(matrix);
  }
  return all;
}

std::vector<glm::dmat4> perspectives(const std::vector<glm::dmat4>& matrices) {
  const auto rowOfW = [](const glm::dmat4& m) {
    return glm::dvec4(m[0][3], m[1][3], m[2][3], m[3][3]);
  };
  const std::vector<glm::dmat4> distinct = firstThatDiffer(matrices);
  std::vector<glm::dmat4> all;
  for (const glm::dmat4& a : distinct) {
    if (glm::length(glm::dvec3(rowOfW(a))) > 1e-9) all.push_back(a);
    if (rowOfW(a) != glm::dvec4(0, 0, -1, 0)) continue;
    for (const glm::dmat4& b : distinct)
      if (rowOfW(b) == glm::dvec4(0, 0, 0, 1)) all.push_back(a * b);
  }
  return all;
}

std::vector<glm::dmat4> matricesAndProducts(const std::vector<glm::dmat4>& matrices) {
  const std::vector<glm::dmat4> distinct = firstThatDiffer(matrices);
  std::vector<glm::dmat4> all = distinct;
  for (const glm::dmat4& a : distinct)
    for (const glm::dmat4& b : distinct) all.push_back(a * b);
  return all;
}

} // namespace floor_rubric
