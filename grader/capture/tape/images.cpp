// Images: what they hold when a tape begins to use them, and what is drawn into or sampled.

#include "capture/channel_writer.hpp"
#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/pixel_state.hpp"
#include "capture/tape/objects.hpp"
#include "capture/tape/writer.hpp"
#include "replay/gl_state.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace ggrade::capture::tape {

using nlohmann::json;
using recorder::gl;
using recorder::levelParameter;
using recorder::number;
using recorder::textureParameter;
using trace::ImageKind;

namespace {

constexpr std::uint32_t kMaxLevels = 16;

struct Known {
  std::uint32_t id;
  bool isWritten; ///< what it holds stands on the tape, or comes from its commands
};

struct Images {
  std::map<std::pair<ImageKind, GLuint>, Known> known;
  std::uint32_t next = 0; ///< a name that is given again gets another number
};

/// Of all images that were used. Never destroyed, as the writer.
Images& images() {
  static auto* const all = new Images;
  return *all;
}

struct Texels {
  GLenum format = 0, type = 0;
  std::uint64_t bytes = 0; ///< of a texel
};

/// How a level's texels leave and enter OpenGL without a change.
Texels texelsOf(GLuint texture, std::uint32_t level) {
  const auto ask = [&](GLenum name) { return levelParameter(texture, level, name); };
  const GLint depth = ask(GL_TEXTURE_DEPTH_SIZE), stencil = ask(GL_TEXTURE_STENCIL_SIZE);
  if (depth > 0) {
    const bool isFloat = ask(GL_TEXTURE_DEPTH_TYPE) == GL_FLOAT;
    if (stencil > 0 && isFloat) return {GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, 8};
    if (stencil > 0) return {GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 4};
    if (isFloat) return {GL_DEPTH_COMPONENT, GL_FLOAT, 4};
    if (depth <= 16) return {GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 2};
    return {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4};
  }
  if (stencil > 0) return {GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1};
  GLint bits = 0;
  GLint type = GL_NONE;
  for (const auto& [size, kind] : {std::pair(GL_TEXTURE_RED_SIZE, GL_TEXTURE_RED_TYPE),
                                   std::pair(GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_GREEN_TYPE),
                                   std::pair(GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_BLUE_TYPE),
                                   std::pair(GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_ALPHA_TYPE)}) {
    const GLint channel = ask(size);
    bits = std::max(bits, channel);
    if (channel > 0 && type == GL_NONE) type = ask(kind);
  }
  switch (type) {
  case GL_INT:
    return {GL_RGBA_INTEGER, GL_INT, 16};
  case GL_UNSIGNED_INT:
    return {GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16};
  case GL_FLOAT:
    return bits <= 16 ? Texels{GL_RGBA, GL_HALF_FLOAT, 8} : Texels{GL_RGBA, GL_FLOAT, 16};
  case GL_UNSIGNED_NORMALIZED:
    return bits <= 8 ? Texels{GL_RGBA, GL_UNSIGNED_BYTE, 4} : Texels{GL_RGBA, GL_UNSIGNED_SHORT, 8};
  case GL_SIGNED_NORMALIZED:
    return bits <= 8 ? Texels{GL_RGBA, GL_BYTE, 4} : Texels{GL_RGBA, GL_SHORT, 8};
  default:
    return {};
  }
}

json levelJson(GLuint texture, GLenum target, std::uint32_t level) {
  const auto ask = [&](GLenum name) { return levelParameter(texture, level, name); };
  const std::uint64_t width = std::uint64_t(ask(GL_TEXTURE_WIDTH)),
                      height = std::uint64_t(ask(GL_TEXTURE_HEIGHT)),
                      depth = std::uint64_t(ask(GL_TEXTURE_DEPTH));
  const GLint samples = ask(GL_TEXTURE_SAMPLES);
  json one = {{"level", level}, {"format", ask(GL_TEXTURE_INTERNAL_FORMAT)},
              {"width", width}, {"height", height},
              {"depth", depth}, {"samples", samples}};
  if (samples > 0) {
    one["fixedSamples"] = ask(GL_TEXTURE_FIXED_SAMPLE_LOCATIONS) != 0;
    return one; // nothing but commands fills it
  }
  if (ask(GL_TEXTURE_COMPRESSED)) refuse("samples a compressed texture");
  const Texels texels = texelsOf(texture, level);
  if (!texels.format) refuse("uses a texture of a kind that can't be read back");
  const std::uint64_t layers = target == GL_TEXTURE_CUBE_MAP ? 6 : depth;
  const std::uint64_t bytes = width * height * layers * texels.bytes;
  if (bytes > plan()->trace.tapeBytes) refuse("uses a texture larger than a tape has room for");
  if (!isOpen()) return one;
  std::vector<std::byte> data(bytes);
  gl().getTextureSubImage(texture, static_cast<GLint>(level), 0, 0, 0, static_cast<GLsizei>(width),
                          static_cast<GLsizei>(height), static_cast<GLsizei>(layers), texels.format,
                          texels.type, static_cast<GLsizei>(bytes), data.data());
  if (gl().getError() != GL_NO_ERROR) refuse("uses a texture that can't be read back");
  one["data"] = {{"format", texels.format}, {"type", texels.type}, {"blob", blob(data)}};
  return one;
}

bool isMultisampled(GLenum target) {
  return target == GL_TEXTURE_2D_MULTISAMPLE || target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY;
}

/// How a texture is sampled: its own parameters, and those of the sampler object if there is one.
json parametersJson(GLuint texture, GLenum target, GLuint sampler) {
  json one = json::object();
  for (const auto& [name, parameter] : ggrade::tape::kTextureOwn)
    one[name] = textureParameter(texture, parameter);
  one["depthStencilMode"] = textureParameter(texture, GL_DEPTH_STENCIL_TEXTURE_MODE);
  if (isMultisampled(target)) return one;
  const auto askInteger = [&](GLenum name) {
    GLint value = 0;
    if (sampler)
      gl().getSamplerParameteriv(sampler, name, &value);
    else
      value = textureParameter(texture, name);
    return value;
  };
  const auto askFloats = [&](GLenum name, GLfloat* values) {
    if (sampler)
      gl().getSamplerParameterfv(sampler, name, values);
    else
      gl().getTextureParameterfv(texture, name, values);
  };
  for (const auto& [name, parameter] : ggrade::tape::kSampling) one[name] = askInteger(parameter);
  for (const auto& [name, parameter] : ggrade::tape::kSamplingFloats) {
    GLfloat value = 0;
    askFloats(parameter, &value);
    one[name] = value;
  }
  GLfloat border[4] = {};
  askFloats(GL_TEXTURE_BORDER_COLOR, border);
  one["borderColor"] = border;
  while (gl().getError() != GL_NO_ERROR) {
  }
  return one;
}

json textureDefinition(GLuint texture, GLenum target) {
  if (target == GL_TEXTURE_BUFFER) refuse("samples a buffer texture");
  json levels = json::array();
  const recorder::PixelState neutral(recorder::PixelDirection::pack);
  for (std::uint32_t level = 0; level < kMaxLevels && isOpen(); ++level)
    if (levelParameter(texture, level, GL_TEXTURE_WIDTH) > 0)
      levels.push_back(levelJson(texture, target, level));
  return {{"target", target},
          {"levels", levels},
          {"parameters", parametersJson(texture, target, 0)},
          {"immutable", textureParameter(texture, GL_TEXTURE_IMMUTABLE_FORMAT) != 0}};
}

json renderbufferDefinition(GLuint renderbuffer) {
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    gl().getNamedRenderbufferParameteriv(renderbuffer, name, &value);
    return value;
  };
  return {{"format", ask(GL_RENDERBUFFER_INTERNAL_FORMAT)},
          {"width", ask(GL_RENDERBUFFER_WIDTH)},
          {"height", ask(GL_RENDERBUFFER_HEIGHT)},
          {"samples", ask(GL_RENDERBUFFER_SAMPLES)}};
}

