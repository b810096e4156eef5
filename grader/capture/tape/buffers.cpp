// Buffers, read when they are used.

#include "capture/channel_writer.hpp"
#include "capture/recorder/gl_calls.hpp"
#include "capture/tape/objects.hpp"
#include "capture/tape/writer.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace ggrade::capture::tape {

using recorder::gl;

namespace {

/// By name, start and bytes. Emptied when any buffer changes: programs fill them before they draw.
std::map<std::tuple<GLuint, GLint64, GLint64>, std::uint64_t>& blobs() {
  static auto* const known = new std::map<std::tuple<GLuint, GLint64, GLint64>, std::uint64_t>;
  return *known;
}

} // namespace

void buffersChanged() {
  if (isWanted) blobs().clear();
}

std::uint64_t bufferBlob(GLuint buffer, GLint64 start, GLint64 bytes) {
  const auto [at, isNew] = blobs().try_emplace({buffer, start, bytes}, 0);
  if (!isNew) return at->second;
  GLint64 size = 0;
  GLint mapped = 0;
  gl().getNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &size);
  gl().getNamedBufferParameteriv(buffer, GL_BUFFER_MAPPED, &mapped);
  if (mapped) refuse("draws from a buffer that is mapped");
  if (start < 0 || start > size) refuse("draws from beyond a buffer's end");
  if (bytes < 0 || bytes > size - start) bytes = size - start;
  if (static_cast<std::uint64_t>(std::max<GLint64>(bytes, 0)) > plan()->trace.tapeBytes)
    refuse("draws from a buffer larger than a tape has room for");
  if (!isOpen()) return 0;
  std::vector<std::byte> data(static_cast<std::size_t>(bytes));
  if (bytes > 0) gl().getNamedBufferSubData(buffer, start, bytes, data.data());
  if (gl().getError() != GL_NO_ERROR) refuse("draws from a buffer that can't be read back");
  return at->second = blob(data);
}

} // namespace ggrade::capture::tape
