#include "overlay.hpp"

#include <algorithm>
#include <cmath>

#include "font.hpp"
#include <fmt/format.h>
#include <glm/common.hpp>

namespace gg::detail {

namespace {

constexpr const char* kVertex = R"(#version 410 core
void main() {
  gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 4 * (gl_VertexID >> 1) - 1, 0, 1);
})";

constexpr const char* kFragment = R"(#version 410 core
uniform sampler2D uImage;
uniform usampler2D uWhole;
uniform int uShown; // as Overlay::Shown
uniform int uLevel;
uniform bool uGrey; // one channel only
uniform vec4 uTile;  // corner and size, pixels
uniform vec2 uDepth; // the nearest and the farthest that was drawn
layout(location = 0) out vec4 oColor;

// Even steps of distance; as the grader's pictures of depth are made (trace::evenDepth).
float evenDepth(float depth) {
  return -log2(1.0 - clamp(depth, 0.0, 1.0) + exp2(-12.0)) / 12.0;
}

void main() {
  vec2 at = (gl_FragCoord.xy - uTile.xy) / uTile.zw;
  ivec2 size = uShown == 3 ? textureSize(uWhole, uLevel) : textureSize(uImage, uLevel);
  ivec2 texel = clamp(ivec2(at * vec2(size)), ivec2(0), size - 1);
  vec3 color;
  if (uShown == 3) {
    uvec2 ids = texelFetch(uWhole, texel, uLevel).rg;
    color = fract(vec3(0.618, 0.755, 0.570) * float(ids.r) + vec3(0.820, 0.671, 0.549) * float(ids.g));
  } else {
    vec4 found = texelFetch(uImage, texel, uLevel);
    color = uGrey ? found.rrr : found.rgb;
    if (uShown == 1) color = max(color, 0.0) / (1.0 + max(color, 0.0));
    float low = evenDepth(uDepth.x), range = max(evenDepth(uDepth.y) - low, 1e-6);
    if (uShown == 2) color = vec3(found.r < 1.0 ? (evenDepth(found.r) - low) / range : 1.0);
  }
  oColor = vec4(color, 1);
})";

void attach(GLuint program, GLenum stage, const char* text) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);
}

// OpenGL's state, as far as drawing a tile changes it.
class Restore {
public:
  Restore() {
    glGetIntegerv(GL_VIEWPORT, viewport_);
    glGetBooleanv(GL_COLOR_WRITEMASK, mask_);
    glGetIntegerv(GL_POLYGON_MODE, polygons_);
    for (std::size_t i = 0; i < std::size(kSwitches); ++i) {
      on_[i] = glIsEnabled(kSwitches[i]);
      glDisable(kSwitches[i]);
    }
    for (std::size_t i = 0; i < std::size(kStores); ++i) {
      stores_[i] = ask(kStores[i]);
      const bool isAlignment = kStores[i] == GL_UNPACK_ALIGNMENT || kStores[i] == GL_PACK_ALIGNMENT;
      glPixelStorei(kStores[i], isAlignment ? 4 : 0);
    }
    for (GLenum unit = 0; unit < 2; ++unit) {
      glActiveTexture(GL_TEXTURE0 + unit);
      textures_[unit] = ask(GL_TEXTURE_BINDING_2D);
      samplers_[unit] = ask(GL_SAMPLER_BINDING);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  }
  ~Restore() {
    glUseProgram(static_cast<GLuint>(program_));
    glBindVertexArray(static_cast<GLuint>(vertices_));
    for (GLenum unit = 0; unit < 2; ++unit) {
      glActiveTexture(GL_TEXTURE0 + unit);
      glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(textures_[unit]));
      glBindSampler(unit, static_cast<GLuint>(samplers_[unit]));
    }
    glActiveTexture(static_cast<GLenum>(unit_));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawn_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(unpacked_));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(packed_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    glColorMask(mask_[0], mask_[1], mask_[2], mask_[3]);
    glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygons_[0]));
    for (std::size_t i = 0; i < std::size(kSwitches); ++i)
      if (on_[i] == GL_TRUE) glEnable(kSwitches[i]);
    for (std::size_t i = 0; i < std::size(kStores); ++i) glPixelStorei(kStores[i], stores_[i]);
  }
  Restore(const Restore&) = delete;
  Restore& operator=(const Restore&) = delete;