GLenum targetOf(GLuint texture, GLenum otherwise) {
  const GLint target = textureParameter(texture, GL_TEXTURE_TARGET);
  while (gl().getError() != GL_NO_ERROR) {
  }
  return target > 0 ? static_cast<GLenum>(target) : otherwise;
}

/// \param define false: the command that follows says what it is
std::uint32_t use(ImageKind kind, GLuint name, GLenum target, bool define) {
  const auto [at, isNew] = images().known.try_emplace({kind, name}, Known{images().next, false});
  Known& known = at->second;
  if (isNew) ++images().next;
  if (known.isWritten) return known.id;
  known.isWritten = true;
  json image = {{"op", "image"}, {"id", known.id}};
  if (kind == ImageKind::renderbuffer) {
    image["kind"] = "renderbuffer";
    image.update(renderbufferDefinition(name));
  } else {
    image["kind"] = "texture";
    if (define)
      image.update(textureDefinition(name, targetOf(name, target)));
    else
      image.update(json{{"target", target}, {"levels", json::array()}, {"immutable", false}});
  }
  command(image);
  return known.id;
}

json attachmentJson(const trace::ImageRef& image) {
  const auto kind = static_cast<ImageKind>(image.kind);
  if (kind == ImageKind::none) return nullptr;
  json one = {{"image", useImage(kind, image.name)}};
  if (kind == ImageKind::texture) {
    one["level"] = image.level;
    if (image.layer != trace::kNone) one["layer"] = image.layer;
  }
  return one;
}

} // namespace

