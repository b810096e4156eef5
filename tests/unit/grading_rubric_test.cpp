// The rubric engine: what the scenes, the scale and a missing frame make of a judge's verdict.

#include "rubric/rubric.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"

#include <gmock/gmock.h>

#include <limits>

using namespace ggrade;
using namespace ggrade::rubric;
using testing::ElementsAre;
using testing::FieldsAre;
using testing::HasSubstr;

namespace {

/// A one-pixel frame whose value is its quality, for a judge that reads it.
Image pixel(float quality) {
  return Image(1, 1, 3, quality);
}
const Judge kReads = [](const View& view) {
  return Verdict{double(view.frames.at(0).at(0, 0)), "as seen"};
};

SceneEvidence scene(const std::string& name, float student, float stub,
                    std::vector<std::string> tags = {"lecture"}) {
  SceneEvidence one;
  one.name = name;
  one.tags = std::move(tags);
  one.frameCount = 1;
  one.student = {pixel(student)};
  one.reference = {pixel(1)};
  one.stub = {pixel(stub)};
  return one;
}

ItemDeclaration item(results::ItemKind kind, std::vector<std::string> scenes = {"lecture"}) {
  ItemDeclaration declared;
  declared.id = "mirror.where";
  declared.kind = kind;
  declared.points = 20;
  declared.scenes = std::move(scenes);
  return declared;
}

/// Beside an item that is gained in scenes "lecture".
Decision decided(const ItemDeclaration& declared, std::vector<SceneEvidence> scenes,
                 const Judge& judge = kReads) {
  return decide(declared, {item(results::ItemKind::gain), declared}, judge,
                {{}, "mirror", std::move(scenes)});
}

TEST(Rubric, AGainIsTheMeanOverTheScenesAndTheWorstIsNamed) {
  const std::vector<SceneEvidence> scenes = {scene("a", 1, 0), scene("b", 0.25f, 0),
                                             scene("c", 0.5f, 0)};
  for (const auto kind : {results::ItemKind::gain, results::ItemKind::bonus}) {
    const Decision decision = decided(item(kind), scenes);
    EXPECT_DOUBLE_EQ(decision.credit, 1.75 / 3);
    EXPECT_EQ(decision.message, "b: as seen");
    EXPECT_THAT(decision.credits, ElementsAre(FieldsAre("a", 1, false), FieldsAre("b", 0.25, false),
                                              FieldsAre("c", 0.5, false)));
  }
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::keep), scenes).credit, 0.25)
      << "what was spoiled is so once";
}

TEST(Rubric, ScenesThatCannotShowTheItemDoNotRaiseItsMean) {
  SceneEvidence blank = scene("blank", 1, 1), cut = scene("cut", 1, 1);
  cut.frameCount = 2;
  const Decision lost = decided(item(results::ItemKind::gain), {blank, scene("b", 0.5f, 0), cut});
  EXPECT_DOUBLE_EQ(lost.credit, 0.5);
  EXPECT_THAT(lost.credits, ElementsAre(FieldsAre("b", 0.5, false)));
  EXPECT_EQ(lost.messages.size(), 1u);
}

TEST(Rubric, WhatIsWrongInOneSceneCostsHalfAtLeast) {
  std::vector<SceneEvidence> scenes(9, scene("a", 1, 0));
  scenes.push_back(scene("b", 0, 0));
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::gain), scenes).credit, 0.5);
  scenes.back() = scene("b", 0.25f, 0);
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::gain), scenes).credit, 0.625);
}

TEST(Rubric, ThePublicSceneCountsWhereNoHiddenOneShowsTheItem) {
  SceneEvidence known = scene("known", 1, 0);
  known.isPublic = true;
  const Decision typedIn = decided(item(results::ItemKind::gain), {known, scene("b", 0, 0)});
  EXPECT_DOUBLE_EQ(typedIn.credit, 0);
  EXPECT_THAT(typedIn.credits, ElementsAre(FieldsAre("known", 1, true), FieldsAre("b", 0, false)));
  known = scene("known", 0.5f, 0);
  known.isPublic = true;
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::gain), {known, scene("b", 1, 0)}).credit, 1);
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::gain), {known, scene("b", 0, 1)}).credit, 0.5);
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::keep), {known, scene("b", 1, 0)}).credit, 0.5);
}

TEST(Rubric, GainIsScaledBetweenStubAndReference) {
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::gain), {scene("a", 0.75f, 0.5f)}).credit, 0.5);
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::gain), {scene("a", 0.5f, 0.5f)}).credit, 0);
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::gain), {scene("a", 0.25f, 0.5f)}).credit, 0);
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::bonus), {scene("a", 0.75f, 0.5f)}).credit, 0.5);
}

TEST(Rubric, KeepIsTheQualityItself) {
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::keep), {scene("a", 0.75f, 1)}).credit, 0.75);
}

TEST(Rubric, ASceneThatTheStubFulfilsCannotShowTheItem) {
  const Decision decision =
      decided(item(results::ItemKind::gain), {scene("a", 0, 1), scene("b", 0.5f, 0)});
  EXPECT_DOUBLE_EQ(decision.credit, 0.5);
  EXPECT_THAT(decision.credits, ElementsAre(FieldsAre("b", 0.5, false)));
  EXPECT_EQ(messageOf<std::runtime_error>(
                [&] { decided(item(results::ItemKind::gain), {scene("a", 0, 1)}); }),
            "no scene can show mirror.where");
}

