// `ggrade check`: why a window is white or black, and every save.

#include "kit_check.hpp"

#include <gmock/gmock.h>

#include <csignal>

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

using namespace tool;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

/// A line that begins with a file's place. Paths are from the folder where `check` runs, which may
/// be the root.
auto hasLineAt(const fs::path& file) {
  return testing::ContainsRegex("\n/?" + file.relative_path().string() + ":[0-9]+:");
}

void expectSilence(const json& part) {
  EXPECT_EQ(part.at("cause"), "");
  EXPECT_EQ(part.at("messages"), json::array()) << "the doctor is silent when all is well";
  for (const json& todo : part.at("todos")) EXPECT_EQ(todo.at("state"), "done") << todo;
}

/// One way to a window without a picture.
struct Window {
  const char* name;
  const char* file;
  std::string from, to;
  const char* cause; ///< what the sentence must name
};

const std::string kEndOfMirror = "  glBindFramebuffer(GL_FRAMEBUFFER, 0);\n"
                                 "  glViewport(0, 0, window.x, window.y);\n";
const std::string kClear = "    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n"
                           "    light.load(scene.light.in(view));";
const std::string kDepthTest = "  glEnable(GL_DEPTH_TEST);\n  glEnable(GL_CULL_FACE);";
const std::string kUse = "    objectProgram.use();";

std::vector<Window> windows() {
  return {
      {"swap in a comment", "floor.cpp", "    window.swapBuffers();",
       "    // shown at last \\\n    window.swapBuffers();", "a comment swallows the line"},
      {"framebuffer object left bound", "mirror.hpp", kEndOfMirror,
       "  glViewport(0, 0, window.x, window.y);\n", "is still bound"},
      {"window not cleared", "floor.cpp", kClear, "    light.load(scene.light.in(view));",
       "was not cleared in this frame"},
      {"depth not cleared", "floor.cpp", kClear,
       "    glClear(GL_COLOR_BUFFER_BIT);\n    light.load(scene.light.in(view));",
       "epth of the window was not cleared"},
      {"viewport of the framebuffer object", "mirror.hpp", kEndOfMirror,
       "  glBindFramebuffer(GL_FRAMEBUFFER, 0);\n", "viewport is 1024 x 1024"},
      {"empty viewport", "mirror.hpp", kEndOfMirror,
       "  glBindFramebuffer(GL_FRAMEBUFFER, 0);\n  glViewport(0, 0, 0, 0);\n", "viewport is empty"},
      {"incomplete framebuffer object", "mirror.hpp", "glRenderbufferStorage(",
       "if (size < 0) glRenderbufferStorage(", "framebuffer object is not complete"},
      {"shader that doesn't compile", "object.frag", "void main() {",
       "void main() {\n  vec3 wrong = 1.0;", "shader doesn't compile"},
      {"sampler on another unit", "floor.cpp", "tileProgram.set(\"uReflection\", 0);",
       "tileProgram.set(\"uReflection\", 3);", "ampler uReflection reads no texture"},
      {"texture that lacks mipmaps", "mirror.hpp",
       "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);", "", "mipmaps"},
      {"out of view", "floor.cpp",
       "const glm::mat4 projection = scene.camera.projection(window.aspect());",
       "const glm::mat4 projection = glm::perspective(1.0f, 1.0f, 0.01f, 0.1f);",
       "projection * view * model * position"},
      {"depth mask", "floor.cpp", kUse, "    glDepthMask(GL_FALSE);\n" + kUse, "glDepthMask"},
      {"colour mask", "floor.cpp", kUse,
       "    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);\n" + kUse, "glColorMask"},
      {"name of a uniform", "floor.cpp", "    program.set(\"uProjection\", projection);",
       "    program.set(\"uProjektion\", projection);",
       "uProjection of mirror.vert + object.frag is 0, as it was never set"},
      {"endless loop", "floor.cpp", "    const double time = glfwGetTime();",
       "    const double time = glfwGetTime();\n    while (glfwGetTime() >= 0) {}",
       "swapBuffers() is not reached"},
      {"blending with zero", "floor.cpp", kDepthTest,
       kDepthTest + "\n  glEnable(GL_BLEND);\n  glBlendFunc(GL_ZERO, GL_ZERO);", "GL_ZERO"},
      {"depth test that nothing passes", "floor.cpp", kDepthTest,
       kDepthTest + "\n  glDepthFunc(GL_NEVER);", "GL_NEVER"},
      {"depth cleared to 0", "floor.cpp", kDepthTest, kDepthTest + "\n  glClearDepth(0);",
       "glClearDepth(1)"},
      {"no program", "floor.cpp", kUse, "    glUseProgram(0);", "no program is in use"},
      {"scissor", "floor.cpp", kDepthTest,
       kDepthTest + "\n  glEnable(GL_SCISSOR_TEST);\n  glScissor(0, 0, 0, 0);", "GL_SCISSOR_TEST"},
      {"cleared last", "floor.cpp", "    window.swapBuffers();",
       "    glClear(GL_COLOR_BUFFER_BIT);\n    window.swapBuffers();",
       "cleared after the last draw"},
      {"culling left", "mirror.hpp", "  glCullFace(GL_BACK);\n", "", "ulling is left at GL_FRONT"},
  };
}

