// The end of a frame: its passes, and the bytes of everything that GL holds.

#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/recorder.hpp"
#include "capture/recorder/session.hpp"

#include <algorithm>

namespace ggrade::capture::recorder {
namespace {

// Names are given out in rising order; after so many in a row that are none, no more are looked
// for.
constexpr GLuint kMaxGap = 1024;
constexpr GLuint kMaxNames = 1U << 20;
constexpr GLint kCountedLevels = 32;

/// Sum of `bytesOf(name)` over all objects of a kind.
template <typename Is, typename BytesOf> std::uint64_t sum(const Is& is, const BytesOf& bytesOf) {
  std::uint64_t bytes = 0;
  GLuint gap = 0;
  for (GLuint name = 1; gap < kMaxGap && name < kMaxNames; ++name) {
    if (is(name)) {
      bytes += bytesOf(name);
      gap = 0;
    } else {
      ++gap;
    }
  }
  return bytes;
}

std::uint64_t textureBytes(GLuint texture) {
  if (textureParameter(texture, GL_TEXTURE_TARGET) == GL_TEXTURE_BUFFER) return 0; // a buffer's
  std::uint64_t bytes = 0;
  for (GLint level = 0; level < kCountedLevels; ++level) bytes += textureLevelBytes(texture, level);
  return bytes;
}

std::uint64_t bufferBytes(GLuint buffer) {
  GLint64 size = 0;
  gl().getNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &size);
  return static_cast<std::uint64_t>(std::max<GLint64>(size, 0));
}

} // namespace

void swap(channel::FrameRecord& record, bool reachable) {
  Session session;
  if (session && reachable) {
    endPass(session);
    record.imageBytes =
        sum(gl().isTexture, textureBytes) + sum(gl().isRenderbuffer, renderbufferBytes);
    record.bufferBytes = sum(gl().isBuffer, bufferBytes);
  }
  session.countFrame(record.firstPass, record.passCount);
}

} // namespace ggrade::capture::recorder
