#pragma once
/// \file
/// The recorder: writes down the passes of a run (trace/records.hpp) while the program draws.
///
/// Nothing here may be called unless `recordsPasses` (channel_writer.hpp). Hooks call these
/// functions before the GL call that they speak of, on the thread that makes it. At each call the
/// recorder asks GL what it draws into, with what state, and what it samples; binding and setting
/// state needs no hooks. It leaves GL's state, errors and messages as they were.

#include "capture/channel.hpp"
#include "capture/context_state.hpp"

#include <GL/gl.h>

#include <array>
#include <cstdint>
#include <optional>

namespace ggrade::capture::recorder {

// Draws and clears: drawing.cpp

struct DrawCall {
  GLenum mode = 0;
  std::uint64_t vertices = 0; ///< instances included
};
void draw(const DrawCall& call);
/// What stands between glBegin and glEnd is one draw, and no other GL call is made there.
void begin(GLenum mode);
void end();

/// glClear.
void clear(GLbitfield mask);

/// glClearBuffer*: what the call brings; nothing of the rest.
struct ClearValue {
  std::optional<std::array<float, 4>> color;
  std::optional<float> depth;
  std::optional<std::uint32_t> stencil;
};
/// Of the bound draw framebuffer, or of the named one (glClearNamedFramebuffer*).
void clearBuffer(GLint drawBuffer, const ClearValue& value);
void clearBufferOf(GLuint framebuffer, GLint drawBuffer, const ClearValue& value);

/// After a draw or clear has been made. Only of use when times were asked for.
void done();

// Passes of their own: transfers.cpp. `ended` is called after the GL call.

void blit(const GLint (&to)[4], GLbitfield mask);
void blitOf(GLuint from, GLuint framebuffer, const GLint (&to)[4], GLbitfield mask);
/// From the read framebuffer to the texture bound to `target`, or the named one.
void copyToBound(GLenum target, GLint level, GLint layer);
void copyTo(GLuint texture, GLint level, GLint layer);
struct CopySide {
  GLuint name;
  GLenum target; ///< GL_RENDERBUFFER or a texture's
  GLint level, z;
};
void copyImage(const CopySide& from, const CopySide& to);
void mipmapOfBound(GLenum target);
void mipmapOf(GLuint texture);
/// A compute shader's.
void dispatch();
void ended();

// What changes or ends an image: changes.cpp

/// Pixels of a level come from the program or get lost.
void uploadedToBound(GLenum target, GLint level);
void uploaded(GLuint texture, GLint level);
void renderbufferChanged(GLuint renderbuffer);
void boundRenderbufferChanged();
void invalidated(); ///< some framebuffer
void texturesDeleted(GLsizei count, const GLuint* names);
void renderbuffersDeleted(GLsizei count, const GLuint* names);
void programChanged(GLuint program);

/// The context is to be no more current to this thread, or its window is to lose its content.
void leave();

/// The window's frame is complete: fills in the frame's passes and bytes. Its context must be
/// current, unless it isn't `reachable`: then only passes that have ended are there.
void swap(channel::FrameRecord& record, bool reachable);

} // namespace ggrade::capture::recorder
