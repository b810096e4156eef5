#include "gradebook/csv.hpp"
#include "gradebook/entry.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

namespace ggrade::gradebook {
namespace {

const std::string kNeutralHeader =
    "assignment,duedate,timestamp,student_id,last_name,first_name,email,"
    "raw_score,late_submission_penalty,score,max_score\n";

TEST(NeutralCsv, HasARowForEveryEntry) {
  EXPECT_EQ(
      neutralCsv("floor", "2026-11-20T23:59+09:00",
                 {{"1234", "学生 1", 87.456, 100, 0, "", "2026-11-20T10:00+09:00"},
                  {"1235", "Student, Two", 60, 100, 25.5, "", "2026-11-22T10:00+09:00"},
                  {"1236", "", 10, 100, 50}}),
      kNeutralHeader +
          "floor,2026-11-20T23:59+09:00,2026-11-20T10:00+09:00,1234,学生 1,,,87.46,0,87.46,100\n"
          "floor,2026-11-20T23:59+09:00,2026-11-22T10:00+09:00,1235,\"Student, Two\",,,60,25.5,"
          "34.5,100\n"
          "floor,2026-11-20T23:59+09:00,,1236,,,,10,50,0,100\n");
}

TEST(NeutralCsv, TellsNotGradableFromZero) {
  EXPECT_EQ(neutralCsv("floor", "", {{"1", "a", {}, 100}, {"2", "b", 0, 100}}),
            kNeutralHeader + "floor,,,1,a,,,,,,100\nfloor,,,2,b,,,0,0,0,100\n");
}

TEST(NeutralCsv, NeutralizesEveryText) {
  const Csv csv(neutralCsv("=a", "+d", {{"@1", " =HYPERLINK(\"x\")", 1, 2, 0, "", "-t"}}), "g.csv");
  EXPECT_EQ(csv.cell(1, 0), "'=a");
  EXPECT_EQ(csv.cell(1, 1), "'+d");
  EXPECT_EQ(csv.cell(1, 2), "'-t");
  EXPECT_EQ(csv.cell(1, 3), "'@1");
  EXPECT_EQ(csv.cell(1, 4), "' =HYPERLINK(\"x\")");
}

TEST(NeutralCsv, RefusesNumbersThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto write = [](const Entry& entry) { return neutralCsv("floor", "", {entry}); };
  EXPECT_THROW(write({"1", "", nan, 100}), std::invalid_argument);
  EXPECT_THROW(write({"1", "", 1, nan}), std::invalid_argument);
  EXPECT_THROW(write({"1", "", 1, 0}), std::invalid_argument);
  EXPECT_THROW(write({"1", "", 1, 100, nan}), std::invalid_argument);
  EXPECT_THROW(write({"1", "", 1, 100, -1}), std::invalid_argument);
}

} // namespace
} // namespace ggrade::gradebook
