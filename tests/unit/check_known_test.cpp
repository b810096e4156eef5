#include "check/known.hpp"
#include "diagnosis_samples.hpp"
#include "framework_temporary_folder.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
using namespace ggrade::check;
using diagnosis::SceneViews;
using diagnosis::samples::painted;
using testing::ElementsAre;

namespace {

SceneViews windowOf(const Image& window) {
  SceneViews views;
  views.windows = {diagnosis::reduced(window, 3)};
  views.width = window.width();
  views.height = window.height();
  return views;
}

const Image kNothingDone = diagnosis::samples::scene();
const Image kFirstDone = painted(kNothingDone, 0.1f, 0.1f, 0.3f, 0.3f, 0.9f);
const Image kBothDone = painted(kFirstDone, 0.6f, 0.6f, 0.9f, 0.9f, 0.05f);
const SceneViews kWrongEnd = windowOf(painted(kBothDone, 0.1f, 0.1f, 0.9f, 0.3f, 0.2f));

/// Of a program in which both steps were begun.
std::set<std::string> spoiling(const Expected& all, const Shown& shown,
                               const diagnosis::FirstWrong& first = {}) {
  return KnownMistakes(all, shown, {"mirror.1", "mirror.2"}, 2).spoiling(first);
}

/// Two steps. A mistake of the first one, which shows in it, looks in the end like one of the
/// second.
Expected twoSteps() {
  Expected all;
  all.assignment = "floor";
  all.part = "mirror";
  all.todos = {"mirror.1", "mirror.2"};
  all.scenes = {{"public", {}, {0}, "", false}};
  all.steps = {{windowOf(kNothingDone)}, {windowOf(kFirstDone)}, {windowOf(kBothDone)}};
  all.reference = all.steps.back();
  const auto fault = [&](const std::string& name, const std::string& todo, std::size_t step,
                         const SceneViews& views) {
    all.faults.push_back({name, "A hint", "", todo, {}, step, {0}, {name, name, {views}}});
  };
  fault("early", "mirror.1", 1, windowOf(painted(kNothingDone, 0.1f, 0.1f, 0.9f, 0.3f, 0.2f)));
  fault("early", "mirror.1", 2, kWrongEnd);
  fault("late", "mirror.2", 2, kWrongEnd);
  return all;
}

std::vector<std::string> titles(const std::vector<const Fault*>& faults) {
  std::vector<std::string> all;
  for (const Fault* fault : faults) all.push_back(fault->title);
  return all;
}

/// As `twoSteps` says, read from a folder, where pictures of faults are.
class CheckKnown : public testing::Test {
protected:
  std::vector<std::string> like(const Expected& made) const {
    save(made, folder_.path());
    const Expected all = load(folder_.path());
    const Shown shown{kWrongEnd};
    return titles(KnownMistakes(all, shown, {"mirror.1", "mirror.2"}, 2).like(0));
  }

