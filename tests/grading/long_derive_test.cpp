// `derive` with the pictures of every assignment, see grade_steps_test.cpp.

#include "handout.hpp"

#include <gmock/gmock.h>

using namespace tool;

namespace {

TEST(LongDerive, StubsHandoutsAndPicturesAreInStepWithTheSolution) {
  for (const ggrade::Assignment& assignment : ggrade::loadAssignments(kSource / "assignments")) {
    SCOPED_TRACE(assignment.id);
    expectInStep(assignment, true);
  }
}

} // namespace
