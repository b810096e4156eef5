#include "grading/scenes.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"

#include <gmock/gmock.h>

#include <set>

using namespace ggrade;
using grading::Draw;
using grading::drawScenes;
using grading::Moments;
using grading::Quality;
using grading::SceneCase;
using grading::ScenePlan;
using nlohmann::json;
using rubric::Moment;
using testing::AllOf;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;

namespace {

/// Plans for the floor's part `mirror` from a scenes.json of the test's own.
class Scenes : public testing::Test {
protected:
  ScenePlan draw(const json& scenes, const Draw& how = {}) {
    files_.write("scenes.json", scenes.dump(1));
    return drawScenes(target_, files_.path(), how);
  }
  std::string problem(const json& scenes) {
    return messageOf<UsageError>([&] { draw(scenes); });
  }
  static json scene(const std::string& name, const json& content) {
    return {{"name", name}, {"times", {0.5}}, {"scene", content}};
  }
  static json file(const std::vector<json>& scenes) { return {{"seed", 5}, {"scenes", scenes}}; }

  TemporaryFolder files_;
  Target target_ = findTarget(GGRADE_SOURCE_DIR "/assignments", "mirror");
};

const json kLight = {{"light", {{"position", {{"between", {{-1, 2, 3}, {1, 4, 3}}}}}}}};

TEST_F(Scenes, TheSameSeedDrawsTheSamePlan) {
  const json scenes = file({scene("a", kLight), scene("b", kLight)});
  const ScenePlan one = draw(scenes), two = draw(scenes);
  EXPECT_EQ(one.seed, 5u);
  ASSERT_EQ(one.scenes.size(), 2u);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(one.scenes[i].scene, two.scenes[i].scene);
  // Scenes don't share their draws.
  EXPECT_NE(one.scenes[0].scene["light"]["position"], one.scenes[1].scene["light"]["position"]);
  const Draw other{6};
  EXPECT_EQ(draw(scenes, other).seed, 6u);
  EXPECT_NE(draw(scenes, other).scenes[0].scene, one.scenes[0].scene);
}

TEST_F(Scenes, DrawsAreTheSameOnEveryMachine) {
  const ScenePlan plan = draw(file(
      {scene("a", {{"ring",
                    {{"radius", {{"between", {1.0, 2.0}}}}, {"count", {{"between", {3, 9}}}}}}})}));
  // The values of this generator and rounding; other numbers mean other scenes for a whole class.
  EXPECT_DOUBLE_EQ(plan.scenes[0].scene["ring"]["radius"].get<double>(), 1.4327);
  EXPECT_EQ(plan.scenes[0].scene["ring"]["count"], 3);
}

TEST_F(Scenes, AddingOneLeavesTheOthersAlone) {
  const ScenePlan before = draw(file({scene("a", kLight), scene("b", kLight)}));
  const ScenePlan after = draw(file({scene("a", kLight), scene("b", kLight), scene("c", kLight)}));
  for (int i = 0; i < 2; ++i) EXPECT_EQ(before.scenes[i].scene, after.scenes[i].scene);
}

TEST_F(Scenes, BetweenStaysInsideAndReachesBothEnds) {
  std::set<int> counts;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const ScenePlan plan = draw(file({scene("a", {{"ring",
                                                   {{"count", {{"between", {2, 4}}}},
                                                    {"radius", {{"between", {1.25, 1.5}}}},
                                                    {"hop", {{"choose", {0.5, 0.75}}}}}}})}),
                                {seed});
    const json& ring = plan.scenes[0].scene["ring"];
    counts.insert(ring["count"].get<int>());
    EXPECT_TRUE(ring["count"].is_number_integer());
    EXPECT_THAT(ring["radius"].get<double>(), AllOf(Ge(1.25), Le(1.5)));
    EXPECT_TRUE(ring["hop"] == 0.5 || ring["hop"] == 0.75);
  }
  EXPECT_THAT(counts, ElementsAre(2, 3, 4));
}