/// The steps' programs: exactly the first k TODOs are done, nothing else is begun.
TEST_F(Check, KnowsEveryStep) {
  for (std::size_t k = 0; k <= 7; ++k) {
    const json part = checked(Submission::firstSteps(int(k)).path());
    for (std::size_t i = 0; i < 7; ++i)
      EXPECT_EQ(part.at("todos").at(i).at("state"), i < k ? "done" : "not_begun")
          << "after step " << k << ": " << part.dump(1);
  }
}

/// Comments are for reading, and somebody may take them out, or write below the last one.
TEST_F(Check, KnowsEveryStepWithoutComments) {
  for (const int k : {1, 2, 4, 6, 7}) {
    const Submission submission = Submission::firstSteps(k);
    takeOutComments(submission.path());
    const json part = checked(submission.path());
    for (std::size_t i = 0; i < 7; ++i)
      EXPECT_EQ(part.at("todos").at(i).at("state"), i < std::size_t(k) ? "done" : "not_begun")
          << "after step " << k << ": " << part.dump(1);
  }
}

/// Comments in Japanese are read as those in English are, whichever of them the kit handed out.
TEST_F(Check, KnowsAStepWhoseCommentsAreJapanese) {
  const TemporaryFolder handedOut, step;
  for (const auto& [todos, folder] : {std::pair("0", &handedOut), std::pair("4", &step)})
    ASSERT_EQ(
        runTool({"derive", "mirror", "--done", todos, "--lang", "ja", "--out", folder->path()})
            .exitCode,
        0);
  ASSERT_THAT(read(step.path() / "mirror.hpp"), HasSubstr("// TODO(mirror.5): 鏡では"));
  const TemporaryFolder japanese;
  fs::copy(expected(), japanese.path(), fs::copy_options::recursive);
  fs::copy(handedOut.path(), japanese.path() / "mirror/handed_out",
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  const std::vector<std::string> untouched(7, "not_begun");
  std::vector<std::string> four = untouched;
  std::fill_n(four.begin(), 4, "done");
  for (const fs::path& kit : {expected(), japanese.path()}) {
    EXPECT_EQ(statesOf("mirror", kit, handedOut.path()), untouched) << kit;
    EXPECT_EQ(statesOf("mirror", kit, step.path()), four) << kit;
  }
  EXPECT_EQ(statesOf("mirror", japanese.path(), Submission::firstSteps(4).path()), four);
}

/// Of a step that isn't done it isn't known what to expect, wherever its comment was.
TEST_F(Check, TellsAMistakeWithoutComments) {
  Submission light = Submission::firstSteps(5);
  light.replace("mirror.hpp", "scene.light.in(mirroredView)", "scene.light.in(view)");
  takeOutComments(light.path());
  const json part = checked(light.path());
  EXPECT_EQ(part.at("cause"), "The light is not brought into the mirrored view") << part.dump(1);
  EXPECT_EQ(part.at("todos").at(3).at("state"), "wrong");
  EXPECT_EQ(part.at("todos").at(5).at("state"), "not_begun");
}

TEST_F(Check, SaysThatNothingOfAStepShows) {
  Submission submission = Submission::firstSteps(4);
  submission.replace("mirror.hpp", "inline void turnCulling() {\n",
                     "inline void turnCulling() {\n  glEnable(GL_CULL_FACE); // as it is\n");
  const json part = checked(submission.path());
  EXPECT_EQ(part.at("todos").at(3).at("state"), "done") << part.dump(1);
  EXPECT_EQ(part.at("todos").at(4).at("state"), "wrong");
  EXPECT_EQ(part.at("cause"),
            "Nothing of mirror.5 shows yet: all is as it was before it. Is all of "
            "it written, and is it called?");
}

/// The call fails in the step that draws, and the framebuffer object is that of the step before.
TEST_F(Check, DoubtsTheStepThatMadeAnIncompleteFramebufferObject) {
  Submission submission = Submission::firstSteps(2);
  submission.replace("mirror.hpp", "  glFramebufferTexture2D(",
                     "  if (false) glFramebufferTexture2D(");
  submission.replace("mirror.hpp", "  glFramebufferRenderbuffer(",
                     "  if (false) glFramebufferRenderbuffer(");
  submission.replace("mirror.hpp", "  if (glCheckFramebufferStatus(",
                     "  if (size < 0 && glCheckFramebufferStatus(");
  const json part = checked(submission.path());
  EXPECT_EQ(part.at("todos").at(0).at("state"), "maybe") << part.dump(1);
  EXPECT_EQ(part.at("todos").at(1).at("state"), "maybe");
  EXPECT_THAT(part.at("cause"), HasSubstr("not complete (FRAMEBUFFER_INCOMPLETE_MISSING"));
}

TEST_F(Check, NamesWhatIsToBeDoneInstead) {
  Arguments shadow = command(Submission::solution().path());
  shadow[1] = "shadow";
  const Ended ended = Running(shadow).wait(100);
  EXPECT_EQ(ended.exitCode, 2);
  EXPECT_EQ(ended.errors, "ggrade: nothing of shadow is to be done here, so there is nothing to "
                          "check of it. To do: mirror\n");
}

TEST_F(Check, KnowsAStepThatStandsInThePlaceOfAnother) {
  // All of the last one is in the third one's place, and in a function that is nobody's.
  Submission submission = Submission::solution();
  submission.replace("tile.frag",
                     "    if (uBlurSigma > 0 && uBlurSamples > 0) reflected = "
                     "blurredReflection(at);\n",
                     "");
  submission.replace("tile.frag", "reflected = texture(uReflection, at).rgb;",
                     "reflected = uBlurSigma > 0 && uBlurSamples > 0 ? blurredReflection(at) : "
                     "texture(uReflection, at).rgb;");
  for (const json& todo : checked(submission.path()).at("todos"))
    EXPECT_EQ(todo.at("state"), "done") << todo;
}

TEST_F(Check, NamesWhyAWindowIsWhiteOrBlack) {
  expectSilence(checked(Submission::solution().path()));
  for (const Window& window : windows()) {
    SCOPED_TRACE(window.name);
    Submission submission = Submission::solution();
    submission.replace(window.file, window.from, window.to);
    const json part = checked(submission.path());
    EXPECT_THAT(part.at("cause").get<std::string>(), HasSubstr(window.cause));
    EXPECT_THAT(part.at("cause").get<std::string>(), Not(HasSubstr("\n")));
  }
}

/// Right answers of each kind: other textures, other states, other shaders, no framebuffer object.
/// The rest of them: long_kit_test.cpp.
TEST_F(Check, IsSilentOnRightAnswers) {
  for (const char* name : {"mirror_copied", "mirror_depth_texture", "mirror_direct_state_access",
                           "mirror_discard", "mirror_inverse_transpose", "mirror_mirrored_camera",
                           "mirror_model_mirrored", "mirror_multisampled", "mirror_window_sized"}) {
    SCOPED_TRACE(name);
    expectSilence(checked(Submission::variant(name).path()));
  }
}

TEST_F(Check, WhatCannotDrawIsNotJudged) {
  Submission submission = Submission::solution();
  submission.replace("tile.frag", "void main() {", "void main() {\n  vec3 wrong = 1.0;");
  const Ended ended = Running(command(submission.path())).wait(100);
  EXPECT_EQ(ended.exitCode, 1);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("mirror: not judged: the program draws nothing"),
                               HasSubstr("judged once the program draws"), Not(HasSubstr("Next:")),
                               Not(HasSubstr("0 of 7"))));
  // As compilers write it, once, and told at once: it is no riddle.
  const fs::path shader = submission.path() / "tile.frag";
  EXPECT_THAT(ended.out, AllOf(hasLineAt(shader), HasSubstr("A shader doesn't compile")));
  const std::string place = shader.relative_path().string();
  EXPECT_EQ(ended.out.find(place), ended.out.rfind(place)) << ended.out;
}

