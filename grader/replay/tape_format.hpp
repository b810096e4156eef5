#pragma once
/// \file
/// A tape: everything that a program drew in its first frames, whole enough to be drawn again
/// without the program. Written into the channel by grader/capture/tape, read by tape.hpp.
///
/// A tape is a row of entries: a head, then as many bytes, padded to eight. A *blob* is bytes that
/// commands name by the blob's number, counted from 0: texels, a buffer's bytes, a shader's source.
/// A *command* is CBOR (RFC 8949) of an object whose "op" says what it does:
///
/// - `context`: core, version, window (size, pixels), depthBits, stencilBits. The first command.
/// - `image`: id, kind (`texture`, `renderbuffer`), target, levels (format, size, samples, data).
///   Comes before the first use of an image, and again when it was changed otherwise than by
///   commands. Renderbuffers have no data: nothing but commands changes them.
/// - `draw`: state, target, program, uniforms, blocks, textures, attributes, indices, calls.
/// - `clear` (colors, depths, stencils: which; color, depth, stencil: to what), `clearBuffer`:
///   state, target.
/// - `blit`, `copy`, `copyImage`, `mipmap`: between images.
/// - `program`: one that was linked and had drawn nothing when the first frame was complete.
/// - `swap`: a frame is complete.
///
/// Names of values are the field's own; enumerants are OpenGL's numbers. A command is complete in
/// itself: it depends on no other but for what the images hold.

#include <cstdint>

namespace ggrade::tape {

enum class EntryKind : std::uint32_t { blob = 1, command = 2 };

struct EntryHead {
  std::uint32_t kind; ///< EntryKind
  std::uint32_t reserved;
  std::uint64_t bytes; ///< of what follows, without padding
};

inline constexpr std::uint64_t kAlign = 8;
constexpr std::uint64_t padded(std::uint64_t bytes) {
  return (bytes + kAlign - 1) / kAlign * kAlign;
}

inline constexpr std::uint32_t kMaxCommands = 20000;
inline constexpr std::uint32_t kMaxBlobs = 20000;

} // namespace ggrade::tape
