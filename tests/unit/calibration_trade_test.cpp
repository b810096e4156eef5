// What looking less closely costs, and what one number for a picture is worth, on answers made up
// for it. Expected values are worked out by hand.

#include "calibration/classifier.hpp"
#include "calibration/measure.hpp"
#include "calibration/subject.hpp"
#include "calibration/tolerances.hpp"
#include "calibration/trade.hpp"
#include "calibration/whole_image.hpp"
#include "grading/judge.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"

#include <gmock/gmock.h>

#include <limits>

using namespace ggrade;
using namespace ggrade::calibration;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Classifier, TheAreaUnderTheRocCurveCountsPairsInOrder) {
  const auto area = [](std::vector<double> right, std::vector<double> wrong) {
    std::vector<Rated> all;
    for (double value : right) all.push_back({true, 0, value});
    for (double value : wrong) all.push_back({false, 1, value});
    return areaUnderRoc(all);
  };
  EXPECT_EQ(area({1, 2}, {3, 4}), 1);
  EXPECT_EQ(area({3, 4}, {1, 2}), 0);
  EXPECT_EQ(area({1, 3}, {2, 4}), 0.75);  // 1 < 2, 1 < 4, 3 < 4 of four pairs
  EXPECT_EQ(area({1, 2}, {2, 3}), 0.875); // the equal pair counts half
  EXPECT_EQ(area({0, 0, 0}, {0}), 0.5);
  EXPECT_EQ(area({0, kInfinity}, {kInfinity}), 0.75);
  EXPECT_EQ(area({1}, {}), std::nullopt);
}

TEST(Classifier, AThresholdIsChosenOnOneHalfAndJudgedOnTheOther) {
  // Right ones 1, 2, 9 and wrong ones 4, 5, 6, 7 in the first half: at 3 one of three right ones is
  // rejected and no wrong one accepted, sum 1/3. Above 9 all wrong ones are accepted, sum 1.
  std::vector<Rated> all;
  for (double value : {1, 2, 9}) all.push_back({true, 0, value});
  for (double value : {4, 5, 6, 7}) all.push_back({false, 0, value});
  // The other half: 2.9 is right and below, 3.5 right and above; 3 and 0 wrong and below.
  for (double value : {2.9, 3.5}) all.push_back({true, 1, value});
  for (double value : {3.0, 0.0, 8.0, kInfinity}) all.push_back({false, 1, value});
  EXPECT_EQ(chooseThreshold(all, 0), 3);
  EXPECT_EQ(errorsOf(all, 0, 3), (Errors{3, 1, 4, 0}));
  EXPECT_EQ(errorsOf(all, 1, 3), (Errors{2, 1, 4, 2}));
  // There 3.5 rejects nothing and accepts two of four; 0 and 2.9 reject one or two of two as well.
  EXPECT_EQ(chooseThreshold(all, 1), (3.5 + 8) / 2);
}

TEST(Classifier, SharesCountWhenOneKindIsRare) {
  // One right answer among ten wrong ones: rejecting it would be one error, accepting it two.
  std::vector<Rated> all = {{true, 0, 5}, {false, 0, 1}, {false, 0, 2}};
  for (int i = 0; i < 8; ++i) all.push_back({false, 0, 10});
  EXPECT_EQ(chooseThreshold(all, 0), 7.5);
  EXPECT_EQ(chooseThreshold(all, 1), 0); // no answers
}

TEST(Classifier, WilsonsUpperBound) {
  // For 0 of n it is z^2 / (n + z^2), with z^2 = 3.841458820694124.
  EXPECT_NEAR(upperBound(0, 10), 3.841458820694124 / 13.841458820694124, 1e-12);
  EXPECT_NEAR(upperBound(0, 100), 0.0369936, 1e-6);
  // 1 of 10: (0.1 + 0.19207294 + 1.95996398 sqrt(0.009 + 0.0096036471)) / 1.3841459
  EXPECT_NEAR(upperBound(1, 10), 0.4041500, 1e-6);
  EXPECT_NEAR(upperBound(10, 10), 1, 1e-12);
  EXPECT_EQ(upperBound(0, 0), 1);
}

grading::ScenePlan plan() {
  grading::ScenePlan made;
  made.scenes.resize(3);
  const char* names[] = {"public", "a", "b"};
  for (std::size_t i = 0; i < 3; ++i) {
    made.scenes[i].name = names[i];
    made.scenes[i].scene = {{"size", {61, 40}}, {"quality", {{"shadow_size", 160}}}};
  }
  made.scenes[0].isPublic = true;
  made.scenes[1].probes["floor"] = {{"size", {61, 40}}};
  made.scenes[2].scene["size"] = {3, 1};
  return made;
}

