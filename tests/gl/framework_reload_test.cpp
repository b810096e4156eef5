// Shaders that are saved while the window is open.

#include "framework_window.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <thread>

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

class Reload : public FrameworkWindow {
protected:
  /// Saves a fragment shader that colours with `color`.
  void save(const std::string& color, const std::string& declarations = "") const {
    folder.write("test.frag", "#version 410 core\n" + declarations +
                                  "\nlayout(location = 0) out vec4 oColor;\n"
                                  "void main() { oColor = " +
                                  color + "; }\n");
    // Two saves within the file system's grain of time would be one.
    std::filesystem::last_write_time(folder.path() / "test.frag",
                                     std::filesystem::file_time_type::clock::now() +
                                         std::chrono::seconds(++saves_));
  }

  /// Ends frames until files have been looked at; what is printed meanwhile.
  std::string wait() {
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    CaptureStderr();
    window.swapBuffers();
    return GetCapturedStderr();
  }

  std::array<int, 4> drawn(const gg::Program& program) const {
    program.use();
    program.set("uClip", glm::mat4(1));
    glBindVertexArray(corners);
    glClear(GL_COLOR_BUFFER_BIT);
    glPointSize(4);
    glDrawArrays(GL_POINTS, 0, 1); // all attributes are 0: the middle of the window
    return pixel(kSide / 2, kSide / 2);
  }

  gg::VertexArray corners;
  mutable int saves_ = 0;
};

TEST_F(Reload, ASavedShaderIsBuiltAgain) {
  const gg::Program program = coloring("vec4(1, 0, 0, 1)");
  const GLuint name = program;
  EXPECT_THAT(drawn(program), ElementsAre(255, 0, 0, 255));
  window.swapBuffers();
  save("vec4(0, 1, 0, 1)");
  EXPECT_EQ(wait(), "test.vert + test.frag: reloaded\n");
  EXPECT_THAT(drawn(program), ElementsAre(0, 255, 0, 255));
  EXPECT_EQ(GLuint(program), name);
  EXPECT_EQ(wait(), "") << "once";
}

TEST_F(Reload, UniformsKeepTheirValues) {
  const std::string declarations =
      "uniform vec3 uColor; uniform float uParts[2]; uniform int uWhole; uniform mat4 uMatrix;";
  const gg::Program program =
      coloring("vec4(uColor * uParts[1] * float(uWhole) * uMatrix[0][0], 1)", declarations);
  program.set("uColor", glm::vec3(0.5f, 0.25f, 0.125f));
  program.set("uParts[1]", 0.5f);
  program.set("uWhole", 2);
  program.set("uMatrix", glm::mat4(2));
  EXPECT_THAT(drawn(program), ElementsAre(255, 128, 64, 255));
  window.swapBuffers();
  save("vec4(uColor.zyx * uParts[1] * float(uWhole) * uMatrix[0][0], 1)", declarations);
  wait();
  EXPECT_THAT(drawn(program), ElementsAre(64, 128, 255, 255));
}

TEST_F(Reload, OneThatDoesNotCompileGoesOnAsItWas) {
  const gg::Program program = coloring("vec4(1, 0, 0, 1)");
  window.swapBuffers();
  save("vec4(1, 0, 0, 1) + foo");
  EXPECT_THAT(wait(), testing::StartsWith("test.frag:4:43: error: `foo' undeclared\n"));
  EXPECT_THAT(drawn(program), ElementsAre(255, 0, 0, 255));
  EXPECT_EQ(wait(), "") << "said once";
  save("vec4(0, 0, 1, 1)");
  EXPECT_EQ(wait(), "test.vert + test.frag: reloaded\n");
  EXPECT_THAT(drawn(program), ElementsAre(0, 0, 255, 255));
}

TEST_F(Reload, OneThatDoesNotLinkGoesOnAsItWas) {
  const gg::Program program = coloring("vec4(1, 0, 0, 1)");
  window.swapBuffers();
  save("uClip", "uniform vec4 uClip;"); // a matrix in the other stage
  EXPECT_THAT(wait(), HasSubstr("test.vert + test.frag: error: does not link: "));
  EXPECT_THAT(drawn(program), ElementsAre(255, 0, 0, 255));
}

TEST_F(Reload, AnIncludedFileCounts) {
  folder.write("color.glsl", "vec4 color() { return vec4(1, 0, 0, 1); }\n");
  const gg::Program program = coloring("color()", "#include \"color.glsl\"");
  window.swapBuffers();
  folder.write("color.glsl", "vec4 color() { return vec4(0, 0, 1, 1); }\n");
  std::filesystem::last_write_time(folder.path() / "color.glsl",
                                   std::filesystem::file_time_type::clock::now() +
                                       std::chrono::seconds(1));
  EXPECT_EQ(wait(), "test.vert + test.frag: reloaded\n");
  EXPECT_THAT(drawn(program), ElementsAre(0, 0, 255, 255));
}

TEST_F(Reload, AFileThatIsGoneForAMomentChangesNothing) {
  const gg::Program program = coloring("vec4(1, 0, 0, 1)");
  window.swapBuffers();
  std::filesystem::remove(folder.path() / "test.frag");
  EXPECT_EQ(wait(), "");
  save("vec4(0, 1, 0, 1)");
  EXPECT_EQ(wait(), "test.vert + test.frag: reloaded\n");
}

} // namespace
