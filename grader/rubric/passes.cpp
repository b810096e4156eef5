#include "rubric/passes.hpp"

namespace ggrade::rubric {

namespace {

// What is looked at of one frame: many times what a right program has. A program that claims
// thousands of textures must not keep the judge busy for hours.
constexpr std::size_t kMostDrawn = 64;

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
      Drawn drawn{&pass, a, trace.drewObjects(pass), copy, nullptr, nullptr, image.format, {}};
      for (std::size_t j = i + 1; j < passes.size() && !drawn.reader; ++j)
        if (const trace::SampleRecord* sample =
                firstSample(trace, passes[j], trace.indexOf(pass), image, &drawn.readingStep)) {
          drawn.reader = &passes[j];
          drawn.uniform = sample->uniform;
        }
      if (drawn.reader) all.push_back(drawn);
      if (all.size() == kMostDrawn) return all;
    }
  }
  return all;
}

} // namespace ggrade::rubric
