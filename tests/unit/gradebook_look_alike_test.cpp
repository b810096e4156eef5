// Who could be taken for whom, and that nobody gets a grade who could.

#include "gradebook_samples.hpp"

#include "gradebook/look_alike.hpp"

#include <gmock/gmock.h>

namespace ggrade::gradebook {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(LookAlike, EverythingThatReadsAsAdaIsAda) {
  for (const char* same : {"ada",
                           "Ada",
                           " ada",
                           "ada ",
                           "\tada\n",
                           "ada\u200B",
                           "\u202Ead\u2060a",
                           "\uFEFFada",
                           "ａｄａ",
                           "\u3000ada",
                           "\u00A0ada",
                           "a\u00ADda",
                           "\u0430da",
                           "\u0410d\u0430",
                           "\u03B1d\u03B1",
                           "ad\u0251",
                           "\u3164ada",
                           "\u2800ada",
                           "ada\U000E0061",
                           "ADA\uFE0F"})
    EXPECT_EQ(skeleton(same), "ada") << visible(same);
  EXPECT_EQ(skeleton("ada  \u2003 lovelace"), "ada lovelace");
  EXPECT_EQ(skeleton("Participant\u200B 12"), "12");
  EXPECT_EQ(skeleton("参加者１２"), skeleton("12"));
  EXPECT_EQ(skeleton("学生か\u3099"), skeleton("学生が"));
  EXPECT_EQ(skeleton("ﬁne"), "fine");
}

TEST(LookAlike, WhoReadsDifferentlyIsAnother) {
  for (const char* other : {"ada1", "a da", "adá", "аdа2", "bda", "aad", ""})
    EXPECT_NE(skeleton(other), "ada") << visible(other);
  EXPECT_NE(skeleton("s10"), skeleton("slo")) << "digits are digits";
  EXPECT_NE(skeleton("学生1"), skeleton("学生2"));
  EXPECT_EQ(skeleton("a\xFF"), "a\uFFFD");
}

TEST(LookAlike, NamesTheOthersOfEach) {
  EXPECT_THAT(lookAlikes({"ada", "ben", "ADA", "\u0430da", "cem", "Ben "}),
              ElementsAre(ElementsAre(2, 3), ElementsAre(5), ElementsAre(0, 3), ElementsAre(0, 2),
                          IsEmpty(), ElementsAre(1)));
  EXPECT_THAT(lookAlikes({}), IsEmpty());
}

TEST(LookAlike, ShowsWhatCannotBeSeen) {
  EXPECT_EQ(visible("ada"), "\"ada\"");
  EXPECT_EQ(visible(" ada "), "\"␣ada␣\"");
  EXPECT_EQ(visible("a  b c"), "\"a␣␣b c\"");
  EXPECT_EQ(visible("ada\u200B"), "\"ada\\u{200B}\"");
  EXPECT_EQ(visible("\u202Eada\u3000"), "\"\\u{202E}ada\\u{3000}\"");
  EXPECT_EQ(visible("\u0430d\u0410"), "\"\\u{430}d\\u{410}\"");
  EXPECT_EQ(visible("a\"\\\n"), "\"a\\\"\\\\\\u{A}\"");
  EXPECT_EQ(visible("学生１"), "\"学生１\"");
}

/// Of one student, as three folders: found as `given`.
std::vector<Entry> threeAdas() {
  std::vector<Entry> all = {entry("ada", 10), entry("ada", 20), entry("\u0430da", 30),
                            entry("ben", 40)};
  all[0].given = "ada";
  all[1].given = " ada";
  all[2].given = "\u0430da";
  return all;
}

TEST(LookAlike, NoWorksheetGetsAGradeOfThem) {
  const std::string sheet = "Identifier,Grade,Maximum grade,Feedback comments\nada,7,100,\n"
                            "ben,,100,\n";
  const Filled moodle = fillMoodle(sheet, "m.csv", threeAdas());
  EXPECT_EQ(moodle.bytes, replaced(sheet, "ben,", "ben,40"));
  EXPECT_THAT(moodle.remarks,
              ElementsAre("line 2, ada: 3 uploads claim this row, no grade is written: \"ada\", "
                          "\"␣ada\", \"\\u{430}da\""));
  const std::string export_ = "Student,ID,SIS Login ID,Floor\n    Points Possible,,,100\n"
                              "\"A, Ada\",1,ada,7\n\"B, Ben\",2,ben,\n";
  const Filled canvas = fillCanvas(export_, "c.csv", threeAdas(), "Floor");
  EXPECT_EQ(canvas.bytes, replaced(export_, "2,ben,", "2,ben,40"));
}

TEST(LookAlike, TheOnlyOneThatFitsIsNotChosen) {
  const std::string sheet = "Identifier,Grade,Maximum grade\nAda,7,100\n";
  for (const std::string student : {"Ada", "ADA"}) { // as the worksheet has it; as nobody has it
    const Filled filled = fillMoodle(sheet, "m.csv", {entry(student, 10), entry("ada", 20)});
    EXPECT_EQ(filled.bytes, sheet);
    EXPECT_THAT(filled.remarks, testing::Contains(HasSubstr("2 uploads claim this row")));
  }
  // One upload alone is no reason for a guess, either.
  const Filled alone = fillMoodle(sheet, "m.csv", {entry("ada", 20)});
  EXPECT_EQ(alone.bytes, sheet);
  EXPECT_THAT(alone.remarks,
              ElementsAre("line 2, Ada: no upload", "ada: the upload has no row in the worksheet"));
}

TEST(LookAlike, TwoRowsThatLookAlikeAreBothLeft) {
  const std::string sheet = "Identifier,Grade,Maximum grade\nAda,7,100\nada,8,100\n";
  const Filled filled = fillMoodle(sheet, "m.csv", {entry("Ada", 10), entry("ada", 20)});
  EXPECT_EQ(filled.bytes, sheet);
  EXPECT_THAT(filled.remarks, ElementsAre(HasSubstr("line 2, Ada: 2 uploads claim this row"),
                                          HasSubstr("line 3, ada: 2 uploads claim this row")));
}

TEST(LookAlike, TheNeutralGradebookHasNoRowOfThem) {
  const std::string csv = neutralCsv("floor", "", threeAdas());
  EXPECT_THAT(csv, HasSubstr("floor,,,ben,"));
  EXPECT_THAT(csv, Not(HasSubstr("da,")));
}

} // namespace
} // namespace ggrade::gradebook
