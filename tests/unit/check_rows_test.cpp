#include "check/rows.hpp"
#include "diagnosis_samples.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
using namespace ggrade::check;
using diagnosis::SceneViews;
using diagnosis::samples::painted;
using diagnosis::samples::scene;

namespace {

/// One scene with a texture and one frame of the window.
SceneViews seen(const Image& texture, const Image& window) {
  SceneViews views;
  views.passes.push_back({{false, true, 0, 0}, 256, 256, diagnosis::reduced(texture, 3)});
  views.windows = {diagnosis::reduced(window, 3)};
  views.width = window.width();
  views.height = window.height();
  return views;
}

const Image kEmpty(256, 256, 3, 0.2f);
const Image kTexture = painted(kEmpty, 0.3f, 0.3f, 0.7f, 0.7f, 0.8f);
const Image kWindow = scene();
const Image kSampled = painted(kWindow, 0, 0.6f, 1, 1, 0.3f);
const Image kShows = painted(kSampled, 0.4f, 0.7f, 0.6f, 0.9f, 0.8f);
const Image kClipped = painted(kShows, 0.4f, 0.85f, 0.6f, 0.9f, 0.1f);

/// Like the mirror: 1 shows nothing, 2 only in the texture, 3 only in the window, 4 in both, and so
/// does 5.
Expected expected() {
  Expected all;
  for (const char* todo : {"m.1", "m.2", "m.3", "m.4", "m.5"}) all.todos.push_back(todo);
  all.scenes = {{"public", {}, {0}, "", false}};
  SceneViews stub = seen(kEmpty, kWindow);
  stub.passes.clear();
  // What is only cleared is not yet the texture that objects are drawn into.
  const auto cleared = [](const Image& window) {
    SceneViews views = seen(kEmpty, window);
    views.passes[0].slot.mesh = false;
    return views;
  };
  const Image clippedTexture = painted(kTexture, 0.3f, 0.6f, 0.7f, 0.7f, 0.2f);
  for (const SceneViews& views : {stub, stub, cleared(kWindow), cleared(kSampled),
                                  seen(kTexture, kShows), seen(clippedTexture, kClipped)})
    all.steps.push_back({views});
  all.reference = all.steps.back();
  return all;
}

std::set<std::string> first(std::size_t count) {
  std::set<std::string> begun;
  for (std::size_t k = 1; k <= count; ++k) begun.insert("m." + std::to_string(k));
  return begun;
}

/// One letter a row: d done, w wrong, t waits, n not begun, l nearly, f differs, m maybe wrong.
std::string letters(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) text += "ndwtlfm"[int(row.state)];
  return text;
}

std::string states(const SceneViews& views, const std::set<std::string>& begun,
                   const Suspect& suspect = {}) {
  return letters(rows(expected(), {views}, begun, suspect));
}

TEST(CheckRows, EveryStepIsDoneUpToItself) {
  const Expected all = expected();
  const char* const kWanted[] = {"nnnnn", "dnnnn", "ddnnn", "dddnn", "ddddn", "ddddd"};
  for (std::size_t k = 0; k <= 5; ++k)
    EXPECT_EQ(states(all.steps[k][0], first(k)), kWanted[k]) << k;
}

TEST(CheckRows, AnotherRightAnswerIsDoneOnceItIsFinished) {
  Expected all = expected();
  const Image other = painted(kSampled, 0.1f, 0.7f, 0.3f, 0.9f, 0.5f);
  all.others = {{seen(kTexture, other)}};
  const auto statesOf = [&](const SceneViews& views) {
    return letters(rows(all, {views}, first(5)));
  };
  EXPECT_EQ(statesOf(seen(kEmpty, other)), "ddddd") << "however its passes are made";
  EXPECT_EQ(statesOf(seen(kEmpty, kShows)), "dddmm") << "neither the one nor the other";
  all.others.clear();
  EXPECT_NE(statesOf(seen(kEmpty, other)), "ddddd");
}

TEST(CheckRows, ALittleThatNothingExplainsIsNotCalledWrong) {
  // A hundredth of the window, and three times as much.
  const auto changed = [](float height) {
    return seen(kTexture, painted(kClipped, 0.1f, 0.1f, 0.2f, 0.1f + height, 0.9f));
  };
  EXPECT_EQ(states(changed(0.1f), first(5)), "dddll") << "at each that draws there";
  EXPECT_EQ(states(changed(0.3f), first(5)), "dddmm");
  EXPECT_EQ(states(changed(0.1f), first(5), {"m.5", true}), "ddddw")
      << "a known mistake shows this";
  EXPECT_EQ(states(changed(0.1f), first(5), {"m.3"}), "ddlll") << "and a guess at where";
  Suspect suspect;
  suspect.drawing = {"m.2"};
  EXPECT_EQ(states(changed(0.1f), first(5), suspect), "dldll") << "and what draws the pass";
}