/// Step 6 is seen in the handout's scene alone, so that is the one that is shown.
TEST_F(Check, ShowsTheSceneThatItSpeaksOf) {
  const Submission finished = Submission::firstSteps(7);
  const Ended all = Running(command(finished.path())).wait(100);
  EXPECT_THAT(all.out, HasSubstr("Next: every step is done; hand in what you changed in " +
                                 finished.path().relative_path().string() + '\n'));
  const Ended six = Running(command(Submission::firstSteps(6).path())).wait(100);
  EXPECT_EQ(six.exitCode, 0) << six.out;
  // Pages are too long to be printed where this fails.
  const auto pageSays = [&](const char* text) {
    return read(folder_.path() / "check.html").find(text) != std::string::npos;
  };
  EXPECT_TRUE(pageSays("your window (in the scene of the handout&apos;s step 6)"));
  const Ended five = Running(command(Submission::firstSteps(5).path())).wait(100);
  EXPECT_EQ(five.exitCode, 0) << five.out;
  EXPECT_THAT(five.out, HasSubstr("Next: assignments/floor/mirror.md, step 6: "));
  EXPECT_TRUE(pageSays("your window"));
  EXPECT_FALSE(pageSays("in the scene of"));
}

TEST_F(Check, NamesAKnownMistakeAndItsTodo) {
  const json part = checked(Submission::example("light_not_mirrored").path());
  EXPECT_THAT(part.at("cause").get<std::string>(), HasSubstr("light"));
  EXPECT_EQ(part.at("todos").at(3).at("state"), "wrong") << part.dump(1);
  EXPECT_EQ(part.at("todos").at(1).at("state"), "done");
}

