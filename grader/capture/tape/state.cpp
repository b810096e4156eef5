// OpenGL's state, as far as drawing depends on it.

#include "capture/recorder/gl_calls.hpp"
#include "capture/tape/objects.hpp"
#include "replay/gl_state.hpp"

#include <array>

namespace ggrade::capture::tape {

using nlohmann::json;
using recorder::gl;
using recorder::number;

namespace {

template <std::size_t count> json integers(GLenum name) {
  std::array<GLint, count> values{};
  gl().getIntegerv(name, values.data());
  return values;
}

template <std::size_t count> json floats(GLenum name) {
  std::array<GLfloat, count> values{};
  gl().getFloatv(name, values.data());
  return values;
}

GLfloat oneFloat(GLenum name) {
  GLfloat value = 0;
  gl().getFloatv(name, &value);
  return value;
}

json stencilFace(bool back) {
  return {
      {"func", number(back ? GL_STENCIL_BACK_FUNC : GL_STENCIL_FUNC)},
      {"ref", number(back ? GL_STENCIL_BACK_REF : GL_STENCIL_REF)},
      {"valueMask", number(back ? GL_STENCIL_BACK_VALUE_MASK : GL_STENCIL_VALUE_MASK)},
      {"writeMask", number(back ? GL_STENCIL_BACK_WRITEMASK : GL_STENCIL_WRITEMASK)},
      {"fail", number(back ? GL_STENCIL_BACK_FAIL : GL_STENCIL_FAIL)},
      {"depthFail", number(back ? GL_STENCIL_BACK_PASS_DEPTH_FAIL : GL_STENCIL_PASS_DEPTH_FAIL)},
      {"depthPass", number(back ? GL_STENCIL_BACK_PASS_DEPTH_PASS : GL_STENCIL_PASS_DEPTH_PASS)}};
}

/// Of one draw buffer.
json blendJson(GLuint buffer) {
  if (!gl().isEnabledi(GL_BLEND, buffer)) return false;
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    gl().getIntegeri_v(name, buffer, &value);
    return value;
  };
  return {{"source", ask(GL_BLEND_SRC_RGB)},
          {"destination", ask(GL_BLEND_DST_RGB)},
          {"equation", ask(GL_BLEND_EQUATION_RGB)},
          {"sourceAlpha", ask(GL_BLEND_SRC_ALPHA)},
          {"destinationAlpha", ask(GL_BLEND_DST_ALPHA)},
          {"equationAlpha", ask(GL_BLEND_EQUATION_ALPHA)}};
}

json colorMask(GLuint buffer) {
  GLboolean channels[4] = {};
  gl().getBooleani_v(GL_COLOR_WRITEMASK, buffer, channels);
  json mask = json::array();
  for (const GLboolean channel : channels) mask.push_back(channel != 0);
  return mask;
}

} // namespace

json stateJson() {
  json state = {{"viewport", integers<4>(GL_VIEWPORT)},
                {"scissor", integers<4>(GL_SCISSOR_BOX)},
                {"depthRange", floats<2>(GL_DEPTH_RANGE)},
                {"cullFace", number(GL_CULL_FACE_MODE)},
                {"frontFace", number(GL_FRONT_FACE)},
                {"depthFunc", number(GL_DEPTH_FUNC)},
                {"depthMask", number(GL_DEPTH_WRITEMASK) != 0},
                {"blendColor", floats<4>(GL_BLEND_COLOR)},
                {"stencilFront", stencilFace(false)},
                {"stencilBack", stencilFace(true)},
                {"polygonOffsetFactor", oneFloat(GL_POLYGON_OFFSET_FACTOR)},
                {"polygonOffsetUnits", oneFloat(GL_POLYGON_OFFSET_UNITS)},
                {"logicOp", number(GL_LOGIC_OP_MODE)},
                {"lineWidth", oneFloat(GL_LINE_WIDTH)},
                {"pointSize", oneFloat(GL_POINT_SIZE)},
                {"provokingVertex", number(GL_PROVOKING_VERTEX)},
                {"restartIndex", number(GL_PRIMITIVE_RESTART_INDEX)},
                {"sampleCoverageValue", oneFloat(GL_SAMPLE_COVERAGE_VALUE)},
                {"sampleCoverageInvert", number(GL_SAMPLE_COVERAGE_INVERT) != 0}};
  GLint polygonMode[2] = {};
  gl().getIntegerv(GL_POLYGON_MODE, polygonMode);
  state["polygonMode"] = polygonMode[0];
  json blend = json::array(), masks = json::array();
  for (GLuint i = 0; i < trace::kColors; ++i) {
    blend.push_back(blendJson(i));
    masks.push_back(colorMask(i));
  }
  state["blend"] = blend;
  state["colorMask"] = masks;
  for (const auto& [name, capability] : ggrade::tape::kSwitches)
    state[name] = gl().isEnabled(capability) != 0;
  GLint sampleMask = 0;
  gl().getIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &sampleMask);
  state["sampleMaskValue"] = sampleMask;
  while (gl().getError() != GL_NO_ERROR) {
  }
  return state;
}

} // namespace ggrade::capture::tape
