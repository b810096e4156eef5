// What a class' folder remembers, who may work in it, and what is swept from it.

#include "batch/state.hpp"

#include "assignment/usage_error.hpp"
#include "framework_temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include <sys/mount.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using namespace ggrade;
using testing::HasSubstr;

std::string messageOf(const auto& run) {
  try {
    run();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(BatchState, ComesBackAsItWas) {
  const TemporaryFolder out;
  EXPECT_FALSE(batch::loadState(out.path()));
  batch::State state;
  state.target = "mirror";
  state.draw = {7, grading::Quality::fast};
  state.work = "/tmp/.ggrade-abc";
  state.run = 4;
  state.selfTest = "15 escapes refused";
  state.refused = {"link: is a symbolic link"};
  state.before = {{"s1", 80.5}, {"学生", 0}};
  batch::saveState(out.path(), state);
  const auto back = batch::loadState(out.path());
  ASSERT_TRUE(back);
  EXPECT_EQ(back->target, "mirror");
  EXPECT_EQ(back->draw, state.draw);
  EXPECT_EQ(back->work, state.work);
  EXPECT_EQ(back->run, 4U);
  EXPECT_FALSE(back->isFinished);
  EXPECT_EQ(back->selfTest, "15 escapes refused");
  EXPECT_EQ(back->refused, state.refused);
  EXPECT_EQ(back->before, state.before);
}

TEST(BatchState, ADamagedOneIsNamed) {
  const TemporaryFolder out;
  std::ofstream(out.path() / ".ggrade-batch.json") << "{";
  EXPECT_THAT(messageOf([&] { batch::loadState(out.path()); }),
              HasSubstr(".ggrade-batch.json is damaged: move"));
}

TEST(BatchState, OneRunAtATime) {
  const TemporaryFolder out;
  {
    const batch::Lock first(out.path());
    EXPECT_THAT(messageOf([&] { batch::Lock second(out.path()); }),
                HasSubstr("another ggrade is at work in"));
  }
  EXPECT_EQ(messageOf([&] { batch::Lock again(out.path()); }), "nothing was thrown");
}

TEST(BatchState, AFolderThatCantBeWrittenToIsNamedWithTheRemedy) {
  const TemporaryFolder folder;
  const auto expectRefused = [](const fs::path& out, const std::string& reason) {
    const std::string message =
        "can't write to " + out.string() + ": " + reason +
        ". Name another folder with --out, or give yourself write permission";
    EXPECT_EQ(messageOf([&] {
                batch::makeClassFolder(out);
                batch::Lock lock(out);
              }),
              message);
  };
  std::ofstream(folder.path() / "file") << "x";
  expectRefused(folder.path() / "file" / "class", "Not a directory");
  if (geteuid() != 0) GTEST_SKIP() << "the rest needs root";
  const fs::path readOnly = folder.path() / "read-only", others = folder.path() / "others";
  fs::create_directory(readOnly);
  fs::create_directory(others);
  if (mount("tmpfs", readOnly.c_str(), "tmpfs", MS_RDONLY, "size=4k") == 0) {
    expectRefused(readOnly, "Read-only file system");
    expectRefused(readOnly / "class", "Read-only file system");
    umount(readOnly.c_str());
  }
  ASSERT_EQ(seteuid(65534), 0);
  expectRefused(others, "Permission denied");
  expectRefused(others / "class", "Permission denied");
  ASSERT_EQ(seteuid(0), 0);
}

TEST(BatchState, SweepsWhatAKilledRunLeftAndNothingElse) {
  const TemporaryFolder out, elsewhere;
  batch::State state;
  state.work = elsewhere.path() / ".ggrade-work";
  fs::create_directories(state.work / "inside");
  fs::create_directories(out.path() / ".ggrade-half" / "inside");
  fs::create_directories(out.path() / "s1");
  std::ofstream(out.path() / ".ggrade-batch.json") << "{}";
  std::ofstream(out.path() / ".index.tmp-12-3.html") << "half a page";
  std::ofstream(out.path() / "s1/.student.tmp-12-4.html") << "half a page";
  std::ofstream(out.path() / "s1/.vimrc") << "somebody's own";
  fs::create_directory_symlink(out.path() / "s1", out.path() / ".ggrade-link");
  batch::sweep(out.path(), state);
  EXPECT_FALSE(fs::exists(state.work));
  EXPECT_FALSE(fs::exists(out.path() / ".ggrade-half"));
  EXPECT_FALSE(fs::exists(out.path() / ".index.tmp-12-3.html"));
  EXPECT_FALSE(fs::exists(out.path() / "s1/.student.tmp-12-4.html"));
  EXPECT_TRUE(fs::exists(out.path() / "s1/.vimrc"));
  EXPECT_TRUE(fs::exists(out.path() / ".ggrade-batch.json"));
  EXPECT_TRUE(fs::is_symlink(out.path() / ".ggrade-link"));

  // In a folder that nobody has graded into only what was to become its state.
  for (const char* name : {"..ggrade-batch.tmp-12-0.json", ".notes.tmp-12-0.txt"})
    std::ofstream(elsewhere.path() / name) << "half";
  fs::create_directory(elsewhere.path() / ".ggrade-other");
  batch::sweep(elsewhere.path(), {});
  EXPECT_FALSE(fs::exists(elsewhere.path() / "..ggrade-batch.tmp-12-0.json"));
  EXPECT_TRUE(fs::exists(elsewhere.path() / ".notes.tmp-12-0.txt"));
  EXPECT_TRUE(fs::exists(elsewhere.path() / ".ggrade-other"));

  // A state that names somebody's folder removes nothing.
  state.work = elsewhere.path();
  batch::sweep(out.path(), state);
  EXPECT_TRUE(fs::exists(elsewhere.path()));
}

} // namespace
