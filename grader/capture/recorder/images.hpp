#pragma once
/// \file
/// What GL answers about images: which ones a framebuffer draws into or reads from, and of what
/// format and size they are. The context must be current.

#include "capture/run.hpp"
#include "trace/records.hpp"

#include <GL/gl.h>

#include <cstdint>

namespace ggrade::capture::recorder {

/// The bound draw framebuffer. Of the images only kind, name, level and layer are filled in.
struct Target {
  GLuint framebuffer = 0;
  std::uint32_t drawBuffers = 0;                         ///< mask of attachments
  std::uint32_t attachmentOfBuffer[trace::kColors] = {}; ///< draw buffer to attachment, or kNone
  trace::ImageRef images[trace::kAttachments] = {};
};

Target boundTarget();

/// True when both draw into the same images.
bool sameImages(const Target& a, const Target& b);

/// The image at an attachment of the framebuffer bound to `binding` (GL_DRAW_FRAMEBUFFER or
/// GL_READ_FRAMEBUFFER), of which the GL name is `framebuffer`; as `Target` has it.
trace::ImageRef attachedImage(GLenum binding, GLuint framebuffer, std::uint32_t attachment);

/// Index of the colour attachment that a draw or read buffer names, or kNone; the window's one
/// buffer is 0.
std::uint32_t attachmentOf(GLint buffer);

/// A level of a texture, not described yet.
trace::ImageRef textureLevel(GLuint texture, std::uint32_t level,
                             std::uint32_t layer = trace::kNone);

/// Fills in target, format, size and samples. `window` is the size of the window's framebuffer.
void describe(trace::ImageRef& image, std::uint32_t attachment, Size window);

/// Which parts the image has: colour, depth, stencil.
struct Aspects {
  bool color = false, depth = false, stencil = false;
};
Aspects aspectsOf(const trace::ImageRef& image);

/// Bytes of all faces, layers and samples.
std::uint64_t textureLevelBytes(GLuint texture, GLint level);
std::uint64_t renderbufferBytes(GLuint renderbuffer);

/// The texture bound to `target` (a cube's face counts as the cube) at the active unit; 0 for
/// targets that hold no texture of the program's, such as proxies.
GLuint boundTexture(GLenum target);

/// Whether one level of such a texture is more than one image: array, cube, 3D.
bool hasLayers(GLenum target);

GLint textureParameter(GLuint texture, GLenum name);
GLint levelParameter(GLuint texture, std::uint32_t level, GLenum name);

} // namespace ggrade::capture::recorder
