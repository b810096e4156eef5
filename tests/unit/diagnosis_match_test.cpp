#include "diagnosis/match.hpp"
#include "diagnosis_samples.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
using namespace ggrade::diagnosis;
using samples::painted;
using samples::scene;
using testing::ElementsAre;

namespace {

const Image kDepth(64, 64, 1, 0.4f), kTexture = scene(256, 256), kFirst = scene(),
                                     kSecond = scene(320, 240, 0.05f);

/// A fault in a rectangle of the window, and if asked for of the texture.
Run fault(float left, float top, float right, float bottom, float value, bool texture = false) {
  const auto paint = [&](const Image& image) {
    return painted(image, left, top, right, bottom, value);
  };
  return {
      samples::views(kDepth, texture ? paint(kTexture) : kTexture, paint(kFirst), paint(kSecond))};
}

KnownFaults faults() {
  return {{samples::views()},
          {{"texture black", "", fault(0.2f, 0.5f, 0.6f, 0.8f, 0, true)},
           {"box white", "", fault(0.5f, 0.1f, 0.9f, 0.4f, 1)},
           {"box white, too", "", fault(0.5f, 0.1f, 0.9f, 0.4f, 0.999f)},
           {"edge grey", "", fault(0, 0, 0.1f, 1, 0.5f)}}};
}

TEST(DiagnosisMatch, DistanceIsTolerantAndCountsBothWays) {
  const Image grey(8, 8, 1, 0.5f), near(8, 8, 1, 0.51f), far(8, 8, 1, 0.9f);
  Image line = grey;
  for (int y = 0; y < 8; ++y) line.at(4, y) = 0.9f;
  const auto sum = [](const std::vector<float>& values) {
    float all = 0;
    for (const float value : values) all += value;
    return all;
  };
  EXPECT_EQ(sum(distance(&grey, &grey)), 0);
  EXPECT_EQ(sum(distance(&grey, &near)), 0);
  EXPECT_EQ(sum(distance(&grey, &far)), 64);
  EXPECT_EQ(sum(distance(&grey, &line)), 8);
  EXPECT_EQ(sum(distance(&line, &grey)), 8);
  EXPECT_EQ(sum(distance(&grey, nullptr)), 64);
  EXPECT_TRUE(distance(nullptr, nullptr).empty());
}

TEST(DiagnosisMatch, ASizeOfItsOwnIsNoFault) {
  const Image large = reduced(scene(512, 512), 3), small = reduced(scene(100, 100), 3);
  const std::vector<float> distances = distance(&large, &small);
  float sum = 0;
  for (const float value : distances) sum += value;
  EXPECT_LT(sum / float(distances.size()), 0.01f);
}

TEST(DiagnosisMatch, TheSameFaultIsFoundByEverything) {
  const auto found = faults().identify(fault(0.2f, 0.5f, 0.6f, 0.8f, 0, true));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->signature, 0u);
  EXPECT_EQ(found->by, Identified::By::everything);
  EXPECT_THAT(found->alike, ElementsAre());
  EXPECT_GT(found->likeness, 0.99);
  EXPECT_GT(found->confidence, 0.95);
}

TEST(DiagnosisMatch, FaultsThatShowTheSameAreNamedTogether) {
  const auto found = faults().identify(fault(0.5f, 0.1f, 0.9f, 0.4f, 1));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->signature, 1u);
  EXPECT_THAT(found->alike, ElementsAre(2u));
  EXPECT_LT(found->next, 0.2);
  EXPECT_NEAR(found->confidence, 0.5, 0.05) << "it is one of two";
  // Two names of one fault are one.
  KnownFaults known = faults();
  known.signatures[1].group = known.signatures[2].group = "box";
  EXPECT_GT(known.identify(fault(0.5f, 0.1f, 0.9f, 0.4f, 1))->confidence, 0.9);
}

TEST(DiagnosisMatch, AnUnknownFaultIsUnknown) {
  EXPECT_FALSE(faults().identify(fault(0.1f, 0.6f, 0.9f, 0.9f, 1)));
  EXPECT_FALSE(faults().identify({samples::views()}));
  std::vector<bool> leftOut = {false, true, true, false};
  EXPECT_FALSE(faults().identify(fault(0.5f, 0.1f, 0.9f, 0.4f, 1), {}, leftOut));
}