TEST(Look, HiddenWindowsAreScaledAndNothingElse) {
  grading::ScenePlan scaled = plan();
  scaleWindows(scaled, 0.25);
  EXPECT_EQ(scaled.scenes[0].scene, plan().scenes[0].scene);
  EXPECT_EQ(scaled.scenes[1].scene.at("size"), nlohmann::json({15, 10}));
  EXPECT_EQ(scaled.scenes[1].scene.at("quality"), plan().scenes[1].scene.at("quality"));
  EXPECT_EQ(scaled.scenes[1].probes.at("floor").at("size"), nlohmann::json({15, 10}));
  EXPECT_EQ(scaled.scenes[2].scene.at("size"), nlohmann::json({1, 1}));
  scaled.scenes[1].scene.erase("size");
  EXPECT_EQ(messageOf<UsageError>([&] { scaleWindows(scaled, 2); }),
            "scene \"a\" has no size that could be scaled");
}

TEST(Look, FewerHiddenScenesAreTheFirstOnes) {
  EXPECT_EQ(scenesUpTo(plan(), 0), 1u);
  EXPECT_EQ(scenesUpTo(plan(), 1), 2u);
  EXPECT_EQ(scenesUpTo(plan(), 2), 3u);
  EXPECT_EQ(scenesUpTo(plan(), 9), 3u);
}

TEST(Look, HasAName) {
  EXPECT_EQ(nameOf(Look{}), "balanced");
  EXPECT_EQ(nameOf(Look{grading::Quality::fast, 0.75, 1}), "fast, windows x 0.75, 1 hidden scene");
}

TEST(Look, ScenesThatAreNotLookedAtCostNothing) {
  results::Item gain, keep, unjudged;
  gain.points = 20;
  gain.earned = 0;
  gain.judged = true;
  gain.credits = {{"public", 0.9, true}, {"a", 0.255}, {"b", 0}};
  gain.messages = {"some", "much", "all"};
  keep.kind = results::ItemKind::keep;
  keep.points = 40;
  keep.earned = -40;
  keep.judged = true;
  keep.credits = {{"b", 0}};
  keep.messages = {"all"};
  unjudged.points = 10;
  std::vector<results::Item> items = {gain, keep, unjudged};
  grading::keepScenes(items, {"public", "a"});
  EXPECT_EQ(items[0].earned, 5.1);
  EXPECT_EQ(items[0].message, "a: much");
  EXPECT_EQ(items[0].credits.size(), 2u);
  EXPECT_EQ(items[0].messages, (std::vector<std::string>{"some", "much"}));
  EXPECT_EQ(items[1].earned, 0);
  EXPECT_EQ(items[1].message, "no scene shows it");
  EXPECT_EQ(items[2].earned, 0); // was never judged
}

/// Frames of one colour.
void writeScene(const std::filesystem::path& folder, const std::vector<std::uint8_t>& values,
                std::uint32_t side = 16) {
  std::vector<rubric::RawFrame> frames;
  for (std::uint8_t value : values)
    frames.push_back(
        {0, side, side, std::vector<std::uint8_t>(std::size_t(side) * side * 4, value)});
  rubric::writeFrames(folder, frames);
}