/// Where it is made, long before the program is finished.
TEST_F(Check, NamesAKnownMistakeAtItsOwnStep) {
  Submission light = Submission::firstSteps(4);
  light.replace("mirror.hpp", "scene.light.in(mirroredView)", "scene.light.in(view)");
  json part = checked(light.path());
  EXPECT_EQ(part.at("cause"), "The light is not brought into the mirrored view");
  EXPECT_EQ(part.at("todos").at(3).at("state"), "wrong");
  EXPECT_EQ(part.at("todos").at(2).at("state"), "done");
  Submission clear = Submission::firstSteps(2);
  clear.replace("mirror.hpp", "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);",
                "glClear(GL_DEPTH_BUFFER_BIT);");
  part = checked(clear.path());
  // Which of them can't be told before objects are drawn.
  EXPECT_EQ(part.at("cause"), "It may be one of these 3 mistakes, which look alike so far");
  EXPECT_THAT(part.at("hint").get<std::string>(),
              AllOf(HasSubstr("- The clear comes before the framebuffer object is bound\n  "),
                    HasSubstr("\n- Only the depth of the framebuffer object is cleared\n  "),
                    HasSubstr("\n- The mirror pass draws into the window\n  ")));
  EXPECT_EQ(part.at("todos").at(1).at("state"), "wrong");
  // The statement that stands above its TODO is all that was changed for step 5.
  Submission culling = Submission::firstSteps(5);
  culling.replace("mirror.hpp", "  glCullFace(GL_FRONT);\n", "");
  culling.replace("mirror.hpp", "  glCullFace(GL_BACK);\n", "");
  culling.replace("mirror.vert", "  vNormal = -vNormal;\n", "");
  culling.replace("mirror.vert", "vNormal = uNormal * aNormal", "vNormal = -(uNormal * aNormal)");
  part = checked(culling.path());
  EXPECT_EQ(part.at("cause"), "Back faces are culled in the mirror pass");
  EXPECT_EQ(part.at("todos").at(4).at("state"), "wrong");
  EXPECT_EQ(part.at("todos").at(3).at("state"), "done");
}

