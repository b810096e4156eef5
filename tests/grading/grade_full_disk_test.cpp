// Our own disk is full, or there are no descriptors left, at whatever step of a grading: the
// student gets the score that is right, or none, and the exit code says that somebody must look.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <numeric>
#include <regex>

#include <sys/mount.h>

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What `ggrade grade` may say of a submission that gets `points` where nothing fails.
void expectRightOrNone(const tool::Ended& ended, const fs::path& out, double points,
                       std::size_t& right) {
  SCOPED_TRACE("code " + std::to_string(ended.exitCode) + '\n' + ended.out + ended.errors);
  const fs::path file = out / "results.json";
  EXPECT_FALSE(ended.late);
  EXPECT_EQ(ended.signal, 0);
  const json results = fs::exists(file) ? json::parse(tool::read(file)) : json();
  if (ended.exitCode == 0) {
    ++right;
    ASSERT_FALSE(results.is_null());
    EXPECT_EQ(results.at("score"), points);
    return;
  }
  if (!results.is_null()) {
    EXPECT_EQ(results.at("extra_data").at("outcome"), "not_gradable");
  }
  // A table breaks its lines anywhere. Without descriptors the sandbox is not even tried.
  EXPECT_THAT(std::regex_replace(ended.out + ended.errors, std::regex("\\s+"), " "),
              testing::ContainsRegex("No space left on device|Too many open files|disk full|"
                                     "no sandbox"));
}

class FullDisk : public testing::Test {
protected:
  const TemporaryFolder folder_;
  /// Drawn again for what its first fault hides: it takes every step that a right one takes.
  const tool::Submission submission_ = tool::Submission::example("scale_on_the_left");
  const double points_ = tool::gradeByTool(submission_).results.at("score");
};

TEST_F(FullDisk, CostsNoPoints) {
  const fs::path small = folder_.path() / "small";
  fs::create_directory(small);
  std::size_t right = 0;
  // In KiB: the unpacked files, the program, the shaders, then one scene's pictures after another,
  // then what is drawn again.
  for (const int size : {16, 80, 400, 1500, 4000, 9000, 16000, 40000, 200000}) {
    SCOPED_TRACE(std::to_string(size) + " KiB");
    const std::string options = "size=" + std::to_string(size) + "k";
    if (mount("tmpfs", small.c_str(), "tmpfs", 0, options.c_str()) != 0)
      GTEST_SKIP() << "only root can make a disk that is full";
    const fs::path out = folder_.path() / std::to_string(size);
    const tool::Ended ended =
        tool::runTool({"grade", "mirror", submission_.path(), "--no-diagnosis", "--out", out},
                      {{"TMPDIR", small}});
    EXPECT_TRUE(fs::is_empty(small)) << "something is left";
    umount(small.c_str());
    expectRightOrNone(ended, out, points_, right);
  }
  EXPECT_GE(right, 1U);
  EXPECT_LE(right, 5U) << "the disk was never full";
}

TEST_F(FullDisk, ThatFillsUpAtAnyStepCostsNone) {
  const fs::path small = folder_.path() / "small";
  fs::create_directory(small);
  std::size_t right = 0;
  for (const char* step : {"building", "rendering", "judging"}) {
    SCOPED_TRACE(step);
    if (mount("tmpfs", small.c_str(), "tmpfs", 0, "size=64m") != 0)
      GTEST_SKIP() << "only root can make a disk that is full";
    const fs::path out = folder_.path() / step;
    tool::Running running(
        tool::words({"grade", "mirror", submission_.path(), "--no-diagnosis", "--out", out}),
        {{"TMPDIR", small}});
    EXPECT_TRUE(running.says(std::string("grading submission: ") + step, 60));
    std::ofstream(small / "filler") << std::string(64 << 20, 'f') << std::flush;
    const tool::Ended ended = running.wait(100);
    fs::remove(small / "filler");
    EXPECT_TRUE(fs::is_empty(small)) << "something is left";
    umount(small.c_str());
    expectRightOrNone(ended, out, points_, right);
  }
  EXPECT_LE(right, 1U) << "the disk was full too late";
}

TEST_F(FullDisk, NorDoDescriptorsThatAreUsedUp) {
  std::size_t right = 0;
  // Each number from too few for any sandbox to enough for a build's, with some inherited ones.
  std::vector<int> limits(11);
  std::iota(limits.begin(), limits.end(), 16);
  for (const int most : {8, 48, 256}) limits.push_back(most);
  for (const int most : limits) {
    SCOPED_TRACE(std::to_string(most) + " descriptors");
    const fs::path out = folder_.path() / std::to_string(most);
    tool::Arguments words = {"/bin/sh", "-c", "ulimit -n " + std::to_string(most) + "; exec \"$@\"",
                             "sh"};
    for (const std::string& word :
         tool::words({"grade", "mirror", submission_.path(), "--no-diagnosis", "--out", out}))
      words.push_back(word);
    expectRightOrNone(tool::Running(words).wait(100), out, points_, right);
  }
  EXPECT_GE(right, 1U);
  EXPECT_LT(right, limits.size()) << "there were always enough";
}

} // namespace
