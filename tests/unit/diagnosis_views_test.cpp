#include "assignment/usage_error.hpp"
#include "diagnosis/views.hpp"
#include "diagnosis_samples.hpp"
#include "framework_temporary_folder.hpp"
#include "trace_samples.hpp"

#include <gmock/gmock.h>

#include <limits>

using namespace ggrade;
namespace fs = std::filesystem;
using namespace ggrade::diagnosis;
using testing::Each;
using testing::ElementsAre;
using testing::FloatNear;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(DiagnosisViews, ReducedKeepsTheMeanAndCompressesWhatIsBright) {
  Image image(320, 80, 3);
  for (int x = 0; x < 320; ++x)
    for (int y = 0; y < 80; ++y)
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = float(x % 2);
  const Image small = reduced(image, 3);
  EXPECT_EQ(small.sizeText(), "160x40");
  EXPECT_THAT(small.values(), Each(FloatNear(0.5f, 1e-5f)));
  Image odd(2, 1, 4);
  odd.at(0, 0, 0) = 4;
  odd.at(0, 0, 1) = -3;
  odd.at(1, 0, 0) = kNan;
  odd.at(1, 0, 2) = std::numeric_limits<float>::infinity();
  const Image kept = reduced(odd, 3);
  EXPECT_EQ(kept.at(0, 0, 0), 3);
  EXPECT_EQ(kept.at(0, 0, 1), -1);
  EXPECT_EQ(kept.at(1, 0, 0), -1);
  EXPECT_EQ(kept.at(1, 0, 2), 17);
}

TEST(DiagnosisViews, DepthIsStretched) {
  Image depth(3, 1, 1);
  depth.at(0, 0) = 0;
  depth.at(1, 0) = 0.99f;
  depth.at(2, 0) = 1;
  const Image out = stretchedDepth(depth);
  EXPECT_NEAR(out.at(0, 0), 0, 1e-4);
  EXPECT_NEAR(out.at(1, 0), 0.551, 1e-2);
  EXPECT_NEAR(out.at(2, 0), 1, 1e-6);
}

TEST(DiagnosisViews, APassIsFoundByWhatItIs) {
  trace::Trace trace = trace::samples::mirror();
  const std::vector<Image> frames = {samples::scene(8, 4)};
  const SceneViews mesh = views(frames, trace);
  ASSERT_EQ(mesh.windows.size(), 1u);
  ASSERT_EQ(mesh.passes.size(), 1u);
  EXPECT_TRUE(mesh.find({false, true, 0, 0}));
  // However many quads, they are no mesh.
  trace.steps[0].draws = 7;
  trace.steps[0].vertices = trace.passes[0].vertices = 42;
  const SceneViews quad = views(frames, trace);
  ASSERT_EQ(quad.passes.size(), 1u);
  EXPECT_TRUE(quad.find({false, false, 1, 0})); // 2 pixels of the window's 4
  EXPECT_EQ(describe(quad.passes[0].slot),
            "the texture without objects, at 1/2 of the window's size");
  EXPECT_TRUE(views({}, trace).passes.empty());
  // What is cleared in a pass of its own shows only where nothing is drawn into it later.
  trace.passes[0].draws = 0;
  EXPECT_EQ(views(frames, trace).passes.size(), 1u);
  trace.passes.insert(trace.passes.begin() + 1, trace.passes[0]);
  trace.passes[1].draws = 1;
  trace.passes[1].firstStep = trace.passes[1].stepCount = 0;
  EXPECT_TRUE(views(frames, trace).passes.empty()); // copied was the first alone
}

TEST(DiagnosisViews, WhatNoShaderWritesIsNoPicture) {
  const auto slots = [](std::uint32_t outputs) {
    trace::Trace trace = trace::samples::mirror();
    trace.copies.clear();
    trace.pixels.clear();
    trace.passes[0].images[1] = trace.passes[0].images[0];
    trace.passes[0].drawBuffers = 3;
    trace.passes[0].attachmentOfOutput[1] = 1;
    for (trace::StepRecord& step : trace.steps) step.outputs = outputs;
    const std::vector<float> grey(16, 0.5f);
    for (const std::uint32_t attachment : {0u, 1u})
      trace::samples::addCopy(trace, 0, attachment, trace::PixelType::f32x4, 2, 2, grey);
    std::vector<int> seen;
    for (const PassView& pass : views({samples::scene(8, 4)}, trace).passes)
      seen.push_back(pass.slot.nth);
    return seen;
  };
  EXPECT_THAT(slots(3), ElementsAre(0, 1));
  EXPECT_THAT(slots(1), ElementsAre(0));
  EXPECT_THAT(slots(2), ElementsAre(1)) << "the others keep their numbers";
}

TEST(DiagnosisViews, AnOutputIsTheSameWhereverItIsAttached) {
  // Two textures, one dark and one bright; the shader's outputs go to them in either order.
  const auto shown = [](std::uint8_t first, std::uint8_t second) {
    trace::Trace trace = trace::samples::mirror();
    trace.copies.clear();
    trace.pixels.clear();
    trace.passes[0].images[1] = trace.passes[0].images[0];
    trace.passes[0].drawBuffers = 3;
    std::ranges::fill(trace.passes[0].attachmentOfOutput, std::uint8_t(trace::kColors));
    trace.passes[0].attachmentOfOutput[0] = first;
    trace.passes[0].attachmentOfOutput[1] = second;
    const std::vector<float> dark(16, 0.25f), bright(16, 0.75f);
    trace::samples::addCopy(trace, 0, first, trace::PixelType::f32x4, 2, 2, dark);
    trace::samples::addCopy(trace, 0, second, trace::PixelType::f32x4, 2, 2, bright);
    return views({samples::scene(8, 4)}, trace);
  };
  for (const SceneViews& views : {shown(0, 1), shown(1, 0)}) {
    ASSERT_EQ(views.passes.size(), 2u);
    EXPECT_FLOAT_EQ(views.find({false, true, 0, 0})->picture.at(0, 0), 0.25f);
    EXPECT_FLOAT_EQ(views.find({false, true, 0, 1})->picture.at(0, 0), 0.75f);
  }
}

TEST(DiagnosisViews, FilesHoldWhatDiffersFromTheBase) {
  const TemporaryFolder folder;
  const SceneViews base = samples::views();
  SceneViews wrong = base;
  wrong.windows[1] = reduced(Image(320, 240, 3, 0.25f), 3);
  wrong.windows.pop_back();
  wrong.passes[1].picture = reduced(Image(100, 50, 3, 0.75f), 3);
  save(base, nullptr, folder.path() / "base");
  save(wrong, &base, folder.path() / "wrong");
  EXPECT_LT(fs::file_size(folder.path() / "wrong") * 2, fs::file_size(folder.path() / "base"));
  const SceneViews read = load(folder.path() / "wrong", &base);
  ASSERT_EQ(read.passes.size(), 2u);
  EXPECT_EQ(read.passes[0].slot, base.passes[0].slot);
  EXPECT_EQ(read.passes[1].width, 640);
  EXPECT_EQ(read.windows.size(), 1u);
  EXPECT_THAT(read.passes[1].picture.values(), Each(FloatNear(0.75f, 2e-4f)));
  for (std::size_t i = 0; i < base.windows[0].values().size(); ++i)
    ASSERT_NEAR(read.windows[0].values()[i], base.windows[0].values()[i], 2e-4f);
  fs::resize_file(folder.path() / "base", 100);
  EXPECT_THROW(load(folder.path() / "base", nullptr), UsageError);
}

} // namespace
