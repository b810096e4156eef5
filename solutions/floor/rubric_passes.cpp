#include "rubric_passes.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace floor_rubric {

namespace {

/// A quad or triangle has six vertices at most; the smallest object of a scene has many more.
constexpr std::uint64_t kMostOfAScreen = 12;

// What is looked at of one frame: many times what a right program has. A program that claims
// thousands of textures or matrices must not keep the judge busy for hours.
constexpr std::size_t kMostDrawn = 64;
constexpr std::size_t kMostMatrices = 24;

const trace::SampleRecord* firstSample(const trace::Trace& trace, const trace::PassRecord& reader,
                                       std::uint32_t writer, const trace::ImageRef& image,
                                       const trace::StepRecord** step) {
  for (const trace::StepRecord& one : trace.stepsOf(reader))
    for (const trace::SampleRecord& sample : trace.samplesOf(one))
      if (sample.writer == writer && sample.image.name == image.name) {
        *step = &one;
        return &sample;
      }
  return nullptr;
}

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

} // namespace

bool drewObjects(const trace::PassRecord& pass) {
  return pass.vertices > kMostOfAScreen;
}

std::vector<Drawn> sampledLater(const trace::Trace& trace) {
  std::vector<Drawn> all;
  if (trace.frames.empty()) return all;
  const auto passes = trace.passesOf(0);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const trace::PassRecord& pass = passes[i];
    for (std::uint32_t a = 0; a < trace::kAttachments; ++a) {
      const trace::ImageRef& image = pass.images[a];
      if (image.kind != std::uint32_t(trace::ImageKind::texture)) continue;
      const trace::CopyRecord* copy = trace.copyOf(trace.indexOf(pass), a);
      if (!copy) continue;
      Drawn drawn{&pass, a, copy, nullptr, nullptr, image.format};
      for (std::size_t j = i + 1; j < passes.size() && !drawn.reader; ++j)
        if (firstSample(trace, passes[j], trace.indexOf(pass), image, &drawn.readingStep))
          drawn.reader = &passes[j];
      if (drawn.reader) all.push_back(drawn);
      if (all.size() == kMostDrawn) return all;
    }
  }
  return all;
}

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

std::vector<glm::dmat4> matricesAndProducts(const std::vector<glm::dmat4>& matrices) {
  std::vector<glm::dmat4> distinct;
  for (const glm::dmat4& matrix : matrices)
    if (distinct.size() < kMostMatrices && std::ranges::find(distinct, matrix) == distinct.end())
      distinct.push_back(matrix);
  std::vector<glm::dmat4> all = distinct;
  for (const glm::dmat4& a : distinct)
    for (const glm::dmat4& b : distinct) all.push_back(a * b);
  return all;
}

} // namespace floor_rubric
