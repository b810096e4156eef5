#pragma once
/// \file
/// A window and a folder for shaders, for each test.

#include <array>
#include <string>

#include "framework_temporary_folder.hpp"
#include <gg/program.hpp>
#include <gg/window.hpp>
#include <gtest/gtest.h>

class FrameworkWindow : public testing::Test {
protected:
  static constexpr int kSide = 32; // pixels

  /// Compiles files that were written to `folder`.
  gg::Program program(std::initializer_list<const char*> files) const {
    return gg::Program(files, folder.path().string());
  }

  /// A program that colours with the expression `color` (a vec4). Its uniforms, inputs and
  /// functions may be declared in `declarations`.
  gg::Program coloring(const std::string& color, const std::string& declarations = "") const {
    folder.write("test.vert", "#version 410 core\n"
                              "layout(location = 0) in vec4 aPosition;\n"
                              "layout(location = 1) in vec3 aNormal;\n"
                              "layout(location = 2) in vec2 aUv;\n"
                              "layout(location = 3) in vec4 aTangent;\n"
                              "uniform mat4 uClip;\n"
                              "out vec3 vNormal; out vec2 vUv; out vec4 vTangent;\n"
                              "void main() { vNormal = aNormal; vUv = aUv; vTangent = aTangent;\n"
                              "  gl_Position = uClip * aPosition; }\n");
    folder.write("test.frag", "#version 410 core\n" + declarations +
                                  "\nin vec3 vNormal; in vec2 vUv; in vec4 vTangent;\n"
                                  "layout(location = 0) out vec4 oColor;\n"
                                  "void main() { oColor = " +
                                  color + "; }\n");
    return program({"test.vert", "test.frag"});
  }

  /// The window's pixel, counted from the bottom left.
  static std::array<int, 4> pixel(int x, int y) {
    std::array<GLubyte, 4> p{};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p.data());
    return {p[0], p[1], p[2], p[3]};
  }

  void TearDown() override { EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)); }

  TemporaryFolder folder;
  gg::Window window{"test", {kSide, kSide}};
};
