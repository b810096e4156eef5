// Puts pixels that the judging side has chosen in place of what a pass left.

#include "capture/channel_writer.hpp"
#include "capture/recorder/copies.hpp"
#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/images.hpp"
#include "capture/recorder/pixel_state.hpp"
#include "capture/recorder/session.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ggrade::capture::recorder {
namespace {

using channel::Replacement;
using channel::ReplacementAnswer;
using trace::ImageRef;
using trace::PixelType;

/// How many bits wide depth is stored, and how.
struct DepthLayout {
  std::uint32_t bits;
  bool isFloat, stencil;
};

DepthLayout depthLayout(const ImageRef& image) {
  const auto ask = [&](GLenum name) { return levelParameter(image.name, image.level, name); };
  return {static_cast<std::uint32_t>(ask(GL_TEXTURE_DEPTH_SIZE)),
          ask(GL_TEXTURE_DEPTH_TYPE) == GL_FLOAT, ask(GL_TEXTURE_STENCIL_SIZE) > 0};
}

bool isSrgb(std::uint32_t format) {
  return format == GL_SRGB || format == GL_SRGB8 || format == GL_SRGB_ALPHA ||
         format == GL_SRGB8_ALPHA8;
}

/// Can the image take these pixels as they are?
bool fits(const ImageRef& image, const Replacement& replacement) {
  const bool layered = image.layer == trace::kNone && hasLayers(image.target);
  return image.kind == static_cast<std::uint32_t>(trace::ImageKind::texture) &&
         image.format == replacement.format && image.width == replacement.width &&
         image.height == replacement.height && image.samples == 0 && !layered &&
         image.target != GL_TEXTURE_1D && image.target != GL_TEXTURE_1D_ARRAY &&
         !isSrgb(image.format);
}

void upload(const ImageRef& image, PixelFormat format, const void* pixels) {
  const auto level = static_cast<GLint>(image.level);
  const auto width = static_cast<GLsizei>(image.width);
  const auto height = static_cast<GLsizei>(image.height);
  if (image.layer == trace::kNone) {
    gl().textureSubImage2D(image.name, level, 0, 0, width, height, format.format, format.type,
                           pixels);
  } else {
    gl().textureSubImage3D(image.name, level, 0, 0, static_cast<GLint>(image.layer), width, height,
                           1, format.format, format.type, pixels);
  }
}

/// 0 to 1 as a whole number of so many bits. A float tells 24 bits apart.
std::uint32_t normalized(float value, std::uint32_t bits) {
  const double most = std::ldexp(1.0, static_cast<int>(bits)) - 1;
  return static_cast<std::uint32_t>(
      std::llround(std::min(std::max(double{value}, 0.0), 1.0) * most));
}

/// Depth goes into an image by whole numbers of its own width: through floats GL rounds some
/// values of 16 bits to their neighbours.
void uploadDepth(const ImageRef& image, const DepthLayout& layout, const float* depth,
                 std::size_t count) {
  if (layout.isFloat) {
    upload(image, {GL_DEPTH_COMPONENT, GL_FLOAT}, depth);
  } else if (layout.bits == 16) {
    std::vector<std::uint16_t> values(count);
    for (std::size_t i = 0; i < count; ++i)
      values[i] = static_cast<std::uint16_t>(normalized(depth[i], 16));
    upload(image, {GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT}, values.data());
  } else {
    // GL takes the upper bits of 32.
    std::vector<std::uint32_t> values(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t bits = normalized(depth[i], layout.bits);
      values[i] = layout.bits == 24 ? bits << 8 | bits >> 16 : bits;
    }
    upload(image, {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT}, values.data());
  }
}

/// Depth and stencil in one: an upload of depth alone makes the stencil garbage. `Pixel` is what
/// one of them takes in memory; `put` sets its depth.
template <typename Pixel, typename Put>
void uploadPacked(const ImageRef& image, GLenum type, std::size_t count, const Put& put) {
  std::vector<Pixel> pixels(count);
  const GLint layer = image.layer == trace::kNone ? 0 : static_cast<GLint>(image.layer);
  const PixelState state(PixelDirection::pack);
  gl().getTextureSubImage(image.name, static_cast<GLint>(image.level), 0, 0, layer,
                          static_cast<GLsizei>(image.width), static_cast<GLsizei>(image.height), 1,
                          GL_DEPTH_STENCIL, type, static_cast<GLsizei>(count * sizeof(Pixel)),
                          pixels.data());
  for (std::size_t i = 0; i < count; ++i) put(pixels[i], i);
  upload(image, {GL_DEPTH_STENCIL, type}, pixels.data());
}

struct FloatDepthStencil {
  float depth;
  std::uint32_t stencil;
};

void replaceDepth(const ImageRef& image, const std::byte* pixels) {
  const auto* const depth = reinterpret_cast<const float*>(pixels);
  const std::size_t count = std::size_t{image.width} * image.height;
  const DepthLayout layout = depthLayout(image);
  if (!layout.stencil) return uploadDepth(image, layout, depth, count);
  if (layout.isFloat)
    return uploadPacked<FloatDepthStencil>(
        image, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, count,
        [&](FloatDepthStencil& pixel, std::size_t i) { pixel.depth = depth[i]; });
  uploadPacked<std::uint32_t>(image, GL_UNSIGNED_INT_24_8, count,
                              [&](std::uint32_t& pixel, std::size_t i) {
                                pixel = normalized(depth[i], 24) << 8 | (pixel & 0xFF);
                              });
}

ReplacementAnswer replace(const ImageRef& image, const Replacement& replacement) {
  if (!fits(image, replacement)) {
    say("pass %u: its attachment %u, %ux%u of format 0x%X, cannot take %ux%u pixels of 0x%X",
        replacement.pass, replacement.attachment, image.width, image.height, image.format,
        replacement.width, replacement.height, replacement.format);
    return ReplacementAnswer::otherImage;
  }
  while (gl().getError() != GL_NO_ERROR) {
  }
  const std::byte* const pixels = replacementPixels(replacement);
  const PixelState state(PixelDirection::unpack);
  if (replacement.attachment == trace::kDepth) {
    replaceDepth(image, pixels);
  } else {
    upload(image, pixelFormat(static_cast<PixelType>(replacement.type)), pixels);
  }
  return gl().getError() == GL_NO_ERROR ? ReplacementAnswer::done : ReplacementAnswer::refused;
}

} // namespace

void replaceOutputs(const OpenPass& pass) {
  const channel::Plan& planned = *plan();
  if (planned.replacementCount == 0 || pass.record.frame != 0 || pass.index == trace::kNone) return;
  for (std::uint32_t i = 0; i < planned.replacementCount; ++i) {
    const Replacement& replacement = planned.replacements[i];
    if (replacement.pass == pass.index)
      answerReplacement(i, replace(pass.record.images[replacement.attachment], replacement));
  }
}

} // namespace ggrade::capture::recorder