TEST(WholeImage, TheWorstHiddenPictureCounts) {
  const TemporaryFolder files;
  std::vector<rubric::SceneFolders> scenes(3);
  const auto write = [&](std::size_t i, std::vector<std::uint8_t> student,
                         std::vector<std::uint8_t> reference) {
    scenes[i].student = files.path() / ("student" + std::to_string(i));
    scenes[i].reference = files.path() / ("reference" + std::to_string(i));
    writeScene(scenes[i].student, student);
    writeScene(scenes[i].reference, reference);
  };
  write(0, {0, 0}, {255, 255}); // the public scene, entirely wrong
  scenes[0].isPublic = true;
  write(1, {100, 100}, {100, 103}); // within the tolerance
  write(2, {51}, {102});
  const auto measured = measurePictures(scenes);
  ASSERT_EQ(measured.size(), wholeImages().size());
  EXPECT_NEAR(measured.at("RMSE").worst, 0.2, 1e-6);
  // Of even pictures SSIM is its first factor: (2ab + 0.01^2) / (a^2 + b^2 + 0.01^2).
  EXPECT_NEAR(measured.at("1 - SSIM").worst, 1 - 0.1601 / 0.2001, 1e-4);
  EXPECT_GT(measured.at("FLIP, mean").worst, 0.1);
  EXPECT_EQ(measured.at("pixels that differ").worst, 1);
  EXPECT_EQ(measured.at("wrong pixels").worst, 1);
  EXPECT_GT(measured.at("densest window").worst, 0);
  for (const auto& [name, error] : measured) EXPECT_GT(error.ms, 0) << name;

  write(2, {102}, {102});
  const auto right = measurePictures(scenes);
  EXPECT_NEAR(right.at("RMSE").worst, 3 / 255.0, 1e-6);
  EXPECT_EQ(right.at("pixels that differ").worst, 0);
  EXPECT_EQ(right.at("wrong pixels").worst, 0);
  EXPECT_EQ(right.at("densest window").worst, 0);

  write(1, {100}, {100, 103});
  EXPECT_THAT(measurePictures(scenes), IsEmpty()) << "a frame is missing";
  write(1, {100, 100}, {100, 103});
  writeScene(scenes[2].student, {102}, 8);
  EXPECT_THAT(measurePictures(scenes), IsEmpty()) << "another size";
}

TEST(ScoreFile, KeepsWhatMeasuresSay) {
  const TemporaryFolder files;
  Score score;
  score.judgeMs = 1.5;
  score.measures["RMSE"] = {0.25, 3};
  saveScore(files.path() / "score.json", score);
  EXPECT_EQ(loadScore(files.path() / "score.json"), score);
}

TEST(TradePlan, RowsThatAreTheSameShareTheirGradings) {
  const TradePlan plan = tradePlan(3);
  const Look& balanced = plan.looks.at(0);
  EXPECT_EQ(balanced, (Look{grading::Quality::balanced, 1, {}, true, true}));
  std::vector<std::string> names, shared;
  for (const TradeSetting& setting : plan.settings) {
    names.push_back(setting.sweep + ": " + setting.name);
    if (setting.look == 0) shared.push_back(setting.name);
    EXPECT_TRUE(plan.looks.at(setting.look).twice);
  }
  EXPECT_THAT(names,
              ElementsAre("quality: fast", "quality: balanced", "quality: thorough",
                          "window size: 1/4", "window size: 1/2", "window size: 3/4",
                          "window size: whole", "hidden scenes: 0 of 3", "hidden scenes: 1 of 3",
                          "hidden scenes: 2 of 3", "hidden scenes: all 3"));
  EXPECT_THAT(shared, ElementsAre("balanced", "whole", "all 3"));
  EXPECT_EQ(plan.looks.size(), 9u);
  EXPECT_EQ(plan.looks.at(plan.settings[3].look).scale, 0.25);
  EXPECT_EQ(plan.looks.at(plan.settings[9].look).hidden, 2u);
}

std::vector<ItemDeclaration> items() {
  ItemDeclaration shape, soft;
  shape.id = "p.shape";
  shape.kind = results::ItemKind::gain;
  shape.points = 100;
  soft.id = "p.soft";
  soft.kind = results::ItemKind::bonus;
  soft.points = 10;
  return {shape, soft};
}

/// A program that was graded once: it lost so many points, and its worst picture is off by so much.
Measured answer(Kind kind, const std::string& name, double lost, double error, double seconds) {
  Measured made;
  made.program.kind = kind;
  made.program.name = name;
  if (kind == Kind::mistake) made.program.fails = "p.shape";
  Score score;
  score.seed = 7;
  score.score = 100 - lost;
  score.bonus = 10;
  score.earned = {{"p.shape", 100 - lost}, {"p.soft", 10}};
  score.seconds = seconds;
  score.judgeMs = 4;
  for (const WholeImage& one : wholeImages()) score.measures[one.name] = {error, 2};
  made.scores = {score};
  return made;
}

/// A name in each half.
std::string inHalf(int half, const std::string& prefix) {
  for (char c = 'a';; ++c)
    if (halfOf(prefix + c) == half) return prefix + c;
}

