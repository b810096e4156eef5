#include "assignment/usage_error.hpp"
#include "gradebook/lateness.hpp"

#include <gmock/gmock.h>

namespace ggrade::gradebook {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;
using testing::ThrowsMessage;

constexpr std::int64_t kDay = 86400;

std::int64_t seconds(std::string_view text) {
  const auto time = readTime(text);
  EXPECT_TRUE(time) << text;
  return time ? time->seconds : -1;
}

TEST(ReadTime, KnowsTheForms) {
  EXPECT_EQ(seconds("1970-01-01T00:00Z"), 0);
  EXPECT_EQ(seconds("2026-11-20T23:59+09:00"), 1795186740);
  for (const std::string text :
       {"2026-11-20T14:59Z", "2026-11-20 14:59:00z", "2026-11-20T23:59:00.750+0900",
        "2026-11-20T23:59+09", "2026-11-20T11:29-03:30", " 2026-11-20T14:59 ", "2026/11/20 14:59"})
    EXPECT_EQ(seconds(text), 1795186740) << text;
  EXPECT_EQ(seconds("2026/1/5 9:05"), seconds("2026-01-05T09:05"));
  EXPECT_EQ(seconds("2028-02-29T00:00"), seconds("2028-03-01T00:00") - kDay);
}

TEST(ReadTime, RefusesEverythingElse) {
  for (const std::string text : {"",
                                 "2026-11-20",
                                 "2026-11-31T00:00",
                                 "2026-02-29T00:00",
                                 "2026-13-01T00:00",
                                 "2026-11-20T24:00",
                                 "2026-11-20T23:60",
                                 "2026-11-20T23:59:60",
                                 "2026-11-20T23:59+9",
                                 "2026-11-20T23:59+09:",
                                 "2026-11-20T23:59+15:00",
                                 "2026-11-20T23:59 JST",
                                 "26-11-20T23:59",
                                 "1969-12-31T23:59",
                                 "2026-1-5T09:05",
                                 "2026-11/20 23:59",
                                 "2026/11/20T23:59",
                                 "20/11/2026",
                                 "2026-11-20T23:59Zx",
                                 "2026-11-20T23",
                                 "2026-11-20T23:59:5.",
                                 "-2026-11-20T23:59"})
    EXPECT_FALSE(readTime(text)) << text;
}

TEST(SecondsLate, ComparesOnlyWhatCanBeCompared) {
  const Time due = *readTime("2026-11-20T23:59+09:00");
  EXPECT_EQ(secondsLate(*readTime("2026-11-20T15:00Z"), due), 60);
  EXPECT_EQ(secondsLate(*readTime("2026-11-20T23:58+09:00"), due), -60);
  EXPECT_EQ(secondsLate(*readTime("2026-11-20T23:58"), due), std::nullopt);
}

TEST(LateRule, ReadsItsPartsInAnyOrder) {
  const LateRule rule = readLateRule("15 min grace, at most 50%, 10% per day");
  EXPECT_EQ(rule.percentPerDay, 10);
  EXPECT_EQ(rule.atMostPercent, 50);
  EXPECT_EQ(rule.graceSeconds, 900);
  EXPECT_EQ(readLateRule("2.5% per day").percentPerDay, 2.5);
  EXPECT_EQ(readLateRule("2.5% per day").atMostPercent, 100);
  EXPECT_EQ(readLateRule("2.5% per day").graceSeconds, 0);
}

TEST(LateRule, RefusesEverythingElseAndShowsTheForms) {
  for (const std::string text :
       {"", "10%", "10% a day", "10 per day", "10% per day,", "10% per day at most 50%",
        "at most 50%", "10% per day, 20% per day", "0% per day", "-5% per day", "101% per day",
        "10% per day, at most 0%", "10% per day, 1.5 min grace", "10% per day, -1 min grace",
        "nan% per day", "10% per day, 15 minutes grace", "10% per day, 99999999 min grace"})
    EXPECT_THAT([&] { readLateRule(text); },
                ThrowsMessage<UsageError>(testing::AllOf(
                    StartsWith("--late \"" + text + "\": "),
                    HasSubstr("write \"10% per day\", and if need be \"at most 50%\" and \"15 min "
                              "grace\""))))
        << text;
}

TEST(LateRule, TakesOffAShareOfTheMaximumForEveryStartedDay) {
  const LateRule rule = readLateRule("10% per day, at most 50%, 15 min grace");
  EXPECT_EQ(penalty(rule, 80, 200, -kDay), 0);
  EXPECT_EQ(penalty(rule, 80, 200, 0), 0);
  EXPECT_EQ(penalty(rule, 80, 200, 900), 0);
  EXPECT_EQ(penalty(rule, 80, 200, 901), 20);
  EXPECT_EQ(penalty(rule, 80, 200, 900 + kDay), 20);
  EXPECT_EQ(penalty(rule, 80, 200, 901 + kDay), 40);
  EXPECT_EQ(penalty(rule, 180, 200, 1000 * kDay), 100) << "at most half of 200";
  EXPECT_EQ(penalty(rule, 80, 200, 1000 * kDay), 80) << "never below 0";
  EXPECT_EQ(penalty(rule, 0, 200, 1000 * kDay), 0);
}

TEST(LateRule, IsDescribed) {
  EXPECT_EQ(
      describe(readLateRule("10% per day, at most 50%, 15 min grace")),
      "Late work loses 10% of the maximum score for every started day, 50% at most. The first "
      "15 min after the deadline don't count.");
  EXPECT_EQ(describe(readLateRule("2.5% per day")),
            "Late work loses 2.5% of the maximum score for every started day.");
}

TEST(ReadDue, ShowsTheForms) {
  EXPECT_EQ(readDue("2026-11-20T23:59+09:00").seconds, 1795186740);
  EXPECT_THAT([] { readDue("tomorrow"); },
              ThrowsMessage<UsageError>("--due \"tomorrow\": write 2026-11-20T23:59+09:00, "
                                        "2026-11-20T23:59 or 2026/11/20 23:59"));
}

TEST(ReadSubmitted, ReadsHowLateEveryoneIs) {
  const auto all = readSubmitted("name,submitted,student\n学生1,2026-11-21T00:00+09:00,1234\n\n"
                                 "Student Two,2026-11-20T00:00Z,1235\n",
                                 "times.csv", readDue("2026-11-20T23:59+09:00"));
  ASSERT_THAT(all, SizeIs(2));
  EXPECT_EQ(all[0].student, "1234");
  EXPECT_EQ(all[0].submitted, "2026-11-21T00:00+09:00");
  EXPECT_EQ(all[0].secondsLate, 60);
  EXPECT_EQ(all[1].secondsLate, -(14 * 3600 + 59 * 60));
}

TEST(ReadSubmitted, NamesTheLineAndTheRemedy) {
  const auto fault = [](const std::string& lines) {
    return [=] {
      readSubmitted("student,submitted\n" + lines, "t.csv", readDue("2026-11-20T23:59+09:00"));
    };
  };
  EXPECT_THAT(fault("1,2026-11-20T23:59\n"),
              ThrowsMessage<UsageError>(
                  "t.csv:2: submitted is \"2026-11-20T23:59\" and has no time zone, but --due has "
                  "one: write both with a zone such as +09:00, or both without"));
  EXPECT_THAT(fault("1,\n"), ThrowsMessage<UsageError>(
                                 StartsWith("t.csv:2: submitted is \"\": write 2026-11-20T23:59")));
  EXPECT_THAT(fault("\n,2026-11-20T23:59Z\n"),
              ThrowsMessage<UsageError>(StartsWith("t.csv:3: there is no student")));
  EXPECT_THAT(fault("1,2026-11-20T23:59Z\n参加者1,2026-11-21T23:59Z\n"),
              ThrowsMessage<UsageError>("t.csv:3: \"参加者1\" stands in line 2, too: keep the "
                                        "submission that counts"));
  EXPECT_THAT(
      [] { readSubmitted("name,time\n", "t.csv", {}); },
      ThrowsMessage<UsageError>("t.csv:1: there is no column \"student\"; the first line has "
                                "the columns student,submitted"));
}

} // namespace
} // namespace ggrade::gradebook
