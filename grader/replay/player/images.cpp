#include "replay/gl_state.hpp"
#include "replay/player/objects.hpp"

#include <array>
#include <stdexcept>

namespace ggrade::player {

namespace {

struct Level {
  GLint level, format;
  GLsizei width, height, depth;
  GLenum dataFormat, dataType;
  const void* data;
  std::size_t bytes; ///< of the data
};

/// Of a texel as it leaves OpenGL; 0: none that tapes have.
std::size_t texelBytes(GLenum format, GLenum type) {
  std::size_t channels = 1;
  if (format == GL_RGBA || format == GL_RGBA_INTEGER) channels = 4;
  switch (type) {
  case GL_UNSIGNED_BYTE:
  case GL_BYTE:
    return channels;
  case GL_UNSIGNED_SHORT:
  case GL_SHORT:
  case GL_HALF_FLOAT:
    return 2 * channels;
  case GL_UNSIGNED_INT:
  case GL_INT:
  case GL_FLOAT:
    return 4 * channels;
  case GL_UNSIGNED_INT_24_8:
    return 4;
  case GL_FLOAT_32_UNSIGNED_INT_24_8_REV:
    return 8;
  default:
    return 0;
  }
}

Level levelOf(const tape::Tape& tape, const json& one) {
  Level level{one.at("level"),  one.at("format"), one.at("width"),
              one.at("height"), one.at("depth"),  GL_RGBA,
              GL_UNSIGNED_BYTE, nullptr,          0};
  if (level.width < 0 || level.height < 0 || level.depth < 0 || level.width > 16384 ||
      level.height > 16384 || level.depth > 2048)
    throw std::runtime_error("a texture's level is of no possible size");
  if (!one.contains("data")) return level;
  const json& data = one["data"];
  level.dataFormat = data.at("format");
  level.dataType = data.at("type");
  const std::vector<std::byte>& bytes = blobOf(tape, data.at("blob"));
  level.data = bytes.data();
  level.bytes = bytes.size();
  return level;
}

/// The data of all layers (or faces) is there.
void require(const Level& level, std::size_t layers) {
  const std::size_t texel = texelBytes(level.dataFormat, level.dataType);
  if (level.data && (texel == 0 || level.bytes != texel * std::size_t(level.width) *
                                                      std::size_t(level.height) * layers))
    throw std::runtime_error("a texture's level has not as many bytes as texels");
}

void defineLevel(GLenum target, const Level& at, const json& one) {
  if (const GLsizei samples = one.value("samples", 0); samples > 0) {
    const GLboolean fixed = one.value("fixedSamples", true);
    if (target == GL_TEXTURE_2D_MULTISAMPLE)
      gl().texImage2DMultisample(target, samples, GLenum(at.format), at.width, at.height, fixed);
    else
      gl().texImage3DMultisample(target, samples, GLenum(at.format), at.width, at.height, at.depth,
                                 fixed);
    return;
  }
  switch (target) {
  case GL_TEXTURE_1D:
    require(at, 1);
    gl().texImage1D(target, at.level, at.format, at.width, 0, at.dataFormat, at.dataType, at.data);
    break;
  case GL_TEXTURE_2D:
  case GL_TEXTURE_RECTANGLE:
  case GL_TEXTURE_1D_ARRAY:
    require(at, 1);
    gl().texImage2D(target, at.level, at.format, at.width, at.height, 0, at.dataFormat, at.dataType,
                    at.data);
    break;
  case GL_TEXTURE_CUBE_MAP: {
    require(at, 6);
    const std::size_t face = at.bytes / 6;
    for (GLenum i = 0; i < 6; ++i)
      gl().texImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, at.level, at.format, at.width, at.height,
                      0, at.dataFormat, at.dataType,
                      at.data ? static_cast<const std::byte*>(at.data) + i * face : nullptr);
    break;
  }
  case GL_TEXTURE_3D:
  case GL_TEXTURE_2D_ARRAY:
  case GL_TEXTURE_CUBE_MAP_ARRAY:
    require(at, std::size_t(at.depth));
    gl().texImage3D(target, at.level, at.format, at.width, at.height, at.depth, 0, at.dataFormat,
                    at.dataType, at.data);
    break;
  default:
    throw std::runtime_error("a texture of a kind that can't be made");
  }
}

} // namespace

const std::vector<std::byte>& blobOf(const tape::Tape& tape, const json& number) {
  const auto at = number.get<std::uint64_t>();
  if (at >= tape.blobs.size()) throw std::runtime_error("no such blob");
  return tape.blobs[at];
}

void applyOwnParameters(GLenum target, const json& parameters) {
  for (const auto& [name, parameter] : tape::kTextureOwn)
    gl().texParameteri(target, parameter, parameters.at(name));
  if (const GLint mode = parameters.value("depthStencilMode", 0); mode != 0)
    gl().texParameteri(target, GL_DEPTH_STENCIL_TEXTURE_MODE, mode);
}

void applyParameters(GLenum target, const json& parameters) {
  applyOwnParameters(target, parameters);
  if (!parameters.contains("minFilter")) return; // multisampled
  for (const auto& [name, parameter] : tape::kSampling)
    if (target != GL_TEXTURE_RECTANGLE || parameter != GL_TEXTURE_WRAP_R)
      gl().texParameteri(target, parameter, parameters.at(name));
  for (const auto& [name, parameter] : tape::kSamplingFloats)
    gl().texParameterf(target, parameter, parameters.at(name));
  const auto border = parameters.at("borderColor").get<std::array<GLfloat, 4>>();
  gl().texParameterfv(target, GL_TEXTURE_BORDER_COLOR, border.data());
}

