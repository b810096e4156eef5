// Every assignment but the floor, whose scores other tests state number by number: what must hold
// of a new one as soon as its folders are there.

#include "tool.hpp"

#include "assignment/assignment.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::IsEmpty;

namespace {

struct One {
  ggrade::Assignment assignment;
  ggrade::Part part;
};

void PrintTo(const One& one, std::ostream* out) {
  *out << one.part.id;
}

/// A function, because kSource is initialised elsewhere.
std::vector<One> parts() {
  std::vector<One> all;
  for (const auto& assignment :
       ggrade::loadAssignments(fs::path(GGRADE_SOURCE_DIR) / "assignments"))
    for (const ggrade::Part& part : assignment.parts)
      if (assignment.id != "floor") all.push_back({assignment, part});
  return all;
}

double pointsOf(const ggrade::Part& part, ggrade::report::ItemKind kind) {
  double sum = 0;
  for (const ggrade::ItemDeclaration& item : part.items)
    if (item.kind == kind) sum += item.points;
  return sum;
}

class Every : public testing::TestWithParam<One> {
protected:
  const ggrade::Part& part() const { return GetParam().part; }
  double points() const { return pointsOf(part(), ggrade::report::ItemKind::gain); }
  double bonusPoints() const { return pointsOf(part(), ggrade::report::ItemKind::bonus); }
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Every);
INSTANTIATE_TEST_SUITE_P(Part, Every, testing::ValuesIn(parts()),
                         [](const auto& one) { return one.param.part.id; });

TEST_P(Every, ReferenceHasEverything) {
  const fs::path solution = kSource / "solutions" / GetParam().assignment.id;
  const Graded graded = gradePart(part().id, solution, {"--solution"});
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.score(), points());
  EXPECT_EQ(graded.bonus(), bonusPoints());
  EXPECT_THAT(graded.lost(), IsEmpty());
}

TEST_P(Every, StubHasNothing) {
  const Graded graded = gradePart(part().id, GetParam().assignment.folder);
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.score(), 0);
  EXPECT_EQ(graded.bonus(), 0);
  for (const ggrade::ItemDeclaration& item : part().items)
    EXPECT_EQ(graded.earned(item.id), 0) << graded.message(item.id);
}

/// A student's way through the handout.
TEST_P(Every, StepEarnsNoLessThanTheOneBefore) {
  double score = 0, bonus = 0;
  int required = 0;
  for (const ggrade::Todo& todo : part().todos)
    if (!todo.bonus) ++required;
  for (int k = 1; k <= static_cast<int>(part().todos.size()); ++k) {
    const Graded graded = gradePart(part().id, Submission::firstSteps(k, part().id));
    EXPECT_EQ(graded.outcome(), "graded") << k;
    EXPECT_GE(graded.score(), score) << "step " << k;
    EXPECT_GE(graded.bonus(), bonus) << "step " << k;
    score = graded.score();
    bonus = graded.bonus();
    if (k == required) {
      EXPECT_EQ(score, points()) << "step " << k;
    }
  }
  EXPECT_EQ(bonus, bonusPoints());
}

} // namespace
