#include "framework_temporary_folder.hpp"
#include "tradeoff/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

using namespace ggrade;
using namespace ggrade::tradeoff;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

namespace fs = std::filesystem;
const fs::path kSource = GGRADE_SOURCE_DIR;

Assignment floorAssignment() {
  return Assignment::load(kSource / "assignments/floor");
}

json good() {
  return {
      {"size", {48, 36}},
      {"parts",
       {{"mirror",
         {{"off", {{"effects", {{"mirror", false}}}}},
          {"scenes",
           {{{"name", "sharp"},
             {"about", "A scene."},
             {"time", 0.5},
             {"numbers", {{"mirror_size", {64, 128}}, {"mirror_clip", {0, 1}}}},
             {"together", json::array({{"mirror_size", "mirror_clip"}})}}}}}}}},
      {"amounts", {"mirror_size"}},
      {"growth", json::array({{{"name", "objects"}, {"steps", json::array({{{"sphere", 8}}})}}})},
      {"saved", json::array({{{"name", "no mirror"}}})}};
}

class TradeoffPlan : public testing::Test {
protected:
  Plan read(const json& text) {
    std::ofstream(file()) << text.dump(1);
    return readPlan(floorAssignment(), {"mirror"}, file());
  }
  /// What is said of the plan, without the file's folder.
  std::string problemOf(const json& text) {
    try {
      read(text);
    } catch (const UsageError& error) {
      const std::string what = error.what(), start = file().string();
      EXPECT_EQ(what.compare(0, start.size(), start), 0) << what;
      return what.substr(start.size());
    }
    return "nothing";
  }
  json& scene(json& text) { return text["parts"]["mirror"]["scenes"][0]; }
  fs::path file() const { return folder_.path() / "quality.json"; }

private:
  TemporaryFolder folder_;
};

TEST_F(TradeoffPlan, OfTheFloorIsRight) {
  const Plan plan = readPlan(floorAssignment(), {"mirror", "shadow", "bloom"},
                             kSource / "solutions/floor/quality.json");
  std::vector<std::string> parts;
  for (const Sweep& sweep : plan.sweeps) parts.push_back(sweep.part);
  EXPECT_THAT(parts,
              testing::ElementsAre("mirror", "mirror", "shadow", "shadow", "shadow", "bloom"));
  EXPECT_EQ(plan.parts.size(), 3u);
  std::size_t settings = 0;
  for (const Sweep& sweep : plan.sweeps) {
    settings += allSettings(sweep).size();
    EXPECT_EQ(sweep.scene["effects"][sweep.part], true);
    EXPECT_EQ(sweep.off["effects"][sweep.part], false);
  }
  EXPECT_GT(settings, 100u);
  EXPECT_LT(settings, 200u) << "all of it must be measured within a quarter of an hour";
}

TEST_F(TradeoffPlan, HasScenesSettingsAndSteps) {
  const Plan plan = read(good());
  ASSERT_EQ(plan.sweeps.size(), 1u);
  const Sweep& sweep = plan.sweeps[0];
  EXPECT_EQ(sweep.scene["size"], json({48, 36}));
  EXPECT_EQ(defaultSetting(sweep), json({{"mirror_clip", 1}, {"mirror_size", 1024}}));
  EXPECT_EQ(referenceSetting(sweep), json({{"mirror_clip", 1}, {"mirror_size", 128}}));
  EXPECT_THAT(settingsOf(sweep, "mirror_size"),
              ElementsAre(json({{"mirror_clip", 1}, {"mirror_size", 64}}),
                          json({{"mirror_clip", 1}, {"mirror_size", 128}})));
  EXPECT_EQ(settingsOf(sweep, sweep.together[0]).size(), 4u);
  EXPECT_EQ(allSettings(sweep).size(), 6u) << "1024 with and without clipping, and four together";
  EXPECT_EQ(withSetting(sweep.scene, {{"mirror_size", 64}})["quality"]["mirror_size"], 64);
  EXPECT_TRUE(sweep.numbers[1].amount);
  EXPECT_FALSE(sweep.numbers[0].amount);
  EXPECT_DOUBLE_EQ(plan.growth[0].steps[0].value, 224);
  EXPECT_EQ(plan.growth[0].steps[0].scene["mesh"], "sphere-8.obj");
  EXPECT_EQ(plan.saved[0].against["debug"]["draw_all_passes"], true);
}

