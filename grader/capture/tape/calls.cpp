#include "capture/tape/calls.hpp"

#include "capture/channel_writer.hpp"
#include "capture/context.hpp"
#include "capture/recorder/bound.hpp"
#include "capture/recorder/gl_calls.hpp"
#include "capture/tape/objects.hpp"
#include "capture/tape/writer.hpp"

#include <mutex>
#include <optional>

namespace ggrade::capture::tape {

using nlohmann::json;
using recorder::gl;
using recorder::number;
using recorder::Session;
using trace::ImageKind;

namespace {

GLint windowBits(GLenum buffer, GLenum size) {
  GLint bits = 0;
  gl().getFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, buffer, size, &bits);
  return bits;
}

/// The first command of a tape.
json contextJson(const Session& session) {
  const WindowBinding window;
  return {{"op", "context"},
          {"core", !session.context().compatible},
          {"version", {number(GL_MAJOR_VERSION), number(GL_MINOR_VERSION)}},
          {"window", {session.state().windowSize.width, session.state().windowSize.height}},
          {"depthBits", windowBits(GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE)},
          {"stencilBits", windowBits(GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE)}};
}

/// The right to write commands, if anything is to be written.
class Taping {
public:
  Taping() {
    if (!isOpen()) return;
    session_.emplace();
    if (!*session_) {
      session_.reset();
      return;
    }
    static std::optional<std::uint32_t> context;
    if (!context) {
      context = session_->context().id;
      command(contextJson(*session_));
    }
    if (*context != session_->context().id) refuse("draws with several contexts");
    if (!isOpen()) session_.reset();
  }
  explicit operator bool() const { return session_.has_value(); }

private:
  std::optional<Session> session_;
};

json indicesJson() {
  GLint buffer = 0;
  gl().getIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &buffer);
  if (!buffer) {
    refuse("draws with indices that lie in no buffer object");
    return nullptr;
  }
  return {{"blob", bufferBlob(static_cast<GLuint>(buffer))}};
}

/// What a command has that draws or clears.
json drawingJson(const char* op) {
  return {{"op", op}, {"state", stateJson()}, {"target", targetJson(recorder::boundTarget())}};
}

std::uint32_t sideJson(const recorder::CopySide& side) {
  return side.target == GL_RENDERBUFFER ? useImage(ImageKind::renderbuffer, side.name)
                                        : useImage(ImageKind::texture, side.name, side.target);
}

bool isCubeFace(GLenum target) {
  return target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z;
}

} // namespace

void draw(GLenum mode, std::span<const Vertices> runs, GLsizei instances, GLuint baseInstance) {
  const Taping taping;
  if (!taping) return;
  if (number(GL_TRANSFORM_FEEDBACK_ACTIVE)) return refuse("draws for transform feedback");
  if (drawsNothing()) return;
  json one = drawingJson("draw");
  one["mode"] = mode;
  one["instances"] = instances;
  one["baseInstance"] = baseInstance;
  if (mode == GL_PATCHES) one["patchVertices"] = number(GL_PATCH_VERTICES);
  one["calls"] = json::array();
  for (const Vertices& run : runs) {
    json& call = one["calls"].emplace_back(json{{"count", run.count}});
    if (run.indexType == GL_NONE) {
      call["first"] = run.first;
      continue;
    }
    call["type"] = run.indexType;
    call["offset"] = run.offset;
    call["baseVertex"] = run.baseVertex;
    if (!one.contains("indices")) one["indices"] = indicesJson();
  }
  addProgram(one);
  command(one);
}

void clear(GLbitfield mask) {
  const Taping taping;
  if (!taping) return;
  json one = drawingJson("clear");
  one["colors"] = (mask & GL_COLOR_BUFFER_BIT) != 0;
  one["depths"] = (mask & GL_DEPTH_BUFFER_BIT) != 0;
  one["stencils"] = (mask & GL_STENCIL_BUFFER_BIT) != 0;
  GLfloat color[4] = {}, depth = 0;
  gl().getFloatv(GL_COLOR_CLEAR_VALUE, color);
  gl().getFloatv(GL_DEPTH_CLEAR_VALUE, &depth);
  one["color"] = color;
  one["depth"] = depth;
  one["stencil"] = integer(GL_STENCIL_CLEAR_VALUE);
  command(one);
}

