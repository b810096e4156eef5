#pragma once
/// \file
/// The OpenGL objects of a tape that is played: made when a command first names them.

#include "replay/player/gl.hpp"
#include "replay/tape.hpp"

#include <map>
#include <string>

namespace ggrade::player {

using nlohmann::json;

/// Textures and renderbuffers by the numbers that the tape gives them.
class Images {
public:
  explicit Images(const tape::Tape& tape) : tape_(tape) {}
  /// As the command `image` says: what was there before is lost.
  void define(const json& command);
  struct Image {
    bool isTexture = true;
    GLenum target = GL_TEXTURE_2D;
    GLuint name = 0;
  };
  /// Throws for a number that no command has defined.
  const Image& at(const json& id) const;
  /// Deletes them all: what is defined next holds nothing of what these held.
  void forget();

private:
  void defineTexture(Image& image, const json& command);
  const tape::Tape& tape_;
  std::map<std::uint64_t, Image> images_;
};

/// Framebuffer objects by what is attached to them.
class Framebuffers {
public:
  explicit Framebuffers(const Images& images) : images_(images) {}
  /// Binds what a command's "target" or "from" says.
  void bindDraw(const json& target);
  void bindRead(const json& from);
  /// Deletes them all.
  void forget();

private:
  GLuint of(const json& attachments);
  const Images& images_;
  std::map<std::string, GLuint> framebuffers_;
};

/// Buffers by their blob.
class Buffers {
public:
  explicit Buffers(const tape::Tape& tape) : tape_(tape) {}
  GLuint at(const json& blob);

private:
  const tape::Tape& tape_;
  std::map<std::uint64_t, GLuint> buffers_;
};

/// Programs by their definition.
class Programs {
public:
  explicit Programs(const tape::Tape& tape) : tape_(tape) {}
  /// 0: it doesn't link, as it didn't when the tape was made, or since it was changed.
  GLuint at(const json& definition);

private:
  const tape::Tape& tape_;
  std::map<std::string, GLuint> programs_;
};

/// Of the texture that is bound to the target: what is its own in any case, and all of how it is
/// sampled without a sampler object.
void applyOwnParameters(GLenum target, const json& parameters);
void applyParameters(GLenum target, const json& parameters);

/// What "state" of a command says.
void applyState(const json& state);

/// Sets the uniform that the used program has at this location. \param values of all elements
void setUniform(GLint location, GLenum type, const json& values);

/// The blob of that number; throws where there is none.
const std::vector<std::byte>& blobOf(const tape::Tape& tape, const json& number);

} // namespace ggrade::player
