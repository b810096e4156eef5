#pragma once
/// \file
/// The judging side of the channel. Everything that the captured process wrote is a claim: it is
/// copied out first, and each length and range is checked before it is used.

#include "capture/channel.hpp"
#include "trace/trace.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace ggrade::channel {

/// A message with its text as valid UTF-8 without control characters (line feeds and tabs apart).
struct CapturedMessage {
  MessageKind kind;
  std::uint32_t frame; ///< in Capture::frames; of one that came in unseen frames only, the next one
  std::uint32_t count;
  std::uint32_t pass; ///< index in the trace, or trace::kNone
  std::string text;
};

struct CapturedFrame {
  double time = 0;          ///< seconds, as planned
  bool written = false;     ///< false: the frame was larger than a slot, and `pixels` is empty
  std::uint32_t width = 0;  ///< pixels; may differ from the plan if the program resized its window
  std::uint32_t height = 0; ///< pixels
  std::vector<std::uint8_t> pixels; ///< width x height x 4 bytes RGBA, row 0 at the top
  std::uint32_t windowDraws = 0;
  std::uint32_t windowClears = 0;
  std::uint32_t boundFramebuffer = 0;
  bool windowSrgb = false;
  double seconds = 0; ///< wall time since the swap before
};

struct Capture {
  /// Empty, or what the captured process wrote that is impossible (outcome `bad_output`), such as
  /// `frames[2].width: 20000 is above 16384`. Everything else is empty then.
  std::string error;
  bool started = false;
  bool contextMade = false;
  bool endedByCapture = false;
  double contextSeconds = 0;
  double shaderSeconds = 0;
  std::string glVersion;
  std::string glRenderer;
  std::vector<CapturedFrame> frames; ///< as many as were swapped, at most the plan's seen ones
  std::uint32_t unseenFrames = 0;    ///< that were swapped besides
  std::vector<CapturedMessage> messages;
  std::uint32_t messagesLost = 0;
  trace::Trace trace;                          ///< empty unless the plan asked for passes
  std::vector<ReplacementAnswer> replacements; ///< one to each that was planned
  std::vector<std::byte> tape; ///< as it was written, unchecked: replay/tape.hpp reads it
  std::string tapeRefused;     ///< why there is none, in words that go on "the program ..."
};

/// Pixels to be put in place of what a pass of the first seen frame leaves; Replacement
/// (channel.hpp) says in which images. Depth is exact in images of 16 and 24 bits and of floats.
struct PassPixels {
  std::uint32_t pass = 0; ///< index in the trace
  std::uint32_t attachment = 0;
  trace::PixelType type = trace::PixelType::u8x4;
  std::uint32_t format = 0; ///< internal format
  std::uint32_t width = 0, height = 0;
  std::vector<std::byte> pixels; ///< as Trace::bytesOf gives them: row 0 on top
};

/// Pixels of the largest frame that is accepted from a program that chooses its window's size
/// itself.
inline constexpr std::uint64_t kDefaultMaxPixels = std::uint64_t{1920} * 1080;

/// Owns the shared memory file.
class Channel {
public:
  /// Creates the file with its plan of 1 to kMaxFrames frames and seals its size. `maxPixels`
  /// counts for frames that leave a side to the program. Throws std::invalid_argument for an
  /// impossible plan, std::system_error when the system refuses.
  explicit Channel(const std::vector<PlannedFrame>& frames,
                   std::uint64_t maxPixels = kDefaultMaxPixels, const trace::Request& trace = {},
                   const std::vector<PassPixels>& replacements = {});
  ~Channel();
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  /// For the child, which finds its number in GG_CAPTURE_FD. Closed on exec unless the caller
  /// clears that.
  int descriptor() const { return descriptor_; }
  const Plan& plan() const { return plan_; }

  /// Copies out what the child wrote. Call it once the child and its children are gone; if they
  /// aren't, the result is as untrue as they like, but still in range. Throws std::system_error
  /// when the file can't be read.
  Capture read() const;

private:
  Plan plan_{};
  int descriptor_ = -1;
};

} // namespace ggrade::channel
