// Other ways to the same picture lose nothing.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::IsEmpty;

namespace {

void expectEverything(const Submission& submission) {
  const Graded graded = grade(submission);
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.score(), 100);
  EXPECT_EQ(graded.bonus(), 10);
  EXPECT_THAT(graded.lost(), IsEmpty());
}

const std::string kFboSize = "makeReflection(reflection, scene.integer(\"quality.mirror_size\"),";
const std::string kFboFormat = "\n                       bloom ? lightFormat(scene) : GL_RGBA8);";

class FramebufferSize : public testing::TestWithParam<const char*> {};

TEST_P(FramebufferSize, LosesNothing) {
  expectEverything(std::move(Submission::solution().replace(
      "floor.cpp", kFboSize, std::string("makeReflection(reflection, ") + GetParam() + ",")));
}

INSTANTIATE_TEST_SUITE_P(Alternative, FramebufferSize, testing::Values("2048", "512"));

TEST(Alternative, DepthTextureInPlaceOfARenderbuffer) {
  Submission other = Submission::solution();
  other.replace("mirror.hpp", "  gg::Renderbuffer depth;\n", "  gg::Texture depth;\n");
  other.replace("mirror.hpp",
                "  glBindRenderbuffer(GL_RENDERBUFFER, reflection.depth);\n"
                "  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size, size);\n",
                "  glBindTexture(GL_TEXTURE_2D, reflection.depth);\n"
                "  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, size, size, 0,\n"
                "               GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);\n");
  other.replace("mirror.hpp",
                "  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, "
                "reflection.depth);\n",
                "  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,\n"
                "                         reflection.depth, 0);\n");
  expectEverything(other);
}

TEST(Alternative, TheFrontFaceTurnedInPlaceOfTheCulledOne) {
  Submission other = Submission::solution();
  other.replace("floor.cpp", "glCullFace(GL_FRONT);", "glFrontFace(GL_CW);");
  other.replace("floor.cpp", "glCullFace(GL_BACK);", "glFrontFace(GL_CCW);");
  expectEverything(other);
}

TEST(Alternative, OneShaderWithInverseTransposedNormals) {
  // No cofactor matrix and no negation: the inverse transpose keeps its sign under a mirror.
  Submission other = Submission::solution();
  const std::string before = "program.set(\"uNormal\", gg::cofactor(view * model));";
  other.replace("floor.cpp", before,
                "program.set(\"uNormal\", glm::transpose(glm::inverse(glm::mat3(view * model))));");
  other.replace("mirror.vert", "  vNormal = -vNormal;\n", "");
  std::string shared = read(other.path() / "mirror.vert");
  other.write("object.vert", shared);
  other.replace("floor.cpp", "{\"mirror.vert\", \"object.frag\"}",
                "{\"object.vert\", \"object.frag\"}");
  expectEverything(other);
}

TEST(Alternative, TheModelMirroredInPlaceOfTheView) {
  Submission other = Submission::solution();
  other.replace("floor.cpp", "                 const gg::Scene& scene, double time) {\n",
                "                 const gg::Scene& scene, double time, float side = 1) {\n");
  other.replace("floor.cpp", "    glm::mat4 model = glm::rotate(glm::mat4(1), angle, {0, 1, 0});\n",
                "    glm::mat4 model = glm::scale(glm::mat4(1), glm::vec3(1, side, 1));\n"
                "    model = glm::rotate(model, angle, {0, 1, 0});\n");
  other.replace(
      "floor.cpp",
      "drawObjects(mirrorProgram, projection, mirroredView, object, material, scene, time);",
      "drawObjects(mirrorProgram, projection, view, object, material, scene, time, -1);");
  // The mirrored objects are below the floor, now; the light is mirrored as before.
  other.replace("mirror.vert", "uClip ? world.y : 1", "uClip ? -world.y : 1");
  expectEverything(other);
}

TEST(Alternative, AFloatingPointTexture) {
  expectEverything(std::move(Submission::solution().replace(
      "mirror.hpp", "0, format, size, size, 0,", "0, GL_RGBA16F, size, size, 0,")));
}

