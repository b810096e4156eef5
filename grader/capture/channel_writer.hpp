#pragma once
/// \file
/// The captured side of the channel. Without a channel (GG_CAPTURE_FD not set) everything is
/// dropped, apart from what GG_CAPTURE_VERBOSE=1 prints on stderr.

#include "capture/channel.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ggrade::capture {

/// The judging side's plan, or null without a channel.
const channel::Plan* plan();

/// Whether passes are to be recorded. Set before `main`, and constant from then on.
extern bool recordsPasses;

/// The tables of the passes and the room for copies, of `plan()->trace.copyBytes` bytes. Null
/// unless `recordsPasses`.
trace::Tables* recordTables();
std::byte* recordCopies();

/// The room for the tape, of `plan()->trace.tapeBytes` bytes. Only if a tape is asked for, as what
/// follows: so many bytes of it are complete, or why there is none.
std::byte* tapeRoom();
void writeTapeBytes(std::uint64_t bytes);
void writeTapeRefused(const char* what);

/// The pixels of a replacement of `plan()`, row 0 at the bottom; aligned for any value.
const std::byte* replacementPixels(const channel::Replacement& replacement);
/// Says what has become of the plan's replacement of that index.
void answerReplacement(std::uint32_t index, channel::ReplacementAnswer answer);

/// Messages of this thread come from this pass from now on; kNone: from none.
void setMessagePass(std::uint32_t pass);

/// Stores a message, or counts it when the same text came before. Any thread.
void writeMessage(channel::MessageKind kind, std::string_view text);

/// Says once that something has no meaning offscreen, or went otherwise than the program may think.
[[gnu::format(printf, 1, 2)]] void say(const char* format, ...);

void writeContext(double seconds, const char* version, const char* renderer);
void addShaderSeconds(double seconds);
void writeEndedByCapture();

/// Stores the frame that ends now: `pixels` is width x height x 4 bytes RGBA, row 0 at the bottom.
/// Sizes beyond the plan's slot are recorded without pixels. Does nothing after the plan's last
/// frame.
void writeFrame(const channel::FrameRecord& record, const std::uint8_t* pixels);

} // namespace ggrade::capture