TEST(Rubric, ItemsLookAtTheScenesWithTheirTags) {
  const std::vector<SceneEvidence> scenes = {scene("a", 0.75f, 0), scene("b", 0.5f, 0, {"sunk"}),
                                             scene("c", 0.25f, 0, {"bonus"})};
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::gain, {"lecture"}), scenes).credit, 0.75);
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::gain, {"sunk", "bonus"}), scenes).credit, 0.375);
  // Without tags: all but bonus scenes.
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::keep, {}), scenes).credit, 0.5);
}

TEST(Rubric, AMissingFrameHasNoCredit) {
  SceneEvidence cut = scene("a", 1, 0);
  cut.frameCount = 2;
  const Decision decision = decided(item(results::ItemKind::gain), {cut});
  EXPECT_DOUBLE_EQ(decision.credit, 0);
  EXPECT_EQ(decision.message, "a: 1 of 2 frames came");
  // What never came harmed nothing.
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::keep), {cut}).credit, 1);
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::keep), {cut, scene("b", 0.5f, 0)}).credit, 0.5);
}

TEST(Rubric, AMissingFrameIsLostOnce) {
  SceneEvidence cut = scene("dim", 1, 1, {"dim"});
  cut.frameCount = 2;
  // Nobody else loses it.
  const ItemDeclaration keep = item(results::ItemKind::keep, {"lecture", "dim"});
  const Decision alone = decided(keep, {scene("a", 1, 0), cut});
  EXPECT_DOUBLE_EQ(alone.credit, 0);
  EXPECT_EQ(alone.message, "dim: 1 of 2 frames came");
  // In the scene that it is a change of it is lost already, if that one never came either.
  SceneEvidence base = scene("a", 1, 0);
  cut.like = base.name;
  EXPECT_DOUBLE_EQ(decided(keep, {base, cut}).credit, 0);
  base.frameCount = 2;
  EXPECT_DOUBLE_EQ(decided(keep, {base, cut}).credit, 1);
}

TEST(Rubric, AWindowOfAnotherSizeHasNoCredit) {
  SceneEvidence resized = scene("a", 1, 0);
  resized.student = {Image(2, 1, 3, 1.0f)};
  const Decision decision = decided(item(results::ItemKind::gain), {resized});
  EXPECT_DOUBLE_EQ(decision.credit, 0);
  EXPECT_EQ(decision.message, "a: the window is 2x1 instead of 1x1");
}

TEST(Rubric, ALaterFrameOfAnotherSizeHasNoCreditEither) {
  SceneEvidence resized = scene("a", 1, 0);
  resized.frameCount = 2;
  resized.student = {pixel(1), Image(2, 1, 3, 1.0f)};
  resized.reference = {pixel(1), pixel(1)};
  resized.stub = {pixel(0), pixel(0)};
  const Decision decision = decided(item(results::ItemKind::gain), {resized});
  EXPECT_DOUBLE_EQ(decision.credit, 0);
  EXPECT_EQ(decision.message, "a: the window is 2x1 instead of 1x1");
}

TEST(Rubric, QualityIsClampedAndMustBeFinite) {
  const auto always = [](double quality) {
    return [quality](const View&) { return Verdict{quality, ""}; };
  };
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::keep), {scene("a", 0, 0)}, always(7)).credit, 1);
  EXPECT_DOUBLE_EQ(decided(item(results::ItemKind::keep), {scene("a", 0, 0)}, always(-7)).credit,
                   0);
  for (double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THAT(messageOf<std::runtime_error>([&] {
                  decided(item(results::ItemKind::keep), {scene("a", 0, 0)}, always(bad));
                }),
                HasSubstr("not finite in scene a"));
}

TEST(Evidence, FramesSurviveTheWayThroughFiles) {
  const TemporaryFolder files;
  const RawFrame frame{0.25, 2, 1, {1, 2, 3, 4, 5, 6, 7, 8}};
  writeFrames(files.path() / "frames", {frame, frame});
  const std::vector<RawFrame> read = readFrames(files.path() / "frames");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[1].time, 0.25);
  EXPECT_EQ(read[1].width, 2u);
  EXPECT_EQ(read[1].height, 1u);
  EXPECT_EQ(read[1].pixels, frame.pixels);
  EXPECT_FLOAT_EQ(toImage(frame).at(1, 0, 2), 7 / 255.0f);
}

TEST(Evidence, AFileOfAnotherSizeThanItSaysIsRefused) {
  const TemporaryFolder files;
  writeFrames(files.path(), {{0, 2, 2, std::vector<std::uint8_t>(16)}});
  files.write("frame-0.rgba", std::string(12, '\0'));
  EXPECT_THAT(messageOf<UsageError>([&] { readFrames(files.path()); }),
              HasSubstr("frame-0.rgba: 12 bytes are not 2x2x4"));
  std::filesystem::remove(files.path() / "frame-0.rgba");
  EXPECT_THAT(messageOf<UsageError>([&] { readFrames(files.path()); }),
              HasSubstr("frame-0.rgba: 0 bytes are not 2x2x4"));
  EXPECT_THAT(messageOf<UsageError>([&] { readFrames("/nowhere"); }), HasSubstr("/nowhere"));
}

} // namespace