TEST(CheckRows, APassThatDiffersIsNotCalledWrongWhileAllWindowsAreRight) {
  // The fourth TODO's texture, which the window doesn't show as the floor doesn't sample it yet.
  Expected all = expected();
  all.steps[4][0].windows = all.steps[3][0].windows;
  const SceneViews other = seen(painted(kTexture, 0.2f, 0.3f, 0.7f, 0.7f, 0.8f), kSampled);
  EXPECT_EQ(letters(rows(all, {other}, first(4))), "dddfn");
  EXPECT_EQ(letters(rows(all, {other}, first(4), {"m.4", true})), "dddwn") << "it is known why";
  SceneViews none = other;
  none.passes.clear();
  EXPECT_EQ(letters(rows(all, {none}, first(4))), "dddwn") << "there is no such pass";
  SceneViews small = other;
  small.passes[0].slot.octave = 1;
  EXPECT_EQ(letters(rows(all, {small}, first(4))), "dddfn") << "a pass of another size";
}

TEST(CheckRows, WhatIsSeenIsDoneWhereverItWasWritten) {
  EXPECT_EQ(states(expected().steps[4][0], {}), "ndddn"); // the text alone tells of the first
}

TEST(CheckRows, WhatIsBegunAndDoesNotShowIsWrong) {
  EXPECT_EQ(states(expected().steps[3][0], first(4)), "dddwn");
  EXPECT_EQ(states(expected().steps[1][0], first(2)), "dwnnn");
}

TEST(CheckRows, TheFirstWrongPictureTellsWhichOne) {
  // A wrong texture, and what follows from it in the window.
  EXPECT_EQ(states(seen(painted(kEmpty, 0.4f, 0.3f, 0.8f, 0.7f, 0.8f),
                        painted(kSampled, 0.65f, 0.7f, 0.95f, 0.9f, 0.8f)),
                   first(4)),
            "dddwn");
  // The texture is right and the window isn't: what the window alone shows.
  EXPECT_EQ(states(seen(kTexture, painted(kWindow, 0, 0.6f, 1, 1, 0.9f)), first(4)), "ddmdn");
}

TEST(CheckRows, OfTwoThatChangeTheSamePictureTheOneThatChangesWhatIsWrong) {
  // Wrong is what 5 changes in the texture.
  const Image texture = painted(kTexture, 0.3f, 0.6f, 0.7f, 0.7f, 0.5f);
  EXPECT_EQ(states(seen(texture, painted(kClipped, 0.2f, 0.8f, 0.8f, 0.95f, 0.95f)), first(5)),
            "dddmm");
}

TEST(CheckRows, AKnownMistakePointsToItsTodo) {
  const SceneViews views = seen(painted(kTexture, 0.5f, 0, 1, 1, 0.9f), kWindow);
  EXPECT_EQ(states(views, first(5), {"m.4", true}), "dddwt");
  // Also to one whose own picture is right, as when a state is left behind.
  const SceneViews later = seen(kTexture, painted(kWindow, 0, 0, 1, 1, 0.1f));
  EXPECT_EQ(states(later, first(4), {"m.4", true}), "dddwn");
}

TEST(CheckRows, WhatWasLeftOutIsWaitedFor) {
  std::set<std::string> begun = first(5);
  begun.erase("m.3");
  // The texture is right already, the window can't be.
  EXPECT_EQ(states(seen(kTexture, kWindow), {"m.1", "m.2", "m.4"}), "ddndn");
  EXPECT_EQ(states(seen(kEmpty, kWindow), begun), "ddntt");
  // Something of a later one is there, such as a line that stands among its own.
  const auto other = [](float height) {
    return seen(kEmpty, painted(kSampled, 0.1f, 0.1f, 0.2f, 0.1f + height, 0.9f));
  };
  const std::set<std::string> gap{"m.1", "m.2", "m.3", "m.5"};
  EXPECT_EQ(states(other(0.05f), gap), "dddnt") << "it may come of the later one";
  EXPECT_EQ(states(other(0.8f), gap).find('t'), 4u) << "what comes before is judged";
  EXPECT_NE(states(other(0.8f), gap).find_first_of("wm"), std::string::npos);
}

TEST(CheckRows, PassesMayBeMadeInAnotherWayWhereTheWindowIsRight) {
  EXPECT_EQ(states(seen(Image(256, 256, 3, 0.9f), kClipped), first(5)), "ddddd");
}

