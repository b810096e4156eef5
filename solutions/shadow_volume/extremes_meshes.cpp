// Casters of every kind from OBJ files, against the truth: open, turned over, folded, nested,
// degenerate; hundreds of volumes over a pixel; a million triangles.

#include "extremes_room.hpp"

#include "grading/workspace.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

using namespace shadow_volume_extremes;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

using glm::dvec3;

/// The text of an OBJ file.
class Obj {
public:
  /// Corners of its own, counterclockwise from the front; three or more.
  Obj& face(const std::vector<dvec3>& corners) {
    std::string indices;
    for (const dvec3& p : corners) {
      text_ += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
      indices += fmt::format(" {}", ++count_);
    }
    text_ += "f" + indices + "\n";
    return *this;
  }
  /// A box from corner to corner, all of its faces but those that `without` has a bit for, in the
  /// order of addFace() below.
  Obj& box(const dvec3& low, const dvec3& high, unsigned without = 0, bool turned = false) {
    unsigned bit = 1;
    const auto addFace = [&](std::vector<dvec3> corners) {
      if (turned) std::swap(corners[1], corners[3]);
      if (!(without & bit)) face(corners);
      bit <<= 1;
    };
    const dvec3 &a = low, &b = high;
    addFace({{a.x, b.y, a.z}, {a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}}); // top
    addFace({{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}}); // bottom
    addFace({{a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}, {b.x, a.y, a.z}}); // -z
    addFace({{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}); // +z
    addFace({{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}}); // -x
    addFace({{b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {b.x, a.y, b.z}}); // +x
    return *this;
  }
  const std::string& text() const { return text_; }

private:
  std::string text_;
  int count_ = 0;
};

constexpr unsigned kTop = 1, kFront = 4;
const dvec3 kLow(-0.5, 0, -0.5), kHigh(0.5, 1, 0.5);
const dvec3 kA(-0.5, 0, 0), kB(0.5, 0, 0), kC(-0.5, 1, 0), kD(0, 0.5, -0.7), kE(0, 0.2, 0.7);

/// The scene with this mesh for a caster, some way above the floor.
class Caster {
public:
  explicit Caster(const std::string& obj) {
    const auto file = folder_.path() / "caster.obj";
    ggrade::report::writeFile(file, obj);
    scene = room({{"mesh", file.string()}, {"caster", {{"lift", 0.4}, {"turn", 0.3}}}});
    scene["orbit"]["radius"] = 1.2;
  }
  json scene;

private:
  ggrade::grading::TemporaryFolder folder_;
};

/// Once round the middle of the room.
const std::vector<double> kTimes = {0, 3.7, 8.1, 12.9, 17.3};

struct Kind {
  const char* name;
  Obj obj;
  testing::Matcher<std::string> prints = IsEmpty();
};
void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.name;
}

/// A strip that is turned over once on its way round.
Obj moebius() {
  constexpr int kSteps = 15;
  const auto at = [](int i, double side) {
    const double turn = 2 * std::numbers::pi * (i % kSteps) / kSteps;
    if (i >= kSteps) side = -side;
    const double out = 1 + side * std::cos(turn / 2);
    return dvec3(out * std::cos(turn), side * std::sin(turn / 2), out * std::sin(turn));
  };
  Obj obj;
  for (int i = 0; i < kSteps; ++i) {
    obj.face({at(i, -0.4), at(i + 1, -0.4), at(i + 1, 0.4)});
    obj.face({at(i, -0.4), at(i + 1, 0.4), at(i, 0.4)});
  }
  return obj;
}

/// Boxes here and there, some in each other.
Obj crowd(int count) {
  Obj obj;
  for (int i = 0; i < count; ++i) {
    // Multiples of irrational numbers lie evenly.
    const auto part = [&](double step) { return i * step - std::floor(i * step); };
    const dvec3 low(part(std::numbers::sqrt2), part(std::numbers::sqrt3), part(std::numbers::phi));
    obj.box(low, low + dvec3(0.03, 0.04, 0.05));
  }
  return obj;
}

const auto kBack = HasSubstr("get a back");

class Mesh : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(
    ShadowVolume, Mesh,
    testing::Values(
        Kind{"ABoxWithoutATop", Obj().box(kLow, kHigh, kTop), kBack},
        Kind{"ABoxWithoutTopAndFront", Obj().box(kLow, kHigh, kTop | kFront), kBack},
        Kind{"OneTriangle", Obj().face({kA, kC, kB}), kBack},
        Kind{"OneTriangleFromBehind", Obj().face({kA, kB, kC}), kBack},
        Kind{"TwoTrianglesBackToBack", Obj().face({kA, kC, kB}).face({kA, kB, kC})},
        Kind{"ThreeFinsAtAnEdge", Obj().face({kA, kC, kB}).face({kB, kC, kD}).face({kB, kC, kE}),
             kBack},
        Kind{"BoxesThatShareAnEdge", Obj().box(kLow, {0, 0.6, 0}).box({0, 0, 0}, {0.5, 1, 0.5})},
        Kind{"BoxesThatShareAFace", Obj().box(kLow, {0, 1, 0.5}).box({0, 0, -0.5}, {0.5, 1, 0.5})},
        Kind{"BoxesThatShareACorner", Obj().box(kLow, {0, 0.5, 0}).box({0, 0.5, 0}, kHigh)},
        Kind{"BoxesThroughEachOther",
             Obj().box(kLow, {0.2, 0.7, 0.2}).box({-0.2, 0.3, -0.2}, kHigh)},
        Kind{"AHollowBox", Obj().box(kLow, kHigh).box({-0.4, 0.1, -0.4}, {0.4, 0.9, 0.4}, 0, true)},
        Kind{"ABoxInsideOut", Obj().box(kLow, kHigh, 0, true), HasSubstr("the mesh is inside out")},
        Kind{"ABoxWithAFaceTurnedOver",
             Obj().box(kLow, kHigh, kFront).box(kLow, kHigh, 0x3f & ~kFront, true), kBack},
        Kind{"AMoebiusStrip", moebius(), kBack},
        Kind{"AFaceTwice", Obj().box(kLow, kHigh).box(kLow, kHigh, 0x3f & ~kTop),
             HasSubstr("is there more than once; drawn once")},
        Kind{"ABoxTwice", Obj().box(kLow, kHigh).box(kLow, kHigh),
             AllOf(HasSubstr("and 11 more"), HasSubstr("drawn once"))},
        Kind{"TrianglesWithoutArea",
             Obj().box(kLow, kHigh).face({kA, kA, kC}).face({kA, kB, 0.5 * (kA + kB)})},
        Kind{
            "ACornerWithinAnEdge",
            Obj()
                .box(kLow, kHigh, kTop)
                .face({{-0.5, 1, -0.5}, {-0.5, 1, 0}, {0.5, 1, -0.5}})
                .face({{-0.5, 1, 0}, {-0.5, 1, 0.5}, {0.5, 1, 0.5}})
                .face({{-0.5, 1, 0}, {0.5, 1, 0.5}, {0.5, 1, -0.5}}),
            kBack},
        Kind{"Needles", Obj().box({-0.5, 0, 0}, {0.5, 1, 1e-6}).box({0, 0, -0.5}, {1e-6, 1, 0.5})},
        Kind{
            "AnEdgeThatNearlyMeets",
            Obj()
                .box(kLow, kHigh, kTop)
                .face({{-0.5, 1, -0.5}, {-0.5, 1, 0.5}, {0.5, 1.0000002, 0.5}, {0.5, 1, -0.5}}),
            kBack},
        Kind{"AThousandBoxes", crowd(1000)}),
    [](const auto& info) { return std::string(info.param.name); });

TEST_P(Mesh, ThrowsTheTruthsShadow) {
  Caster caster(GetParam().obj.text());
  for (const json& quality : {json{{"edges", 0}}, json{{"edges", 1}}}) {
    caster.scene["quality"].update(quality);
    const Counts counts = expectRight(caster.scene, kTimes, GetParam().prints);
    EXPECT_GT(counts.lit, 20000u);
    EXPECT_GT(counts.dark, 500u);
  }
}

/// So many boxes in each other. Between number 256 and the next one there is a gap, so that many
/// pixels of the floor lie in 256 volumes.
Obj nested(int count) {
  Obj obj;
  for (int i = 0; i < count; ++i) {
    const double half = i < 256 ? 0.5 - 0.1 * i / 256 : 0.3 - 0.1 * (i - 256) / 256;
    obj.box({-half, 0.5 - half, -half}, {half, 0.5 + half, half});
  }
  return obj;
}

class Nested : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(ShadowVolume, Nested, testing::Values(127, 128, 255, 256, 257, 300, 512));

TEST_P(Nested, VolumesAreAllCounted) {
  Caster caster(nested(GetParam()).text());
  for (const json& quality : {json{{"edges", 0}}, json{{"edges", 1}}, json{{"method", 0}}}) {
    caster.scene["quality"].update(quality);
    EXPECT_GT(expectRight(caster.scene, {0, 8.1}).dark, 3000u);
  }
}

/// A ring that lies flat.
///   around: corners of the whole ring;  across: of a cut through it
std::string ring(int around, int across) {
  std::string text;
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < across; ++k) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * k / across;
      const double out = 1 + 0.4 * std::cos(b);
      text += fmt::format("v {:.7f} {:.7f} {:.7f}\n", out * std::cos(a), 0.4 * std::sin(b),
                          out * std::sin(a));
    }
  const auto at = [&](int i, int k) { return i % around * across + k % across + 1; };
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < across; ++k)
      text +=
          fmt::format("f {} {} {} {}\n", at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
  return text;
}

TEST(ShadowVolume, HalfAMillionTriangles) {
#ifdef __SANITIZE_ADDRESS__
  const Caster caster(ring(200, 100)); // sanitized, more would take more time than a run has
#else
  const Caster caster(ring(700, 360));
#endif
  const Drawn drawn = draw("shadow_volume", caster.scene, {0});
  const Counts counts = countsOf(caster.scene, 0, drawn.frames.at(0));
  EXPECT_GT(counts.lit, 3000u);
  EXPECT_GT(counts.dark, 200u);
  EXPECT_LE(counts.wrong(), counts.judged() / 1000) << "of " << counts.judged();
}

} // namespace
