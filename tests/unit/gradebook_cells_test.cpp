#include "gradebook/cells.hpp"
#include "report/text.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace ggrade::gradebook {
namespace {

TEST(PlainIdentifier, IsTheNumberBehindMoodlesWord) {
  for (const std::string text : {"1234", "Participant 1234", "participant1234", "参加者1234",
                                 "参加者 1234", "参加者　１２３４", " １２３４ "})
    EXPECT_EQ(plainIdentifier(text), "1234") << text;
}

TEST(PlainIdentifier, LeavesOtherTextAlone) {
  EXPECT_EQ(plainIdentifier("student1"), "student1");
  EXPECT_EQ(plainIdentifier("B0123"), "B0123");
  EXPECT_EQ(plainIdentifier("0123"), "0123");
  EXPECT_EQ(plainIdentifier("Participant"), "Participant");
  EXPECT_EQ(plainIdentifier("Participants 12"), "Participants 12");
  EXPECT_EQ(plainIdentifier("学生１"), "学生1");
  EXPECT_EQ(plainIdentifier(" \t"), "");
}

TEST(FoldedHeader, ForgetsCaseWidthAndBlanks) {
  EXPECT_EQ(foldedHeader("  Maximum   Grade\n"), "maximum grade");
  EXPECT_EQ(foldedHeader("ＩＤ"), "id");
  EXPECT_EQ(foldedHeader(""), "");
}

TEST(Neutralized, DefusesWhatASpreadsheetCouldRun) {
  for (const std::string text : {"=1+1",
                                 "+1",
                                 "-1",
                                 "@SUM(A1)",
                                 "\t=1",
                                 "\r=1",
                                 "\n=1",
                                 " =1",
                                 "\"=1",
                                 "'=1",
                                 " \" ' =1",
                                 "＝1",
                                 "＋1",
                                 "－1",
                                 "＠1",
                                 "\u2212"
                                 "1",
                                 "\u3000=1",
                                 "\u200B=1",
                                 "\uFEFF＝1",
                                 "\u00A0@x",
                                 "“=1",
                                 "-2+3+cmd|' /C calc'!A0"})
    EXPECT_EQ(neutralized(text), "'" + text);
}

TEST(Neutralized, LeavesOtherTextAlone) {
  for (const std::string text : {"", "student1", "学生1", "a=b", "3 - 2", "\"quoted\"", "'", " "})
    EXPECT_EQ(neutralized(text), text);
}

TEST(FeedbackCell, IsHtmlWithLineBreaks) {
  EXPECT_EQ(feedbackCell("31% differ & more:\r\nvec<float> \"影\"\n"),
            "31% differ &amp; more:<br>vec&lt;float&gt; \"影\"<br>");
  EXPECT_EQ(feedbackCell("-4 points"), "'-4 points");
  EXPECT_EQ(feedbackCell(std::string("a\0\xFF", 3)), "a\uFFFD\uFFFD");
}

TEST(ReadNumber, TakesPlainDecimalsOnly) {
  EXPECT_EQ(readNumber("12"), 12);
  EXPECT_EQ(readNumber("-0.5"), -0.5);
  for (const std::string& text :
       std::vector<std::string>{"", "12 ", " 12", "+1", "1e3", "inf", "nan", "NaN", "0x10", "1,5",
                                "ten", std::string(400, '9')})
    EXPECT_EQ(readNumber(text), std::nullopt) << text;
}

TEST(ReadMarkedNumber, KeepsTheMarkOfTheNumber) {
  const auto read = [](std::string_view text, char mark) {
    const auto number = readMarkedNumber(text, mark);
    return number ? writeNumber(number->value, number->mark) + number->mark : "none";
  };
  EXPECT_EQ(read("100.50", ','), "100.5.");
  EXPECT_EQ(read(" 100,50 ", '.'), "100,5,");
  EXPECT_EQ(read("100", ','), "100,");
  EXPECT_EQ(read("１００", '.'), "100.");
  EXPECT_EQ(read("1,000.00", '.'), "none");
  EXPECT_EQ(read("", '.'), "none");
}

TEST(WriteNumber, HasTwoDecimalsAtMost) {
  EXPECT_EQ(writeNumber(2.0 / 3), "0.67");
  EXPECT_EQ(writeNumber(87.5, ','), "87,5");
  EXPECT_EQ(writeNumber(1e7), "10000000");
  EXPECT_EQ(writeNumber(-0.001), "0");
}

TEST(ValidUtf8, CountsTheBytesBeforeTheFirstThatIsNone) {
  EXPECT_EQ(report::validUtf8("a影\x01"), 5u);
  EXPECT_EQ(report::validUtf8("a影\x8E\x9F"), 4u);
  EXPECT_EQ(report::validUtf8("\xE5\xBD"), 0u);
}

} // namespace
} // namespace ggrade::gradebook
