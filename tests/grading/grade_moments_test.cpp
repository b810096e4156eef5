// Scenes with frames before the first one that is looked at: what those leave shows, and nothing
// else of them is seen by anybody.

#include "tool.hpp"

#include "grading/replay.hpp"
#include "grading/toolchain.hpp"

#include <gmock/gmock.h>

using namespace tool;
using ggrade::grading::Moments;
using ggrade::grading::Rendering;
using ggrade::results::Outcome;
using ggrade::sandbox::Isolation;
using nlohmann::json;
using testing::Each;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::Lt;
using testing::SizeIs;

namespace {

namespace grading = ggrade::grading;

/// Puts a column beside those of the frames before: how wide the window is, what time it is, and
/// which frame of the program's own this is. It ends after so many frames.
std::string trail(int frames) {
  return R"(#include <glad/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <vector>

int main() {
  glfwInit();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  GLFWwindow* window = glfwCreateWindow(64, 48, "trail", nullptr, nullptr);
  glfwMakeContextCurrent(window);
  gladLoadGL(glfwGetProcAddress);
  const std::vector<unsigned char> black(4 * 64 * 48);
  GLuint texture = 0, framebuffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 64, 48, 0, GL_RGBA, GL_UNSIGNED_BYTE, black.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  for (int frame = 0; frame < )" +
         std::to_string(frames) + R"( && !glfwWindowShouldClose(window); ++frame) {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glEnable(GL_SCISSOR_TEST);
    glScissor(4 * frame, 0, 4, 48);
    glClearColor(width / 255.0f, float(glfwGetTime() / 10), (frame + 1) / 255.0f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 64, 48, 0, 0, 64, 48, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glfwSwapBuffers(window);
    glfwPollEvents();
  }
}
)";
}

const Moments kTimes({{1.5}, {1, 32, 16}, {0.5}}, {2, 3});

class Trail {
public:
  explicit Trail(int frames = 100) {
    files_.write("trail.cpp", trail(frames));
    const auto built = grading::buildProgram("trail", files_.path(), Isolation::none);
    if (!built.ok()) throw std::runtime_error(built.output);
  }
  Rendering draw(const Moments& times, const ggrade::trace::Request& request) const {
    return grading::renderScene("trail", files_.path(), {{"size", {64, 48}}}, times, {},
                                Isolation::none, request);
  }

private:
  TemporaryFolder files_;
};

/// Window's width, tenths of the time and number of the program's frames, as a frame shows them.
std::vector<std::vector<int>> shownBy(const ggrade::channel::CapturedFrame& frame) {
  std::vector<std::vector<int>> all;
  for (std::size_t k = 0; 4 * k < frame.width; ++k)
    if (const std::uint8_t* at = &frame.pixels[4 * (4 * k + 1)]; at[2] > 0)
      all.push_back({at[0], int(std::lround(at[1] * 100 / 255.0)), at[2]});
  return all;
}

TEST(ScenesWithFramesBefore, BeginWithTheFirstThatIsLookedAt) {
  ggrade::trace::Request request = grading::gradingRequest();
  request.copyFrames = 2;
  const Rendering drawn = Trail().draw(kTimes, request);
  ASSERT_EQ(drawn.happened.outcome, Outcome::graded) << drawn.happened.detail;
  EXPECT_THAT(drawn.happened.detail, HasSubstr("2 of 2 frames"));
  ASSERT_THAT(drawn.capture.frames, SizeIs(2));
  EXPECT_THAT(shownBy(drawn.capture.frames[0]),
              ElementsAre(ElementsAre(64, 5, 1), ElementsAre(32, 10, 2), ElementsAre(64, 15, 3),
                          ElementsAre(64, 20, 4)));
  EXPECT_THAT(shownBy(drawn.capture.frames[1]), SizeIs(5));
  EXPECT_EQ(drawn.capture.frames[0].time, 2);

  const ggrade::trace::Trace& trace = drawn.capture.trace;
  ASSERT_THAT(trace.frames, SizeIs(2));
  EXPECT_EQ(trace.frames[0].firstPass, 0U);
  EXPECT_THAT(trace.passes, SizeIs(4)) << "a clear and a blit each";
  EXPECT_THAT(trace.passesOf(0), Each(Field(&ggrade::trace::PassRecord::frame, 0U)));
  EXPECT_THAT(trace.passesOf(1), Each(Field(&ggrade::trace::PassRecord::frame, 1U)));
  EXPECT_THAT(trace.copies, Each(Field(&ggrade::trace::CopyRecord::pass, Lt(4U))));
  // What the first pass that is looked at left: four columns, one of them its own.
  const ggrade::trace::CopyRecord* copy = trace.copyOf(0, 0);
  ASSERT_NE(copy, nullptr);
  const ggrade::Image left = trace.image(*copy);
  EXPECT_NEAR(left.at(13, 20, 2), 4 / 255.0, 1e-6);
  EXPECT_EQ(left.at(17, 20, 2), 0);
  EXPECT_EQ(grading::rawFrames(drawn.capture).at(0).time, 2);
}

