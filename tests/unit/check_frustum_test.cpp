#include "check/frustum.hpp"
#include "trace_samples.hpp"

#include <gmock/gmock.h>

#include <limits>

using namespace ggrade;
using check::Frustum;
using check::frustumFault;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

trace::MatrixRecord identity(const char* name) {
  trace::MatrixRecord matrix{};
  std::strcpy(matrix.name, name);
  for (int i = 0; i < 4; ++i) matrix.values[i * 5] = 1;
  return matrix;
}

/// Depths alone are drawn by a camera at the origin that looks along -z.
trace::Trace map(const trace::MatrixRecord& projection, const trace::MatrixRecord& view) {
  trace::Trace trace = trace::samples::mirror();
  trace.passes[0].images[0] = {};
  trace.passes[0].images[trace::kDepth] = trace::samples::texture(GL_DEPTH_COMPONENT24, 2, 2);
  trace.steps[0].draws = 1;
  trace.steps[0].firstMatrix = std::uint32_t(trace.matrices.size());
  trace.steps[0].matrixCount = 2;
  trace.matrices.push_back(projection);
  trace.matrices.push_back(view);
  return trace;
}

trace::Trace map(float nearest, float farthest) {
  return map(trace::samples::perspective("uProjection", nearest, farthest), identity("uView"));
}

/// Holds what the reference sees: a square 4 away, and one corner of it 5 away.
Frustum held() {
  trace::Trace reference = map(2, 8);
  reference.copies.clear();
  const float d = trace::samples::depthAt(4, 2, 8), e = trace::samples::depthAt(5, 2, 8);
  trace::samples::addCopy<float>(reference, 0, trace::kDepth, trace::PixelType::f32x1, 2, 2,
                                 {d, d, d, e});
  Frustum frustum{"shadow.2", {"uProjection", "uView"}, {}, {}};
  EXPECT_TRUE(takePoints(frustum, reference));
  return frustum;
}

TEST(CheckFrustum, HoldsThePointsThatTheReferenceSees) {
  const Frustum frustum = held();
  ASSERT_EQ(frustum.points.size(), 4u);
  EXPECT_NEAR(frustum.points[0][0], -2, 1e-4); // half of the view at a distance of 4
  EXPECT_NEAR(frustum.points[0][1], 2, 1e-4);  // top row first
  EXPECT_NEAR(frustum.points[0][2], -4, 1e-4);
  EXPECT_NEAR(frustum.points[3][2], -5, 1e-4);
  EXPECT_NEAR(frustum.extent[0], 0.5, 1e-4);
  EXPECT_THAT(frustumFault(frustum, map(2, 8)), IsEmpty());
}

TEST(CheckFrustum, AnotherOneThatHoldsThemIsRight) {
  EXPECT_THAT(frustumFault(held(), map(0.1f, 20)), IsEmpty());
  EXPECT_THAT(frustumFault(held(), map(3.9f, 5.1f)), IsEmpty());
  trace::MatrixRecord wide = trace::samples::perspective("uProjection", 2, 8);
  wide.values[0] = wide.values[5] = 0.1f;
  EXPECT_THAT(frustumFault(held(), map(wide, identity("uView"))), IsEmpty());
}

TEST(CheckFrustum, NothingIsKnownOfMatricesThatAreNotItsOwn) {
  trace::Trace eyes = map(4.5f, 8);
  ASSERT_THAT(frustumFault(held(), eyes), Not(IsEmpty()));
  const trace::MatrixRecord projection = trace::samples::perspective("uProjection", 4.5f, 8);
  eyes.steps[1].draws = 1;
  eyes.steps[1].firstMatrix = std::uint32_t(eyes.matrices.size());
  eyes.steps[1].matrixCount = 1;
  eyes.matrices.push_back(projection);
  EXPECT_THAT(frustumFault(held(), eyes), IsEmpty()) << "the window is drawn with it";
  eyes.matrices.back().values[0] *= 2;
  EXPECT_THAT(frustumFault(held(), eyes), Not(IsEmpty()));
}

TEST(CheckFrustum, SaysWhatItLacks) {
  EXPECT_THAT(frustumFault(held(), map(4.5f, 8)), HasSubstr("75% of what the light should see lies "
                                                            "nearer than its near plane"));
  EXPECT_THAT(frustumFault(held(), map(1, 4.5f)), HasSubstr("25% of what the light should see lies "
                                                            "beyond its far plane"));
  EXPECT_THAT(frustumFault(held(), map(8, 4.5f)), HasSubstr("what is farther from the light gets a "
                                                            "smaller depth"));
  EXPECT_THAT(frustumFault(held(), map(0, 8)), HasSubstr("within 0% of the depths"));
  EXPECT_THAT(frustumFault(held(), map(1e-4f, 8)), HasSubstr("near plane too near"));
  trace::MatrixRecord narrow = trace::samples::perspective("uProjection", 2, 8);
  narrow.values[0] = 3;
  EXPECT_THAT(frustumFault(held(), map(narrow, identity("uView"))),
              HasSubstr("100% of what the light should see lies beside its frustum"));
  narrow.values[0] = 0.01f;
  EXPECT_THAT(frustumFault(held(), map(narrow, identity("uView"))), HasSubstr("its map's width"));
  trace::MatrixRecord back = identity("uView");
  back.values[0] = back.values[10] = -1;
  EXPECT_THAT(frustumFault(held(), map(trace::samples::perspective("uProjection", 2, 8), back)),
              HasSubstr("100% of what the light should see lies behind the camera"));
  back.values[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(frustumFault(held(), map(trace::samples::perspective("uProjection", 2, 8), back)),
              HasSubstr("NaN"));
}

TEST(CheckFrustum, IsSilentWhereThereIsNone) {
  EXPECT_THAT(frustumFault(held(), trace::samples::mirror()), IsEmpty()) << "colours, too";
  EXPECT_THAT(frustumFault(held(), {}), IsEmpty());
  EXPECT_THAT(frustumFault({}, map(4.5f, 8)), IsEmpty());
  EXPECT_THAT(frustumFault(held(), map(trace::samples::perspective("myProjection", 4.5f, 8),
                                       identity("myView"))),
              IsEmpty())
      << "other names";
  Frustum none{"shadow.2", {"uProjection", "uView"}, {}, {}};
  EXPECT_FALSE(takePoints(none, trace::samples::mirror()));
}

} // namespace
