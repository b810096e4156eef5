#include "grading/replay.hpp"

#include "grading/toolchain.hpp"

#include <fmt/format.h>

namespace ggrade::grading {

namespace {

/// Room for a tape: ten times what the largest reference needs.
constexpr std::uint64_t kTapeBytes = std::uint64_t{256} << 20;

/// Variants that one run draws: so many frames fit a channel.
constexpr std::size_t kVariantFrames = 48;

std::string describe(const trace::Trace& trace, const trace::CopyRecord& copy) {
  const trace::PassRecord& pass = trace.passes[copy.pass];
  return fmt::format("{} after pass {} ({} draws)", trace::attachmentName(copy.attachment),
                     copy.pass, pass.draws);
}

} // namespace

trace::Request tapingRequest(const Moments& times) {
  trace::Request request = gradingRequest();
  request.tapeFrames = std::uint32_t(times.frames());
  request.tapeBytes = kTapeBytes;
  return request;
}

Rendering play(const std::vector<std::byte>& tape, const std::vector<nlohmann::json>& patches,
               const std::vector<std::uint32_t>& size, const Moments& times,
               const ShaderCache& shaders, const trace::Request& request) {
  const nlohmann::json scene = {{"patches", patches}, {"frames", times.frames()}};
  const auto once = plannedFrames(times, size.at(0), size.at(1));
  std::vector<channel::PlannedFrame> frames;
  for (std::size_t i = 0; i < patches.size(); ++i)
    frames.insert(frames.end(), once.begin(), once.end());
  return renderFrames("play", toolchain::kPlayerFolder, scene, frames, shaders, isolation(),
                      request, {}, false, tape);
}

std::vector<channel::Capture> playEach(const std::vector<std::byte>& tape,
                                       const std::vector<nlohmann::json>& patches,
                                       const std::vector<std::uint32_t>& size, const Moments& times,
                                       const ShaderCache& shaders, std::uint64_t frameBytes) {
  const std::size_t frames = times.shown.size();
  trace::Request request = gradingRequest();
  request.copyFrames = channel::kMaxFrames;
  request.copyBytes = std::uint64_t{1} << 30;
  // A patch may add passes: so twice the room.
  const std::size_t room = request.copyBytes / (2 * std::max(frameBytes, std::uint64_t{1}));
  const std::size_t together =
      std::max(std::size_t{1}, std::min(kVariantFrames / times.frames(), room / frames));
  std::vector<channel::Capture> all;
  while (all.size() < patches.size()) {
    const auto begin = patches.begin() + std::ptrdiff_t(all.size());
    const std::size_t count = std::min(together, patches.size() - all.size());
    const std::vector<nlohmann::json> some(begin, begin + std::ptrdiff_t(count));
    const Rendering played = play(tape, some, size, times, shaders, request);
    const std::size_t whole = std::min(count, played.capture.frames.size() / frames);
    for (std::size_t i = 0; i < whole; ++i) {
      channel::Capture& one = all.emplace_back();
      const auto first = played.capture.frames.begin() + std::ptrdiff_t(i * frames);
      one.frames.assign(first, first + std::ptrdiff_t(frames));
      one.trace = trace::framesOf(played.capture.trace, i * frames, frames);
    }
    // What ends a run is one patch's fault: those after it are drawn in another one.
    if (whole == 0 && played.happened.seconds >= kRunSeconds)
      throw std::runtime_error("drawn again with a change, it takes too long");
    if (whole == 0) all.emplace_back();
  }
  return all;
}

std::string differenceOf(const channel::Capture& drawn, const channel::Capture& played) {
  const trace::Trace &a = drawn.trace, &b = played.trace;
  if (played.frames.size() > drawn.frames.size())
    return fmt::format("{} frames instead of {}", played.frames.size(), drawn.frames.size());
  const std::size_t copies =
      std::size_t(std::ranges::count_if(a.copies, [&](const trace::CopyRecord& copy) {
        return a.passes[copy.pass].frame < played.frames.size();
      }));
  for (std::size_t i = 0; i < std::min(copies, b.copies.size()); ++i) {
    const trace::CopyRecord &one = a.copies[i], &other = b.copies[i];
    if (one.pass != other.pass || one.attachment != other.attachment || one.type != other.type ||
        one.width != other.width || one.height != other.height)
      return fmt::format("{} came as {}", describe(a, one), describe(b, other));
    if (a.bytesOf(one) != b.bytesOf(other)) return describe(a, one) + " differs";
  }
  if (copies != b.copies.size())
    return fmt::format("{} outputs of passes instead of {}", b.copies.size(), copies);
  for (std::size_t i = 0; i < played.frames.size(); ++i)
    if (drawn.frames[i].pixels != played.frames[i].pixels)
      return fmt::format("frame {} differs", i + 1);
  return {};
}

} // namespace ggrade::grading
