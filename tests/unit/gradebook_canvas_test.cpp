#include "gradebook_samples.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/csv.hpp"

#include <gmock/gmock.h>

namespace ggrade::gradebook {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

const std::string kCanvasHeader =
    "Student,ID,SIS User ID,SIS Login ID,Section,Floor (12345),\"Floor, "
    "again (12346)\",Current Score,Final Score\r\n";
const std::string kPoints = "    Points Possible,,,,,20.0,10,(read only),(read only)\r\n";
const std::string kGradebook = kCanvasHeader + ",,,,,Manual Posting,,,\r\n" + kPoints +
                               "\"One, Student\",101,s-1,student1,CG,,5.0,50,50\r\n"
                               "\"Two, Student\",102,s-2,student2,CG,7.0,,,\r\n"
                               "\"Three, Student\",103,s-3,student3,CG,EX,,,\r\n"
                               "\"Four, Student\",104,s-4,student4,CG,N/A,,,\r\n"
                               "\"Student, Test\",199,,0a1b2c,CG,,,,\r\n";

TEST(Canvas, FillsInOneAssignmentAndNoOtherByte) {
  const Filled filled =
      fillCanvas(kGradebook, "canvas.csv", {entry("101", 87.5), entry("student2", 110)}, "Floor");
  std::string expected = replaced(kGradebook, "student1,CG,,", "student1,CG,17.5,");
  expected = replaced(expected, "student2,CG,7.0,", "student2,CG,22,");
  EXPECT_EQ(filled.bytes, expected);
  EXPECT_THAT(filled.remarks,
              ElementsAre("line 6, Three, Student (ID 103): no upload",
                          "line 7, Four, Student (ID 104): no upload",
                          "line 5, Two, Student (ID 102): 22 replaces the grade 7.0"));
}

TEST(Canvas, LeavesWhoIsExcusedNotAssignedOrNotGradable) {
  const Filled filled = fillCanvas(
      kGradebook, "canvas.csv",
      {entry("101", {}), entry("102", 35), entry("103", 50), entry("104", 50), entry("199", 50)},
      "Floor (12345)");
  EXPECT_EQ(filled.bytes, kGradebook);
  EXPECT_THAT(filled.remarks,
              ElementsAre("199: the upload has no row in the worksheet",
                          "line 4, One, Student (ID 101): not gradable, left as it is",
                          "line 6, Three, Student (ID 103): excused, left as it is",
                          "line 7, Four, Student (ID 104): the student doesn't have the "
                          "assignment, left as it is"));
}

TEST(Canvas, NeverGuessesWhoseUploadItIs) {
  const std::string sheet = "Student,ID,SIS Login ID,Section,Floor (1)\n    Points Possible,,,,10\n"
                            "A,101,102,CG,\nB,102,103,CG,\n";
  const Filled filled = fillCanvas(sheet, "canvas.csv", {entry("102", 50)}, "Floor");
  EXPECT_EQ(filled.bytes, sheet);
  EXPECT_THAT(filled.remarks,
              ElementsAre("line 3, A (ID 101): no upload", "line 4, B (ID 102): no upload",
                          "102: the upload could belong to line 3, A (ID 101) or to line 4, B (ID "
                          "102); no grade is written"));
}

TEST(Canvas, ReadsLastAndFirstNames) {
  const std::string sheet = "LastName,FirstName,ID,SIS Login ID,Section,Floor (1)\n"
                            "    Points Possible,,,,,10\nOne,Student,101,a,CG,\n"
                            "Student,Test,102,b,CG,\n";
  const Filled filled = fillCanvas(sheet, "c.csv", {entry("101", 50), entry("102", 50)}, "Floor");
  EXPECT_EQ(filled.bytes, replaced(sheet, "a,CG,", "a,CG,5"));
  EXPECT_THAT(filled.remarks, ElementsAre("102: the upload has no row in the worksheet"));
}

TEST(Canvas, TakesACommaWhereTheGradebookHasOne) {
  const std::string sheet =
      "Student;ID;SIS Login ID;Section;Floor (1)\n    Points Possible;;;;10,0\n"
      "A;101;a;CG;\n";
  EXPECT_EQ(fillCanvas(sheet, "c.csv", {entry("101", 55)}, "Floor").bytes,
            replaced(sheet, "a;CG;", "a;CG;5,5"));
}

TEST(Canvas, FindsTheAssignmentOrSaysWhatThereIs) {
  const auto fault = [](const std::string& sheet, const std::string& assignment) {
    return [=] { fillCanvas(sheet, "c.csv", {}, assignment); };
  };
  EXPECT_THAT([] { return fillCanvas(kGradebook, "c.csv", {}, "Floor, again").remarks.size(); }(),
              4u);
  EXPECT_THAT(fault(kGradebook, "Wall"),
              ThrowsMessage<UsageError>(testing::AllOf(
                  HasSubstr("c.csv: no columns are called \"Wall\" or \"Wall (NUMBER)\""),
                  HasSubstr("\"Floor (12345)\", \"Floor, again (12346)\""))));
  EXPECT_THAT(fault("Student,ID,Floor (1),Floor (2)\nPoints Possible,,1,1\n", "Floor"),
              ThrowsMessage<UsageError>(HasSubstr("2 columns are called \"Floor\"")));
  EXPECT_THAT(fault(kGradebook, "Final Score"),
              ThrowsMessage<UsageError>(HasSubstr("(read only): name an assignment")));
  EXPECT_THAT(fault("Student,ID,Floor (1)\nPoints Possible,,0\n", "Floor"),
              ThrowsMessage<UsageError>(HasSubstr("c.csv:2: the points possible of \"Floor (1)\" "
                                                  "are \"0\"")));
}

TEST(Canvas, RefusesWhatIsNoGradebook) {
  const auto fault = [](const std::string& sheet) {
    return [=] { fillCanvas(sheet, "c.csv", {}, "Floor"); };
  };
  for (const std::string sheet :
       {"", "Identifier,Grade\n", "Student,Floor\n", "Student,ID,Floor\n"})
    EXPECT_THAT(fault(sheet),
                ThrowsMessage<UsageError>(HasSubstr("c.csv: this is no gradebook of Canvas: ")))
        << sheet;
  EXPECT_THAT(fault("Student,ID,Floor\nPoints Possible,,1\nA,7,\nB,8,\nC,7,\n"),
              ThrowsMessage<UsageError>(HasSubstr("line 3, A (ID 7) and line 5, C (ID 7) have the "
                                                  "same identifier \"7\"")));
}

} // namespace
} // namespace ggrade::gradebook
