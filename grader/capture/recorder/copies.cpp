#include "capture/recorder/copies.hpp"

#include "capture/context.hpp"
#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/images.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

namespace ggrade::capture::recorder {
namespace {

using trace::ImageKind;
using trace::ImageRef;
using trace::PixelType;

bool isDepth(std::uint32_t attachment) {
  return attachment == trace::kDepth;
}
bool isStencil(std::uint32_t attachment) {
  return attachment == trace::kStencil;
}

/// Where our framebuffer has the image.
GLenum pointOf(std::uint32_t attachment) {
  return isDepth(attachment)     ? GL_DEPTH_ATTACHMENT
         : isStencil(attachment) ? GL_STENCIL_ATTACHMENT
                                 : GL_COLOR_ATTACHMENT0;
}

/// The image as the only attachment of a framebuffer, until this goes.
class Attached {
public:
  Attached(GLuint framebuffer, const ImageRef& image, std::uint32_t attachment)
      : framebuffer_(framebuffer), point_(pointOf(attachment)) {
    const bool color = point_ == GL_COLOR_ATTACHMENT0;
    gl().namedFramebufferReadBuffer(framebuffer, color ? point_ : GL_NONE);
    gl().namedFramebufferDrawBuffer(framebuffer, color ? point_ : GL_NONE);
    const auto level = static_cast<GLint>(image.level);
    if (image.kind == static_cast<std::uint32_t>(ImageKind::renderbuffer)) {
      gl().namedFramebufferRenderbuffer(framebuffer, point_, GL_RENDERBUFFER, image.name);
    } else if (image.layer != trace::kNone) {
      gl().namedFramebufferTextureLayer(framebuffer, point_, image.name, level,
                                        static_cast<GLint>(image.layer));
    } else if (hasLayers(image.target)) {
      gl().namedFramebufferTextureLayer(framebuffer, point_, image.name, level, 0);
    } else {
      gl().namedFramebufferTexture(framebuffer, point_, image.name, level);
    }
  }
  ~Attached() { gl().namedFramebufferRenderbuffer(framebuffer_, point_, GL_RENDERBUFFER, 0); }
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;

private:
  GLuint framebuffer_;
  GLenum point_;
};

/// The window as read framebuffer with its colour as read buffer, until this goes.
class WindowRead {
public:
  WindowRead() {
    gl().bindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    readBuffer_ = number(GL_READ_BUFFER);
    gl().namedFramebufferReadBuffer(0, contextLibrary().windowBuffer());
  }
  ~WindowRead() { gl().namedFramebufferReadBuffer(0, readBuffer_); }
  WindowRead(const WindowRead&) = delete;
  WindowRead& operator=(const WindowRead&) = delete;

private:
  GLenum readBuffer_;
};

/// What a multisampled image of the bound read framebuffer comes to.
class Resolved {
public:
  Resolved(const ImageRef& image, std::uint32_t attachment, bool srgb) {
    gl().createRenderbuffers(1, &renderbuffer_);
    gl().namedRenderbufferStorage(renderbuffer_, image.format, static_cast<GLsizei>(image.width),
                                  static_cast<GLsizei>(image.height));
    gl().createFramebuffers(1, &framebuffer_);
    ImageRef resolved{};
    resolved.kind = static_cast<std::uint32_t>(ImageKind::renderbuffer);
    resolved.name = renderbuffer_;
    attached_.emplace(framebuffer_, resolved, attachment);
    const bool scissor = gl().isEnabledi(GL_SCISSOR_TEST, 0);
    const bool encode = gl().isEnabled(GL_FRAMEBUFFER_SRGB);
    if (scissor) gl().disablei(GL_SCISSOR_TEST, 0);
    // With encoding on, samples of an sRGB image are averaged as linear values.
    if (srgb && !encode) gl().enable(GL_FRAMEBUFFER_SRGB);
    const auto width = static_cast<GLint>(image.width);
    const auto height = static_cast<GLint>(image.height);
    const GLbitfield part = isDepth(attachment)     ? GL_DEPTH_BUFFER_BIT
                            : isStencil(attachment) ? GL_STENCIL_BUFFER_BIT
                                                    : GL_COLOR_BUFFER_BIT;
    gl().blitNamedFramebuffer(number(GL_READ_FRAMEBUFFER_BINDING), framebuffer_, 0, 0, width,
                              height, 0, 0, width, height, part, GL_NEAREST);
    if (srgb && !encode) gl().disable(GL_FRAMEBUFFER_SRGB);
    if (scissor) gl().enablei(GL_SCISSOR_TEST, 0);
    gl().bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  }
  ~Resolved() {
    attached_.reset();
    gl().deleteFramebuffers(1, &framebuffer_);
    gl().deleteRenderbuffers(1, &renderbuffer_);
  }
  Resolved(const Resolved&) = delete;
  Resolved& operator=(const Resolved&) = delete;

private:
  GLuint renderbuffer_ = 0;
  GLuint framebuffer_ = 0;
  std::optional<Attached> attached_;
};

GLint readAttachment(GLenum point, GLenum name) {
  GLint value = 0;
  gl().getFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, point, name, &value);
  return value;
}

struct ColorFormat {
  PixelType type = PixelType::u8x4;
  bool srgb = false;
};

/// Of the colour attachment at `point` of the bound read framebuffer.
ColorFormat colorFormat(GLenum point, bool window) {
  const auto bits = std::max({readAttachment(point, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE),
                              readAttachment(point, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE),
                              readAttachment(point, GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE),
                              readAttachment(point, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE)});
  // A window that could be encoded never is (hooks_draws.cpp).
  if (!window && readAttachment(point, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) == GL_SRGB)
    return {PixelType::f32x4, true};
  switch (readAttachment(point, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE)) {
  case GL_INT:
    return {PixelType::i32x4};
  case GL_UNSIGNED_INT:
    return {PixelType::u32x4};
  case GL_FLOAT:
    return {bits <= 16 ? PixelType::f16x4 : PixelType::f32x4};
  case GL_UNSIGNED_NORMALIZED:
    return {bits <= 8 ? PixelType::u8x4 : PixelType::f32x4};
  default: // signed normalised
    return {PixelType::f32x4};
  }
}

/// Reads the image, whose values GL gives as encoded, as bytes into the end of the room, and
/// decodes them from there to the whole of it.
void readSrgb(GLsizei width, GLsizei height, std::byte* room, std::uint64_t bytes) {
  static const std::array<float, 256> linear = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double encoded = static_cast<double>(i) / 255;
      values[i] = static_cast<float>(encoded <= 0.04045 ? encoded / 12.92
                                                        : std::pow((encoded + 0.055) / 1.055, 2.4));
    }
    return values;
  }();
  const std::uint64_t pixels = bytes / bytesPerPixel(PixelType::f32x4);
  const std::byte* const encoded = room + bytes - 4 * pixels;
  gl().readPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, const_cast<std::byte*>(encoded));
  for (std::uint64_t i = 0; i < pixels; ++i) {
    std::uint8_t from[4];
    std::memcpy(from, encoded + 4 * i, sizeof(from));
    const float to[4] = {linear[from[0]], linear[from[1]], linear[from[2]],
                         static_cast<float>(from[3]) / 255};
    std::memcpy(room + 16 * i, to, sizeof(to));
  }
}

} // namespace

