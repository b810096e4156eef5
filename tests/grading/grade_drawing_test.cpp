// What draws, OSMesa or EGL: both draw the same, whatever the user has set; and what is broken or
// missing, from the start or of a sudden, is named and costs nobody a point.
//
// Libraries are broken for the tool alone: in a mount namespace of its own, by an empty file over
// each.

#include "tool.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <unistd.h>

using namespace tool;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

namespace {

/// The starts of its files' names.
using Library = std::vector<std::string>;

std::vector<fs::path> filesOf(const Library& names) {
  std::vector<fs::path> found;
  for (const fs::path folder : {"/usr/lib/x86_64-linux-gnu", "/usr/lib/x86_64-linux-gnu/dri",
                                "/usr/lib/aarch64-linux-gnu", "/usr/lib/aarch64-linux-gnu/dri"})
    for (const std::string& name : names) {
      if (!fs::exists(folder)) continue;
      for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with(name) && !entry.is_symlink() &&
            entry.is_regular_file())
          found.push_back(entry.path());
    }
  return found;
}

const Library kOsmesa = {"libOSMesa.so"}, kEgl = {"libEGL.so.1"},
              kDriver = {"swrast_dri.so", "libgallium", "libdril_dri.so"};

class WhatDraws : public testing::Test {
protected:
  void SetUp() override {
    if (geteuid() != 0) GTEST_SKIP() << "only root may put a file over a library";
  }

  /// Words that break these libraries and then run the tool.
  static Arguments broken(const std::vector<Library>& libraries, const Arguments& arguments) {
    std::string script = "set -e; ";
    for (const auto& names : libraries)
      for (const fs::path& file : filesOf(names))
        script += "mount --bind /dev/null " + file.string() + "; ";
    Arguments all = {"/usr/bin/unshare", "--mount", "/bin/sh", "-c", script + "exec \"$@\"", "sh"};
    const Arguments tool = words(arguments);
    all.insert(all.end(), tool.begin(), tool.end());
    return all;
  }

  /// A right submission, graded with these libraries broken.
  Ended grade(const std::vector<Library>& libraries, const Arguments& more = {}) {
    Arguments all = {"grade", "mirror", submission_.path(), "--no-diagnosis", "--out", out_};
    all.insert(all.end(), more.begin(), more.end());
    return Running(broken(libraries, all)).wait(100);
  }
  json results() const { return json::parse(read(out_ / "results.json")); }

  /// Bytes of two frames of a reference, and what its trace says.
  std::pair<std::string, json> frames(const std::string& context,
                                      const Environment& environment = {}) {
    const Ended ended = runTool({"render", "floor", "--solution", "--size", "160x120", "--times",
                                 "0,0.5", "--context", context, "--out", out_},
                                environment);
    EXPECT_EQ(ended.exitCode, 0) << ended.errors;
    if (ended.exitCode != 0) return {};
    return {read(out_ / "frame-0.png") + read(out_ / "frame-1.png"),
            json::parse(read(out_ / "trace.json"))};
  }

  /// What can draw here at all: Debian 13 is the last one with OSMesa.
  static std::vector<std::string> contexts() {
    std::vector<std::string> all = {"egl"};
    if (!filesOf(kOsmesa).empty()) all.push_back("osmesa");
    return all;
  }

  TemporaryFolder folder_;
  fs::path out_ = folder_.path() / "out";
  Submission submission_ = Submission::solution();
};

TEST_F(WhatDraws, IsTheSameWithEitherContextWhateverTheUserHasSet) {
  const Environment set = {{"LIBGL_DRIVERS_PATH", "/nowhere"},
                           {"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"},
                           {"__EGL_VENDOR_LIBRARY_DIRS", "/nowhere"},
                           {"EGL_PLATFORM", "x11"},
                           {"LIBGL_ALWAYS_SOFTWARE", "false"},
                           {"GALLIUM_DRIVER", "softpipe"},
                           {"MESA_LOADER_DRIVER_OVERRIDE", "iris"},
                           {"MESA_GL_VERSION_OVERRIDE", "3.3"},
                           {"GALLIUM_OVERRIDE_CPU_CAPS", "nosse"},
                           {"LP_NATIVE_VECTOR_WIDTH", "512"},
                           {"DISPLAY", ":77"}};
  const std::string usual = frames("egl").first;
  ASSERT_FALSE(usual.empty());
  for (const std::string& context : contexts())
    for (const Environment& environment : {Environment{}, set}) {
      SCOPED_TRACE(context + (environment.empty() ? "" : ", with variables set"));
      const auto [bytes, trace] = frames(context, environment);
      EXPECT_TRUE(bytes == usual);
      EXPECT_THAT(trace.at("gl_renderer").get<std::string>(), HasSubstr("llvmpipe"));
      EXPECT_EQ(trace.at("context"), context);
    }
}

