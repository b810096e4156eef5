#include "doctor_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "words/words.hpp"

namespace gg::detail {

GLint ask(GLenum name) {
  GLint value = 0;
  glad_glGetIntegerv(name, &value);
  return value;
}

std::string errorName(GLenum error) {
  switch (error) {
  case GL_INVALID_ENUM:
    return say("GL_INVALID_ENUM (a constant that the function doesn't know)");
  case GL_INVALID_VALUE:
    return say("GL_INVALID_VALUE (a number out of range)");
  case GL_INVALID_OPERATION:
    return say("GL_INVALID_OPERATION (not allowed in the present state)");
  case GL_INVALID_FRAMEBUFFER_OPERATION:
    return say("GL_INVALID_FRAMEBUFFER_OPERATION (the framebuffer object is not complete)");
  case GL_OUT_OF_MEMORY:
    return "GL_OUT_OF_MEMORY";
  default:
    return say("an unknown error");
  }
}

std::string incompleteness() {
  switch (glad_glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER)) {
  case GL_FRAMEBUFFER_COMPLETE:
    return "";
  case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
    return say("an attachment has no storage (glTexImage2D, glRenderbufferStorage), or a format "
               "that can't be drawn into");
  case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
    return say("nothing is attached to it");
  case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER:
  case GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER:
    return say("glDrawBuffer(s) or glReadBuffer names an attachment that isn't there; without any "
               "colour both must be GL_NONE");
  case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
    return say("its attachments have different numbers of samples");
  default:
    return say("this driver can't draw into such a combination of formats");
  }
}

namespace {

GLint askAttachment(GLenum attachment, GLenum name) {
  GLint value = 0;
  glad_glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
  return value;
}

glm::ivec2 textureSize(GLuint texture, GLint level) {
  const GLint before = ask(GL_TEXTURE_BINDING_2D);
  glad_glBindTexture(GL_TEXTURE_2D, texture);
  glm::ivec2 size(0);
  glad_glGetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH, &size.x);
  glad_glGetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_HEIGHT, &size.y);
  glad_glBindTexture(GL_TEXTURE_2D, GLuint(before));
  return size;
}

glm::ivec2 renderbufferSize(GLuint renderbuffer) {
  const GLint before = ask(GL_RENDERBUFFER_BINDING);
  glad_glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  glm::ivec2 size(0);
  glad_glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &size.x);
  glad_glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &size.y);
  glad_glBindRenderbuffer(GL_RENDERBUFFER, GLuint(before));
  return size;
}

} // namespace

