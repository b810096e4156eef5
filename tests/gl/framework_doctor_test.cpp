// What the frame doctor says of frames that go wrong, and that it is silent otherwise.

#include "framework_temporary_folder.hpp"
#include "in_japanese.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <thread>

#include <gg/gg.hpp> // last: from here on, calls are placed

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ResultOf;
using testing::StartsWith;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

constexpr int kSide = 32; // pixels of the window

/// One frame of a program, watched from the moment that the window is open.
class Doctor : public testing::TestWithParam<const char*> {
protected:
  // Without the driver's own messages, as on a Mac, and with them.
  Doctor() { setenv("GG_DEBUG_OUTPUT", GetParam(), 1); }
  ~Doctor() override { unsetenv("GG_DEBUG_OUTPUT"); }

  /// What is printed in a frame that `draw` makes.
  template <class Draw> std::string frame(Draw draw) {
    CaptureStderr();
    {
      gg::Window window("test", {kSide, kSide});
      const gg::VertexArray corners; // bound while drawing, and empty
      glBindVertexArray(corners);
      draw(window);
      window.swapBuffers();
      const std::string printed = GetCapturedStderr();
      CaptureStderr();
      window.swapBuffers();
      EXPECT_EQ(GetCapturedStderr(), "") << "one frame is watched";
      return printed;
    }
  }

  /// Half of what is drawn into, in one colour; or `color`, an expression of GLSL.
  gg::Program triangle(const std::string& color = "vec4(1, 0, 0, 1)",
                       const std::string& declarations = "") const {
    folder.write("test.vert", "#version 410 core\n"
                              "void main() { gl_Position = vec4(2 * (gl_VertexID & 1) - 1, "
                              "2 * (gl_VertexID >> 1) - 1, 0, 1); }\n");
    folder.write("test.frag", "#version 410 core\n" + declarations +
                                  "\nlayout(location = 0) out vec4 oColor;\n"
                                  "void main() { oColor = " +
                                  color + "; }\n");
    return gg::Program({"test.vert", "test.frag"}, folder.path().string());
  }

  static void clear() { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }
  static void draw() { glDrawArrays(GL_TRIANGLES, 0, 3); }

  TemporaryFolder folder;
};

INSTANTIATE_TEST_SUITE_P(Framework, Doctor, testing::Values("0", "1"), [](const auto& one) {
  return std::string(one.param) == "0" ? "WithoutTheDriversWords" : "WithTheDriversWords";
});

std::ptrdiff_t lines(const std::string& text) {
  return std::ranges::count(text, '\n');
}

/// A texture of 16 x 16 pixels to draw into.
struct Target {
  explicit Target(int width = 16) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindTexture(GL_TEXTURE_2D, color);
    if (width > 0)
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, 16, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
  }
  gg::Texture color;
  gg::Framebuffer framebuffer;
};

TEST_P(Doctor, IsSilentWhenAllIsWell) {
  EXPECT_EQ(frame([&](gg::Window& window) {
              const gg::Program red = triangle(), copy = triangle("texture(uTex, vec2(0))",
                                                                  "uniform sampler2D uTex;");
              glEnable(GL_DEPTH_TEST);
              glEnable(GL_CULL_FACE);
              const Target target;
              glViewport(0, 0, 16, 16);
              clear();
              red.use();
              draw();
              glBindFramebuffer(GL_FRAMEBUFFER, 0);
              glViewport(0, 0, window.width(), window.height());
              clear();
              copy.use();
              copy.set("uTex", 0);
              draw();
            }),
            "");
}

TEST_P(Doctor, CanBeSwitchedOff) {
  setenv("GG_DOCTOR", "0", 1);
  EXPECT_EQ(frame([](gg::Window&) {}), "");
  unsetenv("GG_DOCTOR");
}

TEST_P(Doctor, NothingIsDrawn) {
  const std::string said = "frame doctor: nothing is drawn to the window: there is no draw call "
                           "before the end of the frame\n";
  EXPECT_EQ(frame([](gg::Window&) { clear(); }), said);
  EXPECT_EQ(frame([](gg::Window& window) {
              const Target cleared;
              clear();
              glBindFramebuffer(GL_FRAMEBUFFER, 0);
              glViewport(0, 0, window.width(), window.height());
              clear();
            }),
            said)
      << "clearing a framebuffer object draws nothing, either";
}