TEST_F(Scenes, TagsChooseProbes) {
  json scenes = file({scene("a", json::object()), scene("b", json::object())});
  scenes["scenes"][0]["tags"] = {"sunk"};
  scenes["probes"] = {{{"name", "all"}, {"scene", {{"ring", {{"count", 0}}}}}},
                      {{"name", "some"}, {"tags", {"sunk", "other"}}, {"scene", json::object()}}};
  const ScenePlan plan = draw(scenes);
  EXPECT_EQ(plan.scenes[0].probes.size(), 2u);
  EXPECT_EQ(plan.scenes[1].probes.size(), 1u);
  EXPECT_EQ(plan.scenes[1].probes.at("all")["ring"]["count"], 0);
  // A probe is the scene with a patch: the rest is the scene's.
  EXPECT_EQ(plan.scenes[1].probes.at("all")["camera"], plan.scenes[1].scene["camera"]);
}

TEST_F(Scenes, OfOtherPartsAreLeftOut) {
  json scenes =
      file({scene("a", json::object()), scene("b", json::object()), scene("c", json::object())});
  scenes["scenes"][0]["parts"] = {"shadow"};
  scenes["scenes"][1]["parts"] = {"mirror"};
  scenes["scenes"][2]["parts"] = {"shadow", "mirror"}; // shown where both are graded
  const ScenePlan plan = draw(scenes);
  ASSERT_EQ(plan.scenes.size(), 1u);
  EXPECT_EQ(plan.scenes[0].name, "b");
  EXPECT_EQ(plan.scenes[0].scene.at("effects"),
            json({{"mirror", true}, {"shadow", false}, {"bloom", false}}));
}

TEST_F(Scenes, OfPartsThatAreGradedTogetherHaveOnlyTheirOwnEffects) {
  json scenes = file({scene("a", json::object()), scene("b", json::object())});
  scenes["scenes"][0]["parts"] = {"shadow"};
  scenes["scenes"][1]["parts"] = {"mirror", "bloom"};
  target_ = findTarget(target_.assignment.folder.parent_path(), "floor");
  const ScenePlan plan = draw(scenes);
  ASSERT_EQ(plan.scenes.size(), 2u);
  EXPECT_EQ(plan.scenes[0].name, "shadow: a");
  EXPECT_EQ(plan.scenes[0].scene.at("effects"),
            json({{"mirror", false}, {"shadow", true}, {"bloom", false}}));
  EXPECT_EQ(plan.scenes[0].scene.at("ring").at("glow"), 0);
  EXPECT_EQ(plan.scenes[1].name, "mirror + bloom: b");
  EXPECT_EQ(plan.scenes[1].scene.at("effects"),
            json({{"mirror", true}, {"shadow", false}, {"bloom", true}}));
  EXPECT_EQ(plan.scenes[1].scene.at("ring").at("glow"), 4);
}