class Trading : public testing::Test {
protected:
  /// Two looks: closely, everything is told apart; at a glance, one mistake isn't seen.
  Trade trade() const {
    TradePlan plan;
    plan.looks = {Look{}, Look{}};
    plan.settings = {
        {"quality", "glance", 1}, {"quality", "close", 0}, {"window size", "whole", 0}};
    std::vector<Measured> close = {
        answer(Kind::variant, right_[0], 1, 0.1, 1), answer(Kind::variant, right_[1], 0, 0.5, 2),
        answer(Kind::mistake, wrong_[0], 70, 0.4, 3), answer(Kind::mistake, wrong_[1], 80, 0.6, 4)};
    close.push_back(answer(Kind::variant, "p_lecture", 40, 0.9, 5));
    close.back().program.loses = {"p.shape"};
    std::vector<Measured> glance = close;
    glance[2] = answer(Kind::mistake, wrong_[0], 10, 0.4, 0.5);
    return tradeOf("p", items(), plan, {close, glance});
  }

  const std::string right_[2] = {inHalf(0, "p_r"), inHalf(1, "p_r")};
  const std::string wrong_[2] = {inHalf(0, "p_w"), inHalf(1, "p_w")};
};

TEST_F(Trading, EachRowHasItsErrorsTimeAndMargin) {
  const Trade made = trade();
  EXPECT_THAT(made.seeds, ElementsAre(7));
  ASSERT_EQ(made.rows.size(), 3u);
  const TradeRow &glance = made.rows[0], &close = made.rows[1];
  EXPECT_EQ(close.errors, (Errors{3, 0, 2, 0}));
  EXPECT_EQ(close.seconds.median, 3);
  EXPECT_EQ(close.seconds.q1, 2);
  EXPECT_EQ(close.seconds.q3, 4);
  EXPECT_EQ(close.lowestRight, 99); // what the lecture's may lose is given back
  EXPECT_EQ(close.highestWrong, 30);
  EXPECT_EQ(close.margin(), 69);
  EXPECT_EQ(glance.errors, (Errors{3, 0, 2, 1}));
  EXPECT_EQ(glance.seconds.median, 2);
  EXPECT_EQ(glance.margin(), 9);
  EXPECT_THAT(glance.failures, ElementsAre(HasSubstr("p.shape loses 10 of 100 points")));
  EXPECT_EQ(made.rows[2].errors, close.errors);
}

TEST_F(Trading, AMeasureIsJudgedByAThresholdThatTheOtherHalfChose) {
  const Trade made = trade();
  EXPECT_THAT(made.leftOut, ElementsAre("p_lecture"));
  ASSERT_EQ(made.measures.size(), wholeImages().size() + 2);
  const MeasureRow& rmse = made.measures[0];
  // First half: 0.1 right, 0.4 wrong, so 0.25; it rejects the second half's right 0.5. Second half:
  // 0.5 right, 0.6 wrong, so 0.55; it accepts the first half's wrong 0.4.
  ASSERT_TRUE(rmse.thresholds);
  EXPECT_NEAR((*rmse.thresholds)[0], 0.25, 1e-12);
  EXPECT_NEAR((*rmse.thresholds)[1], 0.55, 1e-12);
  EXPECT_EQ(rmse.errors, (Errors{2, 1, 2, 1}));
  EXPECT_EQ(rmse.area, 0.75); // 0.5 against 0.4 is the wrong way round
  EXPECT_EQ(rmse.ms, 2);
  const MeasureRow& points = made.measures[made.measures.size() - 2];
  EXPECT_EQ(points.name, "rubric: points lost");
  EXPECT_EQ(points.errors, (Errors{2, 0, 2, 0}));
  EXPECT_EQ((*points.thresholds)[0], 35.5); // 1 and 70
  EXPECT_EQ(points.area, 1);
  EXPECT_EQ(points.ms, 4);
  const MeasureRow& limits = made.measures.back();
  EXPECT_EQ(limits.errors, (Errors{2, 0, 2, 0}));
  EXPECT_FALSE(limits.thresholds);
  EXPECT_FALSE(limits.area);
}

TEST_F(Trading, WhatDrewNoPictureLooksWorstOfAll) {
  TradePlan plan;
  plan.looks = {Look{}};
  std::vector<Measured> all = {answer(Kind::variant, right_[0], 0, 0.5, 1),
                               answer(Kind::mistake, wrong_[0], 0, 0, 1)};
  all[1].scores[0].measures.clear();
  const Trade made = tradeOf("p", items(), plan, {all});
  EXPECT_EQ(made.measures[0].area, 1);
  EXPECT_EQ(made.measures[made.measures.size() - 2].area, 1);
}