TEST_F(WhatDraws, OneContextIsEnough) {
  for (const auto& [missing, left] :
       {std::pair{kEgl, "osmesa"}, std::pair{kOsmesa, "egl"}, std::pair{kDriver, "osmesa"}}) {
    SCOPED_TRACE(left);
    if (left == std::string("osmesa") && filesOf(kOsmesa).empty()) continue;
    // Newer releases keep the drivers of both in one library.
    if (missing == kDriver && !filesOf({"libgallium"}).empty()) continue;
    const Ended ended =
        Running(broken({missing}, {"render", "floor", "--solution", "--out", out_})).wait(100);
    ASSERT_EQ(ended.exitCode, 0) << ended.errors;
    EXPECT_EQ(json::parse(read(out_ / "trace.json")).at("context"), left);
  }
}

TEST_F(WhatDraws, NothingThatDrawsIsSaidBeforeAnythingIsGraded) {
  const struct {
    std::vector<Library> libraries;
    const char *context, *reason;
  } kCases[] = {{{kOsmesa, kEgl}, "auto", "/libEGL.so.1: file too short"},
                {{kOsmesa, kDriver}, "auto", "egl: "},
                {{kEgl}, "egl", "/libEGL.so.1: file too short"},
                {{kDriver}, "egl", "(egl: "},
                {{kOsmesa}, "osmesa", "libOSMesa.so.8: "}};
  for (const auto& [libraries, context, reason] : kCases) {
    SCOPED_TRACE(fmt::format("{}, {}", context, reason));
    const Ended ended = grade(libraries, {"--context", context});
    EXPECT_EQ(ended.exitCode, 3) << ended.out;
    EXPECT_THAT(
        ended.errors,
        AllOf(
            HasSubstr("nothing to draw with ("), HasSubstr(reason),
            HasSubstr(
                "Remedy: apt-get install --reinstall libosmesa6, or libegl1 and libgl1-mesa-dri")));
    EXPECT_FALSE(fs::exists(out_ / "results.json"));
  }
}

// An update of packages while a class is graded, say.
TEST_F(WhatDraws, WhatBreaksOfASuddenCostsNobodyAPoint) {
  ASSERT_EQ(grade({}).exitCode, 0); // the references are drawn by then
  fs::remove_all(out_);
  const std::string context = contexts().back(); // the usual one
  Running running(
      broken({}, {"grade", "mirror", submission_.path(), "--no-diagnosis", "--out", out_}));
  ASSERT_TRUE(running.says("grading submission: building", 60));
  std::string script = "set -e; ";
  for (const fs::path& file : filesOf(context == "egl" ? kEgl : kOsmesa))
    script += "mount --bind /dev/null " + file.string() + "; ";
  const Ended covered = Running({"/usr/bin/nsenter", "--target", std::to_string(running.pid()),
                                 "--mount", "/bin/sh", "-c", script})
                            .wait(10);
  ASSERT_EQ(covered.exitCode, 0) << covered.errors;
  const Ended ended = running.wait(100);
  EXPECT_EQ(ended.exitCode, 1) << ended.out << ended.errors;
  ASSERT_TRUE(fs::exists(out_ / "results.json"));
  EXPECT_EQ(results().at("extra_data").at("outcome"), "not_gradable");
  EXPECT_THAT(results().dump(), HasSubstr("nothing draws here any more: "));
}

TEST_F(WhatDraws, AContextThatIsNoneIsRefused) {
  const Ended unknown = runTool({"grade", "mirror", folder_.path(), "--context", "gpu"});
  EXPECT_EQ(unknown.exitCode, 2) << "grades come from llvmpipe";
  const Ended ended =
      runTool({"render", "floor", "--solution", "--out", out_}, {{"GGRADE_CONTEXT", "nonsense"}});
  EXPECT_EQ(ended.exitCode, 2);
  EXPECT_THAT(ended.errors, HasSubstr("GGRADE_CONTEXT nonsense: auto, osmesa, egl or gpu"));
}

// qemu's user mode stands for such a machine; ggrade doesn't install it.
TEST(WithoutAvx, IsSaidByEveryProgramThatPeopleStart) {
  const fs::path qemu = "/usr/bin/qemu-x86_64";
  if (!fs::exists(qemu)) GTEST_SKIP() << "qemu-user is not installed";
  for (const char* program : {"ggrade", "ggrade-author", "ggrade-check", "ggrade-compare"}) {
    const Ended ended =
        Running({qemu, "-cpu", "qemu64", kBuild / "bin" / program, "--help"}).wait(20);
    EXPECT_EQ(ended.exitCode, 3) << program;
    EXPECT_THAT(ended.errors, AllOf(HasSubstr("no AVX"), HasSubstr("Remedy")));
  }
}

} // namespace
