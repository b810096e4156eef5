#pragma once
/// \file
/// The one shared memory file between a captured program and the process that judges it.
///
/// The judging side creates the file, writes the Plan, fixes the file's size, and passes the
/// descriptor; the captured side (capture library inside the student's process) writes everything
/// else. All of it is plain data of sizes that the judging side computes itself. Whatever the
/// captured side wrote is a claim: `Channel::read` (channel_reader.hpp) checks every length and
/// range and copies the values out.
///
/// Layout: Header; trace::Tables if passes are recorded; `plan.frameCount` slots of
/// `plan.slotBytes` bytes, each holding one frame as width x height x 4 bytes RGBA, row 0 at the
/// bottom (as OpenGL has it); `plan.trace.copyBytes` bytes of copies; `plan.trace.tapeBytes` bytes
/// of tape (replay/tape_format.hpp); `plan.replacementBytes` bytes of pixels that the judging side
/// has written. Each starts at a page.

#include "trace/records.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace ggrade::channel {

inline constexpr std::uint32_t kMagic = 0x31434747; ///< "GGC1"
inline constexpr std::uint32_t kVersion = 5;
inline constexpr std::uint32_t kMaxFrames = 64;
inline constexpr std::uint32_t kMaxMessages = 64;
inline constexpr std::uint32_t kMaxReplacements = 32;
inline constexpr std::uint32_t kMaxSide = 16384; ///< pixels
/// Environment variable that names the descriptor of the channel.
inline constexpr char kDescriptorVariable[] = "GG_CAPTURE_FD";

/// Exit code of a program whose capture library refused the channel (as when a library cannot be
/// loaded).
inline constexpr int kRefusedExit = 127;

/// One frame that the judging side wants. A side of 0 leaves the window as the program asked for
/// it.
struct PlannedFrame {
  double time;          ///< seconds that glfwGetTime reports in this frame
  std::uint32_t width;  ///< framebuffer pixels, 0 or 1 to kMaxSide
  std::uint32_t height; ///< framebuffer pixels, 0 or 1 to kMaxSide
  /// 1: drawn for what comes of it later, and not looked at. Nothing is recorded of it, and no
  /// frame that is counted or numbered for the judging side is this one.
  std::uint32_t unseen = 0;
  std::uint32_t reserved = 0;
};

/// Pixels that take the place of what a pass of the first seen frame left in one of its
/// attachments, as soon as the pass has ended and before its copies are made. The attachment must
/// be a level of a texture, not multisampled, with all its layers, or encoded as sRGB; of exactly
/// this size and internal format. Stencil that lies in the same texture as depth is kept.
struct Replacement {
  std::uint32_t pass;       ///< index in the table of passes
  std::uint32_t attachment; ///< 0 to 7 colour, or trace::kDepth
  std::uint32_t type;   ///< trace::PixelType; f32x1 for depth, neither f32x1 nor u8x1 for colour
  std::uint32_t format; ///< internal format
  std::uint32_t width, height; ///< pixels
  std::uint64_t offset;        ///< in bytes, from the start of all replacements
  std::uint64_t bytes;         ///< row 0 at the bottom
};

/// What has become of a replacement.
enum class ReplacementAnswer : std::uint32_t {
  notReached = 0, ///< there was no such pass in that frame, or it has not ended
  done,
  otherImage, ///< the attachment is of another kind, size or format; nothing was changed
  refused,    ///< GL did not take the pixels
};

/// Written by the judging side before the program starts, never afterwards.
struct Plan {
  std::uint32_t magic;
  std::uint32_t version;
  std::uint32_t frameCount;       ///< 1 to kMaxFrames
  std::uint32_t replacementCount; ///< 0 to kMaxReplacements; none without passes
  std::uint64_t slotBytes; ///< capacity of one frame; a larger window is reported, not written
  trace::Request trace;    ///< what to record of the passes
  PlannedFrame frames[kMaxFrames];
  std::uint64_t replacementBytes; ///< of the pixels of all replacements
  Replacement replacements[kMaxReplacements];
};

enum class MessageKind : std::uint32_t {
  glError = 1, ///< a GL error, with the name of the call
  glDebug = 2, ///< a debug message that is not an error
  capture = 3, ///< something the capture library has to say (no meaning offscreen, and so on)
};

/// Equal messages are stored once; `count` says how often they came.
struct Message {
  std::uint32_t kind;  ///< MessageKind
  std::uint32_t frame; ///< frame it came in first, a seen one if it ever came in one; from 0
  std::uint32_t count;
  std::uint32_t pass; ///< the pass that it came in first, or trace::kNone
  char text[240];     ///< UTF-8, ends in 0
};

