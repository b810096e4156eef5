#include "capture/recorder/images.hpp"

#include "capture/context.hpp"
#include "capture/recorder/gl_calls.hpp"

#include <initializer_list>

namespace ggrade::capture::recorder {
namespace {

using trace::ImageKind;
using trace::ImageRef;
using trace::kNone;

GLint attachmentParameter(GLenum binding, GLenum attachment, GLenum name) {
  GLint value = 0;
  gl().getFramebufferAttachmentParameteriv(binding, attachment, name, &value);
  return value;
}

GLint renderbufferParameter(GLuint renderbuffer, GLenum name) {
  GLint value = 0;
  gl().getNamedRenderbufferParameteriv(renderbuffer, name, &value);
  return value;
}

GLenum attachmentEnum(GLuint framebuffer, std::uint32_t attachment) {
  if (attachment == trace::kDepth) return framebuffer ? GL_DEPTH_ATTACHMENT : GL_DEPTH;
  if (attachment == trace::kStencil) return framebuffer ? GL_STENCIL_ATTACHMENT : GL_STENCIL;
  if (framebuffer) return GL_COLOR_ATTACHMENT0 + attachment;
  return contextLibrary().windowBuffer() == GL_FRONT ? GL_FRONT_LEFT : GL_BACK_LEFT;
}

/// The window's packed or plain depth format.
std::uint32_t windowFormat(std::uint32_t attachment) {
  if (attachment < trace::kColors) return GL_RGBA8;
  const GLint depth =
      attachmentParameter(GL_DRAW_FRAMEBUFFER, GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  const GLint stencil =
      attachmentParameter(GL_DRAW_FRAMEBUFFER, GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
  if (stencil) return depth ? GL_DEPTH24_STENCIL8 : GL_STENCIL_INDEX8;
  return depth == 16   ? GL_DEPTH_COMPONENT16
         : depth == 24 ? GL_DEPTH_COMPONENT24
                       : GL_DEPTH_COMPONENT32;
}

GLenum bindingOf(GLenum target) {
  switch (target) {
  case GL_TEXTURE_1D:
    return GL_TEXTURE_BINDING_1D;
  case GL_TEXTURE_2D:
    return GL_TEXTURE_BINDING_2D;
  case GL_TEXTURE_3D:
    return GL_TEXTURE_BINDING_3D;
  case GL_TEXTURE_RECTANGLE:
    return GL_TEXTURE_BINDING_RECTANGLE;
  case GL_TEXTURE_1D_ARRAY:
    return GL_TEXTURE_BINDING_1D_ARRAY;
  case GL_TEXTURE_2D_ARRAY:
    return GL_TEXTURE_BINDING_2D_ARRAY;
  case GL_TEXTURE_CUBE_MAP_ARRAY:
    return GL_TEXTURE_BINDING_CUBE_MAP_ARRAY;
  case GL_TEXTURE_BUFFER:
    return GL_TEXTURE_BINDING_BUFFER;
  case GL_TEXTURE_2D_MULTISAMPLE:
    return GL_TEXTURE_BINDING_2D_MULTISAMPLE;
  case GL_TEXTURE_2D_MULTISAMPLE_ARRAY:
    return GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY;
  case GL_TEXTURE_CUBE_MAP:
  case GL_TEXTURE_CUBE_MAP_POSITIVE_X:
  case GL_TEXTURE_CUBE_MAP_NEGATIVE_X:
  case GL_TEXTURE_CUBE_MAP_POSITIVE_Y:
  case GL_TEXTURE_CUBE_MAP_NEGATIVE_Y:
  case GL_TEXTURE_CUBE_MAP_POSITIVE_Z:
  case GL_TEXTURE_CUBE_MAP_NEGATIVE_Z:
    return GL_TEXTURE_BINDING_CUBE_MAP;
  default:
    return 0;
  }
}

} // namespace

std::uint32_t attachmentOf(GLint buffer) {
  if (buffer == GL_NONE) return kNone;
  if (buffer < GL_COLOR_ATTACHMENT0) return 0;
  const auto attachment = static_cast<std::uint32_t>(buffer - GL_COLOR_ATTACHMENT0);
  return attachment < trace::kColors ? attachment : kNone;
}

ImageRef textureLevel(GLuint texture, std::uint32_t level, std::uint32_t layer) {
  ImageRef image{};
  image.kind = static_cast<std::uint32_t>(ImageKind::texture);
  image.name = texture;
  image.level = level;
  image.layer = layer;
  return image;
}

ImageRef attachedImage(GLenum binding, GLuint framebuffer, std::uint32_t attachment) {
  ImageRef image{};
  image.layer = kNone;
  const GLenum at = attachmentEnum(framebuffer, attachment);
  const auto ask = [&](GLenum name) {
    return static_cast<std::uint32_t>(attachmentParameter(binding, at, name));
  };
  switch (ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE)) {
  case GL_FRAMEBUFFER_DEFAULT:
    image.kind = static_cast<std::uint32_t>(ImageKind::window);
    break;
  case GL_RENDERBUFFER:
    image.kind = static_cast<std::uint32_t>(ImageKind::renderbuffer);
    image.name = ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME);
    break;
  case GL_TEXTURE: {
    image = textureLevel(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME),
                         ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL));
    if (ask(GL_FRAMEBUFFER_ATTACHMENT_LAYERED)) break;
    const std::uint32_t face = ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE);
    if (face) {
      image.layer = face - GL_TEXTURE_CUBE_MAP_POSITIVE_X;
      break;
    }
    if (hasLayers(static_cast<GLenum>(textureParameter(image.name, GL_TEXTURE_TARGET))))
      image.layer = ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER);
    break;
  }
  default:
    break;
  }
  return image;
}

