#pragma once
/// \file
/// Calls that draw, clear or move pixels, as commands of the tape. Each is written down before the
/// call is made. Nothing here may be called unless `isWanted` (writer.hpp).

#include "capture/recorder/recorder.hpp"

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <span>
#include <vector>

namespace ggrade::capture::tape {

/// One of the runs of vertices that a draw call draws.
struct Vertices {
  GLint first = 0; ///< of arrays
  GLsizei count = 0;
  GLenum indexType = GL_NONE; ///< GL_NONE: arrays
  std::uintptr_t offset = 0;  ///< bytes into the buffer of indices
  GLint baseVertex = 0;
};

void draw(GLenum mode, std::span<const Vertices> runs, GLsizei instances = 1,
          GLuint baseInstance = 0);

void clear(GLbitfield mask);
/// glClear*Buffer*. `type`: f, i, u, or b for depth and stencil together.
/// \param framebuffer null: the bound one
void clearBuffer(const GLuint* framebuffer, GLenum buffer, GLint drawBuffer, char type,
                 const std::array<double, 4>& values);

/// From the read to the draw framebuffer; null: the bound ones.
void blit(const GLuint* from, const GLuint* to, const std::array<GLint, 8>& corners,
          GLbitfield mask, GLenum filter);

/// From the bound read framebuffer into a level of the texture. `format` not 0: the level gets this
/// internal format and the size of what is copied (glCopyTexImage2D).
struct Copy {
  GLenum target = GL_TEXTURE_2D;
  GLint level = 0;
  std::array<GLint, 3> to{};   ///< offsets in the level
  std::array<GLint, 4> from{}; ///< x, y, width, height
  GLenum format = 0;
};
/// \param texture 0: the one that is bound to the target
void copy(GLuint texture, const Copy& copy);
void copyImage(const recorder::CopySide& from, const std::array<GLint, 3>& fromCorner,
               const recorder::CopySide& to, const std::array<GLint, 3>& toCorner,
               const std::array<GLsizei, 3>& size);
/// \param texture 0: the one that is bound to the target
void mipmap(GLuint texture, GLenum target);

void linkProgram(GLuint program);
void otherProgram(GLuint program);
/// A call that isn't recorded: the tape ends.
void refuseCall(const char* name);
/// The window's frame is complete.
void swap();

} // namespace ggrade::capture::tape
