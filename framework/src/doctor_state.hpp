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

/// A uniform of a linked program; of an array, its first element.
struct ActiveUniform {
  std::string name;
  GLenum type;
  GLint location; ///< -1: of a uniform block
};
using ActiveUniforms = std::vector<ActiveUniform>;
ActiveUniforms activeUniforms(GLuint program);

/// A texture that reads as black, and a sentence that says why.
struct TextureFault {
  GLuint texture; ///< whose own settings are wrong; 0: those of a sampler object
  std::string text;
};

/// What is wrong with the textures that a program's samplers read.
struct SamplerFaults {
  std::vector<TextureFault> certain; ///< incomplete textures
  std::vector<std::string>
      perhaps; ///< none, or one without storage: the shader need not ask for it
};
SamplerFaults samplerFaults(GLuint program, const ActiveUniforms& uniforms);

/// A sampler that may read what is drawn into at the same time.
struct FeedbackLoop {
  std::string sampler;
  GLint unit;
  std::string attachment; ///< "GL_COLOR_ATTACHMENT0"
};

/// The first feedback loop of a draw call with this program as the state is now, if the sampler is
/// ever read ("even if the instructions might only be executed conditionally", OpenGL 4.1, 4.4.3).
/// Of 2D textures only. An attachment that isn't written (draw buffers, masks, no depth test) makes
/// none, as in later versions of OpenGL.
std::optional<FeedbackLoop> feedbackLoop(GLuint program, const ActiveUniforms& uniforms);

/// The float, vector and matrix uniforms of a program that are all 0, with their locations.
std::map<std::string, GLint> zeroUniforms(GLuint program, const ActiveUniforms& uniforms);

/// The names of the square matrices that hold NaN or infinity.
std::vector<std::string> nonFiniteMatrices(GLuint program, const ActiveUniforms& uniforms);

/// The window's back buffer. Empty if a buffer object is bound that would take it instead.
Image windowPicture(const glm::ivec2& window);

} // namespace gg::detail
