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

const std::string kBom = "\xEF\xBB\xBF";

// As Moodle exports it: quotes only where there is a blank or a delimiter, LF.
const std::string kEnglish =
    "Identifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\",\"Grade can be "
    "changed\",\"Last modified (submission)\",\"Last modified (grade)\",\"Feedback comments\"\n"
    "\"Participant 1234\",\"One, Student\",student1@example.com,\"Submitted for grading\",,100.00,"
    "Yes,\"Friday, 20 November 2026, 11:40 PM\",-,\n"
    "\"Participant 1235\",\"Student \"\"Two\"\"\",student2@example.com,\"Submitted for grading - "
    "Graded\",55.00,100.00,Yes,-,-,\"old\ncomment\"\n"
    "\"Participant 1236\",\"Student Three\",student3@example.com,\"No "
    "submission\",,100.00,No,-,-,\n";

// As a Japanese site exports it, after Excel: byte-order mark, everything quoted, CRLF.
const std::string kJapanese =
    kBom +
    "\"ID\",\"フルネーム\",\"ステータス\",\"評定\",\"最大評点\",\"評点変更可\","
    "\"最終更新日時 (提出)\",\"最終更新日時 (評定)\",\"フィードバックコメント\"\r\n"
    "\"参加者1234\",\"学生　１\",\"評定のために提出済み\",\"\",\"50\",\"Yes\",\"-\",\"-\","
    "\"\"\r\n"
    "\"参加者 １２３５\",\"学生,2\",\"提出なし\",\"-\",\"50\",\"いいえ\",\"-\",\"-\",\"\"\r\n"
    "\"参加者1236\",\"学生\r\n3\",\"提出なし\",\"\",\"50\",\"はい\",\"-\",\"-\",\"\"";

// All bytes are those of the worksheet but for the cells of `columns` in `row`.
void expectOnlyChanged(const std::string& filled, const std::string& worksheet, std::size_t row,
                       const std::map<std::size_t, std::string>& cells) {
  Csv expected(worksheet, "sheet.csv");
  for (const auto& [column, text] : cells) expected.set(row, column, text);
  EXPECT_EQ(filled, expected.bytes());
}

TEST(Moodle, FillsInAnEnglishWorksheetAndNoOtherByte) {
  const Filled filled = fillMoodle(kEnglish, "grades.csv",
                                   {entry("1234", 87.456, "Shading: 31% < 90%\nRead step 2.")});
  std::string expected = replaced(kEnglish, "for grading\",,100.00", "for grading\",87.46,100.00");
  expected =
      replaced(expected, "11:40 PM\",-,\n", "11:40 PM\",-,Shading: 31% &lt; 90%<br>Read step 2.\n");
  EXPECT_EQ(filled.bytes, expected);
  EXPECT_THAT(filled.remarks, ElementsAre("line 3, Participant 1235: no upload",
                                          "line 5, Participant 1236: no upload"));
}

TEST(Moodle, FillsInAJapaneseWorksheetAndNoOtherByte) {
  const Filled filled =
      fillMoodle(kJapanese, "grades.csv",
                 {entry("1234", 75, "影を確認"), entry("1236", 0), entry("1235", 10)});
  std::string expected =
      replaced(kJapanese, "提出済み\",\"\",\"50\"", "提出済み\",\"37.5\",\"50\"");
  expected = replaced(expected, "\"-\",\"-\",\"\"\r\n", "\"-\",\"-\",\"影を確認\"\r\n");
  expected = replaced(expected, "提出なし\",\"\",", "提出なし\",\"0\",");
  EXPECT_EQ(filled.bytes, expected);
  EXPECT_THAT(filled.remarks,
              ElementsAre("line 3, 参加者 １２３５: the grade can't be changed, left as it is"));
}