TEST_P(Doctor, SpeaksJapanese) {
  const InJapanese japanese;
  EXPECT_EQ(frame([](gg::Window&) { clear(); }),
            "フレームの診断：ウィンドウに何も描画されていません。フレームの終わりまでに描画命令が"
            "一つもありません\n");
}

TEST_P(Doctor, AFramebufferObjectIsLeftBound) {
  int line = 0;
  const std::string printed = frame([&](gg::Window&) {
    const gg::Program red = triangle();
    GLuint color = 0, framebuffer = 0; // alive when the frame ends
    glGenTextures(1, &color);
    glBindTexture(GL_TEXTURE_2D, color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_FLOAT, nullptr);
    glGenFramebuffers(1, &framebuffer);
    line = __LINE__ + 1;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    clear();
    red.use();
    draw();
  });
  EXPECT_EQ(printed,
            "frame doctor: framebuffer object 1 is still bound at the end of the frame; the window "
            "needs glBindFramebuffer(GL_FRAMEBUFFER, 0) "
            "(framework_doctor_test.cpp:" +
                std::to_string(line) +
                ")\nframe doctor: nothing is drawn to the window: all that this frame draws goes "
                "to framebuffer objects\n");
}

TEST_P(Doctor, AnIncompleteFramebuffer) {
  EXPECT_THAT(frame([&](gg::Window&) {
                const gg::Program red = triangle();
                clear();
                red.use();
                draw();
                const Target target(0);
                draw();
                glBindFramebuffer(GL_FRAMEBUFFER, 0);
              }),
              HasSubstr("framebuffer object 301 is not complete, so nothing is drawn into it: an "
                        "attachment has no storage"));
}

/// With depth it is complete all the same.
TEST_P(Doctor, AFramebufferWithoutItsColour) {
  const auto withDepth = [&](GLenum drawBuffer, GLbitfield cleared) {
    return frame([&](gg::Window& window) {
      const gg::Program red = triangle();
      const gg::Framebuffer framebuffer;
      const gg::Renderbuffer depth;
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      glBindRenderbuffer(GL_RENDERBUFFER, depth);
      glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 16, 16);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
      glDrawBuffer(drawBuffer);
      glViewport(0, 0, 16, 16);
      red.use();
      for (int layer = 0; layer < 2; ++layer) {
        glClear(cleared);
        draw();
      }
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      glViewport(0, 0, window.width(), window.height());
      clear();
      draw();
    });
  };
  constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  EXPECT_THAT(
      withDepth(GL_COLOR_ATTACHMENT0, kBoth),
      AllOf(HasSubstr("frame doctor: framebuffer object 301 has no colour attachment, so its "
                      "colours are neither cleared nor drawn: glFramebufferTexture2D "
                      "attaches a texture, as GL_COLOR_ATTACHMENT0. Where depth is enough, "
                      "glDrawBuffer(GL_NONE) (framework_doctor_test.cpp:"),
            ResultOf(lines, 1)));
  EXPECT_EQ(withDepth(GL_NONE, kBoth), "");
  EXPECT_EQ(withDepth(GL_COLOR_ATTACHMENT0, GL_DEPTH_BUFFER_BIT), "") << "as a shadow map may";
}

TEST_P(Doctor, AViewportThatDoesNotFit) {
  EXPECT_THAT(
      frame([&](gg::Window&) {
        const gg::Program red = triangle();
        const Target target(48);
        red.use();
        draw();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        clear();
        draw();
      }),
      AllOf(StartsWith("frame doctor: the viewport is 32 x 32 pixels, but the first attachment of "
                       "framebuffer object 301 is 48 x 16. Is glViewport called after binding what "
                       "is drawn into, and "
                       "with its size? Or has that a wrong size? (framework_doctor_test.cpp:"),
            ResultOf(lines, 1)));
}