TEST_F(Scenes, OneLikeAnotherHasItsDrawsAndWhatChanged) {
  const auto like = [](const json& change) {
    json one = scene("b", change);
    one.erase("times");
    one["like"] = "a";
    return one;
  };
  const auto whole = [](json base) {
    base["times"] = {0.25, 4};
    base["scene"]["size"] = {{"choose", {{300, 200}}}};
    return base;
  };
  const ScenePlan plan = draw(
      file({whole(scene("a", kLight)), like({{"size", {{"times", {1.25, 1}}}},
                                             {"light", {{"position", {{"plus", {-1, 0, 0.5}}}}}},
                                             {"camera", {{"fov", 0.5}}}})}));
  const json& a = plan.scenes[0].scene;
  json b = plan.scenes[1].scene;
  EXPECT_EQ(plan.scenes[0].like, "");
  EXPECT_EQ(plan.scenes[1].like, "a");
  EXPECT_THAT(plan.scenes[1].times.shown, ElementsAre(0.25)); // the first time of the other
  EXPECT_EQ(b["size"], json({375, 200}));
  EXPECT_EQ(b["camera"]["fov"], 0.5);
  EXPECT_NEAR(b["light"]["position"][0].get<double>(), a["light"]["position"][0].get<double>() - 1,
              1e-9);
  EXPECT_EQ(b["light"]["position"][1], a["light"]["position"][1]);
  EXPECT_NEAR(b["light"]["position"][2].get<double>(),
              a["light"]["position"][2].get<double>() + 0.5, 1e-9);
  b["size"] = a["size"];
  b["light"]["position"] = a["light"]["position"];
  b["camera"]["fov"] = a["camera"]["fov"];
  EXPECT_EQ(b, a); // nothing else changed

  EXPECT_THAT(problem(file({like({})})),
              HasSubstr("b: like \"a\": no earlier scene of these parts has that name"));
  EXPECT_THAT(problem(file({whole(scene("a", kLight)), like({{"mesh", {{"plus", 1}}}})})),
              HasSubstr("mesh: plus and times need numbers"));
  EXPECT_THAT(problem(file({whole(scene("a", kLight)), like({{"size", {{"times", {1, 2, 3}}}}})})),
              HasSubstr("size: 3 values where the scene that it is like has 2"));
  EXPECT_THAT(problem(file({whole(scene("a", kLight)), like({{"size", {{"plus", {-300, 0}}}}})})),
              HasSubstr("size")); // checked like every scene
}

json withBefore(json one, const json& before) {
  one["before"] = before;
  return one;
}

TEST_F(Scenes, HaveFramesBeforeTheFirstOneThatIsLookedAt) {
  json like = scene("c", {{"camera", {{"fov", 0.5}}}});
  like.erase("times");
  like["like"] = "a";
  const json own = withBefore(like, {0.15}); // also named c: it is drawn alone
  const json a = withBefore(scene("a", kLight), {0.3, {{"seconds", 0.25}, {"size", {320, 240}}}});
  const ScenePlan plan = draw(file({a, scene("b", kLight), like}));
  const Moments& times = plan.scenes[0].times;
  EXPECT_THAT(times.before, ElementsAre(Moment{0.3}, Moment{0.25, 320, 240}));
  EXPECT_THAT(times.shown, ElementsAre(0.5));
  EXPECT_EQ(times.frames(), 3u);
  EXPECT_THAT(plan.scenes[1].times.before, testing::IsEmpty());
  EXPECT_EQ(plan.scenes[2].times, times.first()) << "as the one that it is like";
  EXPECT_EQ(draw(file({a, own})).scenes[1].times, Moments({{0.15}}, {0.5}));

  // What else is drawn stays as it was, and what tells plans apart sees them.
  const ScenePlan without = draw(file({scene("a", kLight), scene("b", kLight), like}));
  EXPECT_EQ(plan.scenes[0].scene, without.scenes[0].scene);
  EXPECT_NE(describe(plan), describe(without));
  EXPECT_EQ(json(without.scenes[0].times), json({0.5}));
  EXPECT_EQ(json(times).dump(),
            R"({"before":[0.3,{"seconds":0.25,"size":[320,240]}],"times":[0.5]})");
  EXPECT_EQ(rubric::readBefore(rubric::toJson(times.before), "x"), times.before);
}

TEST_F(Scenes, FramesBeforeAreDrawnByTheSeed) {
  const json before = {{{"between", {0.1, 0.4}}},
                       {{"seconds", 0}, {"size", {{"choose", {{32, 24}, {24, 32}}}}}}};
  std::set<double> times;
  std::set<std::uint32_t> widths;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const ScenePlan plan = draw(file({withBefore(scene("a", kLight), before)}), {seed});
    times.insert(plan.scenes[0].times.before[0].earlier);
    widths.insert(plan.scenes[0].times.before[1].width);
  }
  EXPECT_EQ(times.size(), 20u);
  EXPECT_THAT(*times.begin(), Ge(0.1));
  EXPECT_THAT(*times.rbegin(), Le(0.4));
  EXPECT_THAT(widths, ElementsAre(24, 32));
}

