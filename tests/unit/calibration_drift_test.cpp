#include "calibration/drift.hpp"

#include <gmock/gmock.h>

using namespace ggrade::calibration;
using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

json program(const std::string& name, std::vector<double> scores, bool accepted = true) {
  json all = json::array();
  for (const double score : scores)
    all.push_back({{"seed", all.size()}, {"outcome", "graded"}, {"score", score}, {"bonus", 0.0}});
  return {{"name", name}, {"accepted", accepted}, {"scores", all}};
}

json calibrationOf(const std::vector<json>& programs) {
  return {{"parts", {{{"part", "mirror"}, {"programs", programs}}}}};
}

TEST(Drift, NoneIsFoundWhereNothingMoved) {
  const json all = calibrationOf({program("reference", {100, 100}), program("flat", {40, 41})});
  const Drift drift = driftOf("egl", all, all);
  EXPECT_EQ(drift.gradings, 4U);
  EXPECT_EQ(drift.moved, 0U);
  EXPECT_EQ(drift.furthest, 0);
  EXPECT_THAT(drift.failures, IsEmpty());
}

TEST(Drift, AScoreMayMoveByHalfAPoint) {
  const json before = calibrationOf({program("reference", {100, 100}), program("flat", {40})});
  const json after = calibrationOf({program("reference", {99.5, 100}), program("flat", {40.75})});
  const Drift drift = driftOf("egl", before, after);
  EXPECT_EQ(drift.moved, 2U);
  EXPECT_EQ(drift.furthest, 0.75);
  EXPECT_EQ(drift.where, "mirror/flat");
  EXPECT_THAT(drift.failures, ElementsAre("mirror/flat, seed 0: the score moved by 0.75"));
  EXPECT_THAT(driftOf("refused", before, after, kNoLimit).failures, IsEmpty());
}

TEST(Drift, NoVerdictNorOutcomeMayChange) {
  const json before =
      calibrationOf({program("a", {100}), program("b", {100}), program("c", {100})});
  json after = calibrationOf({program("a", {100}, false), program("b", {100})});
  after["parts"][0]["programs"][1]["scores"][0]["outcome"] = "crash";
  EXPECT_THAT(driftOf("egl", before, after).failures,
              ElementsAre("mirror/a: another verdict", "mirror/b, seed 0: graded became crash",
                          "mirror/c: not graded as often"));
}

} // namespace