TEST_P(Doctor, AViewportOfNoSize) {
  EXPECT_THAT(frame([&](gg::Window&) {
                const gg::Program red = triangle();
                red.use();
                glViewport(0, 0, 0, 32);
                clear();
                draw();
              }),
              StartsWith("frame doctor: the viewport is 0 x 32 pixels, but the window is 32 x 32. "
                         "Is the size that it is given ever set? (framework_doctor_test.cpp:"));
}

TEST_P(Doctor, AViewportThatIsMoved) {
  EXPECT_THAT(frame([&](gg::Window&) {
                const gg::Program red = triangle();
                red.use();
                glViewport(1, 0, 32, 32);
                clear();
                draw();
              }),
              StartsWith("frame doctor: the viewport of the window begins at (1, 0). It should "
                         "begin at (0, 0) (framework_doctor_test.cpp:"));
}

TEST_P(Doctor, TheWindowsViewportIsForgotten) {
  int line = 0;
  const std::string printed = frame([&](gg::Window&) {
    const gg::Program red = triangle();
    const Target target;
    glViewport(0, 0, 16, 16);
    red.use();
    draw();
    line = __LINE__ + 1;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    clear();
    draw();
  });
  EXPECT_EQ(printed,
            "frame doctor: the viewport is 16 x 16 pixels, but the window is 32 x 32. Is "
            "glViewport called after binding what is drawn into, and with its size? Or has that a "
            "wrong size? (framework_doctor_test.cpp:" +
                std::to_string(line) + ")\n");
}

TEST_P(Doctor, CullingIsLeftAtFront) {
  EXPECT_THAT(
      frame([&](gg::Window&) {
        const gg::Program red = triangle();
        clear();
        red.use();
        draw();
        glEnable(GL_CULL_FACE);
        glCullFace(GL_FRONT);
      }),
      HasSubstr("frame doctor: culling is left at GL_FRONT: what faces the eye is not drawn "
                "from here on. glCullFace(GL_BACK) (framework_doctor_test.cpp:"));
}

TEST_P(Doctor, ColoursLeftMasked) {
  int line = 0;
  const std::string said = frame([&](gg::Window&) {
    const gg::Program program = triangle("vec4(1)");
    clear();
    program.use();
    draw();
    line = __LINE__ + 1;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  });
  EXPECT_THAT(said, HasSubstr("frame doctor: colours are left masked: from here on none is "
                              "written, and the next frame isn't cleared. glColorMask(GL_TRUE, "
                              "GL_TRUE, GL_TRUE, GL_TRUE) (framework_doctor_test.cpp:" +
                              std::to_string(line) + ")"));
}

TEST_P(Doctor, ClippingIsEnabledForAShaderThatWritesNoDistance) {
  EXPECT_THAT(frame([&](gg::Window&) {
                const gg::Program red = triangle(), green = triangle("vec4(0, 1, 0, 1)");
                glEnable(GL_CLIP_DISTANCE0);
                clear();
                for (const gg::Program* program : {&red, &green}) {
                  program->use();
                  draw();
                }
                glDisable(GL_CLIP_DISTANCE0);
              }),
              AllOf(HasSubstr("frame doctor: GL_CLIP_DISTANCE0 is enabled, but a vertex shader "
                              "that draws writes no gl_ClipDistance: a graphics card may cut off "
                              "anything. Write it there, or glDisable(GL_CLIP_DISTANCE0) before it "
                              "draws (framework_"
                              "doctor_test.cpp:"),
                    ResultOf(lines, 1)));
}

TEST_P(Doctor, ADistanceIsWrittenWhileClippingIsNotEnabled) {
  const auto clipping = [&](bool enabled) {
    return frame([&](gg::Window&) {
      folder.write("clip.vert", "#version 410 core\n"
                                "void main() { gl_Position = vec4(2 * (gl_VertexID & 1) - 1, "
                                "2 * (gl_VertexID >> 1) - 1, 0, 1); gl_ClipDistance[0] = 1; }\n");
      const gg::Program red = triangle();
      const gg::Program clip({"clip.vert", "test.frag"}, folder.path().string());
      clear();
      clip.use();
      if (enabled) glEnable(GL_CLIP_DISTANCE0);
      draw();
      glDisable(GL_CLIP_DISTANCE0);
    });
  };
  EXPECT_EQ(clipping(true), "");
  EXPECT_THAT(clipping(false),
              HasSubstr("frame doctor: a vertex shader writes gl_ClipDistance, but "
                        "GL_CLIP_DISTANCE0 is not enabled while it draws: a graphics card cuts off "
                        "nothing. glEnable(GL_CLIP_DISTANCE0) (framework_doctor_test.cpp:"));
}

