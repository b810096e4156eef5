#pragma once
/// \file
/// What the framework draws over the program's picture: text, and textures of the frame.

#include <memory>
#include <string>
#include <vector>

#include "doctor_state.hpp"
#include <gg/handle.hpp>
#include <glm/vec2.hpp>

namespace gg::detail {

/// A texture that a frame drew into.
struct Attachment {
  GLuint framebuffer;
  std::string name; ///< "colour 0", "depth"
  GLuint texture;   ///< 2D
  GLint level;
};

/// Of these framebuffer objects, in this order; each level of a texture once, 2D textures only.
std::vector<Attachment> attachmentsOf(const std::vector<GLuint>& framebuffers,
                                      const TextureTargets& targets);

/// Draws into the window's back buffer. What its functions change of OpenGL's state they put back.
class Overlay {
public:
  Overlay();

  /// Text in the upper left corner, as wide as the window at most; `scale` times 6 x 9 pixels a
  /// character.
  void text(const glm::ivec2& window, const std::string& text, int scale);

  /// All these textures, and the window's picture first, side by side, each with its name, size and
  /// format. High range is shown as x / (1 + x). Depth is shown in even steps of distance: black is
  /// the nearest that was drawn, white the farthest and what was only cleared.
  void tiles(const glm::ivec2& window, const std::vector<Attachment>& attachments);

private:
  enum class Shown { asIs, highRange, depth, whole };
  void draw(GLuint texture, GLint level, Shown shown, const glm::ivec2& corner,
            const glm::ivec2& size);
  /// Returns its height, pixels.
  int drawText(const glm::ivec2& window, const glm::ivec2& topLeft, const std::string& text,
               int scale, int width);

  Handle<ProgramTraits> program_;
  VertexArray noVertices_;
  Sampler sampler_;
  Texture text_, picture_;
};

} // namespace gg::detail