TEST_F(Scenes, MistakesInFramesBeforeNameSceneAndValue) {
  const auto of = [&](const json& before) {
    return problem(file({withBefore(scene("late", kLight), before)}));
  };
  const auto names = [](const std::string& what) {
    return AllOf(HasSubstr("scenes.json: late: "), HasSubstr(what));
  };
  EXPECT_THAT(of(1.9), names("before: must be a list of frames, but is 1.9"));
  EXPECT_THAT(of({1, "soon"}), names("before[1]: must be seconds, or {\"seconds\": seconds, "
                                     "\"size\": [width, height]}, but is \"soon\""));
  EXPECT_THAT(of({0.75}),
              names("a frame 0.75 s before the one at 0.5 s would be before the second 0"));
  EXPECT_NO_THROW(draw(file({withBefore(scene("late", kLight), {-0.5})})))
      << "the clock is put back";
  EXPECT_THAT(of({true}), names("but is true"));
  EXPECT_THAT(of({{{"size", {3, 4}}}}), names("before[0].seconds: must be a number, but is null"));
  EXPECT_THAT(of({{{"seconds", "1"}}}), names("before[0].seconds: must be a number, but is \"1\""));
  EXPECT_THAT(of({{{"seconds", 0}, {"at", 2}}}),
              names("before[0].at: there are seconds and size only"));
  for (const json& size : {json({-3, 4}), json({3}), json({3, 4.5}), json({0, 4}), json({3, 20000}),
                           json("large"), json({3, "4"})})
    EXPECT_THAT(of({{{"seconds", 0}, {"size", size}}}),
                names("before[0].size: must be two whole numbers of pixels, 1 to 16384, but is " +
                      size.dump()));
  EXPECT_THAT(of(std::vector<double>(64, 0.1)),
              names("65 frames, 64 of them before, are more than 64"));
  EXPECT_NO_THROW(draw(file({withBefore(scene("late", kLight), std::vector<double>(63, 0.1))})));
}

TEST_F(Scenes, HandoutPicturesHaveFramesBefore) {
  const json settings = {{"times", {0.5}},
                         {"before", {0.25}},
                         {"steps", {{"mirror.6", {{"before", {0.4}}, {"size", {48, 36}}}}}}};
  const Part& part = target_.parts[0];
  EXPECT_EQ(grading::handoutTimes(part, settings, 0), Moments({{0.25}}, {0.5}));
  EXPECT_EQ(grading::handoutTimes(part, settings, 6), Moments({{0.4}}, {0.5}));
  EXPECT_FALSE(grading::handoutScene(target_.assignment, part, settings, 6).contains("before"));
  EXPECT_EQ(grading::handoutTimes(part, {{"times", {0.5, 1}}}, 6), Moments({0.5, 1}));
  EXPECT_THAT(messageOf<UsageError>([&] {
                grading::handoutTimes(settings, {{"before", {"x"}}}, "together");
              }),
              HasSubstr("handout.json: together: before[0]: must be seconds, or"));
}

TEST_F(Scenes, QualityLeavesOutOrDrawsAnew) {
  const json light = {
      {"light", {{"position", {{"between", {{-1.5, 2.5, 3.0}, {1.5, 4.5, 3.0}}}}}}}};
  json open = scene("open", light), changed = scene("changed", {{"camera", {{"fov", 0.5}}}});
  open["public"] = true;
  changed.erase("times");
  changed["like"] = "hidden";
  const json scenes = file({open, scene("hidden", light), changed});
  const auto names = [&](Quality quality) {
    std::vector<std::string> all;
    for (const SceneCase& one : draw(scenes, {std::nullopt, quality}).scenes)
      all.push_back(one.name);
    return all;
  };
  EXPECT_THAT(names(Quality::fast), ElementsAre("open", "hidden"));
  EXPECT_THAT(names(Quality::balanced), ElementsAre("open", "hidden", "changed"));
  EXPECT_THAT(names(Quality::thorough), ElementsAre("open", "hidden", "changed",
                                                    "hidden, drawn anew", "changed, drawn anew"));
  // What is drawn at several qualities is drawn alike, and what is drawn anew is something else.
  const ScenePlan fast = draw(scenes, {std::nullopt, Quality::fast}),
                  thorough = draw(scenes, {std::nullopt, Quality::thorough});
  EXPECT_EQ(fast.scenes[1].scene, thorough.scenes[1].scene);
  EXPECT_NE(thorough.scenes[1].scene, thorough.scenes[3].scene);
  EXPECT_EQ(thorough.scenes[4].like, "hidden, drawn anew");
  EXPECT_EQ(thorough.scenes[4].scene["light"], thorough.scenes[3].scene["light"]);
  EXPECT_NE(describe(draw(scenes)), describe(draw(scenes, {std::nullopt, Quality::fast})));
  EXPECT_THROW(grading::parseQuality("quick"), UsageError);
}