TEST(CheckRows, WhatIsWrongInAnotherSceneAloneIsTheOnesThatChangesItThere) {
  Expected all = expected();
  all.scenes.push_back({"another", {}, {1}, "", true});
  for (diagnosis::Run& step : all.steps) step.push_back(step[0]);
  all.reference = all.steps.back();
  const SceneViews right = all.reference[0];
  SceneViews wrong = right;
  wrong.windows[0] = diagnosis::reduced(painted(kClipped, 0, 0.6f, 0.35f, 1, 0.9f), 3);
  EXPECT_EQ(letters(rows(all, {right, right}, first(5))), "ddddd");
  EXPECT_EQ(letters(rows(all, {right, wrong}, first(5))), "mdmmm")
      << "all but the one that is right there";
  Suspect binds;
  binds.binding = {"m.2"};
  EXPECT_EQ(letters(rows(all, {right, wrong}, first(5), binds)), "mmmmm")
      << "it binds what the window is drawn with";
  EXPECT_EQ(letters(rows(all, {right, wrong}, first(5), {"m.2"})), "dwddd");
  SceneViews pass = right;
  pass.passes[0].picture = diagnosis::reduced(kEmpty, 3);
  EXPECT_EQ(letters(rows(all, {right, pass}, first(5), {"m.2"})), "ddddd") << "the window is right";
}

TEST(CheckRows, WorkThatAnotherSceneDoesWithoutIsNotInDoubtThere) {
  Expected all = expected();
  all.scenes.push_back({"another", {}, {1}, "", true});
  for (diagnosis::Run& step : all.steps) step.push_back(step[0]);
  all.steps[5][1] = all.steps[4][1]; // where nothing is cut off
  all.reference = all.steps.back();
  SceneViews wrong = all.reference[1];
  wrong.windows[0] = diagnosis::reduced(painted(kShows, 0, 0.6f, 0.35f, 1, 0.9f), 3);
  EXPECT_EQ(letters(rows(all, {all.reference[0], wrong}, first(5))), "mdmmd");
}

TEST(CheckRows, SeveralMayBeWrongWhereOnlyAGuessOrALaterFrameTells) {
  const SceneViews black = seen(kEmpty, Image(320, 240, 3, 0.0f));
  Suspect guess{"m.2", true};
  EXPECT_EQ(states(black, first(5), guess).find('m'), std::string::npos) << "it is known";
  guess.isGuess = true;
  const std::string guessed = states(black, first(5), guess);
  EXPECT_EQ(guessed[1], 'm') << guessed;
  EXPECT_GE(std::ranges::count(guessed, 'm'), 2) << guessed << ": the guess is not alone";
  EXPECT_EQ(guessed.find('w'), std::string::npos) << guessed;
  Suspect later;
  later.isLater = true;
  EXPECT_EQ(states(black, first(5), later), "mmmmm");
  EXPECT_EQ(states(black, first(3), later), "mmmnn");
  // Two mistakes that show the same are known, of two steps.
  Suspect same{"m.3", true};
  same.also = {"m.2", "m.5"};
  EXPECT_EQ(states(black, first(4), same), "dmmtn");
}

TEST(CheckRows, SomethingElseThatIsWrongIsTheLastOnes) {
  EXPECT_EQ(states(seen(kEmpty, Image(320, 240, 3, 0.0f)), first(1)), "wnnnn");
}

TEST(CheckRows, AMistakeOfAnEarlierStepMayShowFirstAtTheLastOne) {
  const SceneViews wrong = seen(painted(kEmpty, 0.4f, 0.3f, 0.8f, 0.7f, 0.8f),
                                painted(kSampled, 0.65f, 0.7f, 0.95f, 0.9f, 0.8f));
  Expected all = expected();
  const auto after4 = [&] { return letters(rows(all, {wrong}, first(4))); };
  Fault fault{"", "", "", "m.3"};
  fault.step = 5; // in the finished program alone
  all.faults = {fault};
  EXPECT_EQ(after4(), "dddwn");
  all.faults[0].step = 4;
  EXPECT_EQ(after4(), "ddmmn");
  all.faults[0].todo = "m.1";
  EXPECT_EQ(after4(), "mddmn") << "nor was anything of it seen before";
}

