#include "replay/gl_state.hpp"
#include "replay/player/objects.hpp"

#include <array>
#include <stdexcept>

namespace ggrade::player {

namespace {

void applyStencil(GLenum face, const json& one) {
  gl().stencilFuncSeparate(face, one.at("func"), one.at("ref"), one.at("valueMask"));
  gl().stencilMaskSeparate(face, one.at("writeMask"));
  gl().stencilOpSeparate(face, one.at("fail"), one.at("depthFail"), one.at("depthPass"));
}

void applyBlend(GLuint buffer, const json& one) {
  if (!one.is_object()) return gl().disablei(GL_BLEND, buffer);
  gl().enablei(GL_BLEND, buffer);
  gl().blendFuncSeparatei(buffer, one.at("source"), one.at("destination"), one.at("sourceAlpha"),
                          one.at("destinationAlpha"));
  gl().blendEquationSeparatei(buffer, one.at("equation"), one.at("equationAlpha"));
}

template <typename Value, std::size_t count> std::array<Value, count> listOf(const json& from) {
  return from.get<std::array<Value, count>>();
}

template <typename Value>
void setVectors(GLint location, int rows, GLsizei count, const std::vector<Value>& values) {
  const Value* const data = values.data();
  if constexpr (std::is_same_v<Value, GLfloat>) {
    constexpr auto set = [](int n) {
      const Gl& g = gl();
      return n == 1 ? g.uniform1fv : n == 2 ? g.uniform2fv : n == 3 ? g.uniform3fv : g.uniform4fv;
    };
    set(rows)(location, count, data);
  } else if constexpr (std::is_same_v<Value, GLint>) {
    constexpr auto set = [](int n) {
      const Gl& g = gl();
      return n == 1 ? g.uniform1iv : n == 2 ? g.uniform2iv : n == 3 ? g.uniform3iv : g.uniform4iv;
    };
    set(rows)(location, count, data);
  } else {
    constexpr auto set = [](int n) {
      const Gl& g = gl();
      return n == 1   ? g.uniform1uiv
             : n == 2 ? g.uniform2uiv
             : n == 3 ? g.uniform3uiv
                      : g.uniform4uiv;
    };
    set(rows)(location, count, data);
  }
}

void setMatrices(GLint location, const tape::UniformShape& shape, GLsizei count,
                 const std::vector<GLfloat>& values) {
  const Gl& g = gl();
  const decltype(g.uniformMatrix4fv) all[3][3] = {
      {g.uniformMatrix2fv, g.uniformMatrix2x3fv, g.uniformMatrix2x4fv},
      {g.uniformMatrix3x2fv, g.uniformMatrix3fv, g.uniformMatrix3x4fv},
      {g.uniformMatrix4x2fv, g.uniformMatrix4x3fv, g.uniformMatrix4fv}};
  all[shape.columns - 2][shape.rows - 2](location, count, GL_FALSE, values.data());
}

} // namespace

void applyState(const json& state) {
  const Gl& g = gl();
  for (const auto& [name, capability] : tape::kSwitches)
    (state.at(name).get<bool>() ? g.enable : g.disable)(capability);
  const auto viewport = listOf<GLint, 4>(state.at("viewport"));
  g.viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  const auto scissor = listOf<GLint, 4>(state.at("scissor"));
  g.scissor(scissor[0], scissor[1], scissor[2], scissor[3]);
  const auto range = listOf<double, 2>(state.at("depthRange"));
  g.depthRange(range[0], range[1]);
  g.cullFace(state.at("cullFace"));
  g.frontFace(state.at("frontFace"));
  g.depthFunc(state.at("depthFunc"));
  g.depthMask(state.at("depthMask").get<bool>());
  const auto color = listOf<GLfloat, 4>(state.at("blendColor"));
  g.blendColor(color[0], color[1], color[2], color[3]);
  applyStencil(GL_FRONT, state.at("stencilFront"));
  applyStencil(GL_BACK, state.at("stencilBack"));
  g.polygonOffset(state.at("polygonOffsetFactor"), state.at("polygonOffsetUnits"));
  g.polygonMode(GL_FRONT_AND_BACK, state.at("polygonMode"));
  g.logicOp(state.at("logicOp"));
  g.lineWidth(state.at("lineWidth"));
  g.pointSize(state.at("pointSize"));
  g.provokingVertex(state.at("provokingVertex"));
  g.primitiveRestartIndex(state.at("restartIndex"));
  g.sampleCoverage(state.at("sampleCoverageValue"), state.at("sampleCoverageInvert").get<bool>());
  g.sampleMaski(0, GLbitfield(state.at("sampleMaskValue").get<GLint>()));
  const json &blend = state.at("blend"), &masks = state.at("colorMask");
  if (blend.size() != 8 || masks.size() != 8) throw std::runtime_error("not 8 draw buffers");
  for (GLuint i = 0; i < 8; ++i) {
    applyBlend(i, blend[i]);
    const auto mask = listOf<bool, 4>(masks[i]);
    g.colorMaski(i, mask[0], mask[1], mask[2], mask[3]);
  }
}

void setUniform(GLint location, GLenum type, const json& values) {
  const tape::UniformShape shape = tape::shapeOf(type);
  const auto each = std::size_t(shape.columns * shape.rows);
  if (each == 0 || values.size() % each != 0)
    throw std::runtime_error("a uniform's values are not of its type");
  const auto count = GLsizei(values.size() / each);
  if (shape.base == 'i')
    return setVectors(location, shape.rows, count, values.get<std::vector<GLint>>());
  if (shape.base == 'u')
    return setVectors(location, shape.rows, count, values.get<std::vector<GLuint>>());
  const auto floats = values.get<std::vector<GLfloat>>();
  if (shape.columns == 1) return setVectors(location, shape.rows, count, floats);
  setMatrices(location, shape, count, floats);
}

} // namespace ggrade::player
