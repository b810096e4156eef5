#include "capture/channel_plan.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

namespace ggrade::channel {
namespace {

constexpr std::uint64_t kMaxPixels = std::uint64_t{kMaxSide} * kMaxSide;

void require(bool met, const std::string& rule) {
  if (!met) throw std::invalid_argument("capture plan: " + rule);
}

void writeAll(int descriptor, const void* from, std::uint64_t bytes, std::uint64_t offset) {
  const auto* at = static_cast<const char*>(from);
  while (bytes > 0) {
    const ssize_t put = pwrite(descriptor, at, bytes, static_cast<off_t>(offset));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0)
      throw std::system_error(errno, std::generic_category(), "cannot write the capture plan");
    at += put;
    offset += static_cast<std::uint64_t>(put);
    bytes -= static_cast<std::uint64_t>(put);
  }
}

void requirePossible(const trace::Request& trace) {
  for (const std::uint32_t flag : {trace.passes, trace.stepCopies})
    require(flag <= 1, "what is recorded is 0 or 1");
  require(trace.times <= std::uint32_t(trace::Times::processor), "times are by no clock, 1 or 2");
  for (const std::uint32_t mask : {trace.copies, trace.windowCopies, trace.renderbufferCopies})
    require(mask <= trace::kAllAttachments, "copies are of attachments 0 to 9");
  require(trace.copyFrames <= kMaxFrames, "copies are made in 64 frames at most");
  require(trace.copyBytes <= kMaxCopyBytes, "there is room for 2 GiB of copies at most");
  require(trace.tapeFrames <= kMaxFrames, "64 frames at most are taped");
  require(trace.tapeBytes <= kMaxTapeBytes, "there is room for 1 GiB of tape at most");
  require((trace.tapeFrames == 0) == (trace.tapeBytes == 0),
          "a tape has frames and room, or neither");
  require(trace.passes != 0 || (trace.copies == 0 && trace.copyBytes == 0 && trace.times == 0 &&
                                trace.tapeFrames == 0),
          "nothing is recorded of passes without the passes");
}

bool fits(std::uint32_t attachment, trace::PixelType type) {
  if (attachment == trace::kDepth) return type == trace::PixelType::f32x1;
  return attachment < trace::kColors && type != trace::PixelType::f32x1 &&
         type != trace::PixelType::u8x1 && trace::bytesPerPixel(type) > 0;
}

void addReplacement(Plan& plan, const PassPixels& from) {
  require(plan.trace.passes != 0, "nothing is replaced without the passes");
  require(from.pass < trace::kMaxPasses, "a pass is one of 4096");
  require(fits(from.attachment, from.type), "what is replaced is colour, or depth by floats");
  require(from.width >= 1 && from.width <= kMaxSide && from.height >= 1 && from.height <= kMaxSide,
          "what is replaced has 1 to 16384 pixels a side");
  require(from.pixels.size() ==
              trace::bytesPerPixel(from.type) * std::uint64_t{from.width} * from.height,
          "as many bytes are put in place as the image has");
  plan.replacements[plan.replacementCount++] = {from.pass,
                                                from.attachment,
                                                static_cast<std::uint32_t>(from.type),
                                                from.format,
                                                from.width,
                                                from.height,
                                                plan.replacementBytes,
                                                from.pixels.size()};
  // The next one begins where any value may begin.
  plan.replacementBytes += (from.pixels.size() + 15) / 16 * 16;
  require(plan.replacementBytes <= kMaxReplacementBytes,
          "what is replaced takes 512 MiB at most in all");
}

} // namespace

Plan makePlan(const std::vector<PlannedFrame>& frames, std::uint64_t maxPixels,
              const trace::Request& trace, const std::vector<PassPixels>& replacements) {
  require(!frames.empty() && frames.size() <= kMaxFrames,
          "there are 1 to 64 frames, not " + std::to_string(frames.size()));
  require(maxPixels > 0 && maxPixels <= kMaxPixels, "a frame has 1 to 16384 x 16384 pixels");
  Plan plan{};
  plan.magic = kMagic;
  plan.version = kVersion;
  plan.frameCount = static_cast<std::uint32_t>(frames.size());
  std::uint64_t pixels = 0;
  bool anySeen = false;
  for (const PlannedFrame& frame : frames) {
    require(std::isfinite(frame.time) && frame.time >= 0, "a time is finite and not negative");
    require(frame.width <= kMaxSide && frame.height <= kMaxSide, "a side has 16384 pixels at most");
    require(frame.unseen <= 1, "a frame is seen or not");
    anySeen |= frame.unseen == 0;
    const bool open = frame.width == 0 || frame.height == 0;
    pixels = std::max(pixels, open ? maxPixels : std::uint64_t{frame.width} * frame.height);
  }
  require(anySeen, "some frame is looked at");
  requirePossible(trace);
  plan.slotBytes = 4 * pixels;
  std::copy(frames.begin(), frames.end(), plan.frames);
  plan.trace = trace;
  require(replacements.size() <= kMaxReplacements, "32 outputs at most are replaced");
  for (const PassPixels& replacement : replacements) addReplacement(plan, replacement);
  return plan;
}

void writePlan(int descriptor, const Plan& plan, const std::vector<PassPixels>& replacements) {
  writeAll(descriptor, &plan, sizeof(Plan), 0);
  for (std::uint32_t i = 0; i < plan.replacementCount; ++i) {
    const PassPixels& from = replacements[i];
    const std::uint64_t rowBytes = from.pixels.size() / from.height;
    std::vector<std::byte> turned(from.pixels.size());
    for (std::uint32_t y = 0; y < from.height; ++y)
      std::memcpy(turned.data() + (from.height - 1 - y) * rowBytes,
                  from.pixels.data() + y * rowBytes, rowBytes);
    writeAll(descriptor, turned.data(), turned.size(),
             replacementsOffset(plan) + plan.replacements[i].offset);
  }
}

} // namespace ggrade::channel
