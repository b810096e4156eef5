#include "trace/trace.hpp"

#include "assignment/usage_error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

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

/// A quad or triangle has six vertices at most, and two have this; the smallest mesh has many more.
constexpr std::uint64_t kMostOfAScreen = 12;

} // namespace

bool drawsMesh(const StepRecord& step) {
  return step.vertices > kMostOfAScreen * std::max(step.draws, 1U);
}

bool Trace::drewObjects(const PassRecord& pass) const {
  return std::ranges::any_of(stepsOf(pass), drawsMesh);
}

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

namespace {

/// Stored values of type `Stored`, one after another, through `convert`.
template <typename Stored, typename Convert>
void decode(std::span<const std::byte> bytes, std::span<float> to, Convert convert) {
  const std::byte* from = bytes.data();
  for (float& value : to) {
    Stored stored; // copies begin anywhere: no assumption about alignment
    std::memcpy(&stored, from, sizeof(Stored));
    from += sizeof(Stored);
    value = convert(stored);
  }
}

} // namespace

float halfToFloat(std::uint16_t half) {
  const std::uint32_t sign = std::uint32_t(half & 0x8000U) << 16;
  const std::uint32_t exponent = half >> 10 & 0x1FU;
  const std::uint32_t fraction = half & 0x3FFU;
  if (exponent == 0) { // zero or subnormal: a multiple of 2^-24, which a float holds exactly
    const float magnitude = float(fraction) * 0x1p-24F;
    return sign ? -magnitude : magnitude;
  }
  const std::uint32_t bits = exponent == 31 ? 0x7F800000U : (exponent + 112) << 23;
  return std::bit_cast<float>(sign | bits | fraction << 13);
}

int channelsOf(PixelType type) {
  return type == PixelType::f32x1 || type == PixelType::u8x1 ? 1 : 4;
}

const char* pixelTypeName(PixelType type) {
  switch (type) {
  case PixelType::u8x4:
    return "u8x4";
  case PixelType::f16x4:
    return "f16x4";
  case PixelType::f32x4:
    return "f32x4";
  case PixelType::f32x1:
    return "f32x1";
  case PixelType::u8x1:
    return "u8x1";
  case PixelType::i32x4:
    return "i32x4";
  case PixelType::u32x4:
    return "u32x4";
  }
  return "";
}

Image decodePixels(std::span<const std::byte> bytes, PixelType type, std::uint32_t width,
                   std::uint32_t height) {
  if (bytes.size() != std::uint64_t{width} * height * bytesPerPixel(type) || bytes.empty())
    throw std::invalid_argument("the pixels of a copy have another size than it says");
  Image image(int(width), int(height), channelsOf(type));
  const std::span<float> to = image.values();
  switch (type) {
  case PixelType::u8x4:
    decode<std::uint8_t>(bytes, to, [](std::uint8_t value) { return float(value) / 255.0F; });
    break;
  case PixelType::u8x1:
    decode<std::uint8_t>(bytes, to, [](std::uint8_t value) { return float(value); });
    break;
  case PixelType::f16x4:
    decode<std::uint16_t>(bytes, to, halfToFloat);
    break;
  case PixelType::f32x4:
  case PixelType::f32x1:
    std::memcpy(to.data(), bytes.data(), bytes.size());
    break;
  case PixelType::i32x4:
    decode<std::int32_t>(bytes, to, [](std::int32_t value) { return float(value); });
    break;
  case PixelType::u32x4:
    decode<std::uint32_t>(bytes, to, [](std::uint32_t value) { return float(value); });
    break;
  }
  return image;
}

Trace framesOf(const Trace& all, std::size_t first, std::size_t count) {
  Trace part;
  part.frames.assign(all.frames.begin() + std::ptrdiff_t(first),
                     all.frames.begin() + std::ptrdiff_t(first + count));
  const std::uint32_t begin = part.frames.front().firstPass;
  const std::uint32_t end = part.frames.back().firstPass + part.frames.back().passCount;
  const auto isOurs = [&](std::uint32_t pass) { return pass >= begin && pass < end; };
  for (FrameTrace& frame : part.frames) frame.firstPass -= begin;
  for (std::uint32_t i = begin; i < end; ++i) {
    PassRecord pass = all.passes[i];
    pass.frame -= std::uint32_t(first);
    pass.firstStep = std::uint32_t(part.steps.size());
    for (StepRecord step : all.stepsOf(all.passes[i])) {
      const auto matrices = all.matricesOf(step);
      const auto samples = all.samplesOf(step);
      step.pass = i - begin;
      step.firstMatrix = std::uint32_t(part.matrices.size());
      step.firstSample = std::uint32_t(part.samples.size());
      part.matrices.insert(part.matrices.end(), matrices.begin(), matrices.end());
      for (SampleRecord sample : samples) {
        sample.writer = isOurs(sample.writer) ? sample.writer - begin : kNone;
        part.samples.push_back(sample);
      }
      part.steps.push_back(step);
    }
    part.passes.push_back(pass);
  }
  for (CopyRecord copy : all.copies) {
    if (!isOurs(copy.pass) || part.passes[copy.pass - begin].frame != 0) continue;
    if (copy.step != kNone)
      copy.step =
          copy.step - all.passes[copy.pass].firstStep + part.passes[copy.pass - begin].firstStep;
    const auto bytes = std::span(all.pixels).subspan(copy.offset, copy.bytes);
    copy.pass -= begin;
    copy.offset = part.pixels.size();
    part.pixels.insert(part.pixels.end(), bytes.begin(), bytes.end());
    part.copies.push_back(copy);
  }
  return part;
}

} // namespace ggrade::trace