TEST(ScenesWithFramesBefore, OfAProgramThatEndsWithinThemHaveTooFewFrames) {
  for (const int frames : {1, 3, 4}) {
    const Rendering drawn = Trail(frames).draw(kTimes, grading::gradingRequest());
    EXPECT_EQ(drawn.happened.outcome, Outcome::noFrame);
    EXPECT_EQ(drawn.happened.detail,
              "the program ended before it had swapped the buffers often enough; " +
                  std::to_string(std::max(frames - 3, 0)) + " of 2 frames came");
    EXPECT_THAT(drawn.capture.frames, SizeIs(std::max(frames - 3, 0)));
    EXPECT_THAT(drawn.capture.trace.passes, SizeIs(2 * std::max(frames - 3, 0)));
  }
}

TEST(ScenesWithFramesBefore, AreDrawnAgainFromTheTapeBitForBit) {
  const Rendering drawn = Trail().draw(kTimes, grading::tapingRequest(kTimes));
  const ggrade::channel::Capture& capture = drawn.capture;
  ASSERT_EQ(capture.tapeRefused, "");
  const json none = json::array();
  const std::vector<std::uint32_t> size = {64, 48};
  const Rendering played =
      grading::play(capture.tape, {none}, size, kTimes, {}, grading::gradingRequest());
  EXPECT_EQ(played.happened.outcome, Outcome::graded) << played.happened.detail;
  EXPECT_EQ(grading::differenceOf(capture, played.capture), "");
  EXPECT_THAT(played.capture.frames, SizeIs(2));
  const auto each = grading::playEach(capture.tape, {none, none, none}, size, kTimes, {},
                                      capture.trace.pixels.size());
  ASSERT_THAT(each, SizeIs(3));
  for (const ggrade::channel::Capture& one : each) {
    EXPECT_THAT(one.frames, SizeIs(2));
    EXPECT_EQ(grading::differenceOf(capture, one), "");
    EXPECT_EQ(one.frames.at(1).time, 3);
  }
}

/// What depends on no earlier frame is graded, carried on and repaired as without any.
TEST(ScenesWithFramesBefore, AreGradedAsTheOthers) {
  const ggrade::Target target = ggrade::findTarget(kSource / "assignments", "mirror");
  const fs::path solutions = kSource / "solutions/floor";
  Submission wrong = Submission::solution();
  wrong.replace("mirror.vert", "uClip ? world.y : 1", "uClip ? -world.y : 1");
  const auto gradedWith = [&](const std::vector<ggrade::rubric::Moment>& before) {
    grading::ScenePlan plan = grading::drawScenes(target, solutions);
    std::erase_if(plan.scenes, [](const auto& scene) { return !scene.like.empty(); });
    for (auto& scene : plan.scenes) scene.times.before = before;
    grading::GraderOptions options;
    options.pictures = options.twice = options.diagnosis = false;
    options.repair = true;
    grading::Grader grader(target, solutions, plan, options);
    return grader.gradeTrusted(wrong.path());
  };
  const auto without = gradedWith({}), with = gradedWith({{0}, {0, 320, 240}});
  EXPECT_EQ(with.outcome, Outcome::graded) << with.detail;
  EXPECT_LT(without.score, 100);
  EXPECT_EQ(with.score, without.score);
  ASSERT_EQ(with.causes.size(), without.causes.size()) << with.causesSought;
  for (std::size_t i = 0; i < with.causes.size(); ++i) {
    EXPECT_EQ(with.causes[i].unit, without.causes[i].unit);
    EXPECT_EQ(with.causes[i].passes, without.causes[i].passes);
  }
  ASSERT_EQ(with.items.size(), without.items.size());
  for (std::size_t i = 0; i < with.items.size(); ++i) {
    EXPECT_EQ(with.items[i].message, without.items[i].message);
    EXPECT_EQ(with.items[i].carried, without.items[i].carried);
  }
}

} // namespace
