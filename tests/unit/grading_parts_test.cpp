// Overlay, patches, folders that appear whole, work on several threads.

#include "grading/overlay.hpp"
#include "grading/recipe.hpp"
#include "grading/references.hpp"
#include "grading/workspace.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <stdexcept>

using namespace ggrade;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;
using testing::UnorderedElementsAreArray;

namespace {

/// The floor's assignment, a folder that a student uploads, and where it is laid over.
class Overlaying : public testing::Test {
protected:
  void SetUp() override {
    fs::create_directories(upload_);
    fs::create_directories(into_);
  }
  grading::Overlay overlay() { return grading::overlay(assignment_, upload_, into_); }

  Assignment assignment_ = Assignment::load(GGRADE_SOURCE_DIR "/assignments/floor");
  TemporaryFolder files_;
  fs::path upload_ = files_.path() / "upload", into_ = files_.path() / "into";
};

TEST_F(Overlaying, TakesEditableAndOptionalFilesOverTheHandedOutOnes) {
  files_.write("upload/floor.cpp", "mine");
  files_.write("upload/extra.frag", "added");
  files_.write("upload/scene.json", "changed");
  files_.write("upload/.hidden", "");
  const grading::Overlay taken = overlay();
  EXPECT_THAT(taken.used, UnorderedElementsAre("floor.cpp", "extra.frag"));
  std::vector<std::string> others = assignment_.files;
  std::erase(others, "floor.cpp");
  EXPECT_THAT(taken.missing, UnorderedElementsAreArray(others));
  EXPECT_THAT(taken.unused, ElementsAre(".hidden: not a file of this assignment"));
  EXPECT_EQ(readFile(into_ / "floor.cpp"), "mine");
  EXPECT_EQ(readFile(into_ / "extra.frag"), "added");
  EXPECT_EQ(readFile(into_ / "scene.json"), readFile(assignment_.folder / "scene.json"));
  EXPECT_EQ(readFile(into_ / "tile.frag"), readFile(assignment_.folder / "tile.frag"));
  EXPECT_FALSE(fs::exists(into_ / ".hidden"));
}

TEST_F(Overlaying, FollowsNoLink) {
  files_.write("secret", "secret");
  files_.write("upload/floor.cpp", "mine");
  fs::create_symlink(files_.path() / "secret", upload_ / "tile.frag");
  fs::create_symlink("/", upload_ / "root");
  const grading::Overlay taken = overlay();
  EXPECT_THAT(taken.unused,
              UnorderedElementsAre("tile.frag: a link", "root: not a file of this assignment"));
  EXPECT_EQ(readFile(into_ / "tile.frag"), readFile(assignment_.folder / "tile.frag"));
}

TEST_F(Overlaying, TakesAFileUpToTheLimit) {
  files_.write("upload/floor.cpp", std::string(grading::kLargestSource, ' '));
  files_.write("upload/tile.frag", std::string(grading::kLargestSource + 1, ' '));
  const grading::Overlay taken = overlay();
  EXPECT_THAT(taken.used, ElementsAre("floor.cpp"));
  EXPECT_THAT(taken.unused, ElementsAre("tile.frag: larger than 1024 KiB"));
  EXPECT_EQ(fs::file_size(into_ / "floor.cpp"), grading::kLargestSource);
}

TEST_F(Overlaying, AnEmptyFileIsAFile) {
  files_.write("upload/floor.cpp", "");
  EXPECT_THAT(overlay().used, ElementsAre("floor.cpp"));
  EXPECT_EQ(fs::file_size(into_ / "floor.cpp"), 0u);
}

TEST_F(Overlaying, NothingToTakeIsRefused) {
  EXPECT_THAT(messageOf<UsageError>([&] { overlay(); }),
              AllOf(HasSubstr("holds no file of floor"), HasSubstr("floor.cpp, mirror.hpp, ")));
  upload_ = files_.path() / "gone";
  EXPECT_THAT(messageOf<UsageError>([&] { overlay(); }), HasSubstr("there is no such folder"));
  upload_ = files_.write("file", "");
  EXPECT_THAT(messageOf<UsageError>([&] { overlay(); }), HasSubstr("is not a folder"));
}

class Patch : public testing::Test {
protected:
  fs::path write(const std::string& text) { return files_.write("a.patch", text); }
  TemporaryFolder files_;
};

TEST_F(Patch, HeaderIsReadUpToTheDiff) {
  const auto header =
      grading::patchHeader(write("Title: A name: that\n  goes on\nGrades: mirror\n\n"
                                 "Outcome: graded\n\ndiff --git a/x b/x\nTitle: not this\n"));
  EXPECT_EQ(header.at("Title"), "A name: that goes on");
  EXPECT_EQ(header.at("Grades"), "mirror");
  EXPECT_EQ(header.size(), 3u);
}

TEST_F(Patch, MistakesInTheHeaderNameTheLine) {
  const auto problem = [&](const std::string& text) {
    return messageOf<UsageError>([&] { grading::patchHeader(write(text)); });
  };
  EXPECT_THAT(problem("Title: a\nnonsense\n"), HasSubstr("a.patch:2: expected \"Key: value\""));
  EXPECT_THAT(problem("Title: a\nGrades: mirror\ndiff --git a b\n"),
              HasSubstr("its header lacks \"Outcome:\""));
}

TEST_F(Patch, ThatNoLongerAppliesIsNamed) {
  const Assignment assignment = Assignment::load(GGRADE_SOURCE_DIR "/assignments/floor");
  const fs::path patch =
      write("Title: a\nGrades: mirror\nOutcome: graded\n\n"
            "diff --git a/solutions/floor/floor.cpp b/solutions/floor/floor.cpp\n"
            "--- a/solutions/floor/floor.cpp\n+++ b/solutions/floor/floor.cpp\n"
            "@@ -1,2 +1,2 @@\n-not its first line\n+another\n \n");
  EXPECT_THAT(messageOf<UsageError>([&] {
                grading::writeFiles(assignment, {GGRADE_SOURCE_DIR "/solutions/floor", {patch}},
                                    files_.path() / "into");
              }),
              AllOf(HasSubstr("a.patch no longer applies to"), HasSubstr("solutions/floor")));
}

TEST_F(Patch, EveryExampleApplies) {
  const Assignment assignment = Assignment::load(GGRADE_SOURCE_DIR "/assignments/floor");
  const fs::path solutions = GGRADE_SOURCE_DIR "/solutions/floor";
  int count = 0;
  for (const auto& entry : fs::directory_iterator(solutions / "examples")) {
    const fs::path into = files_.path() / entry.path().stem();
    grading::writeFiles(assignment, {solutions, {entry.path()}}, into);
    bool changed = false;
    for (const std::string& file : assignment.files)
      changed |= readFile(into / file) != readFile(solutions / file);
    EXPECT_TRUE(changed) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 4);
}

TEST(InParallel, DoesEveryTaskOnce) {
  for (unsigned workers : {1u, 2u, 7u}) {
    std::vector<std::atomic<int>> done(50);
    grading::inParallel(done.size(), workers, [&](std::size_t i) { ++done[i]; });
    for (const auto& count : done) EXPECT_EQ(count, 1);
  }
  grading::inParallel(0, 4, [](std::size_t) { FAIL(); });
}

TEST(InParallel, ThrowsTheFirstErrorWhenAllHaveEnded) {
  std::atomic<int> running{0};
  EXPECT_EQ(messageOf<std::runtime_error>([&] {
              grading::inParallel(1000, 4, [&](std::size_t i) {
                ++running;
                if (i == 3) {
                  --running;
                  throw std::runtime_error("third");
                }
                --running;
              });
            }),
            "third");
  EXPECT_EQ(running, 0);
}

TEST(Folder, IsPublishedWholeOrNotAtAll) {
  const TemporaryFolder files;
  const fs::path out = files.path() / "out";
  for (const char* text : {"first", "second"}) {
    grading::TemporaryFolder work(files.path());
    std::ofstream(work.path() / "results.json") << text;
    work.publish(out);
    EXPECT_EQ(readFile(out / "results.json"), text);
  }
  // Neither is what was replaced left behind.
  EXPECT_EQ(std::distance(fs::directory_iterator(files.path()), {}), 1);
}

TEST(Folder, ReplacesNoOther) {
  const TemporaryFolder files;
  files.write("out/letter.txt", "dear");
  {
    grading::TemporaryFolder work(files.path());
    EXPECT_THAT(
        messageOf<UsageError>([&] { work.publish(files.path() / "out"); }),
        AllOf(HasSubstr("holds letter.txt, which is no earlier result"), HasSubstr("--out")));
  }
  EXPECT_EQ(readFile(files.path() / "out/letter.txt"), "dear");
  EXPECT_EQ(std::distance(fs::directory_iterator(files.path()), {}), 1);
}

} // namespace