TEST_P(Doctor, AClipDistanceInACommentIsNone) {
  EXPECT_EQ(frame([&](gg::Window&) {
              const gg::Program red = triangle();
              folder.write("said.vert", "#version 410 core\n"
                                        "// TODO: gl_ClipDistance[0] is the distance\n"
                                        "/* gl_ClipDistance[0] = 1; */\n"
                                        "void main() { gl_Position = vec4(2 * (gl_VertexID & 1) - "
                                        "1, 2 * (gl_VertexID >> 1) - 1, 0, 1); }\n");
              const gg::Program said({"said.vert", "test.frag"}, folder.path().string());
              clear();
              said.use();
              draw();
            }),
            "");
}

TEST_P(Doctor, AUniformIsNeverSet) {
  EXPECT_THAT(
      frame([&](gg::Window&) {
        const gg::Program both = triangle("vec4(uColor * uScale, uOn ? 1 : 0, 0, 1)",
                                          "uniform float uColor, uScale; uniform bool uOn;");
        both.set("uColor", 1.0f);
        clear();
        both.use();
        draw();
      }),
      AllOf(HasSubstr(
                "frame doctor: uniform uScale of test.vert + test.frag is 0, as it was never set: "
                "set(\"uScale\", ...) (framework_doctor_test.cpp:"),
            ResultOf(lines, 1)));
}

/// As where another program's were set: one line for all.
TEST_P(Doctor, SeveralUniformsAreNeverSet) {
  EXPECT_THAT(frame([&](gg::Window&) {
                const gg::Program other = triangle("vec4(uColor)", "uniform float uColor;");
                const gg::Program program = triangle("vec4(uColor * uScale, uShift, 0, 1)",
                                                     "uniform float uColor, uScale, uShift;");
                other.set("uColor", 1.0f);
                clear();
                program.use();
                draw();
              }),
              AllOf(HasSubstr("frame doctor: the uniforms uColor, uScale, uShift of test.vert + "
                              "test.frag are 0, as they were never set: "),
                    ResultOf(lines, 1)));
}

TEST_P(Doctor, AUniformThatIsSetToNothingIsMeantSo) {
  EXPECT_EQ(frame([&](gg::Window&) {
              const gg::Program program =
                  triangle("vec4(1 - uDark, uGreen, uTable[1], 1)",
                           "uniform float uDark, uGreen = 0.5; uniform float uTable[2];");
              clear();
              program.use();
              program.set("uDark", 0.0f);
              const float table[] = {0, 1};
              glUniform1fv(glGetUniformLocation(program, "uTable"), 2, table);
              draw();
            }),
            "");
}

TEST_P(Doctor, DepthIsNotCleared) {
  EXPECT_THAT(frame([&](gg::Window&) {
                const gg::Program red = triangle();
                glEnable(GL_DEPTH_TEST);
                glClear(GL_COLOR_BUFFER_BIT);
                red.use();
                draw();
              }),
              HasSubstr("frame doctor: the depth test is on, but the depth of the window was not "
                        "cleared in this frame"));
}

TEST_P(Doctor, DepthIsClearedUnderAMask) {
  EXPECT_THAT(
      frame([&](gg::Window&) {
        const gg::Program red = triangle();
        glDepthMask(GL_FALSE);
        clear();
        red.use();
        draw();
      }),
      HasSubstr("the depth of the window is not cleared: glDepthMask(GL_FALSE) is still set"));
}

