// Random eyes and lamps in the room, against the truth. Counting behind the surfaces (z-fail) must
// be right from everywhere; counting before them (z-pass) where the near plane lies in no volume.

#include "extremes_room.hpp"

#include <iostream>
#include <random>

using namespace shadow_volume_extremes;
using glm::dvec3;

namespace {

/// One scene, and where its eye and lamp are.
struct View {
  json scene;
  bool eyeInVolume = false, nearPlaneInVolume = false, eyeInSolid = false, lampInSolid = false;
};

class Views {
public:
  explicit Views(unsigned seed) : engine_(seed) {}

  /// Blocks, knot and box by turns.
  View next() {
    json scene = room();
    const char* const meshes[] = {"blocks", "torus_knot", "box"};
    scene["mesh"] = meshes[count_++ % 3];
    if (scene["mesh"] != "blocks")
      scene["caster"] = {{"lift", between(0, 1.2)}, {"turn", between(-3, 3)}};
    scene["camera"] = {{"position", place()}, {"target", place()},        {"up", {0, 1, 0}},
                       {"near", 0.02},        {"fov", between(0.5, 1.6)}, {"far", 20}};
    scene["light"]["position"] = place();
    const Room asked(scene, 0, 128, 128);
    return {scene, asked.isHidden(asked.camera.eye), asked.nearPlaneIsHidden(),
            asked.isInCaster(asked.camera.eye), asked.isInCaster(asked.lamp)};
  }

private:
  /// Not std::uniform_real_distribution, which differs between libraries.
  double between(double low, double high) {
    return low + (high - low) * double(engine_()) / 0x1p32;
  }
  json place() {
    const double x = between(-2.7, 2.7), y = between(0.05, 5.4);
    return {x, y, between(0.05, 5.5)};
  }

  std::mt19937 engine_;
  unsigned count_ = 0;
};

Counts drawn(json scene, int method) {
  scene["quality"]["method"] = method;
  return countsOf(scene, 0, draw("shadow_volume", scene, {0}).frames.at(0));
}

std::size_t total(const std::vector<Counts>& all, std::size_t (Counts::*number)() const) {
  std::size_t sum = 0;
  for (const Counts& one : all) sum += (one.*number)();
  return sum;
}

class Anywhere : public testing::TestWithParam<unsigned> {
protected:
  void state(const std::string& what, const std::vector<Counts>& all) {
    const std::string text = std::to_string(total(all, &Counts::wrong)) + " of " +
                             std::to_string(total(all, &Counts::judged)) + " pixels wrong in " +
                             std::to_string(all.size()) + " views";
    std::cout << what << ": " << text << '\n';
    RecordProperty(what, text);
  }
};

constexpr unsigned kBatches = 10, kOften = 3; // the first few, however little time there is
constexpr int kViews = 20, kInVolume = 5;     // of a batch
INSTANTIATE_TEST_SUITE_P(ShadowVolume, Anywhere, testing::Range(0u, kOften));
INSTANTIATE_TEST_SUITE_P(LongShadowVolume, Anywhere, testing::Range(kOften, kBatches));

TEST_P(Anywhere, OutsideSolidsEveryPixelIsRight) {
  Views views(GetParam());
  std::vector<Counts> fail, passInAir, passInVolume, passAcross;
  int inVolume = 0, solids = 0;
  for (int i = 0; i < kViews;) {
    const View view = views.next();
    if (view.eyeInSolid || view.lampInSolid) {
      ++solids;
      continue;
    }
    if (i < kInVolume && !view.eyeInVolume) continue;
    ++i;
    inVolume += view.eyeInVolume;
    const Counts behind = drawn(view.scene, 1), before = drawn(view.scene, 0);
    EXPECT_EQ(behind.wrong(), 0u) << view.scene.dump();
    EXPECT_EQ(behind.strange, 0u) << view.scene.dump();
    fail.push_back(behind);
    (view.eyeInVolume         ? passInVolume
     : view.nearPlaneInVolume ? passAcross
                              : passInAir)
        .push_back(before);
    if (view.eyeInVolume && before.judged() > 1000) {
      EXPECT_GT(before.wrong(), 0u) << view.scene.dump();
    } else if (!view.nearPlaneInVolume) {
      EXPECT_EQ(before.wrong(), 0u) << view.scene.dump();
    }
  }
  EXPECT_GE(inVolume, kInVolume);
  EXPECT_GT(total(fail, &Counts::judged), 128u * 128 * kViews / 4);
  state("z-fail", fail);
  state("z-pass, near plane in no volume", passInAir);
  state("z-pass, eye in a volume", passInVolume);
  state("z-pass, near plane partly in a volume", passAcross);
  std::cout << solids << " views with the eye or the lamp in a solid left out\n";
}

TEST_P(Anywhere, InSolidsEveryPixelIsRight) {
  Views views(GetParam() + kBatches);
  std::vector<Counts> eyes, lamps;
  while (eyes.size() < 2 || lamps.size() < 2) {
    const View view = views.next();
    std::vector<Counts>& all = view.lampInSolid ? lamps : eyes;
    if ((!view.eyeInSolid && !view.lampInSolid) || all.size() == 2) continue;
    all.push_back(drawn(view.scene, 1));
    EXPECT_EQ(all.back().wrong(), 0u) << view.scene.dump();
    EXPECT_EQ(all.back().strange, 0u) << view.scene.dump();
    if (view.lampInSolid && !view.eyeInSolid) {
      EXPECT_EQ(all.back().lit, 0u) << "light leaves the solid";
    }
  }
  state("z-fail, eye in a solid", eyes);
  state("z-fail, lamp in a solid", lamps);
}

} // namespace