TEST(CheckRows, WhatIsDoneSaysWithWhichStepItsMistakesShow) {
  Expected all = expected();
  const auto add = [&](const char* mistake, std::size_t step) {
    Fault fault{"", "", "", "m.2"};
    fault.step = step;
    fault.signature.group = mistake;
    all.faults.push_back(fault);
  };
  add("early", 2), add("early", 5), add("late", 4), add("late", 5);
  const auto after = [&](std::size_t k) {
    return rows(all, {all.steps[k][0]}, first(k))[1].showsWith;
  };
  EXPECT_EQ(after(1), "") << "not begun";
  EXPECT_EQ(after(2), "m.4");
  EXPECT_EQ(after(3), "m.4");
  EXPECT_EQ(after(4), "") << "it would be seen";
}

TEST(CheckRows, OfALittleInAHandedOutSceneAndMuchInAnotherTheOtherTells) {
  Expected all = expected();
  all.scenes.push_back({"another", {}, {1}, "", true});
  for (diagnosis::Run& step : all.steps) step.push_back(step[0]);
  all.reference = all.steps.back();
  SceneViews little = all.reference[0], much = little;
  little.windows[0] = diagnosis::reduced(painted(kClipped, 0.1f, 0.1f, 0.2f, 0.2f, 0.9f), 3);
  much.windows[0] = diagnosis::reduced(painted(kClipped, 0, 0.6f, 0.35f, 1, 0.9f), 3);
  Suspect suspect{"m.3"};
  suspect.isGuess = true;
  suspect.also = {"m.2"};
  EXPECT_EQ(letters(rows(all, {little, much}, first(5), suspect)), "dmmdd");
  EXPECT_EQ(letters(rows(all, {little, all.reference[0]}, first(5), suspect))[2], 'l');
  EXPECT_EQ(letters(rows(all, {little, little}, first(5), suspect))[2], 'l') << "as little there";
}

/// Its own picture is right, and what it adds to the window may not be.
TEST(CheckRows, AStepWhoseMistakesSpoilTheWindowIsInDoubtThoughItsPictureIsRight) {
  SceneViews views = expected().reference[0];
  views.windows = {diagnosis::reduced(painted(kClipped, 0.1f, 0.1f, 0.9f, 0.5f, 0.9f), 3)};
  Suspect suspect;
  suspect.isGuess = true;
  EXPECT_EQ(states(views, first(5), suspect)[1], 'd');
  suspect.spoiling = {"m.2"};
  EXPECT_EQ(states(views, first(5), suspect)[1], 'm');
}

/// No later step changes it there.
TEST(CheckRows, WhatIsWrongInAStepsOwnSceneIsNoLaterStepsFault) {
  Expected all = expected();
  all.scenes.push_back({"the handout's step 3", {}, {0}, "m.3", false});
  const Image own = painted(kWindow, 0, 0, 1, 0.3f, 0.5f);
  for (std::size_t k = 0; k < all.steps.size(); ++k)
    all.steps[k].push_back(seen(kEmpty, k < 3 ? kWindow : own));
  all.reference = all.steps.back();
  const SceneViews wrong = seen(kTexture, painted(kClipped, 0, 0, 1, 1, 0.5f));
  Suspect suspect;
  suspect.spoiling = {"m.2", "m.3", "m.4", "m.5"};
  const auto told = [&](const Image& window) {
    return letters(rows(all, {wrong, seen(kEmpty, window)}, first(5), suspect));
  };
  EXPECT_EQ(told(own), "dmmmm");
  EXPECT_EQ(told(kWindow), "dmmdt");
  // What a later frame shows may be what a later step left behind.
  all.scenes[1].times = {0, 1};
  for (diagnosis::Run& step : all.steps) step[1].windows.push_back(step[1].windows[0]);
  SceneViews later = seen(kEmpty, own);
  later.windows.push_back(diagnosis::reduced(kWindow, 3));
  EXPECT_EQ(letters(rows(all, {wrong, later}, first(5), suspect)), "dmmmm");
}

/// The first one shows nothing by itself, and the second may lack what that should have made.
TEST(CheckRows, WhatShowsNothingMayStandOnWhatWasNotSeen) {
  const Expected all = expected();
  Suspect suspect{"m.2", true};
  suspect.showsNothing = true;
  EXPECT_EQ(states(all.steps[1][0], first(2), suspect), "mmnnn");
  Suspect guess;
  guess.isGuess = true;
  EXPECT_EQ(states(all.steps[1][0], first(2), guess), "mmnnn");
  suspect.todo = "m.3";
  EXPECT_EQ(states(all.steps[2][0], first(3), suspect), "ddwnn");
  suspect.also = {"m.2"}; // a mistake there hides it
  EXPECT_EQ(states(all.steps[2][0], first(3), suspect), "dmmnn");
}

} // namespace