TEST(Moodle, KnowsTheWordsOfOtherVersions) {
  const std::string sheet = "識別子,氏名,評点,最大評定,評定変更可,フィードバックコメント\n"
                            "参加者1,,,10,不可,\n参加者2,,,10,はい,\n";
  const Filled filled = fillMoodle(sheet, "grades.csv", {entry("1", 50), entry("2", 50, "x")});
  EXPECT_EQ(filled.bytes, replaced(sheet, "2,,,10,はい,", "2,,5,10,はい,x"));
  EXPECT_THAT(filled.remarks, ElementsAre(HasSubstr("can't be changed")));
}

TEST(Moodle, TakesOffThePenalty) {
  const Filled filled = fillMoodle(kEnglish, "grades.csv", {{"1234", "", 80, 100, 12.25}});
  EXPECT_EQ(Csv(filled.bytes, "").cell(1, 4), "67.75");
}

TEST(Moodle, NeverWritesFeedbackWithoutAGrade) {
  const Filled filled = fillMoodle(kEnglish, "grades.csv", {entry("1234", {}, "try again")});
  EXPECT_EQ(filled.bytes, kEnglish);
  EXPECT_THAT(filled.remarks,
              testing::Contains("line 2, Participant 1234: not gradable, left as it is"));
}

TEST(Moodle, NamesWhatItReplaces) {
  const Filled filled = fillMoodle(kEnglish, "grades.csv", {entry("1235", 60, "new")});
  expectOnlyChanged(filled.bytes, kEnglish, 2, {{4, "60"}, {9, "new"}});
  EXPECT_THAT(filled.remarks,
              testing::IsSupersetOf({"line 3, Participant 1235: 60 replaces the grade 55.00",
                                     "line 3, Participant 1235: the feedback that was there is "
                                     "replaced"}));
  EXPECT_EQ(fillMoodle(kEnglish, "grades.csv", {entry("1235", 55)}).bytes, kEnglish)
      << "the same grade stays as it was written, and no feedback wipes none";
}

TEST(Moodle, FillingInTwiceChangesNothingMore) {
  const std::vector<Entry> entries = {entry("1234", 33.333, "a\nb"), entry("1235", 60, "c")};
  const std::string once = fillMoodle(kEnglish, "grades.csv", entries).bytes;
  const Filled twice = fillMoodle(once, "grades.csv", entries);
  EXPECT_EQ(twice.bytes, once);
  EXPECT_THAT(twice.remarks, ElementsAre("line 4, Participant 1236: no upload"));
}

TEST(Moodle, TakesTheDecimalMarkOfTheSite) {
  const std::string header = "Identifier;Grade;Maximum grade;Feedback comments\n";
  const auto grade = [](const std::string& sheet) {
    return Csv(fillMoodle(sheet, "grades.csv", {entry("1", 87.5)}).bytes, "").cell(1, 1);
  };
  EXPECT_EQ(grade(header + "1;;100,00;\n"), "87,5");
  EXPECT_EQ(grade(header + "1;;100;\n"), "87,5");
  EXPECT_EQ(grade(header + "1;;100.00;\n"), "87.5") << "the site itself has written a point";
  EXPECT_EQ(grade("Identifier,Grade,Maximum grade\n1,,\"100,00\"\n"), "87,5");
  EXPECT_EQ(grade("Identifier,Grade,Maximum grade\n1,,100\n"), "87.5");
}

TEST(Moodle, WritesTheMaximumForMoreThanThat) {
  const Filled filled = fillMoodle(kEnglish, "grades.csv", {entry("1234", 104)});
  EXPECT_EQ(Csv(filled.bytes, "").cell(1, 4), "100");
  EXPECT_THAT(filled.remarks,
              testing::Contains("line 2, Participant 1234: 104 of 100 points are written as the "
                                "maximum"));
}

