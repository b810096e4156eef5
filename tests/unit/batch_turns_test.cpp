// Whose runs may go beside whose: never one of which a student is told beside a hidden one.

#include "batch/turns.hpp"

#include <gmock/gmock.h>

#include <map>
#include <random>
#include <set>

namespace {

using namespace std::chrono_literals;
using ggrade::batch::Turns;
using ggrade::grading::Runs;
using testing::ElementsAre;
using testing::IsEmpty;

const Turns::Clock::time_point kStart{};

TEST(BatchTurns, OneKindGoesTogetherAndTheOtherWaits) {
  Turns turns;
  turns.ask(1, Runs::told, kStart);
  turns.ask(2, Runs::told, kStart);
  EXPECT_THAT(turns.grant(kStart), ElementsAre(1, 2));
  turns.ask(1, Runs::hidden, kStart + 1ms);
  EXPECT_THAT(turns.grant(kStart + 1ms), IsEmpty());
  turns.ask(3, Runs::told, kStart + 2ms);
  EXPECT_THAT(turns.grant(kStart + 2ms), ElementsAre(3));
  turns.ask(2, Runs::none, kStart + 3ms);
  EXPECT_THAT(turns.grant(kStart + 3ms), IsEmpty()) << "3 is told of still";
  turns.ask(3, Runs::hidden, kStart + 4ms);
  EXPECT_THAT(turns.grant(kStart + 4ms), ElementsAre(1, 3));
}

TEST(BatchTurns, WhoWaitsLongIsNotOvertaken) {
  Turns turns;
  turns.ask(1, Runs::told, kStart);
  EXPECT_THAT(turns.grant(kStart), ElementsAre(1));
  turns.ask(2, Runs::hidden, kStart);
  const auto later = kStart + Turns::kPatience;
  turns.ask(3, Runs::told, later);
  EXPECT_THAT(turns.grant(later), IsEmpty());
  turns.ask(1, Runs::none, later);
  EXPECT_THAT(turns.grant(later), ElementsAre(2));
  turns.ask(2, Runs::none, later);
  EXPECT_THAT(turns.grant(later), ElementsAre(3));
}

TEST(BatchTurns, WhoGoesOnWithTheSameKindWaitsForNobody) {
  Turns turns;
  turns.ask(1, Runs::told, kStart);
  EXPECT_THAT(turns.grant(kStart), ElementsAre(1));
  turns.ask(2, Runs::hidden, kStart);
  const auto later = kStart + Turns::kPatience;
  turns.ask(1, Runs::told, later); // an upload is unpacked, now it is built
  EXPECT_THAT(turns.grant(later), ElementsAre(1));
  turns.ask(1, Runs::hidden, later);
  EXPECT_THAT(turns.grant(later), ElementsAre(2, 1));
}

TEST(BatchTurns, WhoIsGoneKeepsNobody) {
  Turns turns;
  turns.ask(1, Runs::told, kStart);
  turns.ask(2, Runs::hidden, kStart + 1ms);
  EXPECT_THAT(turns.grant(kStart + 1ms), ElementsAre(1));
  turns.ask(1, Runs::none, kStart + 2ms); // died
  EXPECT_THAT(turns.grant(kStart + 2ms), ElementsAre(2));
  turns.ask(2, Runs::none, kStart + 3ms);
  EXPECT_THAT(turns.grant(kStart + 3ms), IsEmpty());
}

TEST(BatchTurns, ManyWorkersNeverMixAndAllComeToAnEnd) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    Turns turns;
    auto now = kStart;
    const int workers = 1 + int(random() % 16);
    std::map<int, Runs> wanted, running;
    std::map<int, int> asked;
    for (int step = 0; step < 3000; ++step) {
      now += std::chrono::milliseconds(random() % 300);
      const int who = int(random() % unsigned(workers));
      if (!wanted.contains(who)) { // it waits for nothing: goes on to something else
        const Runs kind = Runs(random() % 3);
        running.erase(who);
        turns.ask(who, kind, now);
        if (kind != Runs::none) wanted[who] = kind, asked[who] = step;
      }
      for (const int granted : turns.grant(now)) {
        ASSERT_TRUE(wanted.contains(granted));
        running[granted] = wanted[granted];
        wanted.erase(granted);
      }
      std::set<Runs> kinds;
      for (const auto& [one, kind] : running) kinds.insert(kind);
      ASSERT_LE(kinds.size(), 1U) << "seed " << seed << ", step " << step;
      ASSERT_TRUE(!running.empty() || wanted.empty()) << "all wait";
      for (const auto& [one, kind] : wanted) ASSERT_LT(step - asked[one], 600) << "starved";
    }
  }
}

} // namespace