TEST_F(Trading, AProgramNeedNotCrashWhereTheSceneInWhichItDoesIsLeftOut) {
  TradePlan plan;
  plan.looks = {Look{}, Look{}};
  plan.looks[1].hidden = 1;
  plan.settings = {{"quality", "balanced", 0}, {"hidden scenes", "1 of 2", 1}};
  Measured lecture = answer(Kind::variant, right_[0], 0, 0, 1);
  lecture.program.outcome = results::Outcome::crash;
  const Trade made = tradeOf("p", items(), plan, {{lecture}, {lecture}});
  EXPECT_EQ(made.rows[0].errors, (Errors{1, 1, 0, 0}));
  EXPECT_EQ(made.rows[1].errors, (Errors{1, 0, 0, 0}));
  lecture.scores[0].outcome = results::Outcome::timeout;
  EXPECT_EQ(tradeOf("p", items(), plan, {{lecture}, {lecture}}).rows[1].errors,
            (Errors{1, 1, 0, 0}));
}

TEST_F(Trading, TextJsonAndCsvSayTheSame) {
  Trade made = trade();
  made.hiddenScenes = {"another view", "low light"};
  const auto json = toJson(made);
  EXPECT_EQ(json.at("rows").at(0).at("wrong_taken_for_right"), 1);
  EXPECT_NEAR(json.at("rows").at(0).at("wrong_taken_for_right_at_most"), upperBound(1, 2), 1e-12);
  EXPECT_EQ(json.at("rows").at(0).at("seconds").at("q1"), 1);
  EXPECT_EQ(json.at("rows").at(0).at("margin"), 9);
  EXPECT_EQ(json.at("measures").at(0).at("roc_area"), 0.75);
  EXPECT_EQ(json.at("left_out_of_measures"), nlohmann::json({"p_lecture"}));
  const std::string csv = csvOf({made});
  EXPECT_THAT(csv, HasSubstr("\np,quality,glance,3,0,2,1,2,1,4,99.0,90.0,9.0,,\n"));
  EXPECT_THAT(csv, HasSubstr("\np,measure,RMSE,2,1,2,1,,,,,,,0.75,2\n"));
  EXPECT_THAT(csv, HasSubstr("\np,measure,\"FLIP, mean\",2,1,2,1,"));
  const std::string text = textOf(made);
  EXPECT_THAT(text, AllOf(HasSubstr("p, seeds 7\n"), HasSubstr("2.00 (1.00 to 4.00)"),
                          HasSubstr("1 of 2 (90.5%)"), HasSubstr("35.5, "), HasSubstr("fixed")));
  const auto sections = sectionsOf(made);
  ASSERT_EQ(sections.size(), 4u);
  EXPECT_EQ(sections[0].rows.size(), 2u);
  EXPECT_THAT(sections[2].text, HasSubstr("Their order is: another view; low light."));
  EXPECT_THAT(sections[3].text, HasSubstr("(p_lecture)"));
  // Three dots, of which the one that errs is a ring; what stands in two sweeps has one name.
  EXPECT_THAT(sections[0].chart,
              AllOf(HasSubstr(">close</text>"), Not(HasSubstr(">whole</text>"))));
  EXPECT_THAT(sections[0].chart,
              AllOf(HasSubstr("<svg class=\"plot\""), HasSubstr("<circle class=\"one errs\""),
                    HasSubstr("quality: glance, 2 s, margin 9, 0 right and 1 wrong answers "
                              "misjudged"),
                    HasSubstr("<circle class=\"two\"")));
  PagePart part;
  part.title = "Part one";
  part.sections = sections;
  part.alone = "the trade";
  EXPECT_THAT(calibrationPage({part}, "trade.json"),
              AllOf(HasSubstr("Only the trade was measured this time."), HasSubstr("<svg"),
                    HasSubstr("the highest of a wrong one in what is required.</p>"),
                    HasSubstr("stand in trade.json beside this page"), Not(HasSubstr("{{"))));
}

TEST_F(Trading, WithoutRightOrWrongAnswersThereIsNoMarginToDraw) {
  TradePlan plan;
  plan.looks = {Look{}};
  plan.settings = {{"quality", "fast", 0}};
  const Trade made = tradeOf("p", items(), plan, {{answer(Kind::mistake, wrong_[0], 70, 0.4, 1)}});
  EXPECT_THAT(chartOf(made), IsEmpty());
  EXPECT_THAT(textOf(made), HasSubstr("–"));
  EXPECT_FALSE(toJson(made).at("rows").at(0).contains("margin"));
  EXPECT_THAT(csvOf({made}), HasSubstr(",30.0,,,\n"));
}

} // namespace
