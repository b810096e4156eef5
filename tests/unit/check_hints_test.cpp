// How much of a fault is told, on the terminal and in JSON, and what is remembered of it.
#include "check/page.hpp"
#include "check/terminal.hpp"
#include "grading/workspace.hpp"
#include "in_japanese.hpp"

#include <gmock/gmock.h>

#include <fstream>

using namespace ggrade;
using namespace ggrade::check;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace {

namespace fs = std::filesystem;

Checked found(State state, const std::string& cause, const std::string& hint) {
  Checked checked;
  checked.happened.outcome = results::Outcome::graded;
  checked.drawn = true;
  checked.isPuzzle = true;
  checked.cause = cause;
  checked.hint = hint;
  checked.rows = {{"m.1", State::done}, {"m.2", state}, {"m.3", State::notBegun}};
  return checked;
}

Checked lightWrong() {
  return found(State::wrong, "The light is not brought along", "Which space is it in?");
}

Checked clearWrong() {
  Checked checked =
      found(State::wrong, "It may be one of these 2 mistakes, which look alike so far",
            "- Too early\n  What is bound?\n- Depth alone\n  What is a bit?");
  checked.titles = {"Too early", "Depth alone"};
  return checked;
}

/// The same thing, seen by whoever looks at it.
struct Seen {
  Part part;
  Expected expected;
  Looked looked;

  explicit Seen(Checked checked) {
    part.id = "m";
    part.todos = {{"m.1", "make it", false, false},
                  {"m.2", "light it", false, false},
                  {"m.3", "clip it", false, false}};
    ItemDeclaration item;
    item.title = "Near hides far";
    item.step = "m.1";
    part.items = {item};
    looked.part = &part;
    expected.scenes.resize(1);
    looked.expected = &expected;
    looked.handout = "assignments/m/README.md";
    looked.folder = ".";
    looked.checked = std::move(checked);
    looked.places = {{"m.cpp", 12, 4}, {"m.frag", 3, 0}};
  }
  std::string at(Level level, bool canAsk = true) {
    looked.level = level;
    looked.canAsk = canAsk && level < lastLevel(looked.checked);
    return table({looked}, false, "ask");
  }
};

TEST(CheckHints, OneLevelAfterTheOther) {
  Seen seen(lightWrong());
  EXPECT_THAT(seen.at(Level::where),
              AllOf(HasSubstr("\nm.cpp:12:4: error: m.2 is wrong: light it\n"),
                    HasSubstr("\nm.frag:3: note: m.2 goes on here\n"),
                    HasSubstr("\nFor a hint: ask\n"), Not(HasSubstr("The light")),
                    Not(HasSubstr("Which space"))));
  EXPECT_THAT(seen.at(Level::look),
              AllOf(HasSubstr("\nLikely cause: The light is not brought along\n"),
                    HasSubstr("\nFor one more hint, again: ask\n"), Not(HasSubstr("Which space"))));
  EXPECT_THAT(seen.at(Level::why), AllOf(HasSubstr("The light is not"), HasSubstr("Which space"),
                                         HasSubstr("last hint"), Not(HasSubstr(": ask"))));
}

TEST(CheckHints, TitlesComeBeforeWhatTheyMean) {
  Seen seen(clearWrong());
  EXPECT_THAT(seen.at(Level::look),
              AllOf(HasSubstr("look alike so far\n- Too early\n- Depth alone\n"),
                    Not(HasSubstr("What is bound"))));
  EXPECT_THAT(seen.at(Level::why),
              HasSubstr("look alike so far\n- Too early\n  What is bound?\n- Depth alone\n"));
}

TEST(CheckHints, WhatIsNoPuzzleIsToldAtOnceAndAtItsPlace) {
  Seen seen(lightWrong());
  seen.looked.checked.isPuzzle = false;
  EXPECT_THAT(seen.at(Level::where), AllOf(HasSubstr("The light is not"), HasSubstr("Which space"),
                                           Not(HasSubstr("hint"))));
  Checked nothing = lightWrong();
  nothing.cause.clear();
  EXPECT_THAT(Seen(nothing).at(Level::where), Not(HasSubstr("hint"))) << "nothing is known";
}

TEST(CheckHints, AWrongPictureOfNoKnownCauseIsToldAsSuch) {
  Checked unknown = lightWrong();
  unknown.cause.clear();
  unknown.firstWrong.emplace();
  Seen seen(unknown);
  EXPECT_THAT(seen.at(Level::where),
              HasSubstr("\nNo mistake that is known at this point shows this picture. Put it"));
  EXPECT_THAT(page("m", {seen.looked}, false),
              HasSubstr("No mistake that is known at this point shows this picture. Put it"));
  EXPECT_THAT(page("m", {Seen(lightWrong()).looked}, false), Not(HasSubstr("No known mistake")));
  unknown.rows[1].state = State::nearly;
  EXPECT_THAT(Seen(unknown).at(Level::where), Not(HasSubstr("No known mistake")));
}

TEST(CheckHints, JsonHasEverything) {
  Seen seen(clearWrong());
  const nlohmann::json part = toJson({seen.looked}).at(0);
  EXPECT_THAT(part.at("cause").get<std::string>(), StartsWith("It may be one of these 2"));
  EXPECT_THAT(part.at("hint").get<std::string>(), HasSubstr("What is bound?"));
  EXPECT_EQ(part.at("problems").at(0), (nlohmann::json{{"file", "m.cpp"},
                                                       {"line", 12},
                                                       {"column", 4},
                                                       {"severity", "error"},
                                                       {"text", "m.2 is wrong: light it"}}));
}

TEST(CheckHints, HowFarAndWhatForWhileNothingIsWrong) {
  Seen seen(found(State::notBegun, "", ""));
  EXPECT_THAT(seen.at(Level::where),
              AllOf(HasSubstr("m: [##----] 1 of 3 done"),
                    HasSubstr("\nm.1 is done. What it is for: Near hides far\n"),
                    HasSubstr("\nm.cpp:12:4: note: m.2 is next: light it\n"),
                    HasSubstr("\nNext: assignments/m/README.md, step 2: light it\n")));
  seen.looked.checked.rows[0].showsWith = "m.3";
  EXPECT_THAT(seen.at(Level::where),
              AllOf(HasSubstr("(as far as can be told: known mistakes in it show later, the last "
                              "of them with m.3)\n"),
                    HasSubstr("What it is for: Near hides far (as far as can be told so far)\n")));
  seen.looked.checked.rows[1].state = State::done;
  EXPECT_THAT(seen.at(Level::where), AllOf(HasSubstr("[####--] 2 of 3"),
                                           HasSubstr("\nm.2 is done. What it is for: light it\n")))
      << "no item is about it";
  EXPECT_THAT(Seen(lightWrong()).at(Level::where), Not(HasSubstr("is done.")));
  seen.looked.checked.rows[1].state = State::nearly;
  EXPECT_THAT(seen.at(Level::where), HasSubstr("\nm.cpp:12:4: warning: m.2 may be wrong"));
}

TEST(CheckHints, TheFirstThatIsNotDoneIsNextWhateverWaitsForIt) {
  Checked checked = found(State::notBegun, "", "");
  checked.rows[2].state = State::waits;
  ASSERT_NE(rowToLookAt(checked), nullptr);
  EXPECT_EQ(rowToLookAt(checked)->todo, "m.2");
  checked.drawn = false;
  EXPECT_EQ(rowToLookAt(checked), nullptr);
}

TEST(CheckHints, OfSeveralInDoubtTheLikelyOneIsReadElseAll) {
  Checked checked = found(State::maybe, "", "");
  checked.rows[0].state = State::maybe;
  EXPECT_THAT(Seen(checked).at(Level::where),
              HasSubstr("\nRead again: assignments/m/README.md, one of the steps 1, 2\n"));
  EXPECT_EQ(rowToLookAt(checked)->todo, "m.2") << "the one that was written last";
  EXPECT_EQ(rowsToLookAt(checked).size(), 2U);
  checked.rows[0].isFirst = true;
  EXPECT_EQ(rowToLookAt(checked)->todo, "m.1") << "the one that pictures speak of";
  EXPECT_EQ(rowsToLookAt(checked).size(), 2U);
  checked.rows[0].isFirst = false;
  Seen both(checked);
  both.looked.otherPlaces = {{"m.1", {"n.cpp", 7, 2}}};
  EXPECT_THAT(both.at(Level::where), AllOf(HasSubstr("\nm.cpp:12:4: warning: m.2 may be wrong"),
                                           HasSubstr("\nn.cpp:7:2: warning: m.1 may be wrong")));
  checked.likely = "m.1";
  EXPECT_EQ(rowToLookAt(checked)->todo, "m.1");
  EXPECT_EQ(rowsToLookAt(checked).size(), 1U);
  EXPECT_THAT(Seen(checked).at(Level::where),
              HasSubstr("\nRead again: assignments/m/README.md, step 1: "));
  checked.rows[1].state = State::wrong;
  EXPECT_EQ(rowToLookAt(checked)->todo, "m.2") << "one is known to be wrong";
}

TEST(CheckHints, JapaneseToo) {
  const InJapanese japanese;
  Seen seen(lightWrong());
  EXPECT_THAT(seen.at(Level::where),
              AllOf(HasSubstr("m.cpp:12:4: error: m.2が違います：light it"),
                    HasSubstr("ヒントを見るには：ask"), HasSubstr("[##----] 3個中1個完了")));
}

class ToldTest : public testing::Test {
protected:
  Told told() const { return Told(file()); }
  fs::path file() const { return folder_.path() / "work" / "told.json"; }

private:
  grading::TemporaryFolder folder_;
};

TEST_F(ToldTest, OneLevelMoreEachTimeAndNoMoreThanThereIs) {
  EXPECT_EQ(told().of("m", lightWrong()), Level::where);
  for (const Level level : {Level::look, Level::why, Level::why}) {
    told().tellMore("m", lightWrong());
    EXPECT_EQ(told().of("m", lightWrong()), level) << "kept in the file";
  }
  EXPECT_EQ(told().of("other", lightWrong()), Level::where);
  Checked noHint = lightWrong();
  noHint.hint.clear();
  Told one = told();
  one.tellMore("m", noHint);
  one.tellMore("m", noHint);
  EXPECT_EQ(one.of("m", noHint), Level::look);
}

TEST_F(ToldTest, AnotherFaultBeginsAgain) {
  Told one = told();
  one.tellMore("m", lightWrong());
  one.tellMore("m", lightWrong());
  EXPECT_EQ(one.of("m", clearWrong()), Level::where) << "another cause";
  Checked elsewhere = lightWrong();
  elsewhere.rows[1].state = State::done;
  elsewhere.rows[2].state = State::wrong;
  EXPECT_EQ(one.of("m", elsewhere), Level::where) << "another TODO";
  one.tellMore("m", clearWrong());
  EXPECT_EQ(one.of("m", clearWrong()), Level::look);
  EXPECT_EQ(one.of("m", lightWrong()), Level::where);
}

TEST_F(ToldTest, OnceAllIsRightNothingWasTold) {
  Told one = told();
  one.tellMore("m", lightWrong());
  Checked broken = lightWrong();
  broken.drawn = false;
  for (Row& row : broken.rows) row.state = State::notBegun;
  one.settle("m", broken);
  EXPECT_EQ(told().of("m", lightWrong()), Level::look) << "a typing error in between";
  one.settle("m", found(State::done, "", ""));
  EXPECT_EQ(told().of("m", lightWrong()), Level::where);
}

TEST_F(ToldTest, AFileThatIsNotOursCountsAsNothing) {
  fs::create_directories(file().parent_path());
  for (const char* text : {"", "{", "[]", R"({"m": 3})", R"({"m": {"fault": 3}})",
                           R"({"m": {"fault": "m.2\nThe light is not brought along"}})"}) {
    std::ofstream(file()) << text;
    EXPECT_EQ(told().of("m", lightWrong()), Level::where) << text;
  }
  std::ofstream(file())
      << R"({"m": {"fault": "m.2\nThe light is not brought along", "level": 99}})";
  EXPECT_EQ(told().of("m", lightWrong()), Level::why);
}

} // namespace
