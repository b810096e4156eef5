#include "grading/replay.hpp"

#include "grading/toolchain.hpp"

#include <fmt/format.h>

namespace ggrade::grading {

namespace {

/// Room for a tape: ten times what the largest reference needs.
constexpr std::uint64_t kTapeBytes = std::uint64_t{256} << 20;

std::string describe(const trace::Trace& trace, const trace::CopyRecord& copy) {
  const trace::PassRecord& pass = trace.passes[copy.pass];
  return fmt::format("{} after pass {} ({} draws)", trace::attachmentName(copy.attachment),
                     copy.pass, pass.draws);
}

} // namespace

trace::Request tapingRequest(std::uint32_t frames) {
  trace::Request request = gradingRequest();
  request.tapeFrames = frames;
  request.tapeBytes = kTapeBytes;
  return request;
}

Rendering play(const std::vector<std::byte>& tape, const std::vector<nlohmann::json>& patches,
               const std::vector<std::uint32_t>& size, std::uint32_t frames,
               const ShaderCache& shaders, const trace::Request& request) {
  const nlohmann::json scene = {{"size", size}, {"patches", patches}, {"frames", frames}};
  return renderScene("play", toolchain::kPlayerFolder, scene,
                     std::vector<double>(patches.size() * frames, 0.0), shaders, isolation(),
                     request, {}, false, tape);
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
