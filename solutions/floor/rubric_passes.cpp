#include "rubric_passes.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace floor_rubric {

namespace {

/// A quad or triangle has six vertices at most; the smallest object of a scene has many more.
constexpr std::uint64_t kMostOfAScreen = 12;

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
    }
  }
  return all;
}

Image resampled(const Image& image, int width, int height, int channels) {
  Image out(width, height, channels);
  for (int y = 0; y < height; ++y) {
    const double v =
        std::clamp((y + 0.5) * image.height() / height - 0.5, 0.0, double(image.height() - 1));
    const int y0 = int(v), y1 = std::min(y0 + 1, image.height() - 1);
    for (int x = 0; x < width; ++x) {
      const double u =
          std::clamp((x + 0.5) * image.width() / width - 0.5, 0.0, double(image.width() - 1));
      const int x0 = int(u), x1 = std::min(x0 + 1, image.width() - 1);
      for (int c = 0; c < channels; ++c) {
        const double top =
            image.at(x0, y0, c) + (u - x0) * (image.at(x1, y0, c) - image.at(x0, y0, c));
        const double bottom =
            image.at(x0, y1, c) + (u - x0) * (image.at(x1, y1, c) - image.at(x0, y1, c));
        out.at(x, y, c) = float(top + (v - y0) * (bottom - top));
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
  std::vector<glm::dmat4> all = matrices;
  for (const glm::dmat4& a : matrices)
    for (const glm::dmat4& b : matrices) all.push_back(a * b);
  return all;
}

} // namespace floor_rubric
