#include "capture/recorder/state.hpp"

#include "capture/recorder/gl_calls.hpp"

#include <algorithm>

namespace ggrade::capture::recorder {
namespace {

constexpr std::uint32_t kMaxClipDistances = 8;

std::uint32_t enabled(GLenum name) {
  return gl().isEnabled(name) ? 1 : 0;
}

/// Bits 0 to 3 of a draw buffer.
std::uint32_t colorMask(GLuint buffer) {
  GLboolean channels[4] = {};
  gl().getBooleani_v(GL_COLOR_WRITEMASK, buffer, channels);
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < 4; ++i) mask |= channels[i] ? 1U << i : 0U;
  return mask;
}

trace::StencilFace frontFace() {
  return {number(GL_STENCIL_FUNC),           number(GL_STENCIL_REF),
          number(GL_STENCIL_VALUE_MASK),     number(GL_STENCIL_WRITEMASK),
          number(GL_STENCIL_FAIL),           number(GL_STENCIL_PASS_DEPTH_FAIL),
          number(GL_STENCIL_PASS_DEPTH_PASS)};
}

trace::StencilFace backFace() {
  return {number(GL_STENCIL_BACK_FUNC),           number(GL_STENCIL_BACK_REF),
          number(GL_STENCIL_BACK_VALUE_MASK),     number(GL_STENCIL_BACK_WRITEMASK),
          number(GL_STENCIL_BACK_FAIL),           number(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
          number(GL_STENCIL_BACK_PASS_DEPTH_PASS)};
}

bool present(const trace::ImageRef& image) {
  return image.kind != static_cast<std::uint32_t>(trace::ImageKind::none);
}

/// Whether the scissor box leaves nothing of the image out.
bool scissorCovers(const trace::ImageRef& image) {
  if (!gl().isEnabledi(GL_SCISSOR_TEST, 0)) return true;
  GLint box[4] = {};
  gl().getIntegerv(GL_SCISSOR_BOX, box);
  return box[0] <= 0 && box[1] <= 0 && std::int64_t{box[0]} + box[2] >= image.width &&
         std::int64_t{box[1]} + box[3] >= image.height;
}

} // namespace

trace::StepRecord readState() {
  trace::StepRecord state{};
  state.cullFace = enabled(GL_CULL_FACE) ? number(GL_CULL_FACE_MODE) : 0;
  state.frontFace = number(GL_FRONT_FACE);
  state.depthTest = enabled(GL_DEPTH_TEST) ? number(GL_DEPTH_FUNC) : 0;
  state.depthWrite = number(GL_DEPTH_WRITEMASK) ? 1 : 0;
  state.depthClamp = enabled(GL_DEPTH_CLAMP);
  state.blend = enabled(GL_BLEND);
  state.blendSource = number(GL_BLEND_SRC_RGB);
  state.blendDestination = number(GL_BLEND_DST_RGB);
  state.blendEquation = number(GL_BLEND_EQUATION_RGB);
  state.blendSourceAlpha = number(GL_BLEND_SRC_ALPHA);
  state.blendDestinationAlpha = number(GL_BLEND_DST_ALPHA);
  state.blendEquationAlpha = number(GL_BLEND_EQUATION_ALPHA);
  gl().getFloatv(GL_BLEND_COLOR, state.blendColor);
  state.stencilTest = enabled(GL_STENCIL_TEST);
  state.stencil[0] = frontFace();
  state.stencil[1] = backFace();
  state.colorMask = colorMask(0);
  state.scissorTest = enabled(GL_SCISSOR_TEST);
  gl().getIntegerv(GL_SCISSOR_BOX, state.scissor);
  gl().getIntegerv(GL_VIEWPORT, state.viewport);
  for (std::uint32_t i = 0; i < kMaxClipDistances; ++i)
    state.clipDistances |= enabled(GL_CLIP_DISTANCE0 + i) << i;
  state.polygonOffset = enabled(GL_POLYGON_OFFSET_FILL);
  gl().getFloatv(GL_POLYGON_OFFSET_FACTOR, &state.polygonOffsetFactor);
  gl().getFloatv(GL_POLYGON_OFFSET_UNITS, &state.polygonOffsetUnits);
  state.framebufferSrgb = enabled(GL_FRAMEBUFFER_SRGB);
  state.rasterizerDiscard = enabled(GL_RASTERIZER_DISCARD);
  return state;
}

std::uint32_t writtenBy(const trace::StepRecord& state, const Target& target) {
  if (state.rasterizerDiscard) return 0;
  std::uint32_t written = 0;
  for (std::uint32_t i = 0; i < trace::kColors; ++i) {
    const std::uint32_t at = target.attachmentOfBuffer[i];
    if (at != trace::kNone && present(target.images[at]) && colorMask(i)) written |= 1U << at;
  }
  if (present(target.images[trace::kDepth]) && state.depthTest && state.depthWrite)
    written |= 1U << trace::kDepth;
  if (present(target.images[trace::kStencil]) && state.stencilTest &&
      ((state.stencil[0].writeMask | state.stencil[1].writeMask) & 0xff))
    written |= 1U << trace::kStencil;
  return written;
}

ClearEffect effectOfClear(std::uint32_t asked, const Target& target,
                          const trace::ImageRef* images) {
  ClearEffect effect;
  if (enabled(GL_RASTERIZER_DISCARD)) return effect;
  const auto apply = [&](std::uint32_t at, bool some, bool all) {
    if (!(asked >> at & 1) || !present(images[at]) || !some) return;
    effect.written |= 1U << at;
    if (all && scissorCovers(images[at])) effect.covered |= 1U << at;
  };
  for (std::uint32_t i = 0; i < trace::kColors; ++i) {
    const std::uint32_t at = target.attachmentOfBuffer[i];
    if (at == trace::kNone) continue;
    const std::uint32_t mask = colorMask(i);
    apply(at, mask != 0, mask == 0xf);
  }
  const bool depth = number(GL_DEPTH_WRITEMASK) != 0;
  apply(trace::kDepth, depth, depth);
  const std::uint32_t stencil = number(GL_STENCIL_WRITEMASK) & 0xff;
  apply(trace::kStencil, stencil != 0, stencil == 0xff);
  return effect;
}

} // namespace ggrade::capture::recorder
