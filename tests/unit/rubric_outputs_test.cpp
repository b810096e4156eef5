// Where failed items' passes have left what others build on: which scenes and pairs are offered,
// and which are not; and judging once more by first frames alone.

#include "rubric/rubric.hpp"

#include "trace_samples.hpp"

#include <gmock/gmock.h>

namespace ggrade::rubric {
namespace {

using nlohmann::json;
using testing::ElementsAre;

ItemDeclaration item(const std::string& id, const std::string& after,
                     std::vector<std::string> scenes = {"lecture"}) {
  ItemDeclaration declared;
  declared.id = id;
  declared.kind = results::ItemKind::gain;
  declared.points = 20;
  declared.after = after;
  declared.scenes = std::move(scenes);
  return declared;
}

/// "first" has a finder, "second" is after it, "third" after that, in scenes of its own.
const std::vector<ItemDeclaration> kItems = {
    item("outputs.first", ""), item("outputs.second", "outputs.first"),
    item("outputs.third", "outputs.second", {"late"}), item("outputs.alone", "")};
const bool kFound = [] {
  const Finder finder = [](const View& view) -> std::vector<PassOutput> {
    if (view.trace.passes.empty()) return {};
    return {{0, 0}};
  };
  return addFinder("outputs.first", finder) && addFinder("outputs.alone", finder);
}();

SceneEvidence scene(const std::string& name, const std::string& tag) {
  SceneEvidence one;
  one.name = name;
  one.tags = {tag};
  one.frameCount = 1;
  one.student = one.reference = one.stub = {Image(1, 1, 3)};
  one.studentTrace = one.referenceTrace = trace::samples::mirror();
  return one;
}

Decision failed(double credit = 0.2) {
  Decision decision;
  decision.credit = credit;
  return decision;
}

json outputs(const std::vector<SceneEvidence>& scenes, const Decision& decision = failed(),
             std::size_t declared = 0) {
  EXPECT_TRUE(kFound);
  return outputsOf(kItems[declared], kItems, decision, {{}, "mirror", scenes, {}});
}

const json kPair = json::parse(R"([{"scene": 0, "pairs": [[0, 0, 0, 0]]}])");

TEST(Outputs, AreOfferedWhereTheItemFailedAndALaterOneLooks) {
  EXPECT_EQ(outputs({scene("a", "lecture")}), kPair);
  const json two = outputs({scene("a", "other"), scene("b", "late"), scene("c", "lecture")});
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0]["scene"], 1) << "the third item is after the first one, too";
  EXPECT_EQ(two[1]["scene"], 2);
}

TEST(Outputs, OfAnItemThatNothingIsAfterOrThatHasNearlyAllAreNone) {
  EXPECT_EQ(outputs({scene("a", "lecture")}, failed(), 3), json());
  EXPECT_EQ(outputs({scene("a", "lecture")}, failed(), 1), json()) << "it has no finder";
  EXPECT_EQ(outputs({scene("a", "lecture")}, failed(0.9)), json());
}

TEST(Outputs, OfASceneWhereTheItemIsRightAreNone) {
  Decision decision = failed();
  decision.credits = {{"a", 0.95}, {"b", 0.2}};
  const json one = outputs({scene("a", "lecture"), scene("b", "lecture")}, decision);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0]["scene"], 1);
}

TEST(Outputs, ThatDoNotMatchTheReferencesAreNone) {
  const auto with = [](void (*change)(SceneEvidence&)) {
    SceneEvidence one = scene("a", "lecture");
    change(one);
    return outputs({one});
  };
  EXPECT_EQ(with([](SceneEvidence&) {}), kPair);
  EXPECT_EQ(with([](SceneEvidence& one) { one.studentTrace.passes[0].images[0].width = 4; }),
            json());
  EXPECT_EQ(with([](SceneEvidence& one) { one.studentTrace.passes[0].images[0].height = 4; }),
            json());
  EXPECT_EQ(
      with([](SceneEvidence& one) { one.studentTrace.passes[0].images[0].format = GL_RGBA8; }),
      json());
  EXPECT_EQ(with([](SceneEvidence& one) { one.studentTrace.passes[0].images[0].samples = 4; }),
            json());
  EXPECT_EQ(with([](SceneEvidence& one) {
              one.studentTrace.passes[0].images[0].kind =
                  static_cast<std::uint32_t>(trace::ImageKind::renderbuffer);
            }),
            json());
  EXPECT_EQ(with([](SceneEvidence& one) { one.referenceTrace.copies.clear(); }), json());
  EXPECT_EQ(with([](SceneEvidence& one) { one.studentTrace = {}; }), json());
  EXPECT_EQ(with([](SceneEvidence& one) { one.referenceTrace = {}; }), json());
  EXPECT_EQ(with([](SceneEvidence& one) { one.student.clear(); }), json()) << "it broke off";
}

TEST(Outputs, OfASecondJudgingAreNone) {
  EXPECT_EQ(outputsOf(kItems[0], kItems, failed(),
                      {{}, "mirror", {scene("a", "lecture")}, {"outputs.second"}}),
            json());
}

TEST(FirstFrames, AreAllThatIsLeft) {
  Evidence evidence{{}, "mirror", {scene("a", "lecture")}, {"outputs.second"}};
  SceneEvidence& one = evidence.scenes[0];
  one.frameCount = 2;
  one.student = {Image(1, 1, 3, 0.5F)};
  one.reference = one.stub = {Image(1, 1, 3, 1), Image(1, 1, 3)};
  one.probes["plain"] = one.reference;
  keepFirstFrames(evidence);
  EXPECT_EQ(one.frameCount, 1U);
  EXPECT_EQ(one.student.size(), 1U);
  EXPECT_EQ(one.reference.size(), 1U);
  EXPECT_EQ(one.stub.size(), 1U);
  EXPECT_EQ(one.probes.at("plain").size(), 1U);
}

TEST(FirstFrames, ThatCannotShowAnItemAreNoFault) {
  // The stub is as good as the reference there.
  const Judge full = [](const View& view) {
    return Verdict{&view.frames == &view.scene.student ? 0.5 : 1.0, "as seen"};
  };
  const Decision decision =
      decide(kItems[1], kItems, full, {{}, "mirror", {scene("a", "lecture")}, {"outputs.second"}});
  EXPECT_EQ(decision.credit, 0);
  EXPECT_TRUE(decision.credits.empty());
}

TEST(Messages, StandBesideTheCredits) {
  SceneEvidence late = scene("b", "lecture");
  late.student.clear();
  const Judge half = [](const View& view) {
    return Verdict{&view.frames == &view.scene.student ? 0.5 : 0.0, "half"};
  };
  const Decision decision =
      decide(kItems[1], kItems, half, {{}, "mirror", {scene("a", "lecture"), late}, {}});
  EXPECT_THAT(decision.messages, ElementsAre("half", "0 of 1 frames came"));
  EXPECT_EQ(lineOf(kItems[1], decision)["credits"],
            json::parse(R"([["a", 0.5, false, "half"], ["b", 0.0, false, "0 of 1 frames came"]])"));
}

} // namespace
} // namespace ggrade::rubric