TEST_F(TradeoffPlan, ANumbersSecondSceneHasFilesOfItsOwn) {
  json text = good();
  json second = scene(text);
  second["name"] = "soft";
  second["notes"] = {{"mirror_clip", "Why."}};
  second["truth"] = {{"light_radius", 0.1}};
  text["parts"]["mirror"]["scenes"].push_back(second);
  const Plan plan = read(text);
  ASSERT_EQ(plan.sweeps.size(), 2u);
  EXPECT_EQ(plan.sweeps[0].suffix, "");
  EXPECT_EQ(plan.sweeps[0].truth, json());
  EXPECT_EQ(plan.sweeps[0].numbers[0].note, "");
  EXPECT_EQ(plan.sweeps[1].numbers[0].note, "Why.");
  EXPECT_EQ(plan.sweeps[1].suffix, ".soft");
  EXPECT_EQ(plan.sweeps[1].truth, json({{"light_radius", 0.1}}));
}

TEST_F(TradeoffPlan, ASceneHasFramesBefore) {
  json text = good();
  EXPECT_THAT(read(text).sweeps[0].before, testing::IsEmpty());
  scene(text)["before"] = {0.25, {{"seconds", 0.1}, {"size", {32, 24}}}};
  EXPECT_THAT(read(text).sweeps[0].before,
              ElementsAre(rubric::Moment{0.25}, rubric::Moment{0.1, 32, 24}));
}

TEST_F(TradeoffPlan, SaysWhatIsBest) {
  json text = good();
  scene(text)["reference"] = {{"mirror_size", 64}};
  const Plan plan = read(text);
  EXPECT_EQ(referenceSetting(plan.sweeps[0]), json({{"mirror_clip", 1}, {"mirror_size", 64}}));
}

TEST_F(TradeoffPlan, IsCutDownToTheNumbersAskedFor) {
  json text = good();
  scene(text)["compare"] = {{{"name", "a"}, {"setting", {{"mirror_size", 64}}}},
                            {{"name", "b"}, {"setting", {{"mirror_clip", 1}}}}};
  Plan plan = read(text);
  ASSERT_EQ(plan.sweeps[0].compare.size(), 2u);
  keepOnly(plan, {"mirror_size"});
  ASSERT_EQ(plan.sweeps[0].compare.size(), 1u);
  EXPECT_EQ(plan.sweeps[0].compare[0].name, "a");
  ASSERT_EQ(plan.sweeps[0].numbers.size(), 1u);
  EXPECT_TRUE(plan.sweeps[0].together.empty());
  EXPECT_EQ(defaultSetting(plan.sweeps[0]), json({{"mirror_size", 1024}}));
  try {
    keepOnly(plan, {"fog"});
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "--only fog: no sweep has this number; there are: mirror_size");
  }
}

