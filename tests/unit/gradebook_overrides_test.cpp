#include "assignment/usage_error.hpp"
#include "gradebook/overrides.hpp"

#include <gmock/gmock.h>

namespace ggrade::gradebook {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

const std::string kOverridesHeader = "student,item,points,reason,who\n";

std::vector<Override> read(const std::string& lines) {
  return readOverrides(kOverridesHeader + lines, "overrides.csv");
}

Overrides apply(const std::vector<MachineScore>& scores, const std::string& lines) {
  return applyOverrides(scores, read(lines), "overrides.csv");
}

MachineScore machine() {
  return {"1234",
          14.4,
          {{"mirror.shading", 4.44, 0, 10}, {"mirror.clip", 10, 0, 10}, {"keep", 0, -5, 0}},
          25};
}

TEST(ReadOverrides, ReadsEveryLine) {
  const auto all = read("1234,mirror.shading,7.5,\"seen on paper, fine\",assistant1\r\n\n"
                        "参加者1235,,１２,口頭で説明：できた,助手1\n");
  ASSERT_THAT(all, SizeIs(2));
  EXPECT_EQ(all[0].student, "1234");
  EXPECT_EQ(all[0].item, "mirror.shading");
  EXPECT_EQ(all[0].points, 7.5);
  EXPECT_EQ(all[0].reason, "seen on paper, fine");
  EXPECT_EQ(all[0].who, "assistant1");
  EXPECT_EQ(all[0].line, 2u);
  EXPECT_EQ(all[1].item, "");
  EXPECT_EQ(all[1].points, 12);
  EXPECT_EQ(all[1].reason, "口頭で説明：できた");
  EXPECT_EQ(all[1].line, 4u);
}

TEST(ReadOverrides, TakesColumnsInAnyOrder) {
  const auto all = readOverrides("Who;Points;Item;Student;Reason\na;3;x;1;why\n", "o.csv");
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_EQ(all[0].who + all[0].item + all[0].student + all[0].reason, "ax1why");
}

TEST(ReadOverrides, NamesTheLineAndTheRemedy) {
  const auto fault = [](const std::string& line) { return [=] { read(line); }; };
  const auto says = [](const std::string& start) {
    return ThrowsMessage<UsageError>(testing::StartsWith("overrides.csv:" + start));
  };
  EXPECT_THAT(fault("1,i,x,r,w"), says("2: points is \"x\": write a number such as 7.5"));
  EXPECT_THAT(fault("1,i,nan,r,w"), says("2: points is \"nan\""));
  EXPECT_THAT(fault("1,i,inf,r,w"), says("2: points is \"inf\""));
  EXPECT_THAT(fault("1,i,,r,w"), says("2: points is \"\""));
  EXPECT_THAT(fault("1,i,-1000001,r,w"),
              says("2: points is \"-1000001\": no item and no total has so many"));
  EXPECT_THAT(fault("\"1\",i,\"7,5\",r,w"), says("2: points is \"7,5\""));
  EXPECT_THAT(fault("1,i,7,5,r,w"),
              says("2: 6 cells, but the header has 5: put cells with a \",\""));
  EXPECT_THAT(fault("1,,-1,r,w"), says("2: points is \"-1\": a total is never below 0"));
  EXPECT_THAT(fault("1,i,1, ,w"), says("2: there is no reason: say why"));
  EXPECT_THAT(fault("1,i,1,r"), says("2: there is no who: say who"));
  EXPECT_THAT(fault(",i,1,r,w"), says("2: there is no student"));
  EXPECT_THAT(fault("1,i,1,r,w\n2,i,1,r,w\nParticipant 1,i,2,r,w"),
              says("4: i of \"Participant 1\" is given in line 2, too: keep one of the two lines"));
  EXPECT_THAT(
      [] { readOverrides("student,item,points,reason\n", "o.csv"); },
      ThrowsMessage<UsageError>("o.csv:1: there is no column \"who\"; the first line has the "
                                "columns student,item,points,reason,who"));
  EXPECT_THAT([] { readOverrides("student,item,points,reason,who,note\n", "o.csv"); },
              ThrowsMessage<UsageError>(HasSubstr("o.csv:1: unknown column \"note\"")));
  EXPECT_THAT([] { readOverrides("who,who\n", "o.csv"); },
              ThrowsMessage<UsageError>(HasSubstr("two columns are called \"who\"")));
  EXPECT_THAT([] { readOverrides("", "o.csv"); },
              ThrowsMessage<UsageError>(HasSubstr("there is no column \"student\"")));
}

TEST(ApplyOverrides, ShowsTheMachinesPointsBesideThoseGiven) {
  const Overrides applied = apply({machine(), {"1235", 3.0}}, "1234,mirror.shading,9,r,w\n");
  ASSERT_THAT(applied.scores, SizeIs(2));
  EXPECT_EQ(applied.scores[0].machine, 14.4);
  EXPECT_EQ(applied.scores[0].score, 19);
  ASSERT_THAT(applied.scores[0].changes, SizeIs(1));
  EXPECT_EQ(applied.scores[0].changes[0].item, "mirror.shading");
  EXPECT_EQ(applied.scores[0].changes[0].machine, 4.44);
  EXPECT_EQ(applied.scores[0].changes[0].points, 9);
  EXPECT_EQ(applied.scores[0].changes[0].reason, "r");
  EXPECT_EQ(applied.scores[0].changes[0].who, "w");
  EXPECT_EQ(applied.scores[1].score, 3);
  EXPECT_THAT(applied.scores[1].changes, IsEmpty());
  EXPECT_THAT(applied.remarks, IsEmpty());
}

TEST(ApplyOverrides, RoundsTheSumToOneDecimalAndNeverBelowZero) {
  EXPECT_EQ(apply({machine()}, "1234,mirror.clip,0,r,w\n").scores[0].score, 4.4);
  EXPECT_EQ(apply({machine()}, "1234,mirror.clip,0,r,w\n1234,keep,-5,r,w\n").scores[0].score, 0);
}

TEST(ApplyOverrides, ATotalStandsWhateverTheItems) {
  const Overrides applied = apply({machine()}, "1234,,20,r,w\n1234,mirror.clip,0,r,w\n");
  EXPECT_EQ(applied.scores[0].score, 20);
  EXPECT_EQ(applied.scores[0].changes[0].machine, 14.4);
  EXPECT_THAT(applied.scores[0].changes, SizeIs(2));
  EXPECT_THAT(applied.remarks, ElementsAre(HasSubstr("1234: the total is given, whatever")));
}

TEST(ApplyOverrides, GivesATotalToWhatWasNotGradable) {
  const Overrides applied = apply({{"1234"}}, "1234,,20,r,w\n1234,x,1,r,w\n");
  EXPECT_EQ(applied.scores[0].machine, std::nullopt);
  EXPECT_EQ(applied.scores[0].score, 20);
  EXPECT_THAT(applied.remarks,
              ElementsAre("overrides.csv:3: the submission was not gradable, only its total can be "
                          "given"));
  EXPECT_EQ(apply({{"1234"}}, "").scores[0].score, std::nullopt);
}

TEST(ApplyOverrides, PointsBeyondWhatAnItemCanGiveCountAndAreMarked) {
  const auto only = [](const std::string& line) {
    const Overrides applied = apply({machine()}, "1234," + line + ",r,w\n");
    EXPECT_THAT(applied.scores[0].changes, SizeIs(1));
    return std::pair(*applied.scores[0].score, applied.scores[0].changes[0].beyond);
  };
  EXPECT_EQ(only("keep,5"),
            std::pair(19.4, std::string("5 points are more than the 0 that keep can give")))
      << "a sign that was forgotten";
  EXPECT_EQ(only("keep,-5"), std::pair(9.4, std::string()));
  EXPECT_EQ(only("keep,-5.5"),
            std::pair(8.9, std::string("-5.5 points are less than the -5 that keep can come to")));
  EXPECT_EQ(only("mirror.clip,-1").second,
            "-1 points are less than the 0 that mirror.clip can come to");
  EXPECT_EQ(only("mirror.clip,10").second, "");
  EXPECT_EQ(only(",25"), std::pair(25.0, std::string()));
  EXPECT_EQ(
      only(",160"),
      std::pair(160.0, std::string("160 points are more than the 25 that all items can give")));
  EXPECT_THAT(apply({machine()}, "1234,,160,r,w\n").remarks,
              ElementsAre("overrides.csv:2: 1234: 160 points are more than the 25 that all items "
                          "can give; they count, as they were given"));
}

TEST(ApplyOverrides, SaysInWordsWhatItCannotApply) {
  const Overrides applied = apply({machine(), {"7", 1.0}, {"Participant 7", 1.0}},
                                  "99,,1,r,w\n1234,mirror.shadow,1,r,w\n1234,mirror.clip,11,r,w\n"
                                  "7,,5,r,w\n");
  EXPECT_EQ(applied.scores[0].score, 15.4);
  EXPECT_EQ(applied.scores[1].score, 1);
  EXPECT_THAT(
      applied.remarks,
      ElementsAre("overrides.csv:2: no submission has \"99\" as student",
                  "overrides.csv:3: there is no item \"mirror.shadow\"; there are "
                  "mirror.shading, mirror.clip, keep",
                  "overrides.csv:4: 1234: 11 points are more than the 10 that mirror.clip can "
                  "give; they count, as they were given",
                  "overrides.csv:5: more than one submission has \"7\" as student"));
}

} // namespace
} // namespace ggrade::gradebook