private:
  static constexpr GLenum kSwitches[] = {GL_DEPTH_TEST,     GL_BLEND,
                                         GL_CULL_FACE,      GL_STENCIL_TEST,
                                         GL_SCISSOR_TEST,   GL_FRAMEBUFFER_SRGB,
                                         GL_COLOR_LOGIC_OP, GL_RASTERIZER_DISCARD};
  static constexpr GLenum kStores[] = {
      GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS,
      GL_PACK_ALIGNMENT,   GL_PACK_ROW_LENGTH,   GL_PACK_SKIP_PIXELS,   GL_PACK_SKIP_ROWS};
  GLint program_ = ask(GL_CURRENT_PROGRAM), vertices_ = ask(GL_VERTEX_ARRAY_BINDING),
        unit_ = ask(GL_ACTIVE_TEXTURE), drawn_ = ask(GL_DRAW_FRAMEBUFFER_BINDING),
        read_ = ask(GL_READ_FRAMEBUFFER_BINDING), unpacked_ = ask(GL_PIXEL_UNPACK_BUFFER_BINDING),
        packed_ = ask(GL_PIXEL_PACK_BUFFER_BINDING);
  GLint viewport_[4], polygons_[2], textures_[2], samplers_[2], stores_[std::size(kStores)];
  GLboolean mask_[4], on_[std::size(kSwitches)];
};

struct Format {
  GLint format;
  const char* name;
};
constexpr Format kFormats[] = {{GL_RGBA8, "RGBA8"},
                               {GL_RGB8, "RGB8"},
                               {GL_RG8, "RG8"},
                               {GL_R8, "R8"},
                               {GL_RGBA, "RGBA"},
                               {GL_RGB, "RGB"},
                               {GL_SRGB8_ALPHA8, "SRGB8_ALPHA8"},
                               {GL_RGB10_A2, "RGB10_A2"},
                               {GL_RGBA16, "RGBA16"},
                               {GL_RG16, "RG16"},
                               {GL_R16, "R16"},
                               {GL_RGBA16F, "RGBA16F"},
                               {GL_RGB16F, "RGB16F"},
                               {GL_RG16F, "RG16F"},
                               {GL_R16F, "R16F"},
                               {GL_RGBA32F, "RGBA32F"},
                               {GL_RGB32F, "RGB32F"},
                               {GL_RG32F, "RG32F"},
                               {GL_R32F, "R32F"},
                               {GL_R11F_G11F_B10F, "R11F_G11F_B10F"},
                               {GL_R8UI, "R8UI"},
                               {GL_RG8UI, "RG8UI"},
                               {GL_R16UI, "R16UI"},
                               {GL_RG16UI, "RG16UI"},
                               {GL_R32UI, "R32UI"},
                               {GL_DEPTH_COMPONENT, "DEPTH_COMPONENT"},
                               {GL_DEPTH_COMPONENT16, "DEPTH_COMPONENT16"},
                               {GL_DEPTH_COMPONENT24, "DEPTH_COMPONENT24"},
                               {GL_DEPTH_COMPONENT32F, "DEPTH_COMPONENT32F"},
                               {GL_DEPTH24_STENCIL8, "DEPTH24_STENCIL8"},
                               {GL_DEPTH32F_STENCIL8, "DEPTH32F_STENCIL8"}};

std::string formatName(GLint format) {
  for (const Format& known : kFormats)
    if (known.format == format) return known.name;
  return fmt::format("format 0x{:04X}", format);
}

// Of a level of the texture that is bound.
GLint askLevel(GLint level, GLenum name) {
  GLint value = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D, level, name, &value);
  return value;
}

// The nearest and the farthest depth of a level of the texture that is bound, but for what is 1, as
// it is after clearing; 0 and 1 where there is nothing else.
glm::vec2 depthsDrawn(GLint level) {
  std::vector<float> depths(static_cast<std::size_t>(askLevel(level, GL_TEXTURE_WIDTH)) *
                            static_cast<std::size_t>(askLevel(level, GL_TEXTURE_HEIGHT)));
  glGetTexImage(GL_TEXTURE_2D, level, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  glm::vec2 drawn(1, 0);
  for (const float depth : depths)
    if (depth < 1) drawn = {std::min(drawn.x, depth), std::max(drawn.y, depth)};
  return drawn.x > drawn.y ? glm::vec2(0, 1) : drawn;
}

} // namespace

std::vector<Attachment> attachmentsOf(const std::vector<GLuint>& framebuffers,
                                      const TextureTargets& targets) {
  const GLint before = ask(GL_DRAW_FRAMEBUFFER_BINDING);
  std::vector<Attachment> all;
  const auto add = [&](GLuint framebuffer, GLenum attachment, const std::string& name) {
    const auto value = [&](GLenum what) {
      GLint found = 0;
      glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &found);
      return found;
    };
    if (value(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE) return;
    const Attachment one{framebuffer, name,
                         static_cast<GLuint>(value(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)),
                         value(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL)};
    const auto target = targets.find(one.texture);
    if (target == targets.end() || target->second != GL_TEXTURE_2D) return;
    for (const Attachment& other : all)
      if (other.texture == one.texture && other.level == one.level) return;
    all.push_back(one);
  };
  for (const GLuint framebuffer : framebuffers) {
    if (glIsFramebuffer(framebuffer) == GL_FALSE) continue; // deleted meanwhile
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    for (GLenum i = 0; i < 8; ++i)
      add(framebuffer, GL_COLOR_ATTACHMENT0 + i, fmt::format("colour {}", i));
    add(framebuffer, GL_DEPTH_ATTACHMENT, "depth");
  }
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
  return all;
}

