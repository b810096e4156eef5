#include "capture_traces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace ggrade::test {
namespace {

using trace::ImageKind;
using trace::kNone;
using trace::PixelType;

std::string imageName(const trace::ImageRef& image) {
  std::string text;
  switch (static_cast<ImageKind>(image.kind)) {
  case ImageKind::none:
    return "nothing";
  case ImageKind::window:
    text = "window";
    break;
  case ImageKind::texture:
    text = "texture " + std::to_string(image.name);
    break;
  case ImageKind::renderbuffer:
    text = "renderbuffer " + std::to_string(image.name);
    break;
  }
  if (image.level) text += " level " + std::to_string(image.level);
  if (image.layer != kNone) text += " layer " + std::to_string(image.layer);
  text += " " + trace::glName(image.format) + " " + std::to_string(image.width) + "x" +
          std::to_string(image.height);
  if (image.samples) text += " x" + std::to_string(image.samples);
  return text;
}

std::string maskNames(const char* what, std::uint32_t mask) {
  if (!mask) return "";
  std::string text = std::string("; ") + what;
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i)
    if (mask >> i & 1) text += " " + trace::attachmentName(i);
  return text;
}

double halfValue(std::uint16_t half) {
  const double sign = half & 0x8000 ? -1 : 1;
  const int exponent = half >> 10 & 31;
  const int fraction = half & 1023;
  if (exponent == 31)
    return fraction ? std::numeric_limits<double>::quiet_NaN()
                    : sign * std::numeric_limits<double>::infinity();
  return sign * std::ldexp(exponent ? 1024 + fraction : fraction, (exponent ? exponent : 1) - 25);
}

template <typename Value> double at(const std::byte* from) {
  Value value;
  std::memcpy(&value, from, sizeof(value));
  return static_cast<double>(value);
}

} // namespace

trace::Request everything() {
  trace::Request request{};
  request.passes = 1;
  request.copies = request.windowCopies = request.renderbufferCopies = trace::kAllAttachments;
  request.copyFrames = channel::kMaxFrames;
  request.copyBytes = std::uint64_t{64} << 20;
  return request;
}

CaptureRun record(const std::string& program, const std::string& scenario, int frames,
                  const trace::Request& request) {
  CaptureOptions options;
  if (!scenario.empty()) options.arguments = {scenario};
  options.trace = request;
  const std::vector<channel::PlannedFrame> planned(static_cast<std::size_t>(frames), {0, 8, 8});
  CaptureRun run = runCaptured(program, planned, options);
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.signal, 0) << run.errors;
  EXPECT_EQ(run.capture.error, "");
  EXPECT_EQ(run.capture.frames.size(), planned.size());
  return run;
}

std::string line(const trace::PassRecord& pass) {
  static const char* const kKinds[] = {"?", "draw", "blit", "copy", "mipmap", "imageStore"};
  std::string text = kKinds[pass.kind];
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i) {
    const trace::ImageRef& image = pass.images[i];
    const bool window = image.kind == static_cast<std::uint32_t>(ImageKind::window);
    if (image.kind && (i == 0 || !window))
      text += " " + trace::attachmentName(i) + "=" + imageName(image);
  }
  if (pass.draws) text += "; " + std::to_string(pass.draws) + " draws";
  return text + maskNames("to", pass.drawBuffers) + maskNames("cleared", pass.cleared) +
         maskNames("written", pass.written);
}

std::vector<std::string> lines(const std::vector<trace::PassRecord>& passes) {
  std::vector<std::string> result;
  for (const trace::PassRecord& pass : passes) result.push_back(line(pass));
  return result;
}

std::string line(const trace::SampleRecord& sample) {
  std::string text = sample.uniform;
  if (!text.empty()) text += " unit " + std::to_string(sample.unit) + ": ";
  text += imageName(sample.image);
  if (sample.writer != kNone) text += ", writer " + std::to_string(sample.writer);
  if (sample.sampler) text += ", sampler " + std::to_string(sample.sampler);
  if (sample.feedback) text += ", feedback";
  if (sample.incomplete) text += ", incomplete";
  return text;
}

std::vector<std::string> samplesOf(const trace::Trace& trace, std::uint32_t step) {
  std::vector<std::string> result;
  for (const trace::SampleRecord& sample : trace.samplesOf(trace.steps.at(step)))
    result.push_back(line(sample));
  return result;
}

std::vector<double> valueOf(const trace::Trace& trace, const trace::CopyRecord& copy,
                            std::uint32_t x, std::uint32_t y) {
  const auto type = static_cast<PixelType>(copy.type);
  const std::vector<std::byte> bytes = trace.bytesOf(copy);
  const std::byte* const pixel =
      bytes.data() + trace::bytesPerPixel(type) * (std::size_t{y} * copy.width + x);
  const bool single = type == PixelType::f32x1 || type == PixelType::u8x1;
  std::vector<double> values;
  for (std::size_t i = 0; i < (single ? 1U : 4U); ++i) {
    switch (type) {
    case PixelType::u8x4:
    case PixelType::u8x1:
      values.push_back(at<std::uint8_t>(pixel + i));
      break;
    case PixelType::f16x4: {
      std::uint16_t half;
      std::memcpy(&half, pixel + 2 * i, sizeof(half));
      values.push_back(halfValue(half));
      break;
    }
    case PixelType::f32x4:
    case PixelType::f32x1:
      values.push_back(at<float>(pixel + 4 * i));
      break;
    case PixelType::i32x4:
      values.push_back(at<std::int32_t>(pixel + 4 * i));
      break;
    case PixelType::u32x4:
      values.push_back(at<std::uint32_t>(pixel + 4 * i));
      break;
    }
  }
  return values;
}

std::vector<double> valueAfter(const trace::Trace& trace, std::uint32_t pass,
                               std::uint32_t attachment, std::uint32_t x, std::uint32_t y) {
  const trace::CopyRecord* const copy = trace.copyOf(pass, attachment);
  return copy ? valueOf(trace, *copy, x, y) : std::vector<double>();
}

} // namespace ggrade::test