/// Any size will do; the window, which doesn't show the texture yet, is right.
TEST_F(Check, ATextureOfAnotherSizeIsNotCalledWrong) {
  Submission submission = Submission::firstSteps(2);
  submission.replace("floor.cpp", "scene.integer(\"quality.mirror_size\")", "300");
  const Ended ended = Running(command(submission.path())).wait(100);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("mirror: [##------------] 1 of 7 done"),
                               HasSubstr("  mirror.2          differs"),
                               HasSubstr(": warning: mirror.2 may be"),
                               HasSubstr("or another right way; it may lie in mirror.1, too"),
                               Not(HasSubstr("Likely cause"))));
  submission.replace("mirror.hpp", "  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n", "");
  EXPECT_EQ(checked(submission.path()).at("todos").at(1).at("state"), "wrong")
      << "there is no pass at all";
}

/// Software clips by what is written, so no picture tells; a graphics card doesn't.
TEST_F(Check, TellsOfClippingThatWasNotEnabled) {
  Submission submission = Submission::firstSteps(6);
  submission.replace("mirror.hpp", "  if (clip) glEnable(GL_CLIP_DISTANCE0);\n", "");
  const json part = checked(submission.path());
  EXPECT_EQ(part.at("todos").at(5).at("state"), "wrong");
  EXPECT_EQ(part.at("todos").at(4).at("state"), "done");
  EXPECT_THAT(part.at("cause").get<std::string>(), HasSubstr("glEnable(GL_CLIP_DISTANCE0)"));
}

/// Though nothing else is bound that the floor could sample instead.
TEST_F(Check, ATextureThatIsNotBoundIsMissed) {
  const std::string bind = "  glBindTexture(GL_TEXTURE_2D, reflection.color);\n";
  for (const bool atAll : {false, true})
    for (const int steps : {3, 7}) {
      Submission submission = Submission::firstSteps(steps);
      submission.replace("mirror.hpp", "  glActiveTexture(GL_TEXTURE0);\n" + bind,
                         atAll ? "  glActiveTexture(GL_TEXTURE1);\n" + bind : "");
      const json part = checked(submission.path());
      EXPECT_EQ(part.at("todos").at(2).at("state"), "wrong") << part.dump(1);
      EXPECT_THAT(part.at("cause").get<std::string>(),
                  HasSubstr("The sampler uReflection reads no texture"));
    }
}

/// What pictures show of a mistake that nobody knows may come of several steps, and what is
/// observed goes before what looks like a known one.
TEST_F(Check, DoubtsWhatItDoesNotKnow) {
  Submission axis = Submission::solution();
  axis.replace("mirror.hpp", "glm::vec3(1, -1, 1)", "glm::vec3(1, 1, -1)");
  json part = checked(axis.path());
  EXPECT_EQ(part.at("todos").at(3).at("state"), "maybe") << part.dump(1);
  EXPECT_EQ(part.at("todos").at(4).at("state"), "maybe") << part.dump(1);
  EXPECT_EQ(part.at("cause"), "");
  // The same picture as that of a framebuffer object without depths.
  Submission test = Submission::solution();
  test.replace(
      "mirror.hpp", "  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n",
      "  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n  glDisable(GL_DEPTH_TEST);\n");
  test.replace("mirror.hpp", kEndOfMirror, kEndOfMirror + "  glEnable(GL_DEPTH_TEST);\n");
  part = checked(test.path());
  EXPECT_THAT(part.at("cause").get<std::string>(), HasSubstr("while the depth test is off"));
  EXPECT_EQ(part.at("hint"), "") << "what may be is no help beside what is";
  for (const json& todo : part.at("todos")) EXPECT_NE(todo.at("state"), "wrong") << part.dump(1);
  // It is wrong where it was called.
  Submission viewport = Submission::solution();
  viewport.replace("mirror.hpp", "glViewport(0, 0, reflection.size, reflection.size)",
                   "glViewport(0, 0, reflection.size / 2, reflection.size / 2)");
  part = checked(viewport.path());
  EXPECT_EQ(part.at("todos").at(1).at("state"), "wrong") << part.dump(1);
}