glm::ivec2 framebufferSize(const TextureTargets& targets) {
  constexpr GLenum kAttachments[] = {GL_COLOR_ATTACHMENT0,     GL_COLOR_ATTACHMENT0 + 1,
                                     GL_COLOR_ATTACHMENT0 + 2, GL_COLOR_ATTACHMENT0 + 3,
                                     GL_DEPTH_ATTACHMENT,      GL_STENCIL_ATTACHMENT};
  for (const GLenum attachment : kAttachments) {
    const GLint type = askAttachment(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
    if (type == GL_NONE) continue;
    const auto name =
        static_cast<GLuint>(askAttachment(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    if (type == GL_RENDERBUFFER) return renderbufferSize(name);
    const auto target = targets.find(name);
    if (target != targets.end() && target->second == GL_TEXTURE_2D)
      return textureSize(name, askAttachment(attachment, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL));
  }
  return {0, 0};
}

bool hasDepth() {
  const bool window = ask(GL_DRAW_FRAMEBUFFER_BINDING) == 0;
  return askAttachment(window ? GL_DEPTH : GL_DEPTH_ATTACHMENT,
                       GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
}

bool lacksColor() {
  bool isNamed = false;
  for (GLint i = 0; i < ask(GL_MAX_DRAW_BUFFERS); ++i) {
    const GLint buffer = ask(GL_DRAW_BUFFER0 + GLenum(i));
    if (buffer == GL_NONE) continue;
    isNamed = true;
    if (askAttachment(GLenum(buffer), GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE)
      return false;
  }
  return isNamed;
}

namespace {

bool isSampler2D(GLenum type) {
  return type == GL_SAMPLER_2D || type == GL_SAMPLER_2D_SHADOW || type == GL_INT_SAMPLER_2D ||
         type == GL_UNSIGNED_INT_SAMPLER_2D;
}

bool wantsMipmaps(GLint filter) {
  return filter != GL_NEAREST && filter != GL_LINEAR;
}

GLint askTexture(GLenum name) {
  GLint value = 0;
  glad_glGetTexParameteriv(GL_TEXTURE_2D, name, &value);
  return value;
}

struct Filters {
  GLint minification, magnification;
};

// By which the active unit's 2D texture is read.
Filters filters() {
  Filters found{askTexture(GL_TEXTURE_MIN_FILTER), askTexture(GL_TEXTURE_MAG_FILTER)};
  if (const GLint sampler = ask(GL_SAMPLER_BINDING); sampler != 0) {
    glad_glGetSamplerParameteriv(GLuint(sampler), GL_TEXTURE_MIN_FILTER, &found.minification);
    glad_glGetSamplerParameteriv(GLuint(sampler), GL_TEXTURE_MAG_FILTER, &found.magnification);
  }
  return found;
}

// Why the 2D texture of the active unit reads as black; empty if it doesn't.
std::string textureFault(GLenum samplerType) {
  const auto texture = static_cast<GLuint>(ask(GL_TEXTURE_BINDING_2D));
  const GLint base = askTexture(GL_TEXTURE_BASE_LEVEL);
  const glm::ivec2 size = textureSize(texture, base);
  const auto [minFilter, magFilter] = filters();
  if (wantsMipmaps(minFilter) && std::max(size.x, size.y) > 1 &&
      askTexture(GL_TEXTURE_MAX_LEVEL) > base && textureSize(texture, base + 1).x == 0)
    return ask(GL_SAMPLER_BINDING) == 0
               ? say("is incomplete: its filter wants mipmaps, and it has none. Set "
                     "GL_TEXTURE_MIN_FILTER to GL_NEAREST or GL_LINEAR")
               : say("has no mipmaps, and the sampler object of this unit wants them. Set its "
                     "GL_TEXTURE_MIN_FILTER to GL_NEAREST or GL_LINEAR (glSamplerParameteri)");
  const bool integers =
      samplerType == GL_INT_SAMPLER_2D || samplerType == GL_UNSIGNED_INT_SAMPLER_2D;
  if (integers && (magFilter != GL_NEAREST ||
                   (minFilter != GL_NEAREST && minFilter != GL_NEAREST_MIPMAP_NEAREST)))
    return say("is incomplete: it holds whole numbers, which can't be filtered. Set both filters "
               "to GL_NEAREST");
  return "";
}

} // namespace

ActiveUniforms activeUniforms(GLuint program) {
  ActiveUniforms uniforms;
  GLint count = 0;
  if (program != 0) glad_glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i) {
    char name[256];
    GLint size = 0;
    GLenum type = 0;
    glad_glGetActiveUniform(program, GLuint(i), sizeof(name), nullptr, &size, &type, name);
    uniforms.push_back({name, type, glad_glGetUniformLocation(program, name)});
  }
  return uniforms;
}

namespace {

// Calls look(uniform, unit) for each 2D sampler, while the texture unit that it reads is active.
template <class Look>
void eachSampler2D(GLuint program, const ActiveUniforms& uniforms, Look look) {
  const GLint unitBefore = ask(GL_ACTIVE_TEXTURE);
  for (const ActiveUniform& uniform : uniforms) {
    if (!isSampler2D(uniform.type)) continue;
    GLint unit = 0;
    glad_glGetUniformiv(program, uniform.location, &unit);
    glad_glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    look(uniform, unit);
  }
  glad_glActiveTexture(GLenum(unitBefore));
}

} // namespace

SamplerFaults samplerFaults(GLuint program, const ActiveUniforms& uniforms) {
  SamplerFaults faults;
  eachSampler2D(program, uniforms, [&](const ActiveUniform& sampler, GLint unit) {
    const auto texture = static_cast<GLuint>(ask(GL_TEXTURE_BINDING_2D));
    if (texture == 0) {
      faults.perhaps.push_back(
          say("sampler {} reads texture unit {}, where no texture is bound: it reads black",
              sampler.name, unit));
    } else if (textureSize(texture, askTexture(GL_TEXTURE_BASE_LEVEL)).x == 0) {
      faults.perhaps.push_back(say("sampler {} reads texture unit {}, where the texture has no "
                                   "storage (glTexImage2D): it reads black",
                                   sampler.name, unit));
    } else if (const std::string fault = textureFault(sampler.type); !fault.empty()) {
      faults.certain.push_back(
          {ask(GL_SAMPLER_BINDING) == 0 ? texture : 0,
           say("sampler {} reads texture unit {}, where the texture reads as black: it {}",
               sampler.name, unit, fault)});
    }
  });
  return faults;
}

namespace {

struct WrittenTexture {
  GLuint texture;
  GLint level;
  std::string attachment;
};

// The textures that a draw call would write now.
std::vector<WrittenTexture> writtenTextures() {
  std::vector<WrittenTexture> all;
  if (ask(GL_DRAW_FRAMEBUFFER_BINDING) == 0) return all;
  const auto add = [&](GLenum attachment, const std::string& name) {
    if (askAttachment(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE) return;
    all.push_back({GLuint(askAttachment(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)),
                   askAttachment(attachment, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL), name});
  };
  for (GLint i = 0; i < ask(GL_MAX_DRAW_BUFFERS); ++i) {
    const GLint buffer = ask(GL_DRAW_BUFFER0 + GLenum(i));
    GLboolean mask[4] = {};
    glad_glGetBooleani_v(GL_COLOR_WRITEMASK, GLuint(i), mask);
    if (buffer != GL_NONE && std::ranges::find(mask, GL_TRUE) != std::end(mask))
      add(GLenum(buffer), fmt::format("GL_COLOR_ATTACHMENT{}", buffer - GL_COLOR_ATTACHMENT0));
  }
  if (glad_glIsEnabled(GL_DEPTH_TEST) == GL_TRUE && ask(GL_DEPTH_WRITEMASK) == GL_TRUE)
    add(GL_DEPTH_ATTACHMENT, "GL_DEPTH_ATTACHMENT");
  return all;
}

// May a sampler read this level of the active unit's 2D texture?
bool readsLevel(GLint level) {
  const GLint base = askTexture(GL_TEXTURE_BASE_LEVEL);
  return level == base || (wantsMipmaps(filters().minification) && level > base &&
                           level <= askTexture(GL_TEXTURE_MAX_LEVEL));
}

} // namespace

std::optional<FeedbackLoop> feedbackLoop(GLuint program, const ActiveUniforms& uniforms) {
  const std::vector<WrittenTexture> written = writtenTextures();
  std::optional<FeedbackLoop> loop;
  if (written.empty()) return loop;
  eachSampler2D(program, uniforms, [&](const ActiveUniform& sampler, GLint unit) {
    const auto texture = static_cast<GLuint>(ask(GL_TEXTURE_BINDING_2D));
    for (const WrittenTexture& target : written)
      if (!loop && target.texture == texture && readsLevel(target.level))
        loop = {sampler.name, unit, target.attachment};
  });
  return loop;
}

namespace {

// GLSL without its comments (GLSL 4.10, 3.3).
std::string withoutComments(std::string_view text) {
  std::string code;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    const std::string_view end = rest.starts_with("//") ? "\n" : rest.starts_with("/*") ? "*/" : "";
    if (end.empty()) {
      code += text[i++];
    } else {
      const std::size_t close = text.find(end, i + 2);
      i = close == text.npos ? text.size() : close + end.size();
      code += ' ';
    }
  }
  return code;
}

} // namespace

std::optional<bool> writesClipDistance(GLuint program) {
  GLint count = 0;
  if (program != 0) glad_glGetProgramiv(program, GL_ATTACHED_SHADERS, &count);
  if (count == 0) return std::nullopt;
  std::vector<GLuint> shaders(static_cast<std::size_t>(count));
  glad_glGetAttachedShaders(program, count, nullptr, shaders.data());
  for (const GLuint shader : shaders) {
    GLint stage = 0, length = 0;
    glad_glGetShaderiv(shader, GL_SHADER_TYPE, &stage);
    glad_glGetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
    if (stage == GL_FRAGMENT_SHADER || length == 0) continue;
    std::string text(static_cast<std::size_t>(length), '\0');
    glad_glGetShaderSource(shader, length, nullptr, text.data());
    if (withoutComments(text).find("gl_ClipDistance") != text.npos) return true;
  }
  return false;
}

namespace {

bool isSquareMatrix(GLenum type) {
  return type >= GL_FLOAT_MAT2 && type <= GL_FLOAT_MAT4;
}

// A float, a vector or a square matrix; what it doesn't have is 0.
std::array<GLfloat, 16> valueOf(GLuint program, const ActiveUniform& uniform) {
  std::array<GLfloat, 16> values{};
  glad_glGetUniformfv(program, uniform.location, values.data());
  return values;
}

} // namespace

std::map<std::string, GLint> zeroUniforms(GLuint program, const ActiveUniforms& uniforms) {
  std::map<std::string, GLint> zero;
  for (const ActiveUniform& uniform : uniforms) {
    const GLenum type = uniform.type;
    const bool isFloat = type == GL_FLOAT || (type >= GL_FLOAT_VEC2 && type <= GL_FLOAT_VEC4) ||
                         isSquareMatrix(type);
    if (!isFloat || uniform.location < 0) continue; // of a block, or a switch that may be off
    if (std::ranges::all_of(valueOf(program, uniform), [](float v) { return v == 0; }))
      zero.emplace(uniform.name, uniform.location);
  }
  return zero;
}

std::vector<std::string> nonFiniteMatrices(GLuint program, const ActiveUniforms& uniforms) {
  std::vector<std::string> names;
  for (const ActiveUniform& uniform : uniforms)
    if (isSquareMatrix(uniform.type) && uniform.location >= 0 &&
        !std::ranges::all_of(valueOf(program, uniform), [](float v) { return std::isfinite(v); }))
      names.push_back(uniform.name);
  return names;
}

Image windowPicture(const glm::ivec2& window) {
  if (ask(GL_PIXEL_PACK_BUFFER_BINDING) != 0) return {};
  const GLint framebuffer = ask(GL_READ_FRAMEBUFFER_BINDING);
  constexpr GLenum kStores[] = {GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS,
                                GL_PACK_SKIP_ROWS};
  GLint before[std::size(kStores)];
  for (std::size_t i = 0; i < std::size(kStores); ++i) {
    before[i] = ask(kStores[i]);
    glad_glPixelStorei(kStores[i], i == 0 ? 4 : 0);
  }
  glad_glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  Image picture{window.x, window.y, {}};
  picture.rgba.resize(4 * std::size_t(window.x) * std::size_t(window.y));
  glad_glReadPixels(0, 0, window.x, window.y, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  glad_glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(framebuffer));
  for (std::size_t i = 0; i < std::size(kStores); ++i) glad_glPixelStorei(kStores[i], before[i]);
  return picture;
}

} // namespace gg::detail