  const TemporaryFolder folder_;
};

TEST_F(CheckKnown, AFinishedProgramMayHaveAnOldMistake) {
  EXPECT_THAT(like(twoSteps()), ElementsAre("late", "early"));
}

TEST_F(CheckKnown, OfAnUnfinishedOneTheLastStepIsWhatWasMadeJustNow) {
  Expected all = twoSteps();
  all.todos.push_back("mirror.3");
  all.steps.push_back({windowOf(painted(kBothDone, 0.4f, 0.4f, 0.5f, 0.5f, 0.7f))});
  all.reference = all.steps.back();
  EXPECT_THAT(like(all), ElementsAre("late"));
}

/// Two that show the same are one mistake where they are made in one TODO.
TEST_F(CheckKnown, OfOneGroupThoseOfTwoTodosAreBothTold) {
  Expected all = twoSteps();
  for (Fault& fault : all.faults) fault.signature.group = "late";
  EXPECT_THAT(like(all), ElementsAre("late", "early"));
  for (Fault& fault : all.faults) fault.todo = "mirror.2";
  EXPECT_THAT(like(all), ElementsAre("early"));
}

TEST_F(CheckKnown, AMistakeOfAnEarlierStepMayHideTheLast) {
  const auto hiding = [&](const Expected& made) {
    save(made, folder_.path());
    const Expected all = load(folder_.path());
    return KnownMistakes(all, {windowOf(kFirstDone)}, {"mirror.1", "mirror.2"}, 2).hidingTheStep();
  };
  Expected all = twoSteps();
  EXPECT_THAT(hiding(all), testing::IsEmpty());
  all.faults[1].signature.run = {windowOf(kFirstDone)};
  EXPECT_THAT(hiding(all), ElementsAre("mirror.1"));
  all.faults[1].todo = "mirror.2";
  EXPECT_THAT(hiding(all), testing::IsEmpty()) << "that isn't written, or not called";
}

/// What would show in a scene that is right isn't there.
TEST_F(CheckKnown, AMistakeThatWouldSpoilARightSceneSpoilsNothing) {
  Expected made = twoSteps();
  made.scenes.push_back({"the handout's step 1", {}, {0}, "mirror.1", false});
  for (diagnosis::Run& step : made.steps) step.push_back(step.front());
  made.reference = made.steps.back();
  for (Fault& fault : made.faults) {
    fault.signature.run.push_back(fault.signature.run.front());
    if (fault.todo == "mirror.1") fault.scenes.insert(1);
  }
  save(made, folder_.path());
  const Expected all = load(folder_.path());
  const SceneViews unknown = windowOf(painted(kBothDone, 0.4f, 0.4f, 0.5f, 0.9f, 0.7f));
  EXPECT_THAT(spoiling(all, {unknown, std::nullopt}), ElementsAre("mirror.1", "mirror.2"));
  EXPECT_THAT(spoiling(all, {unknown, unknown}), ElementsAre("mirror.1", "mirror.2"));
  EXPECT_THAT(spoiling(all, {unknown, windowOf(kBothDone)}), ElementsAre("mirror.2"));
  EXPECT_THAT(KnownMistakes(all, {unknown}, {}, 2).spoiling({0, diagnosis::Slot{}}),
              testing::IsEmpty());
}

/// One that shows in its own scene alone, of the same pass, doesn't explain the public scene's.
TEST_F(CheckKnown, AMistakeThatLeavesTheWrongSceneRightIsntMeant) {
  Expected made = twoSteps();
  made.scenes.push_back({"the handout's step 2", {}, {0}, "mirror.2", false});
  for (diagnosis::Run& step : made.steps) step.push_back(step.front());
  made.reference = made.steps.back();
  for (Fault& fault : made.faults) {
    fault.scenes.insert(1);
    fault.signature.run.push_back(fault.signature.run.front());
    if (fault.todo == "mirror.2") fault.signature.run[0] = windowOf(kBothDone);
  }
  save(made, folder_.path());
  const Expected all = load(folder_.path());
  const SceneViews unknown = windowOf(painted(kBothDone, 0.4f, 0.4f, 0.5f, 0.9f, 0.7f));
  EXPECT_THAT(spoiling(all, {unknown, unknown}, {0}), ElementsAre("mirror.1"));
  EXPECT_THAT(spoiling(all, {unknown, unknown}, {1}), ElementsAre("mirror.1", "mirror.2"));
}

/// Two may spoil the same pass; one of them spoils the window, too, which is right.
TEST_F(CheckKnown, AMistakeThatWouldSpoilARightWindowIsntMeant) {
  Expected made = twoSteps();
  const auto withPass = [](SceneViews views, float grey) {
    views.passes = {{{}, 8, 8, diagnosis::reduced(Image(8, 8, 3, grey), 3)}};
    return views;
  };
  for (diagnosis::Run& step : made.steps) step[0] = withPass(step[0], 0.5f);
  made.reference = made.steps.back();
  made.faults.clear();
  for (const auto& [todo, window] :
       {std::pair("mirror.1", kWrongEnd), {"mirror.2", windowOf(kBothDone)}})
    made.faults.push_back(
        {todo, "A hint", "", todo, {}, 2, {0}, {todo, todo, {withPass(window, 1)}}});
  save(made, folder_.path());
  const Expected all = load(folder_.path());
  const diagnosis::FirstWrong pass{0, diagnosis::Slot{}};
  EXPECT_THAT(spoiling(all, {withPass(windowOf(kBothDone), 0)}, pass), ElementsAre("mirror.2"));
  EXPECT_THAT(spoiling(all, {withPass(kWrongEnd, 0)}, pass), ElementsAre("mirror.1", "mirror.2"));
}

} // namespace
