// The catalogue of mistakes and right answers: what a header must say, and how a fault is named.

#include "grading/catalogue.hpp"
#include "grading/overlay.hpp"
#include "grading/recipe.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

namespace {

const fs::path kFloorSolution = GGRADE_SOURCE_DIR "/solutions/floor";

/// A solution's folder with scenes and a catalogue of its own.
class CatalogueTest : public testing::Test {
protected:
  void SetUp() override {
    files_.write("floor/scenes.json", readFile(kFloorSolution / "scenes.json"));
  }

  static std::string diff(const std::string& file = "floor.cpp") {
    return fmt("\ndiff --git a/solutions/floor/%s b/solutions/floor/%s\n", file);
  }
  static std::string fmt(std::string text, const std::string& value) {
    for (std::size_t at; (at = text.find("%s")) != text.npos;) text.replace(at, 2, value);
    return text;
  }
  static std::string mistakeHeader() {
    return "Title: The light is not mirrored\nGrades: mirror\nSymptom: Dark reflections.\n"
           "Hint: Look at where the light\n  is.\nFails: mirror.shading\nStep: mirror.4\n"
           "Shows: mirror\n";
  }
  void mistake(const std::string& name, const std::string& more = {}) {
    files_.write("floor/mistakes/" + name + ".patch", mistakeHeader() + more + diff());
  }
  /// A mistake whose header has `to` where it should have `from`.
  void faulty(const std::string& from, const std::string& to) {
    std::string text = mistakeHeader();
    text.replace(text.find(from), from.size(), to);
    files_.write("floor/mistakes/mirror_a.patch", text + diff());
  }
  grading::Catalogue load(const std::string& part = "mirror") {
    const Target target = findTarget(GGRADE_SOURCE_DIR "/assignments", part);
    return grading::loadCatalogue(target.assignment, target.parts[0], files_.path() / "floor",
                                  files_.path() / "floor");
  }
  std::string problem() {
    return messageOf<UsageError>([&] { load(); });
  }

