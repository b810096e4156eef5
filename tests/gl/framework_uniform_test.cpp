// Uniforms and uniform blocks.

#include "framework_window.hpp"
#include <gg/math.hpp>
#include <gg/mesh.hpp>
#include <gg/uniform_buffer.hpp>
#include <gmock/gmock.h>

namespace {

using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

class Uniform : public FrameworkWindow {};

TEST_F(Uniform, OfEveryTypeIsSetWithoutUse) {
  const gg::Program p = coloring("vec4(uBool ? uFloat : uInt) + vec4(uV2, uV3.xy) + uV4 + "
                                 "vec4(uM3[2], 1) + uM4[3]",
                                 "uniform bool uBool; uniform int uInt; uniform float uFloat;\n"
                                 "uniform vec2 uV2; uniform vec3 uV3; uniform vec4 uV4;\n"
                                 "uniform mat3 uM3; uniform mat4 uM4;");
  CaptureStderr();
  glm::mat3 m3(1);
  m3[2] = {7, 8, 9};
  glm::mat4 m4(1);
  m4[3] = {1, 2, 3, 4};
  p.set("uBool", true);
  p.set("uInt", -3);
  p.set("uFloat", 1.5);
  p.set("uV2", glm::vec2(1, 2));
  p.set("uV3", glm::vec3(3, 4, 5));
  p.set("uV4", glm::vec4(6, 7, 8, 9));
  p.set("uM3", m3);
  p.set("uM4", m4);
  EXPECT_EQ(GetCapturedStderr(), "");

  GLfloat values[16] = {};
  GLint whole = 0;
  const auto location = [&](const char* name) { return glGetUniformLocation(p, name); };
  glGetUniformiv(p, location("uBool"), &whole);
  EXPECT_EQ(whole, 1);
  glGetUniformiv(p, location("uInt"), &whole);
  EXPECT_EQ(whole, -3);
  glGetUniformfv(p, location("uFloat"), values);
  EXPECT_EQ(values[0], 1.5f);
  glGetUniformfv(p, location("uV4"), values);
  EXPECT_EQ(values[3], 9);
  glGetUniformfv(p, location("uM3"), values);
  EXPECT_EQ(values[7], 8);
  glGetUniformfv(p, location("uM4"), values);
  EXPECT_EQ(values[14], 3);
}

TEST_F(Uniform, ThatNoStageDeclaresIsReportedOnce) {
  const gg::Program p = coloring("vec4(1)");
  CaptureStderr();
  p.set("uMirrored", true);
  p.set("uMirrored", false);
  p.set("uOther", 1);
  EXPECT_EQ(GetCapturedStderr(),
            "test.vert + test.frag: warning: uniform \"uMirrored\": these shaders have no such "
            "uniform\n"
            "test.vert + test.frag: warning: uniform \"uOther\": these shaders have no such "
            "uniform\n");
}

TEST_F(Uniform, ThatHasNoEffectIsLeftAloneSilently) {
  const gg::Program p = coloring("vec4(1)", "uniform float uBlur; // later");
  CaptureStderr();
  p.set("uBlur", 1.0f);
  EXPECT_EQ(GetCapturedStderr(), "");
}

TEST_F(Uniform, PartOfAWordIsNoDeclaration) {
  const gg::Program p = coloring("vec4(1)", "uniform float uBlurSigma;");
  CaptureStderr();
  p.set("uBlur", 1.0f);
  EXPECT_THAT(GetCapturedStderr(), testing::HasSubstr("\"uBlur\": these shaders have no such"));
}

TEST_F(Uniform, OfAnotherTypeIsReportedOnceAndAnErrorAsInPlainGl) {
  const gg::Program p = coloring("vec4(uSize)", "uniform float uSize;");
  CaptureStderr();
  p.set("uSize", 3);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  p.set("uSize", 4);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  const std::string text = GetCapturedStderr();
  EXPECT_THAT(text,
              testing::StartsWith("test.vert + test.frag: warning: uniform \"uSize\": is "
                                  "float in the shader, but was set to a value of type int\n"));
  EXPECT_EQ(text.find("was set", text.find("was set") + 1), text.npos);
}

TEST_F(Uniform, SamplersTakeTheirUnitAndArraysTheirElements) {
  const gg::Program p = coloring("texture(uMap, vec2(0)) + vec4(uList[0] + uList[2])",
                                 "uniform sampler2D uMap; uniform float uList[3];");
  CaptureStderr();
  p.set("uMap", 5);
  p.set("uList[0]", 1.0f);
  p.set("uList[2]", 2.0f);
  EXPECT_EQ(GetCapturedStderr(), "");
  GLint unit = 0;
  glGetUniformiv(p, glGetUniformLocation(p, "uMap"), &unit);
  EXPECT_EQ(unit, 5);
  GLfloat value = 0;
  glGetUniformfv(p, glGetUniformLocation(p, "uList[2]"), &value);
  EXPECT_EQ(value, 2);
}

// A surface in front of the eye, lit and seen straight on, shows ambient + diffuse + specular.
TEST_F(Uniform, BlocksReachTheLightingOfTheFramework) {
  const gg::Program p =
      coloring("vec4(blinnPhong(vec3(0, 0, -2), normalize(vec3(0, uTilt, 1))).ambient.r,"
               "     blinnPhong(vec3(0, 0, -2), normalize(vec3(0, uTilt, 1))).diffuse.g,"
               "     blinnPhong(vec3(0, 0, -2), normalize(vec3(0, uTilt, 1))).specular.b, 1)",
               "#include \"gg/lighting.glsl\"\nuniform float uTilt;");
  gg::Light light;
  light.ambient = {0.5f, 0, 0, 1};
  light.diffuse = {0, 0.8f, 0, 1};
  light.specular = {0, 0, 0.6f, 1};
  light.position = {0, 0, 0, 1};
  gg::Material material;
  material.ambient = {0.4f, 0, 0, 1};
  material.diffuse = {0, 0.5f, 0, 1};
  material.specular = {0, 0, 0.5f, 1};
  material.shininess = 2;
  const gg::UniformBuffer<gg::Material> materials(gg::kMaterialBinding);
  const gg::UniformBuffer<gg::Light> lights(gg::kLightBinding);
  lights.load(light);
  materials.load(material);

  const gg::Mesh mesh = gg::plane(2, 2);
  p.use();
  p.set("uClip", glm::rotate(glm::mat4(1), glm::radians(90.0f), {1, 0, 0}));
  p.set("uTilt", 0.0f);
  mesh.draw();
  EXPECT_THAT(pixel(16, 16), testing::ElementsAre(51, 102, 76, 255)); // 0.2, 0.4, 0.3

  p.set("uTilt", 1.0f); // normal at 45 degrees: cosine 0.7071 and its square
  mesh.draw();
  EXPECT_THAT(pixel(16, 16), testing::ElementsAre(51, 72, 38, 255)); // 0.2, 0.2828, 0.15

  material.shininess = 4;
  materials.load(material);
  mesh.draw();
  EXPECT_THAT(pixel(16, 16), testing::ElementsAre(51, 72, 19, 255)); // specular 0.075

  light.position = {0, 0, -2, 1}; // in the surface itself: no direction, and no NaN
  lights.load(light);
  mesh.draw();
  EXPECT_THAT(pixel(16, 16), testing::ElementsAre(51, 0, 0, 255));

  light.position = {0, 0, -9, 1}; // behind it
  lights.load(light);
  mesh.draw();
  EXPECT_THAT(pixel(16, 16), testing::ElementsAre(51, 0, 0, 255));
}

} // namespace
