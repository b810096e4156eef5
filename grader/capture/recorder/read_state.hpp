#pragma once
/// \file
/// The program's state that reading pixels depends on.

#include <GL/gl.h>

#include <array>
#include <cstddef>

namespace ggrade::capture::recorder {

/// While this exists, pixel-store state is neutral, no pack buffer is bound, and the read
/// framebuffer may be bound elsewhere. The destructor puts all of it back. The context must be
/// current.
class ReadState {
public:
  ReadState();
  ~ReadState();
  ReadState(const ReadState&) = delete;
  ReadState& operator=(const ReadState&) = delete;

  static constexpr std::size_t kPacks = 9;
  static constexpr std::size_t kTransfers = 14; ///< of the compatibility profile

private:
  GLuint framebuffer_;
  GLuint buffer_;
  GLuint clamp_;
  bool compatible_;
  std::array<GLint, kPacks> pack_{};
  std::array<GLfloat, kTransfers> transfer_{};
};

} // namespace ggrade::capture::recorder