/// What happened up to one glfwSwapBuffers.
struct FrameRecord {
  std::uint32_t written; ///< 1 once the slot's pixels are complete; 0 for ever if unseen
  std::uint32_t width;   ///< framebuffer pixels
  std::uint32_t height;
  std::uint32_t windowDraws;      ///< draw calls and blits that reached the window
  std::uint32_t windowClears;     ///< clears that reached the window
  std::uint32_t boundFramebuffer; ///< GL_DRAW_FRAMEBUFFER_BINDING at the swap
  std::uint32_t windowSrgb;       ///< 1 if GL_FRAMEBUFFER_SRGB was on for the window (it is linear)
  std::uint32_t firstPass;        ///< in the table of passes
  std::uint32_t passCount;
  std::uint32_t reserved;
  double seconds;           ///< wall time since the swap before (or since the context, for frame 0)
  std::uint64_t imageBytes; ///< of all textures and renderbuffers, if passes are recorded
  std::uint64_t bufferBytes; ///< of all buffer objects, if passes are recorded
};

struct Header {
  Plan plan;
  // Everything below is written by the captured side.
  std::uint32_t started;        ///< 1 once the library has been loaded and initialised
  std::uint32_t contextMade;    ///< 1 once a context exists
  std::uint32_t framesDone;     ///< number of swaps so far, at most plan.frameCount
  std::uint32_t messageCount;   ///< at most kMaxMessages
  std::uint32_t messagesLost;   ///< messages beyond kMaxMessages
  std::uint32_t endedByCapture; ///< 1 if the program ignored the request to close and was ended
  double contextSeconds;        ///< time to make the first context
  double shaderSeconds; ///< time spent in glCompileShader, glLinkProgram and first use queries
  char glVersion[128];  ///< GL_VERSION
  char glRenderer[128]; ///< GL_RENDERER
  FrameRecord frames[kMaxFrames];
  Message messages[kMaxMessages];
  std::uint32_t replacements[kMaxReplacements]; ///< ReplacementAnswer to each of the plan's
  std::uint64_t tapeBytes;                      ///< of the tape that is complete
  char tapeRefused[128]; ///< why there is no tape: "The program ..." goes on so; empty: there is
};

static_assert(std::is_trivially_copyable_v<Header>);
static_assert(sizeof(Message) == 256);

inline constexpr std::uint64_t kPage = 4096;
/// Most room for copies that a plan may ask for.
inline constexpr std::uint64_t kMaxCopyBytes = std::uint64_t{2} << 30;

/// Most room for a tape.
inline constexpr std::uint64_t kMaxTapeBytes = std::uint64_t{1} << 30;

/// Most room that the pixels of all replacements together may take.
inline constexpr std::uint64_t kMaxReplacementBytes = std::uint64_t{512} << 20;

constexpr std::uint64_t pageAligned(std::uint64_t bytes) {
  return (bytes + kPage - 1) / kPage * kPage;
}

/// Offset in bytes of the tables from the start of the file. Only there if `plan.trace.passes`.
constexpr std::uint64_t tablesOffset() {
  return pageAligned(sizeof(Header));
}

/// Offset in bytes of frame `index`'s pixels from the start of the file.
constexpr std::uint64_t slotOffset(const Plan& plan, std::uint32_t index) {
  const std::uint64_t first =
      tablesOffset() + (plan.trace.passes ? pageAligned(sizeof(trace::Tables)) : 0);
  return first + index * plan.slotBytes;
}

/// Offset in bytes of the copies.
constexpr std::uint64_t copiesOffset(const Plan& plan) {
  return pageAligned(slotOffset(plan, plan.frameCount));
}

/// Offset in bytes of the tape.
constexpr std::uint64_t tapeOffset(const Plan& plan) {
  return pageAligned(copiesOffset(plan) + plan.trace.copyBytes);
}

/// Offset in bytes of the replacements' pixels.
constexpr std::uint64_t replacementsOffset(const Plan& plan) {
  return pageAligned(tapeOffset(plan) + plan.trace.tapeBytes);
}

/// Size of the whole file in bytes.
constexpr std::uint64_t totalBytes(const Plan& plan) {
  return plan.replacementCount ? replacementsOffset(plan) + plan.replacementBytes
                               : tapeOffset(plan) + plan.trace.tapeBytes;
}

} // namespace ggrade::channel