void clearBuffer(const GLuint* framebuffer, GLenum buffer, GLint drawBuffer, char type,
                 const std::array<double, 4>& values) {
  const Taping taping;
  if (!taping) return;
  std::optional<recorder::Bound> bound;
  if (framebuffer) bound.emplace(GL_DRAW_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER_BINDING, *framebuffer);
  json one = drawingJson("clearBuffer");
  one["buffer"] = buffer;
  one["drawBuffer"] = drawBuffer;
  one["type"] = std::string(1, type);
  one["values"] = values;
  command(one);
}

void blit(const GLuint* from, const GLuint* to, const std::array<GLint, 8>& corners,
          GLbitfield mask, GLenum filter) {
  const Taping taping;
  if (!taping) return;
  std::optional<recorder::Bound> boundTo, boundFrom;
  if (to) boundTo.emplace(GL_DRAW_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER_BINDING, *to);
  if (from) boundFrom.emplace(GL_READ_FRAMEBUFFER, GL_READ_FRAMEBUFFER_BINDING, *from);
  json one = drawingJson("blit");
  one["from"] = readTargetJson();
  one["corners"] = corners;
  one["mask"] = mask;
  one["filter"] = filter;
  command(one);
}

void copy(GLuint texture, const Copy& copy) {
  const Taping taping;
  if (!taping) return;
  const GLenum target = isCubeFace(copy.target) ? GL_TEXTURE_CUBE_MAP : copy.target;
  if (!texture) texture = recorder::boundTexture(copy.target);
  if (!texture) return;
  if (copy.format && target != GL_TEXTURE_2D && target != GL_TEXTURE_CUBE_MAP)
    return refuse("copies into a texture of a kind that isn't recorded");
  json one = {{"op", "copy"}, {"from", readTargetJson()}};
  const bool isDefined = recorder::levelParameter(texture, 0, GL_TEXTURE_WIDTH) > 0;
  one["image"] =
      isDefined ? useImage(ImageKind::texture, texture, target) : useUndefined(texture, target);
  one["target"] = copy.target;
  one["level"] = copy.level;
  one["to"] = copy.to;
  one["area"] = copy.from;
  one["format"] = copy.format;
  one["state"] = {{"framebufferSrgb", gl().isEnabled(GL_FRAMEBUFFER_SRGB) != 0}};
  command(one);
}

void copyImage(const recorder::CopySide& from, const std::array<GLint, 3>& fromCorner,
               const recorder::CopySide& to, const std::array<GLint, 3>& toCorner,
               const std::array<GLsizei, 3>& size) {
  const Taping taping;
  if (!taping) return;
  command({{"op", "copyImage"},
           {"from", {{"image", sideJson(from)}, {"level", from.level}, {"corner", fromCorner}}},
           {"to", {{"image", sideJson(to)}, {"level", to.level}, {"corner", toCorner}}},
           {"size", size}});
}

void mipmap(GLuint texture, GLenum target) {
  const Taping taping;
  if (!taping) return;
  if (!texture) texture = recorder::boundTexture(target);
  if (!texture) return;
  const std::uint32_t image = useImage(ImageKind::texture, texture, target);
  command({{"op", "mipmap"},
           {"image", image},
           {"baseLevel", recorder::textureParameter(texture, GL_TEXTURE_BASE_LEVEL)},
           {"maxLevel", recorder::textureParameter(texture, GL_TEXTURE_MAX_LEVEL)}});
}

void linkProgram(GLuint program) {
  if (const Taping taping; taping) linking(program);
}

void otherProgram(GLuint program) {
  if (const Taping taping; taping) unknownProgram(program);
}

void refuseCall(const char* name) {
  if (isOpen()) refuse(std::string("calls ") + name);
}

void swap() {
  {
    const Taping taping;
    if (taping) {
      static std::once_flag first;
      std::call_once(first, addUnusedPrograms);
      command({{"op", "swap"}});
    }
  }
  frameEnded();
}

} // namespace ggrade::capture::tape
