#pragma once
/// \file
/// The judging side of the channel. Everything that the captured process wrote is a claim: it is
/// copied out first, and each length and range is checked before it is used.

#include "capture/channel.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ggrade::channel {

/// What to render: 1 to kMaxFrames frames, and the largest frame to accept in pixels.
struct PlanRequest {
  std::vector<PlannedFrame> frames;
  std::uint64_t maxPixels = 0; ///< capacity of a slot; at least what the planned sizes need
};

/// A message with its text as valid UTF-8 without control characters (line feeds and tabs apart).
struct CapturedMessage {
  MessageKind kind;
  std::uint32_t frame;
  std::uint32_t count;
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
  bool started = false;
  bool contextMade = false;
  bool endedByCapture = false;
  double contextSeconds = 0;
  double shaderSeconds = 0;
  std::string glVersion;
  std::string glRenderer;
  std::vector<CapturedFrame> frames; ///< as many as were swapped, at most the plan's
  std::vector<CapturedMessage> messages;
  std::uint32_t messagesLost = 0;
};

/// The captured process wrote something impossible (outcome `bad_output`).
struct CaptureError {
  std::string field;  ///< `frames[2].width`
  std::string reason; ///< `20000 is above 16384`
};

using CaptureResult = std::variant<Capture, CaptureError>;

/// Owns the shared memory file.
class Channel {
public:
  /// Creates the file with its plan and seals its size. Throws std::invalid_argument for an
  /// impossible request, std::system_error when the system refuses.
  explicit Channel(const PlanRequest& request);
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
  CaptureResult read() const;

private:
  Plan plan_{};
  int descriptor_ = -1;
};

} // namespace ggrade::channel