std::uint32_t useImage(ImageKind kind, GLuint name, GLenum target) {
  return use(kind, name, target, true);
}

std::uint32_t useUndefined(GLuint texture, GLenum target) {
  return use(ImageKind::texture, texture, target, false);
}

void imageChanged(ImageKind kind, GLuint name) {
  if (const auto found = images().known.find({kind, name}); found != images().known.end())
    found->second.isWritten = false;
}

void imageDeleted(ImageKind kind, GLuint name) {
  images().known.erase({kind, name});
}

json targetJson(const recorder::Target& target) {
  json buffers = json::array();
  if (!target.framebuffer)
    return {{"window", true}, {"drawBuffer", target.attachmentOfBuffer[0] != trace::kNone}};
  std::uint32_t last = 0;
  for (std::uint32_t i = 0; i < trace::kColors; ++i)
    if (target.attachmentOfBuffer[i] != trace::kNone) last = i + 1;
  for (std::uint32_t i = 0; i < last; ++i) {
    const std::uint32_t at = target.attachmentOfBuffer[i];
    buffers.push_back(at == trace::kNone ? json(nullptr) : json(at));
  }
  json attachments = json::object();
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i) {
    const std::string name = i == trace::kDepth     ? "depth"
                             : i == trace::kStencil ? "stencil"
                                                    : "color" + std::to_string(i);
    if (const json one = attachmentJson(target.images[i]); !one.is_null()) attachments[name] = one;
  }
  return {{"attachments", attachments}, {"drawBuffers", buffers}};
}

json readTargetJson() {
  const GLuint framebuffer = number(GL_READ_FRAMEBUFFER_BINDING);
  if (!framebuffer) return {{"window", true}};
  recorder::Target target;
  target.framebuffer = framebuffer;
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i)
    target.images[i] = recorder::attachedImage(GL_READ_FRAMEBUFFER, framebuffer, i);
  std::fill_n(target.attachmentOfBuffer, trace::kColors, trace::kNone);
  json from = targetJson(target);
  const std::uint32_t buffer = recorder::attachmentOf(integer(GL_READ_BUFFER));
  from["readBuffer"] = buffer == trace::kNone ? json(nullptr) : json(buffer);
  return from;
}

json textureJson(GLenum target, GLuint unit) {
  gl().activeTexture(GL_TEXTURE0 + unit);
  json one = {{"unit", unit}, {"target", target}};
  const GLuint texture = recorder::boundTexture(target);
  if (!texture) return one;
  one["image"] = useImage(ImageKind::texture, texture, target);
  const GLuint sampler = number(GL_SAMPLER_BINDING);
  if (sampler) one["samplerObject"] = true;
  one.update(parametersJson(texture, target, sampler));
  return one;
}

} // namespace ggrade::capture::tape