TEST_F(Scenes, MistakesNameTheFile) {
  const auto names = [](const std::string& what) {
    return AllOf(HasSubstr("scenes.json"), HasSubstr(what));
  };
  EXPECT_THAT(problem(file({scene("a", {{"ring", {{"count", {{"between", {1, "six"}}}}}}})})),
              names("between: needs two numbers or two lists of one length"));
  EXPECT_THAT(problem(file({scene("a", {{"size", {{"between", {{1, 2}, {1, 2, 3}}}}}})})),
              names("between: needs two numbers"));
  EXPECT_THAT(problem(file({scene("a", {{"ring", {{"hop", {{"choose", json::array()}}}}}})})),
              names("choose: needs a list with values"));
  EXPECT_THAT(problem(file({scene("bent", {{"ring", {{"count", "six"}}}})})),
              AllOf(names("bent"), HasSubstr("ring.count")));
  EXPECT_THAT(problem(file({scene("bent", {{"rings", 6}})})),
              AllOf(names("bent"), HasSubstr("rings")));
  EXPECT_THAT(problem({{"seed", 1}}), names("scenes"));
  EXPECT_THAT(problem({{"seed", "one"}, {"scenes", json::array()}}), names("number"));
}

TEST_F(Scenes, HandoutScenesChangeStepByStep) {
  const json settings = {{"scene", {{"size", {48, 36}}}},
                         {"steps", {{"mirror.6", {{"ring", {{"base", -0.5}}}}}}}};
  const Part& part = target_.parts[0];
  const auto scene = [&](std::size_t k) {
    return grading::handoutScene(target_.assignment, part, settings, k);
  };
  EXPECT_EQ(scene(0)["size"], json::array({48, 36}));
  EXPECT_EQ(scene(0), scene(5));
  EXPECT_EQ(scene(6)["ring"]["base"], -0.5);
  EXPECT_EQ(scene(7), scene(0)); // a step's scene is its own
}

/// The homework's scene, for instance, which no command reads by itself.
TEST(SceneFiles, OfEveryAssignmentCanBeDrawn) {
  const std::set<std::string> others = {"assignment.json", "presets.json", "words.ja.json"};
  std::set<std::string> names;
  for (const Assignment& assignment : loadAssignments(GGRADE_SOURCE_DIR "/assignments"))
    for (const auto& entry : std::filesystem::directory_iterator(assignment.folder)) {
      const std::string name = entry.path().filename().string();
      if (entry.path().extension() != ".json" || others.contains(name)) continue;
      names.insert(name);
      EXPECT_NO_THROW(grading::readScene(assignment, entry.path())) << entry.path();
    }
  EXPECT_THAT(names, testing::IsSupersetOf({"scene.json", "homework.json"}));
}

TEST_F(Scenes, ASceneFileIsCheckedAsItWasWritten) {
  const auto file = files_.write("my.json", "{\n  \"ring\": {\n    \"count\": -1\n  }\n}\n");
  EXPECT_THAT(messageOf<UsageError>([&] { grading::readScene(target_.assignment, file); }),
              HasSubstr("my.json:3: ring.count"));
}

} // namespace