Target boundTarget() {
  Target target;
  target.framebuffer = number(GL_DRAW_FRAMEBUFFER_BINDING);
  const std::uint32_t colors = target.framebuffer ? trace::kColors : 1;
  for (std::uint32_t i = 0; i < trace::kColors; ++i) {
    const std::uint32_t at = i < colors ? attachmentOf(integer(GL_DRAW_BUFFER0 + i)) : kNone;
    target.attachmentOfBuffer[i] = at;
    if (at != kNone) target.drawBuffers |= 1U << at;
  }
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i) {
    if (i >= colors && i < trace::kColors) continue;
    target.images[i] = attachedImage(GL_DRAW_FRAMEBUFFER, target.framebuffer, i);
  }
  return target;
}

bool sameImages(const Target& a, const Target& b) {
  if (a.drawBuffers != b.drawBuffers) return false;
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i) {
    if (!sameImage(a.images[i], b.images[i])) return false;
  }
  return true;
}

bool hasLayers(GLenum target) {
  return target == GL_TEXTURE_3D || target == GL_TEXTURE_1D_ARRAY ||
         target == GL_TEXTURE_2D_ARRAY || target == GL_TEXTURE_CUBE_MAP ||
         target == GL_TEXTURE_CUBE_MAP_ARRAY || target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY;
}

GLint textureParameter(GLuint texture, GLenum name) {
  GLint value = 0;
  gl().getTextureParameteriv(texture, name, &value);
  return value;
}

GLint levelParameter(GLuint texture, std::uint32_t level, GLenum name) {
  GLint value = 0;
  gl().getTextureLevelParameteriv(texture, static_cast<GLint>(level), name, &value);
  return value;
}