TEST(Moodle, LeavesRowsThatAreNotCertain) {
  const std::string sheet = "Identifier,Grade,Maximum grade,Feedback comments\n"
                            "1,,100,\n\n2,,,\n3,,0,\n,,100,\n4,\n";
  const Filled filled = fillMoodle(sheet, "grades.csv",
                                   {{"1", "Student One", 1, 100},
                                    {"Participant 1", "", 2, 100},
                                    entry("2", 1),
                                    entry("3", 1),
                                    entry("4", 1),
                                    {"9", "Student Nine", 1, 100}});
  EXPECT_EQ(filled.bytes, sheet);
  EXPECT_THAT(
      filled.remarks,
      ElementsAre("line 6: no identifier, left as it is",
                  "line 7: only 2 of 4 cells, left as it is",
                  "line 2, 1: 2 uploads claim this row, no grade is written: 1 (Student "
                  "One), Participant 1",
                  "4: the upload has no row in the worksheet",
                  "9 (Student Nine): the upload has no row in the worksheet",
                  "line 4, 2: the maximum grade is \"\", no number above 0, left as it is",
                  "line 5, 3: the maximum grade is \"0\", no number above 0, left as it is"));
}

TEST(Moodle, RefusesTwoRowsOfOneStudent) {
  EXPECT_THAT(
      [] {
        fillMoodle("Identifier,Grade,Maximum grade\nParticipant 7,,9\n8,,9\n７,,9\n", "g.csv", {});
      },
      ThrowsMessage<UsageError>(
          "g.csv: line 2, Participant 7 and line 4, ７ have the same identifier "
          "\"7\": export the worksheet again, or take one of the rows out"));
}

TEST(Moodle, TakesColumnsByName) {
  const std::string sheet = "Nr;Note;Bestnote;Kommentar;Grade\n1;;10;;x\n";
  const Filled filled =
      fillMoodle(sheet, "g.csv", {entry("1", 55, "gut")},
                 readColumns("identifier=Nr, grade=Note,feedback=kommentar,max=Bestnote"));
  EXPECT_EQ(filled.bytes, "Nr;Note;Bestnote;Kommentar;Grade\n1;5,5;10;gut;x\n");
  EXPECT_THAT(filled.remarks, IsEmpty());
}

TEST(Moodle, SaysWhichColumnIsMissing) {
  const auto fault = [](const std::string& sheet, const std::string& columns) {
    return [=] { fillMoodle(sheet, "g.csv", {}, readColumns(columns)); };
  };
  EXPECT_THAT(
      fault("Nr,Grade\n", ""),
      ThrowsMessage<UsageError>("g.csv: no column is called identifier, 識別子, id: name it "
                                "with --columns identifier=HEADER; there are \"Nr\", "
                                "\"Grade\""));
  EXPECT_THAT(fault("ID,Grade\n", ""),
              ThrowsMessage<UsageError>(HasSubstr("no column is called maximum grade")));
  EXPECT_THAT(fault("ID,Grade\n", "max=Top"),
              ThrowsMessage<UsageError>(HasSubstr("--columns max=Top: there is no such column")));
  EXPECT_THAT(fault("ID,Identifier,Grade,Maximum grade\n", ""),
              ThrowsMessage<UsageError>(HasSubstr("both \"ID\" and \"Identifier\" could be")));
  EXPECT_THAT(fault("ID,Grade,Scale\n", ""), ThrowsMessage<UsageError>(HasSubstr("on a scale")));
  EXPECT_THAT(fault("", ""), ThrowsMessage<UsageError>(HasSubstr("is empty")));
  for (const std::string columns : {"grad=x", "grade", "grade=", "grade=a,grade=b", ","})
    EXPECT_THAT(fault("", columns), ThrowsMessage<UsageError>(HasSubstr("is none of identifier=")))
        << columns;
}

TEST(Moodle, SaysWhenThereIsNoPlaceForFeedback) {
  const Filled filled =
      fillMoodle("ID,Grade,Maximum grade\n1,,10\n", "g.csv", {entry("1", 100, "x")});
  EXPECT_EQ(filled.bytes, "ID,Grade,Maximum grade\n1,10,10\n");
  EXPECT_THAT(filled.remarks, ElementsAre(HasSubstr("no column for feedback")));
}

TEST(Moodle, NeutralizesFeedback) {
  const Filled filled = fillMoodle(kEnglish, "grades.csv", {entry("1234", 1, "=1+1")});
  EXPECT_EQ(Csv(filled.bytes, "").cell(1, 9), "'=1+1");
}

} // namespace
} // namespace ggrade::gradebook