PixelFormat pixelFormat(PixelType type) {
  switch (type) {
  case PixelType::f32x1:
    return {GL_DEPTH_COMPONENT, GL_FLOAT};
  case PixelType::u8x1:
    return {GL_STENCIL_INDEX, GL_UNSIGNED_BYTE};
  case PixelType::u8x4:
    return {GL_RGBA, GL_UNSIGNED_BYTE};
  case PixelType::f16x4:
    return {GL_RGBA, GL_HALF_FLOAT};
  case PixelType::i32x4:
    return {GL_RGBA_INTEGER, GL_INT};
  case PixelType::u32x4:
    return {GL_RGBA_INTEGER, GL_UNSIGNED_INT};
  default:
    return {GL_RGBA, GL_FLOAT};
  }
}

ImageReader::ImageReader(GLuint& framebuffer) {
  if (!framebuffer) gl().createFramebuffers(1, &framebuffer);
  framebuffer_ = framebuffer;
}

std::uint32_t ImageReader::copy(const ImageRef& image, trace::CopyRecord record,
                                TableWriter& tables) {
  std::optional<WindowRead> window;
  std::optional<Attached> attached;
  GLenum point = pointOf(record.attachment);
  if (image.kind == static_cast<std::uint32_t>(ImageKind::window)) {
    window.emplace();
    point = contextLibrary().windowBuffer() == GL_FRONT ? GL_FRONT_LEFT : GL_BACK_LEFT;
  } else {
    attached.emplace(framebuffer_, image, record.attachment);
    gl().bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  }
  // As when the image's texture is gone.
  if (gl().checkFramebufferStatus(GL_READ_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    tables.loseCopy();
    return trace::kNone;
  }
  ColorFormat format;
  if (isDepth(record.attachment)) {
    format.type = PixelType::f32x1;
  } else if (isStencil(record.attachment)) {
    format.type = PixelType::u8x1;
  } else {
    format = colorFormat(point, window.has_value());
  }
  record.type = static_cast<std::uint32_t>(format.type);
  record.width = image.width;
  record.height = image.height;
  record.bytes = bytesPerPixel(format.type) * image.width * image.height;
  std::byte* const room = tables.roomForCopy(record.bytes);
  if (!room) return trace::kNone;
  std::optional<Resolved> resolved;
  if (image.samples > 0) resolved.emplace(image, record.attachment, format.srgb);
  const auto width = static_cast<GLsizei>(image.width);
  const auto height = static_cast<GLsizei>(image.height);
  while (gl().getError() != GL_NO_ERROR) {
  }
  if (format.srgb) {
    readSrgb(width, height, room, record.bytes);
  } else {
    const PixelFormat read = pixelFormat(format.type);
    gl().readPixels(0, 0, width, height, read.format, read.type, room);
  }
  if (gl().getError() != GL_NO_ERROR) {
    tables.loseCopy();
    return trace::kNone;
  }
  return tables.addCopy(record);
}

} // namespace ggrade::capture::recorder