TEST_F(Check, WhatAnotherPartBindsIsNotMissedHere) {
  const fs::path file = expected() / "mirror" / "expected.json";
  const std::string kept = read(file);
  Submission light = Submission::firstSteps(4);
  light.replace("mirror.hpp", "scene.light.in(mirroredView)", "scene.light.in(view)");
  json all = json::parse(kept);
  for (json& step : all.at("samplers"))
    step["uOfAnotherPart"] = {{"isDepth", false},
                              {"width", 64},
                              {"height", 64},
                              {"byObject", false},
                              {"isComplete", true}};
  std::ofstream(file) << all;
  EXPECT_EQ(checked(light.path()).at("cause"), "The light is not brought into the mirrored view");
  all.at("samplers").at(0) = json::object();
  std::ofstream(file) << all;
  EXPECT_THAT(checked(light.path()).at("cause").get<std::string>(),
              HasSubstr("The sampler uOfAnotherPart reads no texture"));
  std::ofstream(file) << kept;
}

/// The handout's blur is 0.01 of the window's height.
TEST_F(Check, ANumberTypedInShowsInAnotherScene) {
  Submission submission = Submission::solution();
  submission.replace("tile.frag", "uBlurSigma * vec2", "0.01 * vec2");
  const Ended ended = Running(command(submission.path())).wait(100);
  EXPECT_EQ(ended.exitCode, 1);
  const fs::path file = expected() / "mirror" / "scene-4.json";
  // Where, and no more than that before somebody asks.
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("mirror: [############--] 6 of 7 done"),
                    HasSubstr("  mirror.7          maybe wrong"),
                    hasLineAt(submission.path() / "tile.frag"),
                    HasSubstr(": warning: mirror.7 may be wrong: "),
                    testing::ContainsRegex("[(]in another scene, with .*size \\[[0-9]+,[0-9]+\\]"),
                    HasSubstr(file.relative_path().string() + ")"),
                    HasSubstr("For a hint: add --hint\n"), Not(HasSubstr("Likely cause"))));
  const Ended asked = Running(command(submission.path(), {"--hint"})).wait(100);
  EXPECT_THAT(
      asked.out,
      HasSubstr(
          "Likely cause: It is as it should be in the handed-out scenes, and differs in another "
          "one: is a number typed in"));
  EXPECT_EQ(json::parse(read(file)).at("mirror").at("blur"), 0.03);
  // What the scene is there for is where to look, though the whole floor is too bright.
  Submission samples = Submission::solution();
  samples.replace("tile.frag", "i < uBlurSamples", "i < 16");
  const json part = checked(samples.path());
  EXPECT_EQ(part.at("todos").at(6).at("state"), "maybe");
  EXPECT_EQ(part.at("todos").at(2).at("state"), "done");
  Submission none = Submission::solution();
  none.replace("tile.frag", "uBlurSigma > 0 && uBlurSamples > 0", "uBlurSigma > 0");
  EXPECT_EQ(checked(none.path()).at("todos").at(6).at("state"), "maybe")
      << "the sum of no samples was divided by their number";
}

TEST_F(Check, AWindowsSizeThatIsTypedInIsNamedInTheSceneThatShowsIt) {
  Submission submission = Submission::solution();
  submission.replace("mirror.hpp", "glViewport(0, 0, window.x, window.y);",
                     "glViewport(0, 0, 640, 480);");
  const json part = checked(submission.path());
  EXPECT_EQ(part.at("todos").at(1).at("state"), "wrong");
  EXPECT_THAT(part.at("cause").get<std::string>(),
              HasSubstr("The viewport is 640 x 480 pixels, but the window is "));
  for (const std::size_t other : {0U, 2U, 3U, 4U, 5U})
    EXPECT_EQ(part.at("todos").at(other).at("state"), "done") << other;
}