TEST_P(Doctor, ColoursAreNotCleared) {
  // Depths alone are cleared before so many vertices are drawn.
  const auto frameOf = [&](GLsizei vertices, const std::function<void()>& after) {
    return frame([&](gg::Window&) {
      const gg::Program red = triangle();
      glEnable(GL_DEPTH_TEST);
      glClear(GL_DEPTH_BUFFER_BIT);
      red.use();
      glDrawArrays(GL_TRIANGLES, 0, vertices);
      after();
    });
  };
  const auto nothing = [] {};
  EXPECT_THAT(frameOf(9, nothing),
              HasSubstr("the colours of the window are not cleared before objects are drawn"));
  EXPECT_THAT(
      frameOf(9,
              [] {
                glClear(GL_COLOR_BUFFER_BIT);
                draw();
              }),
      HasSubstr("objects are drawn into the window, and its colours are cleared after that"));
  EXPECT_EQ(frameOf(3, nothing), "") << "it may cover the window, and is no object";
}

TEST_P(Doctor, ATextureWithoutMipmaps) {
  int stored = 0; // the line of its storage
  const std::string said = frame([&](gg::Window&) {
    const gg::Program copy = triangle("texture(uTex, vec2(0))", "uniform sampler2D uTex;");
    const Target target;
    stored = __LINE__ + 1;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    clear();
    copy.use();
    draw();
  });
  EXPECT_THAT(said, HasSubstr("frame doctor: sampler uTex reads texture unit 0, where the texture "
                              "reads as black: it is incomplete: its filter wants mipmaps, and it "
                              "has none. Set GL_TEXTURE_MIN_FILTER to GL_NEAREST or GL_LINEAR "
                              "(framework_doctor_test.cpp:" +
                              std::to_string(stored) + ")"));
}

TEST_P(Doctor, ASamplerWithoutATexture) {
  EXPECT_THAT(
      frame([&](gg::Window&) {
        const gg::Program copy = triangle("texture(uTex, vec2(0))", "uniform sampler2D uTex;");
        clear();
        copy.use();
        copy.set("uTex", 3);
        draw();
      }),
      AllOf(HasSubstr("frame doctor: all pixels of the window have one colour, though something "
                      "was drawn there"),
            HasSubstr("frame doctor: perhaps: sampler uTex reads texture unit 3, where no "
                      "texture is bound: it reads black")));
}

/// What is said when `copy` draws into a texture of two levels that its sampler uTex may read.
///   prepare: what is done between binding all that and drawing
class DoctorOfFeedback : public Doctor {
protected:
  template <class Prepare> std::string feedback(Prepare prepare, int level = 0) {
    return frame([&](gg::Window& window) {
      const gg::Program copy = triangle("texture(uTex, vec2(0)) + uShift",
                                        "uniform sampler2D uTex; uniform vec4 uShift;");
      const gg::Framebuffer framebuffer;
      const gg::Texture texture, other;
      for (const GLuint one : {GLuint(other), GLuint(texture)}) {
        glBindTexture(GL_TEXTURE_2D, one);
        for (int i = 0; i < 2; ++i)
          glTexImage2D(GL_TEXTURE_2D, i, GL_RGBA8, kSide >> i, kSide >> i, 0, GL_RGBA, GL_FLOAT,
                       nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
      }
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer), boundAt_ = __LINE__;
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, level);
      glViewport(0, 0, kSide >> level, kSide >> level);
      glClear(GL_COLOR_BUFFER_BIT);
      copy.use();
      copy.set("uTex", 0);
      copy.set("uShift", glm::vec4(1));
      prepare(copy, other);
      for (int i = 0; i < 2; ++i) draw();
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      glBindTexture(GL_TEXTURE_2D, texture); // into the window it may be read
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
      glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      glViewport(0, 0, window.width(), window.height());
      clear();
      draw();
    });
  }
  int boundAt_ = 0; ///< the line of the last call that binds what the loop is made of
};

INSTANTIATE_TEST_SUITE_P(Framework, DoctorOfFeedback, testing::Values("0"));

TEST_P(DoctorOfFeedback, ATextureIsReadAndDrawnInto) {
  EXPECT_THAT(feedback([](const gg::Program&, GLuint) {}),
              AllOf(HasSubstr("frame doctor: sampler uTex of test.vert + test.frag reads the "
                              "texture that is being drawn into (GL_COLOR_ATTACHMENT0 of "
                              "framebuffer object 301), a feedback loop, whose result is "
                              "undefined: bind another texture to unit 0 or another framebuffer "
                              "before drawing; "),
                    ResultOf(lines, 1)));
}

