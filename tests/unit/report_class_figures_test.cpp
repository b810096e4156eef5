#include "report/class_figures.hpp"
#include "report_class_samples.hpp"

#include <gmock/gmock.h>
#include <limits>

namespace ggrade::report {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<ClassRow> scoring(const std::vector<double>& scores) {
  std::vector<ClassRow> rows;
  for (const double score : scores) rows.push_back(samples::student("student", score));
  return rows;
}

ClassRow notGradable() {
  ClassRow row = samples::student("student");
  row.outcome = results::Outcome::notGradable;
  row.finalScore = 0;
  return row;
}

TEST(ClassFigures, MeanMedianAndQuartiles) {
  const ScoreFigures figures = scoreFigures(scoring({90, 10, 40, 20}));
  EXPECT_EQ(figures.count, 4u);
  EXPECT_DOUBLE_EQ(figures.most, 100);
  EXPECT_DOUBLE_EQ(figures.mean, 40);
  EXPECT_DOUBLE_EQ(figures.median, 30);
  EXPECT_DOUBLE_EQ(figures.lowerQuartile, 17.5);
  EXPECT_DOUBLE_EQ(figures.upperQuartile, 52.5);
}

TEST(ClassFigures, OneScoreIsAllOfThem) {
  const ScoreFigures figures = scoreFigures(scoring({61.5}));
  EXPECT_DOUBLE_EQ(figures.mean, 61.5);
  EXPECT_DOUBLE_EQ(figures.median, 61.5);
  EXPECT_DOUBLE_EQ(figures.lowerQuartile, 61.5);
  EXPECT_DOUBLE_EQ(figures.upperQuartile, 61.5);
}

TEST(ClassFigures, WhatHasNoScoreIsLeftOut) {
  std::vector<ClassRow> rows = scoring({50, kNaN});
  rows.push_back(notGradable());
  EXPECT_EQ(scoreFigures(rows).count, 1u);
  EXPECT_DOUBLE_EQ(scoreFigures(rows).mean, 50);
  EXPECT_EQ(scoreFigures({}).count, 0u);
}

TEST(ClassFigures, AnInstructorsTotalCountsWhereNothingWasGradable) {
  ClassRow row = notGradable();
  row.adjustments = {{"mirror.where", 0, 40, "seen", "tutor1"}};
  EXPECT_FALSE(hasScore(row)) << "an item's points are no total";
  row.adjustments.push_back({"", 0, 70, "shown in the exercise", "tutor1"});
  row.finalScore = 70;
  EXPECT_TRUE(hasScore(row));
}

TEST(ClassFigures, BinsHoldTheirLowerEndAndTheLastOneBoth) {
  EXPECT_EQ(binOf(0, 100), 0u);
  EXPECT_EQ(binOf(9.99, 100), 0u);
  EXPECT_EQ(binOf(10, 100), 1u);
  EXPECT_EQ(binOf(.7 * 3, 3), 7u) << "2.0999999999999996 is seven tenths of 3";
  EXPECT_EQ(binOf(99.9, 100), 9u);
  EXPECT_EQ(binOf(100, 100), 9u);
  EXPECT_EQ(binOf(100.5, 100), kBins) << "by a bonus";
  EXPECT_EQ(binOf(-3, 100), 0u);
  EXPECT_EQ(binOf(kNaN, 100), std::nullopt);
  EXPECT_EQ(binOf(5, 0), std::nullopt);
  EXPECT_EQ(binOf(5, kNaN), std::nullopt);
}

TEST(ClassFigures, DiagnosesAreCountedByStudentAndTheUnknownComeLast) {
  std::vector<ClassRow> rows = scoring({1, 2, 3, 4});
  rows[0].diagnoses = {{"", "Nothing known."}, {"cull", "Look at glFrontFace."}};
  rows[1].diagnoses = {{"bias", "Add a bias."}, {"bias", "Add a bias."}};
  rows[2].diagnoses = {{"bias", "Add a bias."}};
  rows[3].diagnoses = {{"", "Nothing known."}};
  const auto groups = groupByDiagnosis(rows);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].id, "bias");
  EXPECT_THAT(groups[0].rows, ElementsAre(1, 2));
  EXPECT_EQ(groups[1].text, "Look at glFrontFace.");
  EXPECT_EQ(groups[2].id, "");
  EXPECT_THAT(groups[2].rows, ElementsAre(0, 3));
}

TEST(ClassFigures, OutcomesKeepTheirOrder) {
  std::vector<ClassRow> rows = scoring({1, 2, 3});
  rows[0].outcome = results::Outcome::crash;
  rows[2].outcome = results::Outcome::crash;
  const auto groups = groupByOutcome(rows);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].id, "graded");
  EXPECT_EQ(groups[1].id, "crash");
  EXPECT_THAT(groups[1].rows, ElementsAre(0, 2));
  EXPECT_THAT(groupByOutcome({}), IsEmpty());
}

TEST(ClassFigures, ItemsHardestFirstOverThoseJudged) {
  std::vector<ClassRow> rows = scoring({1, 2, 3});
  rows[0].items = {{"a", "A", results::ItemKind::gain, 10, 20, true},
                   {"keep", "Keep", results::ItemKind::keep, -3, 30, true},
                   {"b", "B", results::ItemKind::gain, 0, 20, false}};
  rows[1].items = {{"a", "A", results::ItemKind::gain, 20, 20, true},
                   {"keep", "Keep", results::ItemKind::keep, 0, 30, true},
                   {"b", "B", results::ItemKind::gain, 5, 20, true}};
  rows[2].items = {{"a", "A", results::ItemKind::gain, kNaN, 20, true},
                   {"keep", "Keep", results::ItemKind::keep, 0, 30, false},
                   {"c", "C", results::ItemKind::gain, 0, 20, false}};
  const auto items = itemFigures(rows);
  ASSERT_EQ(items.size(), 4u);
  EXPECT_EQ(items[0].id, "b");
  EXPECT_DOUBLE_EQ(items[0].share, .25);
  EXPECT_EQ(items[0].judged, 1u);
  EXPECT_EQ(items[1].id, "a");
  EXPECT_DOUBLE_EQ(items[1].share, .75);
  EXPECT_EQ(items[1].lost, 1u);
  EXPECT_EQ(items[1].judged, 2u) << "no number is no judgement";
  EXPECT_EQ(items[2].id, "keep");
  EXPECT_DOUBLE_EQ(items[2].share, .95) << "share kept";
  EXPECT_EQ(items[3].id, "c") << "never judged: last, though its share is 0";
}

} // namespace
} // namespace ggrade::report