void Images::defineTexture(Image& image, const json& command) {
  const GLenum target = command.at("target");
  if (image.name && (!image.isTexture || image.target != target)) image = {};
  image.isTexture = true;
  image.target = target;
  if (!image.name) gl().genTextures(1, &image.name);
  gl().activeTexture(GL_TEXTURE0);
  gl().bindTexture(target, image.name);
  for (const json& one : command.at("levels")) defineLevel(target, levelOf(tape_, one), one);
  if (command.contains("parameters")) applyParameters(target, command["parameters"]);
}

void Images::define(const json& command) {
  Image& image = images_[command.at("id").get<std::uint64_t>()];
  if (command.at("kind") == "texture") return defineTexture(image, command);
  if (image.isTexture) image = {};
  image.isTexture = false;
  if (!image.name) gl().genRenderbuffers(1, &image.name);
  gl().bindRenderbuffer(GL_RENDERBUFFER, image.name);
  gl().renderbufferStorageMultisample(GL_RENDERBUFFER, command.at("samples"), command.at("format"),
                                      command.at("width"), command.at("height"));
}

const Images::Image& Images::at(const json& id) const {
  const auto found = images_.find(id.get<std::uint64_t>());
  if (found == images_.end()) throw std::runtime_error("an image that was never defined");
  return found->second;
}

void Images::forget() {
  for (const auto& [id, image] : images_) {
    if (image.isTexture)
      gl().deleteTextures(1, &image.name);
    else
      gl().deleteRenderbuffers(1, &image.name);
  }
  images_.clear();
}

void Framebuffers::forget() {
  for (const auto& [key, framebuffer] : framebuffers_) gl().deleteFramebuffers(1, &framebuffer);
  framebuffers_.clear();
}

GLuint Framebuffers::of(const json& attachments) {
  std::string key = attachments.dump();
  for (const auto& [name, one] : attachments.items())
    key += ' ' + std::to_string(images_.at(one.at("image")).name);
  const auto [at, isNew] = framebuffers_.try_emplace(key, 0);
  GLuint& framebuffer = at->second;
  if (!isNew) return framebuffer;
  gl().genFramebuffers(1, &framebuffer);
  gl().bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  for (const auto& [name, one] : attachments.items()) {
    const GLenum point = name == "depth"     ? GL_DEPTH_ATTACHMENT
                         : name == "stencil" ? GL_STENCIL_ATTACHMENT
                                             : GL_COLOR_ATTACHMENT0 + GLenum(name.at(5) - '0');
    const Images::Image& image = images_.at(one.at("image"));
    if (!image.isTexture) {
      gl().framebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, image.name);
      continue;
    }
    const GLint level = one.value("level", 0);
    if (!one.contains("layer"))
      gl().framebufferTexture(GL_FRAMEBUFFER, point, image.name, level);
    else if (image.target == GL_TEXTURE_CUBE_MAP)
      gl().framebufferTexture2D(GL_FRAMEBUFFER, point,
                                GL_TEXTURE_CUBE_MAP_POSITIVE_X + one["layer"].get<GLenum>(),
                                image.name, level);
    else
      gl().framebufferTextureLayer(GL_FRAMEBUFFER, point, image.name, level, one["layer"]);
  }
  return framebuffer;
}

void Framebuffers::bindDraw(const json& target) {
  if (target.value("window", false)) {
    gl().bindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl().drawBuffer(target.value("drawBuffer", true) ? GL_BACK : GL_NONE);
    return;
  }
  gl().bindFramebuffer(GL_DRAW_FRAMEBUFFER, of(target.at("attachments")));
  std::vector<GLenum> buffers;
  for (const json& at : target.at("drawBuffers"))
    buffers.push_back(at.is_null() ? GL_NONE : GL_COLOR_ATTACHMENT0 + at.get<GLenum>());
  if (buffers.empty()) buffers.push_back(GL_NONE);
  if (buffers.size() > 8) throw std::runtime_error("more than 8 draw buffers");
  gl().drawBuffers(GLsizei(buffers.size()), buffers.data());
}

void Framebuffers::bindRead(const json& from) {
  if (from.value("window", false)) {
    gl().bindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    gl().readBuffer(GL_BACK);
    return;
  }
  gl().bindFramebuffer(GL_READ_FRAMEBUFFER, of(from.at("attachments")));
  const json& buffer = from.at("readBuffer");
  gl().readBuffer(buffer.is_null() ? GL_NONE : GL_COLOR_ATTACHMENT0 + buffer.get<GLenum>());
}

GLuint Buffers::at(const json& blob) {
  const auto [at, isNew] = buffers_.try_emplace(blob.get<std::uint64_t>(), 0);
  if (!isNew) return at->second;
  const std::vector<std::byte>& bytes = blobOf(tape_, blob);
  gl().genBuffers(1, &at->second);
  gl().bindBuffer(GL_ARRAY_BUFFER, at->second);
  gl().bufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  return at->second;
}

} // namespace ggrade::player