TEST(DiagnosisMatch, HalfWayBetweenTwoIsUnknown) {
  KnownFaults known = faults();
  known.signatures.push_back({"box higher", "", fault(0.5f, 0.07f, 0.9f, 0.37f, 1)});
  const diagnosis::Run between = fault(0.5f, 0.085f, 0.9f, 0.385f, 1);
  diagnosis::Thresholds thresholds;
  thresholds.confidence = 0.5; // how like each it is is another matter
  EXPECT_FALSE(known.identify(between, thresholds));
  // Said to be one diagnosis, it doesn't matter which.
  for (std::size_t i : {1u, 2u, 4u}) known.signatures[i].group = "box";
  EXPECT_TRUE(known.identify(between, thresholds));
  // What is likely, but not sure, is unknown.
  EXPECT_FALSE(known.identify(between));
}

/// The box of "box white" in the window, behind passes that hold something else.
Run boxBehind(const Image& depth, const Image& texture) {
  return {samples::views(depth, texture, painted(kFirst, 0.5f, 0.1f, 0.9f, 0.4f, 1),
                         painted(kSecond, 0.5f, 0.1f, 0.9f, 0.4f, 1))};
}

TEST(DiagnosisMatch, TheWindowSuffices) {
  // The depths are others, as those of another frustum in a program that is made in another way.
  const auto found =
      faults().identify(boxBehind(painted(kDepth, 0.2f, 0.2f, 0.7f, 0.7f, 0.8f), kTexture));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->signature, 1u);
  EXPECT_EQ(found->by, Identified::By::windows);
}

TEST(DiagnosisMatch, AFaultInTheWindowExplainsNoPassThatIsLost) {
  const Image wrong = painted(kTexture, 0.2f, 0.2f, 0.7f, 0.7f, 1);
  EXPECT_FALSE(faults().identify(boxBehind(kDepth, wrong)));
  // Of a level, so much may differ as another filter changes.
  const auto withLevel = [](diagnosis::Run run, float left) {
    run[0].passes.push_back(
        {{false, false, 1, 0}, 160, 120, reduced(painted(kFirst, left, 0, 1, 1, 1), 3)});
    return run;
  };
  KnownFaults known = faults();
  known.reference = withLevel(known.reference, 1);
  for (Signature& signature : known.signatures) signature.run = withLevel(signature.run, 1);
  const diagnosis::Run box = boxBehind(kDepth, kTexture);
  EXPECT_TRUE(known.identify(withLevel(box, 0.95f)));
  EXPECT_FALSE(known.identify(withLevel(box, 0.8f)));
}

TEST(DiagnosisMatch, APassThatIsRightHasNoFault) {
  // The windows are those of "texture black", but the texture isn't: something else is wrong.
  diagnosis::Run student = fault(0.2f, 0.5f, 0.6f, 0.8f, 0);
  EXPECT_FALSE(faults().identify(student));
  // Without that texture the program may be made in another way.
  std::erase_if(student[0].passes, [](const PassView& pass) { return !pass.slot.depth; });
  const auto found = faults().identify(student);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->signature, 0u);
  EXPECT_EQ(found->by, Identified::By::windows);
}

TEST(DiagnosisMatch, TheFirstWrongPassSuffices) {
  diagnosis::Run student = fault(0.2f, 0.5f, 0.6f, 0.8f, 0, true);
  student[0].windows = {reduced(Image(320, 240, 3, 0.2f), 3), reduced(Image(320, 240, 3, 0.2f), 3)};
  const auto found = faults().identify(student);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->signature, 0u);
  EXPECT_EQ(found->by, Identified::By::firstPass);
}

TEST(DiagnosisMatch, TheFirstWrongPictureAndItsPlace) {
  const diagnosis::Run reference = {samples::views()};
  EXPECT_FALSE(firstWrong(reference, reference));
  const auto texture = firstWrong(fault(0.2f, 0.5f, 0.6f, 0.8f, 0, true), reference);
  ASSERT_TRUE(texture);
  ASSERT_TRUE(texture->slot);
  EXPECT_EQ(describe(*texture->slot), "the texture that objects are drawn into");
  // The middle of a window in which all is wrong.
  EXPECT_GT(texture->x, 0.2);
  EXPECT_LT(texture->x, 0.6);
  EXPECT_GT(texture->y, 0.5);
  EXPECT_LT(texture->y, 0.8);
  EXPECT_NEAR(texture->share, 0.12, 0.02);
  const auto window = firstWrong(fault(0.5f, 0.1f, 0.9f, 0.4f, 1), reference);
  ASSERT_TRUE(window);
  EXPECT_FALSE(window->slot);
  diagnosis::Run without = reference;
  without[0].passes.erase(without[0].passes.begin());
  const auto missing = firstWrong(without, reference);
  ASSERT_TRUE(missing);
  EXPECT_TRUE(missing->missing);
  EXPECT_EQ(describe(*missing->slot), "the depth texture that objects are drawn into");
}

} // namespace
