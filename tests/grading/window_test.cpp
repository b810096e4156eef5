// The program in a real window: GLFW, X11 and Mesa in place of the capture library.

#include "tool.hpp"

#include "image/compare.hpp"
#include "image/png.hpp"

#include <gmock/gmock.h>

#include <csignal>

#include <unistd.h>

using namespace tool;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

namespace {

/// An X server without a screen, on a display that nobody uses. It must not start afresh when its
/// only client leaves: a program that connects just then would find no display.
class Screen {
public:
  Screen()
      : server_({"/usr/bin/Xvfb", "-displayfd", "1", "-screen", "0", "1280x1024x24", "-ac",
                 "-nolisten", "tcp", "-noreset"}) {
    for (int i = 0; i < 2000 && !ready(); ++i) usleep(5000);
  }
  ~Screen() {
    server_.signalGroup(SIGTERM);
    server_.wait(5);
  }
  bool ready() const { return server_.out().find('\n') != std::string::npos; }
  Environment environment() const {
    const std::string number = server_.out().substr(0, server_.out().find('\n'));
    // The real Mesa, on a machine whatever its graphics card; pixels as the offscreen run's.
    return {{"DISPLAY", ":" + number},
            {"LIBGL_ALWAYS_SOFTWARE", "1"},
            {"GALLIUM_OVERRIDE_CPU_CAPS", "avx"}};
  }
  std::string errors() const { return server_.errors(); }

private:
  Running server_;
};

/// The contents of the window called `title`, once two pictures of it agree; empty if that never
/// happens.
ggrade::Image screenshot(const std::string& title, const Environment& environment,
                         const fs::path& folder) {
  ggrade::Image before;
  for (int i = 0; i < 200; ++i, usleep(100'000)) {
    // `import` waits for a click where there is no such window.
    if (Running({"/usr/bin/xwininfo", "-name", title}, environment).wait(20).exitCode != 0)
      continue;
    const fs::path file = folder / ("shot-" + std::to_string(i) + ".png");
    const Ended ended =
        Running({"/usr/bin/import", "-window", title, "-depth", "8", "png24:" + file.string()},
                environment)
            .wait(20);
    if (ended.exitCode != 0) continue;
    const ggrade::Image now = ggrade::firstChannels(ggrade::readPng(file), 3);
    // A window that nothing was drawn to is black.
    bool drawn = false;
    for (float value : now.values()) drawn = drawn || value > 0.05f;
    const bool still = sameSize(before, now) && ggrade::compare(now, before).wrongPixels == 0;
    if (drawn && still) return now;
    before = now;
  }
  return {};
}

TEST(Window, ShowsWhatTheOffscreenRunDraws) {
  const TemporaryFolder folder;
  // A cycle of 115 days: nothing moves that can be seen while we look, but for a pixel or two on an
  // edge that what moves a little has just reached.
  json scene = json::parse(read(kSource / "assignments/floor/scene.json"));
  scene["effects"] = {{"mirror", true}, {"shadow", true}, {"bloom", true}};
  scene["ring"]["cycle"] = 1e7;
  const fs::path file = folder.write("still.json", scene.dump());
  const fs::path program = kBuild / "solutions/floor/floor";

  const Screen screen;
  ASSERT_TRUE(screen.ready()) << screen.errors();
  Running window({program, "--scene", file}, screen.environment());
  const ggrade::Image shown = screenshot("floor", screen.environment(), folder.path());
  ASSERT_FALSE(shown.empty()) << window.errors();
  EXPECT_EQ(shown.sizeText(), "640x480");

  const Ended rendered =
      runTool({"render", "--out", folder.path() / "out", "--", program, "--scene", file});
  ASSERT_EQ(rendered.exitCode, 0) << rendered.errors;
  const ggrade::Image offscreen = ggrade::readPng(folder.path() / "out/frame-0.png");
  const ggrade::Comparison comparison = ggrade::compare(shown, offscreen);
  EXPECT_LE(comparison.wrongPixels, 5u) << comparison.message;
  std::cout << comparison.message << '\n';

  // Another scene is another picture: the comparison above could have failed.
  scene["effects"]["mirror"] = false;
  const Ended other = runTool({"render", "--out", folder.path() / "out", "--", program, "--scene",
                               folder.write("off.json", scene.dump())});
  ASSERT_EQ(other.exitCode, 0) << other.errors;
  EXPECT_GT(ggrade::compare(shown, ggrade::readPng(folder.path() / "out/frame-0.png")).wrongShare,
            0.1);
}

TEST(Window, EndsWithAMessageWhereThereIsNoDisplay) {
  const Ended ended =
      Running({kBuild / "solutions/floor/floor"}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}})
          .wait(20);
  EXPECT_EQ(ended.exitCode, 4);
  EXPECT_THAT(ended.errors,
              AllOf(HasSubstr("floor: no window can be opened"), HasSubstr("xvfb-run")));
}

// What `ggrade run` says before it builds anything.
class RunCommand : public testing::Test {
protected:
  Ended script(const Arguments& arguments) {
    Arguments all = {kSource / "ggrade", "run"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return Running(all).wait(60);
  }
};

TEST_F(RunCommand, HelpHasAnExample) {
  const Ended ended = script({"--help"});
  EXPECT_EQ(ended.exitCode, 0);
  EXPECT_THAT(ended.out, AllOf(HasSubstr("Usage: ggrade run ID"), HasSubstr("ggrade run floor")));
}

TEST_F(RunCommand, WithoutAnIdIsWrongUse) {
  const Ended ended = script({});
  EXPECT_EQ(ended.exitCode, 2);
}

TEST_F(RunCommand, UnknownIdsListWhatThereIs) {
  for (const char* id : {"mirrror", "../solutions", "flo.r", ".*", "floor mirror"}) {
    const Ended ended = script({id});
    EXPECT_EQ(ended.exitCode, 2) << id;
    EXPECT_EQ(ended.out, "");
    EXPECT_THAT(ended.errors,
                AllOf(HasSubstr("there is no assignment or part"),
                      HasSubstr("there are: afterglow, antialias, bloom, deferred, ")))
        << id;
  }
}

} // namespace