TEST_F(Check, ClippingThatIsLeftOnIsTheWorkOfWhoAsksForDistances) {
  Submission submission = Submission::solution();
  submission.replace("mirror.hpp", "  glDisable(GL_CLIP_DISTANCE0);\n", "");
  // Above its TODO, where another one's lines are.
  submission.replace("mirror.vert", "  gl_ClipDistance[0] = uClip ? world.y : 1;\n", "");
  submission.replace("mirror.vert", "  // TODO(mirror.6)",
                     "  gl_ClipDistance[0] = uClip ? world.y : 1;\n  // TODO(mirror.6)");
  const json part = checked(submission.path());
  EXPECT_EQ(part.at("todos").at(4).at("state"), "done");
  EXPECT_EQ(part.at("todos").at(5).at("state"), "wrong");
}

TEST_F(Check, AnErrorOfOpenGlIsNeverDone) {
  Submission submission = Submission::firstSteps(1);
  submission.replace(
      "mirror.hpp",
      "  glBindFramebuffer(GL_FRAMEBUFFER, reflection.framebuffer);\n  glFramebufferTexture2D",
      "  glFramebufferTexture2D");
  const json part = checked(submission.path());
  EXPECT_EQ(part.at("outcome"), "gl_error");
  EXPECT_EQ(part.at("todos").at(0).at("state"), "wrong");
  EXPECT_THAT(part.at("cause").get<std::string>(), HasSubstr("OpenGL reports errors"));
}

TEST_F(Check, AProgramThatDoesNotCompileIsNamedWithItsLine) {
  const Submission submission = Submission::example("build_error");
  const Ended ended = Running(command(submission.path())).wait(100);
  EXPECT_EQ(ended.exitCode, 1);
  EXPECT_THAT(ended.out, AllOf(HasSubstr(" error: "), hasLineAt(submission.path() / "mirror.hpp")));
}

TEST_F(Check, LooksAgainAtEverySave) {
  Submission submission = Submission::firstSteps(2);
  const Ended refused =
      Running(command(submission.path(), {"--watch", "--open", "--edit-cmd", "vim {file}"}))
          .wait(10);
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_THAT(refused.errors, HasSubstr("tmux split-window"));
  const fs::path opened = folder_.path() / "opened";
  Running watching(command(submission.path(), {"--watch", "--open", "--edit-cmd",
                                               "echo {file}:{line} >> " + opened.string()}));
  const auto waitFor = [&](const std::string& text) {
    for (int i = 0; i < 600; ++i) {
      if (watching.out().find(text) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  };
  EXPECT_TRUE(waitFor("2 of 7 done")) << watching.out() << watching.errors();
  const fs::path page = folder_.path() / "check.html";
  EXPECT_THAT(read(page), AllOf(HasSubstr("2 of 7 done"), HasSubstr("data-watched")));
  const Submission more = Submission::firstSteps(4);
  for (const std::string& name : names(more.path()))
    fs::copy_file(more.path() / name, submission.path() / name,
                  fs::copy_options::overwrite_existing);
  // Somebody's own look at the same time builds in the same place.
  const Ended own = Running(command(submission.path())).wait(100);
  EXPECT_EQ(own.exitCode, 0) << own.out;
  EXPECT_TRUE(waitFor("4 of 7 done")) << watching.out() << watching.errors();
  EXPECT_THAT(read(page), HasSubstr("4 of 7 done"));
  // At step 3 first, then at step 5; each is done in mirror.hpp and in another file.
  std::istringstream places(read(opened));
  std::vector<std::string> lines;
  for (std::string line; std::getline(places, line);) lines.push_back(line);
  const std::string program = (submission.path() / "mirror.hpp").relative_path().string() + ':';
  EXPECT_THAT(lines, testing::ElementsAre(HasSubstr(program), HasSubstr(program)));
  watching.signalGroup(SIGINT);
  EXPECT_EQ(watching.wait(10).exitCode, 130);
}

} // namespace
