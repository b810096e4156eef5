// `ggrade render` and the commands around it; and that the reference draws only what a scene can
// show.

#include "tool.hpp"

#include "image/compare.hpp"
#include "image/png.hpp"

#include <gmock/gmock.h>

#include <chrono>

using namespace tool;
using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

namespace {

/// A scene file for the floor and what `ggrade render` makes of it.
class Render : public testing::Test {
protected:
  /// Renders and returns the bytes of the frames' files.
  std::vector<std::string> frames(const Arguments& arguments) {
    Arguments all = {"render", "--out", out_};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ended ended = runTool(all);
    EXPECT_EQ(ended.exitCode, 0) << ended.errors;
    std::vector<std::string> bytes;
    if (ended.exitCode != 0) return bytes;
    const json trace = this->trace();
    for (const json& frame : trace.at("frames")) bytes.push_back(read(out_ / frame.at("image")));
    return bytes;
  }
  /// Frames of the reference's program as it was built with the tool, in the mirror's scene with
  /// `patch`.
  std::vector<std::string> reference(const json& patch, const Arguments& options = {}) {
    json scene = json::parse(read(kSource / "assignments/floor/scene.json"));
    scene["size"] = {320, 240};
    scene["effects"]["mirror"] = true;
    scene.merge_patch(patch);
    Arguments arguments = options;
    arguments.insert(arguments.end(), {"--", kBuild / "solutions/floor/floor", "--scene",
                                       folder_.write("scene.json", scene.dump())});
    return frames(arguments);
  }
  json trace() { return json::parse(read(out_ / "trace.json")); }

