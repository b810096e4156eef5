#include "report/inspect_graph.hpp"

#include <algorithm>
#include <tuple>

namespace ggrade::report {

using namespace trace;

namespace {

/// Which attachment of `writer` holds the image that is read; levels apart, as a mipmapped texture
/// is read as a whole.
std::uint32_t attachmentOf(const PassRecord& writer, const ImageRef& image) {
  for (std::uint32_t i = 0; i < kAttachments; ++i)
    if (writer.images[i].kind == image.kind && writer.images[i].name == image.name) return i;
  return kNone;
}

} // namespace

bool drawsToWindow(const PassRecord& pass) {
  return std::ranges::any_of(pass.images, [](const ImageRef& image) {
    return image.kind == std::uint32_t(ImageKind::window);
  });
}

FrameGraph::FrameGraph(const Trace& trace, std::size_t frame) : trace_(trace) {
  if (trace.frames.empty()) {
    count_ = std::uint32_t(trace.passes.size());
  } else if (frame < trace.frames.size()) {
    first_ = trace.frames[frame].firstPass;
    count_ = trace.frames[frame].passCount;
  }
  const auto key = [](const PassRead& read) {
    return std::tie(read.reader, read.writer, read.attachment);
  };
  for (std::uint32_t reader = first_; reader < first_ + count_; ++reader)
    for (const StepRecord& step : trace.stepsOf(trace.passes[reader]))
      for (const SampleRecord& sample : trace.samplesOf(step))
        if (sample.writer < trace.passes.size() && holds(sample.writer))
          reads_.push_back(
              {sample.writer, reader, attachmentOf(trace.passes[sample.writer], sample.image)});
  std::ranges::sort(reads_, {}, key);
  const auto again = std::ranges::unique(reads_, {}, key);
  reads_.erase(again.begin(), again.end());
}

std::vector<PassRead> FrameGraph::readsOf(std::uint32_t pass) const {
  std::vector<PassRead> found;
  for (const PassRead& read : reads_)
    if (read.reader == pass) found.push_back(read);
  return found;
}

std::vector<PassRead> FrameGraph::readersOf(std::uint32_t pass) const {
  std::vector<PassRead> found;
  for (const PassRead& read : reads_)
    if (read.writer == pass) found.push_back(read);
  return found;
}

bool FrameGraph::isDrawnOver(std::uint32_t pass) const {
  const auto goesOn = [&](const ImageRef& image) {
    if (image.kind == std::uint32_t(ImageKind::none)) return false;
    for (std::uint32_t later = pass + 1; later < first_ + count_; ++later)
      for (std::uint32_t i = 0; i < kAttachments; ++i) {
        const PassRecord& next = trace_.passes[later];
        const bool used = next.draws > 0 || (next.written >> i & 1);
        if (used && sameImage(image, next.images[i])) return (next.cleared >> i & 1) == 0;
      }
    return false;
  };
  return std::ranges::any_of(trace_.passes[pass].images, goesOn);
}

std::uint32_t FrameGraph::writerBefore(std::uint32_t pass, std::uint32_t attachment) const {
  const ImageRef& image = trace_.passes[pass].images[attachment];
  for (std::uint32_t earlier = pass; earlier-- > first_;)
    for (std::uint32_t i = 0; i < kAttachments; ++i)
      if ((trace_.passes[earlier].written >> i & 1) &&
          sameImage(trace_.passes[earlier].images[i], image))
        return earlier;
  return kNone;
}

} // namespace ggrade::report
