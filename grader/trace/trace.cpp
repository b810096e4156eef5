#include "trace/trace.hpp"

#include "assignment/usage_error.hpp"
#include "trace/pixels.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace ggrade::trace {
namespace {

/// `size` bytes of a file from `offset` on. Throws UsageError.
std::vector<std::byte> readPart(const std::filesystem::path& file, std::uint64_t offset,
                                std::uint64_t size) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw UsageError("can't read " + file.string());
  std::vector<std::byte> bytes(size);
  std::uint64_t done = 0;
  while (done < size) {
    const ssize_t got =
        pread(descriptor, bytes.data() + done, size - done, static_cast<off_t>(offset + done));
    if (got <= 0) break;
    done += static_cast<std::uint64_t>(got);
  }
  close(descriptor);
  if (done < size) throw UsageError(file.string() + " is cut off");
  return bytes;
}

} // namespace

std::span<const StepRecord> Trace::stepsOf(const PassRecord& pass) const {
  return std::span(steps).subspan(pass.firstStep, pass.stepCount);
}

std::span<const MatrixRecord> Trace::matricesOf(const StepRecord& step) const {
  return std::span(matrices).subspan(step.firstMatrix, step.matrixCount);
}

std::span<const SampleRecord> Trace::samplesOf(const StepRecord& step) const {
  return std::span(samples).subspan(step.firstSample, step.sampleCount);
}

std::span<const PassRecord> Trace::passesOf(std::size_t frame) const {
  return std::span(passes).subspan(frames.at(frame).firstPass, frames.at(frame).passCount);
}

const CopyRecord* Trace::copyOf(std::uint32_t pass, std::uint32_t attachment,
                                std::uint32_t step) const {
  for (const CopyRecord& copy : copies)
    if (copy.pass == pass && copy.attachment == attachment && copy.step == step) return &copy;
  return nullptr;
}

std::vector<std::byte> Trace::bytesOf(const CopyRecord& copy) const {
  if (pixels.empty()) return readPart(pixelFile, copy.offset, copy.bytes);
  const auto stored = std::span(pixels).subspan(copy.offset, copy.bytes);
  return {stored.begin(), stored.end()};
}

Image Trace::image(const CopyRecord& copy) const {
  return decodePixels(bytesOf(copy), static_cast<PixelType>(copy.type), copy.width, copy.height);
}

} // namespace ggrade::trace
