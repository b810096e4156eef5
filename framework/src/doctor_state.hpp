#pragma once
/// \file
/// What the frame doctor asks OpenGL. All by the loader's unwatched functions; every question puts
/// back what it changed and leaves no error behind.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gg/gl.hpp>
#include <gg/texture.hpp>
#include <glm/vec2.hpp>

namespace gg::detail {

GLint ask(GLenum name);

/// GL_TEXTURE_2D or another target, by texture object: as what each was bound first.
using TextureTargets = std::map<GLuint, GLenum>;

/// "GL_INVALID_ENUM (a constant that the function doesn't know)"
std::string errorName(GLenum error);

/// Why the framebuffer object that is bound for drawing is not complete; empty if it is.
std::string incompleteness();

/// The size of what the framebuffer object that is bound for drawing draws into, pixels; 0 if it is
/// unknown. A texture's size is known for 2D textures only.
glm::ivec2 framebufferSize(const TextureTargets& targets);

/// Has the framebuffer that is bound for drawing a depth buffer?
bool hasDepth();

/// Are colours drawn into the framebuffer object that is bound for drawing, as its draw buffers
/// say, though nothing is attached where they name?
bool lacksColor();

/// Is gl_ClipDistance written before this program's fragment shader? Told from the text of its
/// shaders; nothing where they aren't attached any more.
std::optional<bool> writesClipDistance(GLuint program);

/// What is wrong with the textures that the current program's samplers read, a sentence each.
struct SamplerFaults {
  std::vector<std::string> certain; ///< incomplete textures
  std::vector<std::string>
      perhaps; ///< none, or one without storage: the shader need not ask for it
};
SamplerFaults samplerFaults();

/// The float, vector and matrix uniforms of a program that are all 0, with their locations.
std::map<std::string, GLint> zeroUniforms(GLuint program);

/// The window's back buffer. Empty if a buffer object is bound that would take it instead.
Image windowPicture(const glm::ivec2& window);

} // namespace gg::detail
