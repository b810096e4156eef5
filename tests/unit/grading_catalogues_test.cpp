// The catalogues of all assignments: every header is complete, and every patch still applies, alone
// and in its pairs. What they are worth is for `ggrade calibrate` to say.

#include "grading/catalogue.hpp"
#include "grading/owners.hpp"
#include "grading/recipe.hpp"

#include "framework_temporary_folder.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
namespace fs = std::filesystem;
using testing::Contains;
using testing::EndsWith;

namespace {

std::vector<std::string> everyPart() {
  std::vector<std::string> all;
  for (const Assignment& assignment : loadAssignments(GGRADE_SOURCE_DIR "/assignments"))
    for (const Part& part : assignment.parts) all.push_back(part.id);
  return all;
}

class Catalogues : public testing::TestWithParam<std::string> {
protected:
  Target target_ = findTarget(GGRADE_SOURCE_DIR "/assignments", GetParam());
  fs::path solution_ = fs::path(GGRADE_SOURCE_DIR "/solutions") / target_.assignment.id;
  grading::Catalogue all_ =
      grading::loadCatalogue(target_.assignment, target_.parts.at(0), solution_, solution_);

  /// Applies the patches to the solution, in this order.
  void expectToApply(const std::vector<fs::path>& patches) {
    const TemporaryFolder into;
    EXPECT_NO_THROW(
        grading::writeFiles(target_.assignment, {solution_, patches}, into.path() / "submission"));
  }
};

// What is kept is read as it stands there, and a whole assignment knows what its parts do.
TEST(Owners, OfAWholeAssignmentAreThoseOfItsParts) {
  const Target floor = findTarget(GGRADE_SOURCE_DIR "/assignments", "floor");
  const fs::path solution = GGRADE_SOURCE_DIR "/solutions/floor";
  const grading::Owners owners(floor, solution);
  for (const Part& part : floor.parts) {
    std::size_t roles = 0;
    const auto kept = readJson(grading::ownersFile(solution, part.id));
    for (const auto& [role, units] : kept.at("units").items()) {
      if (!units.contains("draws") || !units.at("draws").contains("without")) continue;
      ++roles;
      for (const auto& [todo, share] : units.at("draws").at("without").items())
        EXPECT_THAT(owners.drawersOf(role), Contains(todo)) << role;
    }
    EXPECT_GT(roles, 0u) << part.id;
  }
}

// Counting what is hidden sets anew what counting what is seen has set.
TEST(Owners, AStepMayDecideElsewhereWhatAnotherDecidesInThePublicScene) {
  const Target target = findTarget(GGRADE_SOURCE_DIR "/assignments", "shadow_volume");
  const fs::path solution = GGRADE_SOURCE_DIR "/solutions/shadow_volume";
  const grading::Owners owners(target, solution);
  const auto kept = readJson(grading::ownersFile(solution, "shadow_volume"));
  std::size_t roles = 0;
  for (const auto& [role, units] : kept.at("units").items()) {
    const repair::Unit unit{role, "stencil operations"};
    if (!units.contains(unit.name) || !units.at(unit.name).contains("elsewhere by")) continue;
    ++roles;
    EXPECT_EQ(owners.decidersOf(unit, false), std::set<std::string>{"shadow_volume.5"});
    EXPECT_EQ(owners.decidersOf(unit, true), std::set<std::string>{"shadow_volume.3"});
  }
  EXPECT_EQ(roles, 1u);
}

// Grading learns it else, half a minute for each part.
TEST_P(Catalogues, WhoseWorkIsWhatIsKeptOfTheFilesThatAreThere) {
  EXPECT_TRUE(grading::areOwnersKept(target_, solution_))
      << "run ./ggrade derive " << target_.assignment.id << " --no-pictures";
}

TEST_P(Catalogues, EveryMistakeSpeaksInSentences) {
  for (const grading::Mistake& mistake : all_.mistakes) {
    EXPECT_THAT(mistake.symptom, EndsWith(".")) << mistake.name;
    EXPECT_THAT(mistake.hint, testing::ContainsRegex("[.?]$")) << mistake.name;
    EXPECT_GE(mistake.hint.size(), 60u) << mistake.name << ": too short to act on";
    EXPECT_THAT(mistake.experiment, testing::MatchesRegex("|.*[.?]")) << mistake.name;
    if (mistake.same.empty()) continue;
    // One diagnosis for both: the one that is named speaks for itself.
    const grading::Mistake* other = all_.mistake(mistake.same);
    ASSERT_TRUE(other) << mistake.name;
    EXPECT_EQ(other->same, "") << mistake.name;
    EXPECT_EQ(other->fails, mistake.fails) << mistake.name;
  }
}

TEST_P(Catalogues, EveryPatchApplies) {
  for (const grading::Mistake& mistake : all_.mistakes) expectToApply({mistake.patch});
  for (const grading::Variant& variant : all_.variants) expectToApply({variant.patch});
}

TEST_P(Catalogues, EveryPairAppliesInARow) {
  for (const auto& [first, second] : all_.pairs)
    expectToApply({all_.mistake(first)->patch, all_.mistake(second)->patch});
}

INSTANTIATE_TEST_SUITE_P(Parts, Catalogues, testing::ValuesIn(everyPart()),
                         [](const auto& info) { return info.param; });

/// What the demo grades.
TEST(Examples, EveryPatchApplies) {
  int count = 0;
  for (const Assignment& assignment : loadAssignments(GGRADE_SOURCE_DIR "/assignments")) {
    const fs::path solution = fs::path(GGRADE_SOURCE_DIR "/solutions") / assignment.id;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(solution / "examples", none)) {
      const TemporaryFolder into;
      EXPECT_NO_THROW(
          grading::writeFiles(assignment, {solution, {entry.path()}}, into.path() / "submission"));
      ++count;
    }
  }
  EXPECT_GE(count, 17);
}

class FloorCatalogue : public Catalogues {};

TEST_P(FloorCatalogue, HasEnoughOfEveryKind) {
  EXPECT_GE(all_.mistakes.size(), 20u);
  EXPECT_GE(all_.variants.size(), 10u);
  EXPECT_GE(all_.pairs.size(), 20u);
  std::vector<std::string> variants;
  for (const grading::Variant& variant : all_.variants) variants.push_back(variant.name);
  EXPECT_THAT(variants, Contains(EndsWith("_lecture")));
}

INSTANTIATE_TEST_SUITE_P(Parts, FloorCatalogue, testing::Values("mirror", "shadow", "bloom"),
                         [](const auto& info) { return info.param; });

} // namespace