TEST_F(TradeoffPlan, ErrorsNameFileKeyAndValue) {
  json text = good();
  text["colour"] = 1;
  EXPECT_EQ(problemOf(text), ": colour: there is no such key here; there are: size, parts, "
                             "amounts, growth, saved");
  text = good();
  scene(text)["numbers"]["fog"] = {1};
  EXPECT_EQ(problemOf(text),
            ": parts.mirror.scenes[0].numbers.fog: scene.json has no such quality number");
  text = good();
  scene(text)["numbers"]["mirror_size"] = {64, "many"};
  EXPECT_EQ(problemOf(text),
            ": parts.mirror.scenes[0].numbers.mirror_size: \"many\" is not a number");
  text = good();
  scene(text)["numbers"]["mirror_size"] = {64, 64};
  EXPECT_EQ(problemOf(text), ": parts.mirror.scenes[0].numbers.mirror_size: 64 stands there twice");
  text = good();
  scene(text)["numbers"]["mirror_size"] = json::array();
  EXPECT_EQ(problemOf(text),
            ": parts.mirror.scenes[0].numbers.mirror_size: must be a list of numbers, but is []");
  text = good();
  scene(text)["together"] = json::array({{"mirror_size", "blur_samples"}});
  EXPECT_EQ(problemOf(text), ": parts.mirror.scenes[0].together: \"blur_samples\" is not one of "
                             "this scene's numbers");
  text = good();
  scene(text)["compare"] = {{{"name", "large"}, {"setting", {{"mirror_size", 3}}}}};
  EXPECT_EQ(problemOf(text), ": parts.mirror.scenes[0].compare[0].setting: {\"mirror_size\":3} is "
                             "not among the settings that are swept");
  scene(text)["compare"] = {{{"name", "large"}, {"setting", 3}}};
  EXPECT_EQ(problemOf(text),
            ": parts.mirror.scenes[0].compare[0].setting: must be an object, but is 3");
  text = good();
  scene(text)["time"] = -1;
  EXPECT_EQ(problemOf(text), ": parts.mirror.scenes[0].time: must be seconds from 0, but is -1");
  text = good();
  scene(text)["name"] = "a b";
  EXPECT_EQ(problemOf(text), ": parts.mirror.scenes[0].name: \"a b\" may hold small letters, "
                             "digits and _ only");
  text = good();
  text["parts"]["fog"] = text["parts"]["mirror"];
  EXPECT_EQ(problemOf(text), ": parts.fog: floor has no such part");
  text = good();
  text["amounts"] = {"fog"};
  EXPECT_EQ(problemOf(text), ": amounts: \"fog\" is not a number that is swept");
  text = good();
  text["growth"][0]["steps"][0] = {{"value", 0}};
  EXPECT_EQ(problemOf(text), ": growth[0].steps[0].value: must be above 0, but is 0");
  text = good();
  text["parts"]["mirror"].erase("off");
  EXPECT_EQ(problemOf(text), ": parts.mirror: lacks the key \"off\"");
  text = good();
  scene(text)["reference"] = {{"fog", 1}};
  EXPECT_EQ(problemOf(text), ": parts.mirror.scenes[0].reference.fog: there is no such key here; "
                             "there are: mirror_clip, mirror_size");
  text = good();
  text["parts"]["mirror"]["scenes"].push_back(scene(text));
  EXPECT_EQ(problemOf(text),
            ": parts.mirror.scenes[1].name: \"sharp\" is another scene of this part");
}

TEST_F(TradeoffPlan, ValuesMustBeAllowedByTheAssignment) {
  json text = good();
  scene(text)["numbers"]["mirror_size"] = {64, 99999};
  const std::string problem = problemOf(text);
  EXPECT_THAT(problem, HasSubstr("parts.mirror.scenes[0].numbers.mirror_size"));
  EXPECT_THAT(problem, HasSubstr("99999"));
  text = good();
  scene(text)["scene"] = {{"ring", {{"speed", 1}}}};
  EXPECT_THAT(problemOf(text), HasSubstr("ring.speed"));
}

TEST(TradeoffSphere, HasItsTrianglesOnTheUnitSphere) {
  const std::string text = sphereObj(8);
  std::size_t faces = 0;
  for (std::size_t at = text.find("\nf "); at != text.npos; at = text.find("\nf ", at + 1)) ++faces;
  EXPECT_DOUBLE_EQ(double(faces), sphereTriangles(8));
  EXPECT_THROW(sphereObj(1), std::invalid_argument);
}

} // namespace
