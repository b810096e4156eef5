#pragma once
/// \file
/// The program's state that moving pixels between GL and memory depends on.

#include <GL/gl.h>

#include <array>
#include <cstddef>

namespace ggrade::capture::recorder {

enum class PixelDirection {
  pack,   ///< from GL to memory
  unpack, ///< from memory to GL
};

/// While this exists, pixel-store state of one direction is neutral, no pixel buffer is bound
/// there, and pixels are moved as they are. The destructor puts all of it back. The context must be
/// current.
class PixelState {
public:
  explicit PixelState(PixelDirection direction);
  ~PixelState();
  PixelState(const PixelState&) = delete;
  PixelState& operator=(const PixelState&) = delete;

  static constexpr std::size_t kStores = 9;
  static constexpr std::size_t kTransfers = 14; ///< of the compatibility profile

private:
  PixelDirection direction_;
  GLuint buffer_;
  bool compatible_;
  std::array<GLint, kStores> store_{};
  std::array<GLfloat, kTransfers> transfer_{};
};

/// While this exists, pixels are read as they are into plain memory, and the read framebuffer may
/// be bound elsewhere. The destructor puts all of it back. The context must be current.
class ReadState {
public:
  ReadState();
  ~ReadState();
  ReadState(const ReadState&) = delete;
  ReadState& operator=(const ReadState&) = delete;

private:
  GLuint framebuffer_;
  GLuint clamp_;
  PixelState pack_;
};

} // namespace ggrade::capture::recorder