/// Not where it is drawn, which a helper may do for many.
TEST_P(DoctorOfFeedback, ThePlaceIsWhereTheLoopIsClosed) {
  const std::string said = feedback([](const gg::Program&, GLuint) {});
  EXPECT_THAT(said, HasSubstr(fmt::format("framework_doctor_test.cpp:{})", boundAt_)));
}

/// As down a pyramid that reads the level it writes.
TEST_P(DoctorOfFeedback, ASamplerIsNamedOnce) {
  EXPECT_THAT(feedback([](const gg::Program&, GLuint) {
                draw();
                const gg::Framebuffer another;
                GLint texture = 0;
                glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
                glBindFramebuffer(GL_FRAMEBUFFER, another);
                glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                                       GLuint(texture), 0);
                draw();
              }),
              AllOf(HasSubstr("a feedback loop"), ResultOf(lines, 1)));
}

/// Where the window isn't bound again, what was drawn is read on its framebuffer object.
TEST_P(DoctorOfFeedback, IsNotToldWhereItComesOfAFramebufferLeftBound) {
  EXPECT_THAT(
      frame([&](gg::Window&) {
        const gg::Program copy = triangle("texture(uTex, vec2(0))", "uniform sampler2D uTex;");
        GLuint color = 0, framebuffer = 0; // alive when the frame ends
        glGenTextures(1, &color);
        glBindTexture(GL_TEXTURE_2D, color);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_FLOAT, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
        clear();
        copy.use();
        draw();
      }),
      AllOf(HasSubstr("is still bound at the end of the frame"),
            Not(HasSubstr("a feedback loop"))));
}

TEST_P(DoctorOfFeedback, AnotherTextureMayBeRead) {
  EXPECT_EQ(feedback([](const gg::Program&, GLuint other) { glBindTexture(GL_TEXTURE_2D, other); }),
            "");
  EXPECT_EQ(feedback([](const gg::Program& copy, GLuint other) {
              copy.set("uTex", 1); // the texture stays bound to a unit that nobody reads
              glActiveTexture(GL_TEXTURE1);
              glBindTexture(GL_TEXTURE_2D, other);
            }),
            "");
}

/// By the sampler's filter: mipmaps are read from the base level to the last.
TEST_P(DoctorOfFeedback, AnotherLevelMayBeRead) {
  const auto filter = [](GLint filter, GLint base, GLint last) {
    return [=](const gg::Program&, GLuint) {
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, base);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, last);
    };
  };
  const auto isTold = HasSubstr("a feedback loop");
  EXPECT_EQ(feedback(filter(GL_LINEAR_MIPMAP_LINEAR, 1, 1), 0), "");
  EXPECT_EQ(feedback(filter(GL_LINEAR_MIPMAP_LINEAR, 0, 0), 1), "");
  EXPECT_EQ(feedback(filter(GL_LINEAR, 0, 1), 1), "");
  EXPECT_THAT(feedback(filter(GL_LINEAR_MIPMAP_LINEAR, 0, 1), 1), isTold);
  EXPECT_THAT(feedback(filter(GL_LINEAR, 1, 1), 1), isTold);
}

TEST_P(DoctorOfFeedback, WhatIsNotWrittenMayBeRead) {
  EXPECT_EQ(feedback([](const gg::Program&, GLuint) { glDrawBuffer(GL_NONE); }), "");
  EXPECT_EQ(feedback([](const gg::Program&, GLuint) {
              glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
            }),
            "");
}