void describe(ImageRef& image, std::uint32_t attachment, Size window) {
  switch (static_cast<ImageKind>(image.kind)) {
  case ImageKind::none:
    return;
  case ImageKind::window:
    image.format = windowFormat(attachment);
    image.width = static_cast<std::uint32_t>(window.width);
    image.height = static_cast<std::uint32_t>(window.height);
    return;
  case ImageKind::renderbuffer: {
    const auto ask = [&](GLenum name) {
      return static_cast<std::uint32_t>(renderbufferParameter(image.name, name));
    };
    image.format = ask(GL_RENDERBUFFER_INTERNAL_FORMAT);
    image.width = ask(GL_RENDERBUFFER_WIDTH);
    image.height = ask(GL_RENDERBUFFER_HEIGHT);
    image.samples = ask(GL_RENDERBUFFER_SAMPLES);
    return;
  }
  case ImageKind::texture: {
    const auto ask = [&](GLenum name) {
      return static_cast<std::uint32_t>(levelParameter(image.name, image.level, name));
    };
    // 0 in the compatibility profile, where this GL doesn't answer.
    image.target = static_cast<std::uint32_t>(textureParameter(image.name, GL_TEXTURE_TARGET));
    image.format = ask(GL_TEXTURE_INTERNAL_FORMAT);
    image.width = ask(GL_TEXTURE_WIDTH);
    image.height = ask(GL_TEXTURE_HEIGHT);
    image.samples = ask(GL_TEXTURE_SAMPLES);
    return;
  }
  }
}

Aspects aspectsOf(const ImageRef& image) {
  Aspects aspects;
  if (image.kind == static_cast<std::uint32_t>(ImageKind::texture)) {
    aspects.depth = levelParameter(image.name, image.level, GL_TEXTURE_DEPTH_SIZE) > 0;
    aspects.stencil = levelParameter(image.name, image.level, GL_TEXTURE_STENCIL_SIZE) > 0;
  } else if (image.kind == static_cast<std::uint32_t>(ImageKind::renderbuffer)) {
    aspects.depth = renderbufferParameter(image.name, GL_RENDERBUFFER_DEPTH_SIZE) > 0;
    aspects.stencil = renderbufferParameter(image.name, GL_RENDERBUFFER_STENCIL_SIZE) > 0;
  }
  aspects.color = !aspects.depth && !aspects.stencil;
  return aspects;
}

std::uint64_t textureLevelBytes(GLuint texture, GLint level) {
  const auto ask = [&](GLenum name) {
    return static_cast<std::uint64_t>(
        levelParameter(texture, static_cast<std::uint32_t>(level), name));
  };
  const std::uint64_t pixels =
      ask(GL_TEXTURE_WIDTH) * ask(GL_TEXTURE_HEIGHT) * ask(GL_TEXTURE_DEPTH);
  if (pixels == 0) return 0;
  const std::uint64_t faces =
      textureParameter(texture, GL_TEXTURE_TARGET) == GL_TEXTURE_CUBE_MAP ? 6 : 1;
  if (ask(GL_TEXTURE_COMPRESSED)) return faces * ask(GL_TEXTURE_COMPRESSED_IMAGE_SIZE);
  std::uint64_t bits = 0;
  for (const GLenum size : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                            GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE})
    bits += ask(size);
  const std::uint64_t samples = ask(GL_TEXTURE_SAMPLES);
  return faces * pixels * (samples ? samples : 1) * bits / 8;
}

std::uint64_t renderbufferBytes(GLuint renderbuffer) {
  const auto ask = [&](GLenum name) {
    return static_cast<std::uint64_t>(renderbufferParameter(renderbuffer, name));
  };
  std::uint64_t bits = 0;
  for (const GLenum size :
       {GL_RENDERBUFFER_RED_SIZE, GL_RENDERBUFFER_GREEN_SIZE, GL_RENDERBUFFER_BLUE_SIZE,
        GL_RENDERBUFFER_ALPHA_SIZE, GL_RENDERBUFFER_DEPTH_SIZE, GL_RENDERBUFFER_STENCIL_SIZE})
    bits += ask(size);
  const std::uint64_t samples = ask(GL_RENDERBUFFER_SAMPLES);
  return ask(GL_RENDERBUFFER_WIDTH) * ask(GL_RENDERBUFFER_HEIGHT) * (samples ? samples : 1) * bits /
         8;
}

GLuint boundTexture(GLenum target) {
  const GLenum binding = bindingOf(target);
  return binding ? number(binding) : 0;
}

} // namespace ggrade::capture::recorder