TEST(Alternative, DirectStateAccess) {
  Submission other = Submission::solution();
  std::string text = read(other.path() / "mirror.hpp");
  // Names that glCreate... makes are not gg's to own.
  for (const char* type : {"Texture color", "Renderbuffer depth", "Framebuffer framebuffer"}) {
    const std::string name = std::string(type).substr(std::string(type).find(' ') + 1);
    const std::string from = std::string("  gg::") + type + ";\n";
    text.replace(text.find(from), from.size(), "  GLuint " + name + " = 0;\n");
  }
  const std::size_t from =
      text.find("  glBindTexture(GL_TEXTURE_2D, reflection.color);\n  glTexImage2D");
  const std::size_t to = text.find("  // END SOLUTION(mirror.1)");
  ASSERT_NE(from, text.npos);
  other.write("mirror.hpp", text.substr(0, from) + R"(
  GLuint &color = reflection.color, &depth = reflection.depth;
  GLuint& framebuffer = reflection.framebuffer;
  glCreateTextures(GL_TEXTURE_2D, 1, &color);
  glTextureStorage2D(color, 1, GL_RGBA8, size, size);
  glTextureParameteri(color, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(color, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(color, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glCreateRenderbuffers(1, &depth);
  glNamedRenderbufferStorage(depth, GL_DEPTH_COMPONENT24, size, size);
  glCreateFramebuffers(1, &framebuffer);
  glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, color, 0);
  glNamedFramebufferRenderbuffer(framebuffer, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  if (glCheckNamedFramebufferStatus(framebuffer, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("not complete");
)" + text.substr(to));
  expectEverything(other);
}

TEST(Alternative, AWindowSizedFramebufferSampledByTexel) {
  Submission other = Submission::solution();
  other.replace("mirror.hpp", "GLsizei size = 0; // pixels, width and height",
                "GLsizei size = 0, width = 0, height = 0;");
  for (const auto& [from, to] : std::initializer_list<std::pair<std::string, std::string>>{
           {"GLsizei size, GLenum format) {\n  reflection.size = size;\n",
            "GLsizei width, GLsizei height) {\n"
            "  reflection.size = reflection.width = width;\n  reflection.height = height;\n"},
           {"format, size, size,", "GL_RGBA8, width, height,"},
           {"GL_DEPTH_COMPONENT24, size, size", "GL_DEPTH_COMPONENT24, width, height"}})
    other.replace("mirror.hpp", from, to);
  other.replace("floor.cpp", kFboSize + kFboFormat,
                "makeReflection(reflection, window.width(), window.height());");
  other.replace("floor.cpp", "glViewport(0, 0, reflection.size, reflection.size);",
                "glViewport(0, 0, reflection.width, reflection.height);");
  other.replace("tile.frag", "    reflected = texture(uReflection, at).rgb;\n",
                "    reflected = texelFetch(uReflection, ivec2(gl_FragCoord.xy), 0).rgb;\n");
  expectEverything(other);
}

TEST(Alternative, ObjectsAndFloorInTheOtherOrder) {
  Submission other = Submission::solution();
  const std::string draw =
      "    light.load(scene.light.in(view));\n    objectProgram.use();\n"
      "    drawObjects(objectProgram, projection, view, object, material, scene, time);\n";
  other.replace("floor.cpp", draw, "    light.load(scene.light.in(view));\n");
  other.replace(
      "floor.cpp", "    rectangle.draw();\n",
      "    rectangle.draw();\n    objectProgram.use();\n"
      "    drawObjects(objectProgram, projection, view, object, material, scene, time);\n");
  expectEverything(other);
}

TEST(Alternative, TheFramebufferMadeAnewEachFrame) {
  Submission other = Submission::solution();
  other.replace("floor.cpp", "      if (reflection.size == 0)\n        makeReflection",
                "      reflection = Reflection();\n        makeReflection");
  expectEverything(other);
}

} // namespace