  TemporaryFolder folder_;
  fs::path out_ = folder_.path() / "out";
};

TEST_F(Render, TargetsOfEveryKindAgree) {
  const auto byId = frames({"floor", "--solution", "--size", "160x120"});
  ASSERT_EQ(byId.size(), 1u);
  EXPECT_TRUE(frames({kSource / "solutions/floor", "--size", "160x120"}) == byId);
  EXPECT_FALSE(frames({"mirror", "--solution", "--size", "160x120"}) == byId)
      << "a part has its own effects only";
  // The assignment's own files are the stub.
  const auto stub = frames({"floor", "--size", "160x120"});
  EXPECT_FALSE(stub == byId);
  EXPECT_TRUE(frames({Submission::stub().path(), "--size", "160x120"}) == stub);
}

TEST_F(Render, AFolderOfWhatWasChangedGoesOverTheHandedOutFiles) {
  const TemporaryFolder changed;
  changed.write("tile.frag", "#version 410 core\nout vec4 oColor;\n"
                             "void main() { oColor = vec4(0, 1, 0, 1); }\n");
  const auto stub = frames({"mirror", "--size", "160x120"});
  EXPECT_FALSE(frames({"mirror", changed.path(), "--size", "160x120"}) == stub);
  const Ended alone = runTool({"render", changed.path(), "--out", out_});
  EXPECT_EQ(alone.exitCode, 2);
  EXPECT_THAT(alone.errors,
              HasSubstr("name the assignment or part before it (see ggrade list): mirror " +
                        changed.path().string()));
  const Ended both = runTool({"render", "mirror", changed.path(), "--solution", "--out", out_});
  EXPECT_EQ(both.exitCode, 2);
  EXPECT_THAT(both.errors, HasSubstr("name either a folder or --solution"));
}

TEST_F(Render, NothingIsKeptOfFramesBefore) {
  ASSERT_EQ(
      frames({"mirror", "--size", "80x60", "--times", "0.5", "--before", "0.25,0.375", "--passes"})
          .size(),
      1u);
  const json trace = this->trace();
  ASSERT_EQ(trace.at("frames").size(), 1u);
  EXPECT_EQ(trace.at("frames")[0].at("time"), 0.5);
  EXPECT_EQ(trace.at("frames")[0].at("first_pass"), 0);
  EXPECT_EQ(trace.at("frames")[0].at("pass_count"), trace.at("passes").size());
}

TEST_F(Render, TraceSaysWhatWasDrawn) {
  ASSERT_EQ(frames({"mirror", "--solution", "--size", "160x120", "--times", "0.5,0,2.25"}).size(),
            3u);
  EXPECT_THAT(names(out_), ElementsAre("frame-0.png", "frame-1.png", "frame-2.png", "trace.json"));
  const json trace = this->trace();
  EXPECT_EQ(trace.at("version"), 1);
  EXPECT_EQ(trace.at("outcome"), "graded");
  EXPECT_EQ(trace.at("rows"), "top first");
  EXPECT_THAT(trace.at("gl_renderer").get<std::string>(), HasSubstr("llvmpipe"));
  EXPECT_THAT(trace.at("messages").dump(), Not(HasSubstr("GL_")));
  const double times[] = {0.5, 0, 2.25};
  for (std::size_t i = 0; i < 3; ++i) {
    const json& frame = trace.at("frames").at(i);
    EXPECT_EQ(frame.at("time"), times[i]);
    EXPECT_EQ(frame.at("width"), 160);
    EXPECT_EQ(frame.at("height"), 120);
    EXPECT_EQ(frame.at("window_draws"), 7); // six objects and the floor
    EXPECT_EQ(frame.at("window_clears"), 1);
    EXPECT_EQ(frame.at("framebuffer_at_swap"), 0);
    const ggrade::Image image = ggrade::readPng(out_ / frame.at("image").get<std::string>());
    EXPECT_EQ(image.sizeText(), "160x120");
  }
}

/// The only sampled texture with that uniform in a pass of trace.json.
json sampled(const json& pass, const std::string& uniform) {
  json found;
  for (const json& step : pass.at("steps"))
    for (const json& sample : step.at("samples"))
      if (sample.at("uniform") == uniform) found = sample;
  return found;
}

TEST_F(Render, PassesOfTheMirror) {
  const auto plain = frames({"mirror", "--solution", "--size", "160x120"});
  EXPECT_TRUE(frames({"mirror", "--solution", "--size", "160x120", "--passes", "--raw"}) == plain)
      << "recording changes no pixel";
  const json trace = this->trace();
  ASSERT_EQ(trace.at("passes").size(), 2u);
  EXPECT_EQ(trace.at("lost").dump(),
            R"({"copies":0,"matrices":0,"passes":0,"samples":0,"steps":0})");
  const json& frame = trace.at("frames").at(0);
  EXPECT_EQ(frame.at("first_pass"), 0);
  EXPECT_EQ(frame.at("pass_count"), 2);
  EXPECT_GT(frame.at("buffer_bytes"), 0);

  const json& reflection = trace.at("passes").at(0);
  const json& colour = reflection.at("attachments").at("color0");
  EXPECT_EQ(colour.at("kind"), "texture");
  const std::size_t pixels =
      colour.at("width").get<std::size_t>() * colour.at("height").get<std::size_t>();
  EXPECT_GE(frame.at("image_bytes"), 7 * pixels) << "colour, and depth of 24 bits";
  EXPECT_EQ(reflection.at("attachments").at("depth").at("kind"), "renderbuffer");
  EXPECT_NE(reflection.at("framebuffer"), 0);
  EXPECT_EQ(reflection.at("status"), "FRAMEBUFFER_COMPLETE");
  EXPECT_EQ(reflection.at("cleared"), json({"color0", "depth"}));
  EXPECT_EQ(reflection.at("draws"), 6);
  EXPECT_EQ(reflection.at("steps").at(0).at("cull_face"), "FRONT");
  EXPECT_EQ(reflection.at("read_by"), json({1}));

  const json& window = trace.at("passes").at(1);
  EXPECT_EQ(window.at("framebuffer"), 0);
  EXPECT_EQ(window.at("attachments").at("color0").at("kind"), "window");
  EXPECT_EQ(window.at("attachments").at("color0").at("width"), 160);
  EXPECT_EQ(window.at("draws"), 7);
  EXPECT_EQ(sampled(window, "uReflection").at("written_by"), 0);
  EXPECT_EQ(sampled(window, "uReflection").at("image"), colour);
  EXPECT_EQ(sampled(window, "uReflection").at("incomplete"), false);

  // A picture of each attachment that was written, of its size.
  EXPECT_THAT(names(out_), ElementsAre("frame-0", "frame-0.png", "trace.json"));
  EXPECT_THAT(names(out_ / "frame-0"),
              ElementsAre("pass-00-color0.f32", "pass-00-color0.png", "pass-00-depth.f32",
                          "pass-00-depth.png", "pass-01-color0.f32", "pass-01-color0.png",
                          "pass-01-depth.f32", "pass-01-depth.png"));
  for (const json& pass : trace.at("passes")) {
    ASSERT_EQ(pass.at("copies").size(), 2u);
    for (const json& copy : pass.at("copies")) {
      const ggrade::Image image = ggrade::readPng(out_ / copy.at("image").get<std::string>());
      EXPECT_EQ(image.width(), copy.at("width"));
      EXPECT_EQ(image.height(), copy.at("height"));
      const bool depth = copy.at("attachment") == "depth";
      EXPECT_EQ(copy.at("scale"), depth ? "stretched depth by uProjection" : "as stored");
      EXPECT_EQ(fs::file_size(out_ / copy.at("raw").get<std::string>()),
                image.pixelCount() * (depth ? 4 : 16));
    }
  }
  // What the last pass left in the window is the frame; what lies far away is darker than nothing.
  EXPECT_EQ(ggrade::compare(ggrade::readPng(out_ / "frame-0/pass-01-color0.png"),
                            ggrade::readPng(out_ / "frame-0.png"))
                .wrongShare,
            0);
  const json& depth = window.at("copies").at(1);
  EXPECT_EQ(depth.at("attachment"), "depth");
  EXPECT_GT(depth.at("low"), 4.0) << "the nearest object is some metres away";
  EXPECT_LT(depth.at("high"), 15.0) << "before the far plane";
}

TEST_F(Render, PassesOfEveryFrameAndEveryStep) {
  ASSERT_EQ(frames({"floor", "--solution", "--size", "80x60", "--times", "0,1", "--passes",
                    "--steps", "--pass-times"})
                .size(),
            2u);
  const json trace = this->trace();
  const json& passes = trace.at("passes");
  const std::size_t each = trace.at("frames").at(0).at("pass_count");
  EXPECT_GT(each, 4u) << "shadow, mirror, scene, bloom";
  ASSERT_EQ(passes.size(), 2 * each);
  EXPECT_EQ(trace.at("frames").at(1).at("first_pass"), each);
  EXPECT_EQ(passes.at(each).at("frame"), 1);
  EXPECT_THAT(names(out_),
              ElementsAre("frame-0", "frame-0.png", "frame-1", "frame-1.png", "trace.json"));
  std::size_t files = 0;
  for (const json& pass : passes) {
    EXPECT_GT(pass.at("seconds"), 0.0);
    for (const json& copy : pass.at("copies")) {
      EXPECT_TRUE(fs::exists(out_ / copy.at("image").get<std::string>())) << copy;
      if (!copy.at("step").is_null()) {
        EXPECT_LT(copy.at("step"), pass.at("steps").size());
      }
      ++files;
    }
  }
  EXPECT_EQ(files, names(out_ / "frame-0").size() + names(out_ / "frame-1").size());
  EXPECT_THAT(names(out_ / "frame-0"), testing::Contains("pass-00-step-0-depth.png"));
}

TEST_F(Render, PassesOfARunThatFailedAreKept) {
  Submission crashes = Submission::solution();
  crashes.replace("floor.cpp", "    window.swapBuffers();\n",
                  "    if (time > 0.5) std::abort();\n    window.swapBuffers();\n");
  const Ended ended = runTool({"render", crashes.path(), "--times", "0,1,2", "--size", "64x48",
                               "--passes", "--json", "--out", out_});
  EXPECT_EQ(ended.exitCode, 1);
  const json trace = this->trace();
  EXPECT_EQ(json::parse(ended.out), trace) << "--json prints what it writes";
  ASSERT_EQ(trace.at("frames").size(), 1u);
  const std::size_t first = trace.at("frames").at(0).at("pass_count");
  EXPECT_GT(trace.at("passes").size(), first) << "those of the frame that never came, too";
  EXPECT_EQ(trace.at("passes").back().at("frame"), 1);
}

TEST_F(Render, PassesAreAskedForFirst) {
  for (const char* option : {"--steps", "--pass-times", "--raw"}) {
    const Ended ended = runTool({"render", "floor", option, "--out", out_});
    EXPECT_EQ(ended.exitCode, 2) << option;
    EXPECT_THAT(ended.errors, HasSubstr("--passes")) << option;
  }
  ASSERT_EQ(frames({"floor", "--size", "64x48"}).size(), 1u);
  EXPECT_FALSE(trace().contains("passes"));
}

TEST_F(Render, AnyProgramOfAnybody) {
  // 3.3.8's own API and nothing of ours: the window's size is the program's.
  const fs::path source = folder_.write("tiny.cpp", R"(
#include <GLFW/glfw3.h>
#include <cstdio>
int main(int argc, char** argv) {
  if (!glfwInit()) return 1;
  GLFWwindow* window = glfwCreateWindow(48, 32, argc > 1 ? argv[1] : "", nullptr, nullptr);
  glfwMakeContextCurrent(window);
  while (!glfwWindowShouldClose(window)) {
    glClearColor(float(glfwGetTime()), 0.4f, argc > 2 ? 1.0f : 0.0f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
  std::printf("closed\n");
})");
  const fs::path program = folder_.path() / "tiny";
  const Ended built = Running({"/usr/bin/c++", source, "-o", program, "-lglfw", "-lGL"}).wait(60);
  ASSERT_EQ(built.exitCode, 0) << built.errors;
  ASSERT_EQ(frames({"--times", "0.2,0.6", "--", program, "title", "--blue"}).size(), 2u);
  for (int i = 0; i < 2; ++i) {
    const ggrade::Image image = ggrade::readPng(out_ / ("frame-" + std::to_string(i) + ".png"));
    ASSERT_EQ(image.sizeText(), "48x32");
    EXPECT_NEAR(image.at(24, 16, 0), i ? 0.6f : 0.2f, 0.003f);
    EXPECT_NEAR(image.at(0, 0, 1), 0.4f, 0.003f);
    EXPECT_NEAR(image.at(47, 31, 2), 1, 0.003f);
  }
  // A program is found as a shell finds it.
  const Ended relative =
      Running(words({"render", "--out", out_, "--", "./tiny"}), {}, folder_.path()).wait(60);
  EXPECT_EQ(relative.exitCode, 0) << relative.errors;
  // --size is the window's size, whatever the program asked for.
  ASSERT_EQ(frames({"--size", "20x10", "--", program}).size(), 1u);
  EXPECT_EQ(ggrade::readPng(out_ / "frame-0.png").sizeText(), "20x10");
}

TEST_F(Render, AFailureIsSaidAndKeepsWhatCame) {
  Submission crashes = Submission::solution();
  crashes.replace("floor.cpp", "    window.swapBuffers();\n",
                  "    window.swapBuffers();\n    if (time > 0.5) std::abort();\n");
  const Ended ended = runTool({"render", crashes.path(), "--times", "0,1,2", "--out", out_});
  EXPECT_EQ(ended.exitCode, 1);
  EXPECT_THAT(ended.errors, AllOf(HasSubstr("SIGABRT"), HasSubstr("2 of 3 frames came")));
  EXPECT_EQ(trace().at("outcome"), "crash");
  EXPECT_THAT(names(out_), ElementsAre("frame-0.png", "frame-1.png", "trace.json"));

  const Ended shader = runTool(
      {"render", Submission::example("shader_error").path(), "--out", folder_.path() / "shader"});
  EXPECT_EQ(shader.exitCode, 1);
  EXPECT_THAT(shader.errors,
              AllOf(ContainsRegex("tile\\.frag:[0-9]+:[0-9]+: error"),
                    HasSubstr("vec2 at = gl_FragCoord.xy / uWindow;"), HasSubstr("^")));
  const Ended missing =
      runTool({"render", "--out", folder_.path() / "none", "--", "/nowhere/tiny"});
  EXPECT_EQ(missing.exitCode, 2);
  EXPECT_THAT(missing.errors, HasSubstr("there is no program /nowhere/tiny"));
  EXPECT_FALSE(fs::exists(folder_.path() / "none"));
}

TEST_F(Render, TheSecondFrameEqualsAFirstFrameOfThatTime) {
  for (const json& patch :
       {json::object(), json{{"ring", {{"base", -0.6}}}}, json{{"mirror", {{"blur", 0.01}}}}}) {
    const auto both = reference(patch, {"--times", "0.3,2.2"});
    const auto alone = reference(patch, {"--times", "2.2"});
    ASSERT_EQ(both.size(), 2u);
    ASSERT_EQ(alone.size(), 1u);
    EXPECT_FALSE(both[0] == both[1]);
    EXPECT_TRUE(both[1] == alone[0]) << patch;
  }
}

TEST_F(Render, OddSizes) {
  for (const char* size : {"1x1", "7x13", "641x479"}) {
    const json effects = {{"mirror", true}, {"shadow", true}, {"bloom", true}};
    ASSERT_EQ(reference({{"effects", effects}}, {"--size", size}).size(), 1u) << size;
    EXPECT_EQ(ggrade::readPng(out_ / "frame-0.png").sizeText(), size);
    EXPECT_THAT(trace().at("messages").dump(), Not(HasSubstr("GL_"))) << size;
  }
}

struct Scene {
  const char* name;
  const char* patch;
};
void PrintTo(const Scene& scene, std::ostream* out) {
  *out << scene.name;
}

class NothingToReflect : public Render, public testing::WithParamInterface<Scene> {};

TEST_P(NothingToReflect, ThePassIsLeftOutAndThePictureIsTheSame) {
  json patch = json::parse(GetParam().patch);
  const auto usual = reference(patch, {"--times", "0.2,1.4", "--passes"});
  ASSERT_EQ(usual.size(), 2u);
  EXPECT_EQ(trace().at("passes").size(), 2u) << "the window's, in each frame";
  patch["debug"]["draw_all_passes"] = true;
  EXPECT_TRUE(reference(patch, {"--times", "0.2,1.4", "--passes"}) == usual);
  const json passes = trace().at("passes");
  EXPECT_GE(passes.size(), 4u);
  EXPECT_NE(passes.at(0).at("framebuffer"), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Render, NothingToReflect,
    testing::Values(
        Scene{"EyeBelowTheFloor", R"({"camera": {"position": [0, -2, 7]}})"},
        Scene{"NoSpecularFloor", R"({"materials": {"floor": {"specular": [0, 0, 0]}}})"},
        Scene{"FloorOutOfView", R"({"camera": {"position": [0, 3, 7], "target": [0, 9, 0]}})"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Commands, ListSaysTheSameInJson) {
  const Ended text = runTool({"list"});
  EXPECT_EQ(text.exitCode, 0);
  EXPECT_THAT(text.out,
              AllOf(HasSubstr("floor  Mirror, shadow and bloom over a chequered floor"),
                    ContainsRegex("mirror +100 points \\+ 10 bonus, 7 TODOs"),
                    ContainsRegex("shadow +100 points \\+ 20 bonus, 6 TODOs"),
                    ContainsRegex("bloom +100 points"), HasSubstr("edit: floor.cpp mirror.hpp")));
  const Ended ended = runTool({"list", "--json"});
  EXPECT_EQ(ended.exitCode, 0);
  EXPECT_EQ(ended.errors, "");
  const json list = json::parse(ended.out);
  const auto floor =
      std::ranges::find_if(list, [](const json& one) { return one.at("id") == "floor"; });
  ASSERT_NE(floor, list.end());
  const json& parts = floor->at("parts");
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts.at(0).at("id"), "mirror");
  EXPECT_EQ(parts.at(1).at("id"), "shadow");
  EXPECT_EQ(parts.at(2).at("id"), "bloom");
  EXPECT_EQ(parts.at(0).at("points"), 100);
  EXPECT_EQ(parts.at(0).at("bonus"), 10);
  EXPECT_THAT(floor->at("files"),
              AllOf(testing::Contains("floor.cpp"), testing::Contains("mirror.vert"),
                    testing::Contains("shadow.frag"), testing::Contains("bright.frag")));
}

TEST(Commands, EveryHelpHasAnExample) {
  const Ended all = runTool({"--help"});
  EXPECT_EQ(all.exitCode, 0);
  EXPECT_THAT(all.out, HasSubstr("Examples:"));
  for (const std::string command :
       {"list", "render", "grade", "demo", "derive", "new", "compare"}) {
    const Ended help = runTool({command, "--help"});
    EXPECT_EQ(help.exitCode, 0) << command;
    EXPECT_THAT(help.out, ContainsRegex("Examples?:?\n  ggrade " + command));
    EXPECT_THAT(all.out, HasSubstr(command));
  }
}

TEST(Commands, VersionSaysWhatKeepsSubmissionsAway) {
  const auto start = std::chrono::steady_clock::now();
  const Ended version = runTool({"--version"});
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(version.exitCode, 0) << version.errors;
  EXPECT_THAT(version.out,
              ContainsRegex("^ggrade [0-9]+\\.[0-9]+\\.[0-9]+\nsandbox: bubblewrap [0-9.]+\n"
                            "self-test: passed, 16 escapes were tried and refused\n"
                            "drawing: (osmesa|egl), [^\n]*Mesa [^\n]*llvmpipe[^\n]*\n$"));
  EXPECT_LT(passed.count(), 5) << "a hundredth of it on an idle machine";
  EXPECT_THAT(runTool({"--version", "--lang", "ja"}).out, HasSubstr("自己診断: 合格"));
}

TEST(Commands, WhatStudentsRunSpeaksJapanese) {
  // Without the program's own output, in which there may be names.
  const auto english = [](const Ended& ended) {
    return ended.out.find("Print this") != ended.out.npos ||
           ended.out.find("Examples:") != ended.out.npos ||
           ended.errors.find("Run with") != ended.errors.npos;
  };
  for (const std::string command : {"list", "render", "inspect"}) {
    const Ended help = runTool({command, "--help", "--lang", "ja"});
    EXPECT_THAT(help.out, HasSubstr("使い方: ggrade " + command));
    EXPECT_FALSE(english(help)) << help.out;
    const Ended wrong = runTool({command, "--lang", "ja", "--unknown"});
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_THAT(wrong.errors, HasSubstr("使い方の誤り："));
    EXPECT_FALSE(english(wrong)) << wrong.errors;
  }
  const Ended unknown = runTool({"inspect", "nosuch", "--lang", "ja"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("課題またはパート「nosuch」はありません"));
}

TEST(Commands, CompareIsReachedThroughTheTool) {
  const std::string picture = kSource / "assignments/floor/handout/mirror-5.png";
  EXPECT_EQ(runTool({"compare", picture, picture}).exitCode, 0);
  EXPECT_EQ(
      runTool({"compare", picture, kSource / "assignments/floor/handout/mirror-0.png"}).exitCode,
      2);
}

TEST(Commands, GradeWritesEveryFileOfTheContract) {
  const TemporaryFolder folder;
  const Ended ended = runTool({"grade", "mirror", kSource / "assignments/floor", "--no-diagnosis",
                               "--json", "--out", folder.path() / "a/b/out"});
  EXPECT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(names(folder.path() / "a/b/out"),
              ElementsAre("index.html", "junit.xml", "results.json", "student.html"));
  // --json prints what it writes.
  EXPECT_EQ(json::parse(ended.out).at("extra_data").at("outcome"), "graded");
  EXPECT_EQ(json::parse(ended.out).at("score"),
            json::parse(read(folder.path() / "a/b/out/results.json")).at("score"));
  // What the student gets names hidden scenes, but no place in them.
  const std::string student = read(folder.path() / "a/b/out/student.html");
  const std::size_t at = student.find("where a sunken object must be cut off: ");
  ASSERT_NE(at, student.npos);
  EXPECT_THAT(student.substr(at, 120), HasSubstr("densest at (position withheld)"));
  EXPECT_EQ(student.find("Not used"), student.npos);
  EXPECT_EQ(student.find("handout: not a file"), student.npos);
}

} // namespace
