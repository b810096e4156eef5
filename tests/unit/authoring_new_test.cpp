// What `ggrade new` writes, and what it refuses.

#include "authoring/new_assignment.hpp"

#include "authoring/handout.hpp"
#include "authoring/solution_blocks.hpp"
#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"
#include "grading/catalogue.hpp"
#include "grading/recipe.hpp"
#include "grading/scenes.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

const fs::path kTemplates = GGRADE_SOURCE_DIR "/grader/authoring/new";

/// A tree with the assignment "cube" of two parts.
class NewId : public testing::Test {
protected:
  void SetUp() override {
    files_.write("assignments/cube/assignment.json",
                 R"({"id": "cube", "title": "A cube", "files": [], "parts": [
                     {"id": "turn", "title": "Turning", "todos": []},
                     {"id": "light", "title": "Light", "todos": []}]})");
    files_.write("build.ninja", "# made\nbuild all: phony\n\nbuild fog: phony bin/fog\n");
  }
  std::string problem(const std::string& id) {
    return messageOf<UsageError>(
        [&] { authoring::requireFreeId(id, files_.path(), files_.path() / "build.ninja"); });
  }
  TemporaryFolder files_;
};

TEST_F(NewId, IsMadeOfLowerCaseLettersDigitsAndUnderscores) {
  const auto isRefused = AllOf(HasSubstr("an ID is made of lower case letters, digits and _"),
                               HasSubstr("such as soft_light"));
  for (const char* id :
       {"", "Soft", "soft light", "soft-light", "../soft", "soft/light", "läuft", "soft.", "a\nb"})
    EXPECT_THAT(problem(id), isRefused) << id;
  EXPECT_THAT(problem("Soft"), HasSubstr("ID \"Soft\": "));
  EXPECT_THAT(problem(std::string(41, 'a')), isRefused);
  for (const std::string id : {"soft_light", "4k", "x", "_", "turn_2"})
    EXPECT_NO_THROW(authoring::requireFreeId(id, files_.path(), "none")) << id;
  EXPECT_NO_THROW(authoring::requireFreeId(std::string(40, 'a'), files_.path(), "none"));
}

TEST_F(NewId, OfAnotherAssignmentOrPartIsRefused) {
  EXPECT_EQ(problem("cube"), "ID \"cube\": there is such an assignment; choose another ID");
  EXPECT_EQ(problem("light"), "ID \"light\": cube has a part of this name; choose another ID");
}

TEST_F(NewId, OfAFolderOnEitherSideIsRefused) {
  fs::create_directories(files_.path() / "assignments/mine");
  fs::create_directories(files_.path() / "solutions/yours");
  EXPECT_THAT(problem("mine"), HasSubstr("assignments/mine is there already; move it away"));
  EXPECT_THAT(problem("yours"), HasSubstr("solutions/yours is there already; move it away"));
}

TEST_F(NewId, OfATargetOfTheBuildIsRefused) {
  for (const char* id : {"all", "fog"})
    EXPECT_THAT(problem(id), HasSubstr("the build has a target of this name; choose another ID"));
  EXPECT_NO_THROW(authoring::requireFreeId("phony", files_.path(), files_.path() / "build.ninja"));
}

TEST(NewTitle, IsMadeFromTheId) {
  EXPECT_EQ(authoring::titleOf("soft_light"), "Soft light");
  EXPECT_EQ(authoring::titleOf("4k"), "4k");
}

TEST(NewTitle, IsOneLine) {
  for (const std::string title : {"", "  ", "a\nb", "a  b", "\x1b[31mred", "\xff"})
    EXPECT_THAT(messageOf<UsageError>([&] { authoring::requireTitle(title); }),
                HasSubstr("a title is one line of UTF-8 text"))
        << title;
  EXPECT_THAT(messageOf<UsageError>([] { authoring::requireTitle(std::string(101, 'a')); }),
              HasSubstr("1 to 100 bytes"));
  EXPECT_THAT(messageOf<UsageError>([] { authoring::requireTitle("Light {{points}}"); }),
              HasSubstr("title \"Light {{points}}\": {{ begins a directive of the handout"));
  EXPECT_NO_THROW(authoring::requireTitle("光 \"from\" a \\ window"));
}