TEST_P(Doctor, ADepthTextureIsReadAndDrawnInto) {
  const auto reading = [&](bool isTested, GLboolean isWritten) {
    return frame([&](gg::Window&) {
      const gg::Program copy =
          triangle("texture(uDepth, vec2(0)) + 1", "uniform sampler2D uDepth;");
      const gg::Framebuffer framebuffer;
      const gg::Texture depth;
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      glBindTexture(GL_TEXTURE_2D, depth);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kSide, kSide, 0, GL_DEPTH_COMPONENT,
                   GL_FLOAT, nullptr);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
      glDrawBuffer(GL_NONE);
      glClear(GL_DEPTH_BUFFER_BIT);
      if (isTested) glEnable(GL_DEPTH_TEST);
      glDepthMask(isWritten);
      copy.use();
      copy.set("uDepth", 0);
      draw();
      glDepthMask(GL_TRUE);
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      clear();
      draw();
    });
  };
  EXPECT_THAT(reading(true, GL_TRUE),
              AllOf(HasSubstr("frame doctor: sampler uDepth of test.vert + test.frag reads the "
                              "texture that is being drawn into (GL_DEPTH_ATTACHMENT of "
                              "framebuffer object 301), a feedback loop"),
                    ResultOf(lines, 1)));
  EXPECT_EQ(reading(true, GL_FALSE), "");
  EXPECT_EQ(reading(false, GL_TRUE), "") << "without the test no depth is written";
}

TEST_P(Doctor, AMatrixIsNotFinite) {
  const auto drawnWith = [&](const glm::mat4& matrix) {
    return frame([&](gg::Window&) {
      const gg::Program program = triangle("uView * vec4(1) + (uModel * vec4(uNormal[0], 1))",
                                           "uniform mat4 uView, uModel; uniform mat3 uNormal;");
      clear();
      program.use();
      program.set("uView", glm::mat4(1));
      program.set("uModel", matrix);
      program.set("uNormal", glm::mat3(matrix));
      for (int i = 0; i < 2; ++i) draw();
    });
  };
  const auto isTold =
      AllOf(HasSubstr("frame doctor: a matrix of test.vert + test.frag holds NaN or infinity "
                      "(uModel, uNormal), so what is drawn with it gets lost: look for a division "
                      "by zero, "),
            ResultOf(lines, 1));
  EXPECT_THAT(drawnWith(glm::inverse(glm::scale(glm::mat4(1), glm::vec3(1, 1, 0)))), isTold);
  EXPECT_THAT(drawnWith(glm::lookAt(glm::vec3(1), glm::vec3(1), glm::vec3(0, 1, 0))), isTold);
  EXPECT_THAT(drawnWith(glm::lookAt(glm::vec3(0, 2, 0), glm::vec3(0), glm::vec3(0, 1, 0))), isTold);
  EXPECT_THAT(drawnWith(glm::perspective(0.0f, 1.0f, 1.0f, 2.0f)), isTold);
  EXPECT_THAT(drawnWith(glm::perspective(1.0f, 1.0f, 1.0f, 1.0f)), HasSubstr("NaN or infinity"));
  EXPECT_EQ(drawnWith(glm::infinitePerspective(1.0f, 1.0f, 1.0f)), "");
  EXPECT_EQ(drawnWith(glm::mat4(3e38f)), "") << "large, but finite";
}

/// As with the name of a deleted program, which some drivers give to the next one.
TEST_P(Doctor, AProgramLinkedAnewHasOtherUniforms) {
  EXPECT_EQ(frame([&](gg::Window&) {
              const gg::Program scaled = triangle("uScale * vec4(1)", "uniform mat4 uScale;");
              const gg::Program red = triangle();
              clear();
              scaled.set("uScale", glm::mat4(1));
              scaled.use();
              draw();
              GLuint before[2], after[2];
              glGetAttachedShaders(scaled, 2, nullptr, before);
              glGetAttachedShaders(red, 2, nullptr, after);
              for (int i = 0; i < 2; ++i) {
                glDetachShader(scaled, before[i]);
                glAttachShader(scaled, after[i]);
              }
              glLinkProgram(scaled);
              draw();
            }),
            "");
}

TEST_P(Doctor, AWindowThatShowedNoFrameIsForgotten) {
  {
    const gg::Window window("before", {kSide, kSide});
    const gg::VertexArray corners;
    glBindVertexArray(corners);
    const gg::Program scaled = triangle("uScale * vec4(1)", "uniform mat4 uScale;");
    scaled.set("uScale", glm::mat4(1));
    scaled.use();
    draw();
  }
  EXPECT_EQ(frame([&](gg::Window&) {
              const gg::Program red = triangle();
              clear();
              red.use();
              draw();
            }),
            "");
}

