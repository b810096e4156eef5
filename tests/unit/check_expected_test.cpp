#include "check/expected.hpp"
#include "diagnosis_samples.hpp"
#include "framework_temporary_folder.hpp"

#include <gmock/gmock.h>

#include <fstream>

using namespace ggrade;
using namespace ggrade::check;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

Expected small() {
  Expected all;
  all.assignment = "floor";
  all.part = "mirror";
  all.todos = {"mirror.1"};
  all.scenes = {{"public", {{"size", {4, 3}}}, {0.25}, "", false},
                {"blurred", {{"size", {5, 6}}}, {1}, "mirror.1", true, 0, {"mirror.3"}},
                {"other", {}, {{{0.5}, {0.75, 8, 6}}, {1}}, "mirror.2", false}};
  diagnosis::SceneViews black = diagnosis::samples::views();
  black.windows[0] = diagnosis::reduced(Image(320, 240, 3, 0.0f), 3);
  const diagnosis::SceneViews right = diagnosis::samples::views();
  all.reference = {right, right, right};
  all.steps = {{black, right, right}, all.reference};
  all.frustum = {"mirror.1", {"uProjection", "uView"}, {{1, 2, 3}}, {0.9, 0.8, 0.5}};
  all.samplers = {{}, {{"uShadowMap", {true, 512, 256, true, false}}}};
  all.faults = {{"A title",
                 "A hint",
                 "A test",
                 "mirror.1",
                 {"mirror.2"},
                 1,
                 {0, 1},
                 {"x", "group", {black, right, {}}}}};
  all.others = {{right, black, right}};
  return all;
}

TEST(CheckExpected, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  save(small(), folder.path());
  const Expected all = load(folder.path());
  EXPECT_EQ(all.assignment, "floor");
  EXPECT_EQ(all.part, "mirror");
  EXPECT_THAT(all.todos, ElementsAre("mirror.1"));
  ASSERT_EQ(all.scenes.size(), 3u);
  EXPECT_EQ(all.scenes[0].scene.at("size"), nlohmann::json({4, 3}));
  EXPECT_EQ(all.scenes[0].times, rubric::Moments({0.25}));
  EXPECT_EQ(all.scenes[2].times, rubric::Moments({{0.5}, {0.75, 8, 6}}, {1}));
  EXPECT_EQ(all.scenes[1].todo, "mirror.1");
  EXPECT_FALSE(all.scenes[0].another);
  EXPECT_TRUE(all.scenes[1].another);
  EXPECT_THAT(all.scenes[1].also, ElementsAre("mirror.3"));
  EXPECT_EQ(readJson(sceneFile(folder.path(), 1)).at("size"), nlohmann::json({5, 6}));
  EXPECT_FALSE(std::filesystem::exists(sceneFile(folder.path(), 0)));
  ASSERT_EQ(all.steps.size(), 2u);
  EXPECT_NEAR(all.steps[0][0].windows[0].at(0, 0), 0, 1e-4); // 16 bits
  EXPECT_GT(all.steps[1][0].windows[0].at(0, 0), 0);
  EXPECT_THAT(all.samplers[1], ElementsAre(std::pair(
                                   "uShadowMap", diagnosis::Sampled{true, 512, 256, true, false})));
  ASSERT_EQ(all.faults.size(), 1u);
  EXPECT_EQ(all.faults[0].hint, "A hint");
  EXPECT_EQ(all.faults[0].experiment, "A test");
  EXPECT_THAT(all.faults[0].also, ElementsAre("mirror.2"));
  EXPECT_EQ(all.faults[0].step, 1u);
  EXPECT_THAT(all.faults[0].scenes, ElementsAre(0, 1));
  EXPECT_EQ(all.frustum.todo, "mirror.1");
  EXPECT_THAT(all.frustum.matrices, ElementsAre("uProjection", "uView"));
  EXPECT_EQ(all.frustum.points.at(0)[1], 2);
  EXPECT_EQ(all.frustum.extent[2], 0.5);
  EXPECT_EQ(all.faults[0].signature.group, "group");
  EXPECT_NEAR(viewsOf(all, 0, 0).windows[0].at(0, 0), 0, 1e-4);
  EXPECT_GT(viewsOf(all, 0, 1).windows[0].at(0, 0), 0);
  ASSERT_EQ(all.others.size(), 1u);
  EXPECT_GT(all.others[0][0].windows[0].at(0, 0), 0);
  EXPECT_NEAR(all.others[0][1].windows[0].at(0, 0), 0, 1e-4);
  // Not its TODO's scene: nothing is known, nor is a file written.
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "views/fault-0-2.views"));
}

TEST(CheckExpected, SaysWhichFileIsAtFault) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { load(folder.path()); }, ThrowsMessage<UsageError>(HasSubstr("expected.json")));
  save(small(), folder.path());
  std::filesystem::resize_file(folder.path() / "views/step-0-0.views", 40);
  EXPECT_THAT([&] { load(folder.path()); }, ThrowsMessage<UsageError>(HasSubstr("step-0-0.views")));
  std::ofstream(folder.path() / "expected.json") << "{\"assignment\": 3}";
  EXPECT_THAT([&] { load(folder.path()); }, ThrowsMessage<UsageError>(HasSubstr("expected.json")));
}

} // namespace