/// Both sides of the template, filled in.
class Template : public testing::Test {
protected:
  void SetUp() override {
    for (const char* side : {"assignments", "solutions"})
      authoring::writeTemplate(kTemplates / side / "new_assignment", "lamp", kTitle,
                               files_.path() / side / "lamp");
    assignment_ = Assignment::load(files_.path() / "assignments/lamp");
  }
  const std::string kTitle = "A \"new_assignment\" \\ of light";
  TemporaryFolder files_;
  fs::path solution_ = files_.path() / "solutions/lamp";
  Assignment assignment_;
};

TEST_F(Template, IsAnAssignmentOfOnePart) {
  EXPECT_TRUE(assignment_.isOnePart());
  EXPECT_EQ(assignment_.title, kTitle);
  const Target target = findTarget(files_.path() / "assignments", "lamp");
  EXPECT_EQ(target.title(), kTitle);
  EXPECT_EQ(target.maxScore(), 100);
}

TEST_F(Template, HoldsTheIdAndTheTitleWhereverItHeldItsOwn) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(files_.path())) {
    EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("new_assignment")));
    if (!entry.is_regular_file()) continue;
    ++files;
    std::string text = readFile(entry.path());
    for (const std::string& title : {kTitle, std::string("A \\\"new_assignment\\\" \\\\ of light")})
      for (std::size_t at = 0; (at = text.find(title)) != text.npos;) text.erase(at, title.size());
    EXPECT_THAT(text, Not(HasSubstr("new_assignment"))) << entry.path();
    EXPECT_THAT(text, Not(HasSubstr("A new assignment"))) << entry.path();
  }
  EXPECT_GE(files, 11);
  EXPECT_TRUE(readFile(solution_ / "handout.md").starts_with("# " + kTitle + "\n"));
}

TEST_F(Template, HasWhatEveryTodoAndItemNeeds) {
  int blocks = 0;
  for (const std::string& file : assignment_.files)
    blocks += int(authoring::blocks(readFile(solution_ / file), file).size());
  EXPECT_EQ(blocks, 1);
  EXPECT_THAT(readFile(solution_ / "rubric.cpp"),
              HasSubstr("GGRADE_ITEM(\"" + assignment_.parts.at(0).items.at(0).id + "\""));
  const std::string handout = authoring::expandHandout(
      readFile(solution_ / "handout.md"), "handout.md", assignment_,
      [&](const std::string& file) {
        return authoring::withFilled(readFile(solution_ / file), file, {});
      },
      [](const std::string&) { return ""; });
  EXPECT_THAT(handout, AllOf(HasSubstr("| 100 | "), HasSubstr("TODO(lamp.1)"),
                             HasSubstr("(handout/lamp-1.png)"), Not(HasSubstr("toLight"))));
}

TEST_F(Template, HasAPublicAndHiddenScenesOnEverySeed) {
  const Target target = findTarget(files_.path() / "assignments", "lamp");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const grading::ScenePlan plan =
        grading::drawScenes(target, solution_, {seed, grading::Quality::balanced});
    EXPECT_EQ(plan.scenes.size(), 3u);
    EXPECT_EQ(std::ranges::count_if(plan.scenes, &grading::SceneCase::isPublic), 1);
  }
}

TEST_F(Template, HasACatalogueThatApplies) {
  const grading::Catalogue catalogue =
      grading::loadCatalogue(assignment_, assignment_.parts.at(0), solution_, solution_);
  ASSERT_EQ(catalogue.mistakes.size(), 1u);
  ASSERT_EQ(catalogue.variants.size(), 1u);
  for (const fs::path& patch : {catalogue.mistakes[0].patch, catalogue.variants[0].patch})
    EXPECT_NO_THROW(grading::writeFiles(assignment_, {solution_, {patch}},
                                        files_.path() / "made" / patch.stem()));
}

} // namespace