TEST_P(Doctor, NoProgramIsInUse) {
  EXPECT_THAT(
      frame([&](gg::Window&) {
        const gg::Program tile = triangle("uColor", "uniform vec4 uColor;");
        clear();
        tile.set("uColor", glm::vec4(1));
        draw();
      }),
      HasSubstr("frame doctor: something is drawn while no program is in use, which draws nothing: "
                "call use() (or glUseProgram) before it (framework_doctor_test.cpp:"));
}

/// Two programs of a frame: `object` draws first, and `draw` does the rest.
class DoctorOfUse : public Doctor {
protected:
  template <class Draw> std::string afterObject(Draw rest) {
    return frame([&](gg::Window&) {
      folder.write("object.frag", "#version 410 core\nuniform vec4 uColor;\n"
                                  "layout(location = 0) out vec4 oColor;\n"
                                  "void main() { oColor = uColor; }\n");
      const gg::Program tile = triangle("uColor", "uniform vec4 uColor;");
      const gg::Program object({"test.vert", "object.frag"}, folder.path().string());
      clear();
      object.use();
      object.set("uColor", glm::vec4(1));
      draw();
      rest(object, tile);
    });
  }
  static constexpr glm::vec4 kRed{1, 0, 0, 1};
};

INSTANTIATE_TEST_SUITE_P(Framework, DoctorOfUse, testing::Values("0"));

TEST_P(DoctorOfUse, AProgramIsSetAndAnotherOneDraws) {
  EXPECT_THAT(
      afterObject([](const gg::Program&, const gg::Program& tile) {
        for (int i = 0; i < 2; ++i) {
          tile.set("uColor", kRed);
          draw();
        }
      }),
      AllOf(HasSubstr("frame doctor: test.vert + test.frag draws nothing in this frame: its "
                      "uniforms are set, but what is drawn next is drawn with test.vert + "
                      "object.frag, which is still in use. set() doesn't change that: call "
                      "use() of test.vert + test.frag (or glUseProgram) before drawing "
                      "(framework_doctor_test.cpp:"),
            ResultOf(lines, 1)));
}

TEST_P(DoctorOfUse, AProgramMayBeSetForLater) {
  EXPECT_EQ(afterObject([](const gg::Program&, const gg::Program& tile) {
              tile.set("uColor", kRed);
              draw(); // with `object` once more
              tile.use();
              draw();
            }),
            "")
      << "it draws in this frame";
  EXPECT_EQ(
      afterObject([](const gg::Program&, const gg::Program& tile) { tile.set("uColor", kRed); }),
      "")
      << "of a pass that isn't written yet";
  EXPECT_EQ(afterObject([](const gg::Program& object, const gg::Program& tile) {
              tile.set("uColor", kRed);
              object.use();
              draw();
            }),
            "")
      << "the one that draws is told to";
  EXPECT_EQ(afterObject([](const gg::Program& object, const gg::Program& tile) {
              for (const gg::Program* program : {&object, &tile}) program->set("uColor", kRed);
              draw();
            }),
            "")
      << "both are set alike";
}

TEST_P(Doctor, NamesTheLineOfAnError) {
  int line = 0;
  const std::string printed = frame([&](gg::Window&) {
    const gg::Program red = triangle();
    clear();
    red.use();
    draw();
    line = __LINE__ + 1;
    glBindTexture(0x1234, 0);
  });
  EXPECT_THAT(printed,
              AllOf(HasSubstr("GL_INVALID_ENUM"), HasSubstr("in glBindTexture"),
                    HasSubstr("(framework_doctor_test.cpp:" + std::to_string(line) + ")\n")));
}

// A frame that never comes.
TEST(DoctorWaits, ForTheFirstFrame) {
  CaptureStderr();
  gg::Window window("test", {kSide, kSide});
  for (int i = 0; i < 3; ++i) glClear(GL_COLOR_BUFFER_BIT);
  std::this_thread::sleep_for(std::chrono::milliseconds(3500));
  EXPECT_EQ(GetCapturedStderr(), "frame doctor: no frame was shown within 3 seconds: does the loop "
                                 "call window.swapBuffers()?\n");
}

} // namespace