Overlay::Overlay() {
  attach(program_, GL_VERTEX_SHADER, kVertex);
  attach(program_, GL_FRAGMENT_SHADER, kFragment);
  glLinkProgram(program_);
  glProgramUniform1i(program_, glGetUniformLocation(program_, "uWhole"), 1);
  // Whatever filter or comparison the program's textures have.
  glSamplerParameteri(sampler_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glSamplerParameteri(sampler_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void Overlay::draw(GLuint texture, GLint level, Shown shown, const glm::ivec2& corner,
                   const glm::ivec2& size) {
  const GLuint unit = shown == Shown::whole ? 1 : 0;
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  glBindSampler(unit, sampler_);
  glUseProgram(program_);
  const auto at = [&](const char* name) { return glGetUniformLocation(program_, name); };
  glUniform1i(at("uShown"), static_cast<GLint>(shown));
  glUniform1i(at("uLevel"), level);
  glUniform1i(at("uGrey"), askLevel(level, GL_TEXTURE_GREEN_SIZE) == 0);
  glUniform4f(at("uTile"), float(corner.x), float(corner.y), float(size.x), float(size.y));
  if (shown == Shown::depth) {
    const glm::vec2 drawn = depthsDrawn(level);
    glUniform2f(at("uDepth"), drawn.x, drawn.y);
  }
  glViewport(corner.x, corner.y, size.x, size.y);
  glBindVertexArray(noVertices_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

int Overlay::drawText(const glm::ivec2& window, const glm::ivec2& topLeft, const std::string& text,
                      int scale, int width) {
  const Image image = textImage(text, width / (scale * kCharacterWidth));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, text_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.rgba.data());
  const glm::ivec2 size = scale * glm::ivec2(image.width, image.height);
  draw(text_, 0, Shown::asIs, {topLeft.x, window.y - topLeft.y - size.y}, size);
  return size.y;
}

void Overlay::text(const glm::ivec2& window, const std::string& text, int scale) {
  const Restore restore;
  drawText(window, {0, 0}, text, scale, window.x);
}

void Overlay::tiles(const glm::ivec2& window, const std::vector<Attachment>& attachments) {
  const Restore restore;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture_);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, window.x, window.y, 0);
  constexpr GLfloat kGrey[] = {0.25f, 0.25f, 0.25f, 1};
  glClearBufferfv(GL_COLOR, 0, kGrey);

  const int count = 1 + static_cast<int>(attachments.size());
  const int columns = static_cast<int>(std::ceil(std::sqrt(double(count))));
  const int rows = (count + columns - 1) / columns;
  const glm::ivec2 cell = glm::max(window / glm::ivec2(columns, rows), 1);
  for (int i = 0; i < count; ++i) {
    const glm::ivec2 topLeft = cell * glm::ivec2(i % columns, i / columns);
    const Attachment one = i == 0 ? Attachment{0, "window", picture_, 0}
                                  : attachments[static_cast<std::size_t>(i - 1)];
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, one.texture);
    const glm::ivec2 size(askLevel(one.level, GL_TEXTURE_WIDTH),
                          askLevel(one.level, GL_TEXTURE_HEIGHT));
    const GLint type = askLevel(one.level, GL_TEXTURE_RED_TYPE);
    const bool isDepth = askLevel(one.level, GL_TEXTURE_DEPTH_SIZE) > 0;
    const Shown shown = isDepth                   ? Shown::depth
                        : type == GL_UNSIGNED_INT ? Shown::whole
                        : type == GL_FLOAT        ? Shown::highRange
                                                  : Shown::asIs;
    const std::string label =
        (i == 0 ? std::string("window") : fmt::format("{}: {}", one.framebuffer, one.name)) +
        fmt::format(" {}x{}", size.x, size.y) +
        (i == 0 ? "" : " " + formatName(askLevel(one.level, GL_TEXTURE_INTERNAL_FORMAT)));
    const int below = drawText(window, topLeft, label, 1, cell.x) + 1;
    if (size.x == 0 || size.y == 0) continue;
    const glm::vec2 room = glm::max(cell - glm::ivec2(2, below + 1), 1);
    const float scale = std::min(room.x / float(size.x), room.y / float(size.y));
    const glm::ivec2 shownSize = glm::max(glm::ivec2(scale * glm::vec2(size)), 1);
    draw(one.texture, one.level, shown, {topLeft.x, window.y - topLeft.y - below - shownSize.y},
         shownSize);
  }
}

} // namespace gg::detail