  TemporaryFolder files_;
};

TEST_F(CatalogueTest, IsEmptyWithoutPatches) {
  const grading::Catalogue all = load();
  EXPECT_THAT(all.mistakes, IsEmpty());
  EXPECT_THAT(all.variants, IsEmpty());
  EXPECT_THAT(all.pairs, IsEmpty());
}

TEST_F(CatalogueTest, ReadsMistakesVariantsAndPairsOfOnePart) {
  mistake("mirror_b", "Outcome: no_frame\nSame: a\nTry: Take the light away.\n");
  mistake("mirror_a");
  files_.write("floor/mistakes/shadow_a.patch", "nothing of the mirror's business");
  files_.write("floor/mistakes/mirror.pairs", "# together\nmirror_a b # prefix or not\n\n");
  files_.write("floor/variants/mirror_lecture.patch",
               "Title: As in the lecture\nGrades: mirror\nLoses: mirror.clip, "
               "mirror.blur\nOutcome: crash\n" +
                   diff("more.glsl"));
  const grading::Catalogue all = load();
  ASSERT_EQ(all.mistakes.size(), 2u);
  EXPECT_EQ(all.mistakes[0].name, "mirror_a");
  EXPECT_EQ(all.mistakes[0].hint, "Look at where the light is.");
  EXPECT_EQ(all.mistakes[0].fails, "mirror.shading");
  EXPECT_EQ(all.mistakes[0].outcome, results::Outcome::graded);
  EXPECT_EQ(all.mistakes[0].experiment, "");
  EXPECT_EQ(all.mistakes[1].experiment, "Take the light away.");
  EXPECT_EQ(all.mistakes[1].outcome, results::Outcome::noFrame);
  EXPECT_EQ(all.mistakes[1].same, "mirror_a");
  ASSERT_EQ(all.variants.size(), 1u);
  EXPECT_THAT(all.variants[0].loses, ElementsAre("mirror.clip", "mirror.blur"));
  EXPECT_EQ(all.variants[0].outcome, results::Outcome::crash);
  EXPECT_THAT(all.pairs, ElementsAre(Pair("mirror_a", "mirror_b")));
}

TEST_F(CatalogueTest, AMissingKeyIsNamed) {
  faulty("Hint: Look at where the light\n  is.\n", "");
  EXPECT_THAT(problem(), AllOf(HasSubstr("mirror_a.patch"), HasSubstr("lacks \"Hint:\"")));
}

TEST_F(CatalogueTest, AnUnknownKeyIsNamed) {
  faulty("Symptom", "Hint2: x\nSymptom");
  EXPECT_THAT(problem(), HasSubstr("mirror_a.patch: \"Hint2:\" is no key; there are Title,"));
}

TEST_F(CatalogueTest, AKeyThatStandsThereTwiceIsNamed) {
  faulty("Symptom", "Title: again\nSymptom");
  EXPECT_THAT(problem(), HasSubstr("mirror_a.patch:3: \"Title:\" stands there twice"));
}

TEST_F(CatalogueTest, AnItemOfAnotherPartIsNamed) {
  faulty("mirror.shading", "shadow.map");
  EXPECT_THAT(problem(), HasSubstr("mirror_a.patch: Fails: mirror has no item \"shadow.map\"; "
                                   "there are mirror.target, mirror.texture"));
}

TEST_F(CatalogueTest, UnknownStepTagPartAndOutcomeAreAllNamedAtOnce) {
  faulty("mirror.4", "mirror.9");
  files_.write("floor/mistakes/mirror_b.patch",
               fmt(mistakeHeader(), "") + "Outcome: broken\n" + diff());
  files_.write("floor/variants/mirror_c.patch", "Title: c\nGrades: shadow\n" + diff());
  files_.write("floor/variants/mirror_d.patch", "Title: d\nGrades: mirror\n");
  EXPECT_THAT(problem(),
              AllOf(HasSubstr("mirror_a.patch: Step: mirror has no step \"mirror.9\""),
                    HasSubstr("mirror_b.patch: Outcome: \"broken\" is none"),
                    HasSubstr("mirror_c.patch: Grades: \"shadow\", but its name says mirror"),
                    HasSubstr("mirror_d.patch: changes no file")));
}

TEST_F(CatalogueTest, ATagThatNoSceneOfThePartHasIsNamed) {
  faulty("Shows: mirror", "Shows: grazing");
  EXPECT_THAT(problem(), HasSubstr("Shows: no scene of mirror has the tag \"grazing\"; there are "
                                   "blurred, mirror, mirror_moved, mirror_resized, sunk"));
}

TEST_F(CatalogueTest, ARightAnswerMustNotLoseWhatIsRequired) {
  files_.write("floor/variants/mirror_a.patch",
               "Title: a\nGrades: mirror\nLoses: mirror.shading\n" + diff());
  EXPECT_THAT(problem(), HasSubstr("mirror_a.patch: Loses: mirror.shading is required"));
}

TEST_F(CatalogueTest, APatchOfAFileThatNobodyHandsInIsNamed) {
  files_.write("floor/variants/mirror_a.patch", "Title: a\nGrades: mirror\n" + diff("scenes.json"));
  EXPECT_THAT(problem(), HasSubstr("mirror_a.patch: scenes.json is no file that a student hands"));
  files_.write("floor/variants/mirror_a.patch",
               "Title: a\nGrades: mirror\n\ndiff --git a/floor.cpp b/floor.cpp\n");
  EXPECT_THAT(problem(), HasSubstr("is no file of solutions/floor/"));
}

TEST_F(CatalogueTest, PairsNameTheLineOfAMistakeThatIsNotThere) {
  mistake("mirror_a");
  mistake("mirror_b");
  files_.write("floor/mistakes/mirror.pairs", "a b\na c\na\nb a\nb b\n");
  EXPECT_THAT(problem(), AllOf(HasSubstr("mirror.pairs:2: there is no mistake \"c\""),
                               HasSubstr("mirror.pairs:3: expected the names of two mistakes"),
                               HasSubstr("mirror.pairs:4: mirror_b and mirror_a stand there twice"),
                               HasSubstr("mirror.pairs:5: mirror_b twice is no pair")));
}

TEST_F(CatalogueTest, SameMustNameAnotherMistake) {
  mistake("mirror_a", "Same: mirror_z\n");
  EXPECT_THAT(problem(), HasSubstr("mirror_a.patch: Same: there is no other mistake \"mirror_z\""));
}

TEST_F(CatalogueTest, TwoPatchesAreAppliedInARowAndMayAddAFile) {
  const Assignment assignment = Assignment::load(GGRADE_SOURCE_DIR "/assignments/floor");
  const std::string screen = readFile(kFloorSolution / "screen.vert");
  std::istringstream lines(screen);
  std::string first, second, third;
  std::getline(lines, first);
  std::getline(lines, second);
  std::getline(lines, third);
  const std::string header =
      "diff --git a/solutions/floor/screen.vert b/solutions/floor/screen.vert\n"
      "--- a/solutions/floor/screen.vert\n"
      "+++ b/solutions/floor/screen.vert\n";
  const fs::path one = files_.write("one.patch", "Title: one\n\n" + header + "@@ -1,2 +1,3 @@\n " +
                                                     first + "\n+// one\n " + second + "\n");
  const fs::path two = files_.write(
      "two.patch",
      "Title: two\n\ndiff --git a/solutions/floor/mine.glsl b/solutions/floor/mine.glsl\n"
      "new file mode 100644\n--- /dev/null\n+++ b/solutions/floor/mine.glsl\n"
      "@@ -0,0 +1 @@\n+// new\n" +
          header + "@@ -2,2 +2,3 @@\n " + second + "\n+// two\n " + third + "\n");
  grading::writeFiles(assignment, {kFloorSolution, {one, two}}, files_.path() / "both");
  EXPECT_EQ(readFile(files_.path() / "both/screen.vert"),
            first + "\n// one\n" + second + "\n// two\n" +
                screen.substr(first.size() + second.size() + 2));
  EXPECT_EQ(readFile(files_.path() / "both/mine.glsl"), "// new\n");
  EXPECT_FALSE(fs::exists(files_.path() / "both/rubric_common.hpp"));

  fs::create_directory(files_.path() / "into");
  const grading::Overlay taken =
      grading::overlay(assignment, files_.path() / "both", files_.path() / "into");
  EXPECT_THAT(taken.unused, IsEmpty());
  EXPECT_EQ(readFile(files_.path() / "into/mine.glsl"), "// new\n");
}

} // namespace
