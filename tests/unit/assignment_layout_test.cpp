// `check` tells the same of a program after a formatter with other settings has been at it.

#include "another_layout.hpp"

#include "assignment/assignment.hpp"
#include "authoring/solution_blocks.hpp"
#include "check/begun.hpp"

#include <gmock/gmock.h>

#include <set>

using namespace ggrade;
namespace fs = std::filesystem;

namespace {

TEST(AssignmentLayout, IsNoWorkForCheck) {
  std::size_t begun = 0;
  for (const Assignment& assignment : loadAssignments(fs::path(GGRADE_SOURCE_DIR) / "assignments"))
    for (const std::string& file : assignment.files) {
      const std::string solution =
          readFile(fs::path(GGRADE_SOURCE_DIR) / "solutions" / assignment.id / file);
      const std::string stub = authoring::withFilled(solution, file, {});
      ASSERT_NE(inAnotherLayout(stub), stub) << file;
      for (const Part& part : assignment.parts) {
        std::set<std::string> filled;
        std::string before = stub;
        for (std::size_t k = 0;; ++k) {
          const std::string step = authoring::withFilled(solution, file, filled);
          if (k == 0 || step != before) {
            const check::Begun was = check::begunIn(stub, step),
                               is = check::begunIn(stub, inAnotherLayout(step));
            EXPECT_EQ(is.certain, was.certain) << assignment.id << '/' << file << " step " << k;
            EXPECT_EQ(is.possible, was.possible) << assignment.id << '/' << file << " step " << k;
            begun += was.certain.size();
          }
          before = step;
          if (k == part.todos.size()) break;
          filled.insert(part.todos[k].id);
        }
      }
    }
  EXPECT_GE(begun, 60u) << "nothing was compared";
}

} // namespace
