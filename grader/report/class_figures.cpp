#include "report/class_figures.hpp"

#include "report/summary.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ggrade::report {
namespace {

double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * double(sorted.size() - 1);
  const std::size_t below = std::size_t(at), above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - double(below));
}

void add(std::vector<ClassGroup>& groups, const std::string& id, const std::string& text,
         std::size_t row) {
  auto group = std::ranges::find(groups, id, &ClassGroup::id);
  if (group == groups.end()) group = groups.insert(group, {id, text, {}});
  // Two parts of one submission can have the same mistake: one student.
  if (group->rows.empty() || group->rows.back() != row) group->rows.push_back(row);
}

double lostPoints(const ClassItem& item) {
  results::Item whole;
  whole.kind = item.kind, whole.points = item.points, whole.earned = item.earned;
  return lost(whole);
}

} // namespace

bool hasScore(const ClassRow& row) {
  const bool decided = std::ranges::any_of(
      row.adjustments, [](const Adjustment& adjustment) { return adjustment.item.empty(); });
  return std::isfinite(row.finalScore) && (row.outcome != results::Outcome::notGradable || decided);
}

ScoreFigures scoreFigures(std::span<const ClassRow> rows) {
  ScoreFigures figures;
  std::vector<double> scores;
  for (const ClassRow& row : rows) {
    if (std::isfinite(row.maxScore)) figures.most = std::max(figures.most, row.maxScore);
    if (hasScore(row)) scores.push_back(row.finalScore);
  }
  if (scores.empty()) return figures;
  std::ranges::sort(scores);
  figures.count = scores.size();
  figures.mean = std::accumulate(scores.begin(), scores.end(), 0.0) / double(scores.size());
  figures.median = quantile(scores, .5);
  figures.lowerQuartile = quantile(scores, .25);
  figures.upperQuartile = quantile(scores, .75);
  return figures;
}

std::optional<std::size_t> binOf(double score, double most) {
  if (!std::isfinite(score) || !std::isfinite(most) || most <= 0) return std::nullopt;
  if (score > most + kEpsilon) return kBins;
  const double bin = std::floor((score + kEpsilon) / most * double(kBins));
  return std::size_t(std::clamp(bin, 0.0, double(kBins - 1)));
}

std::vector<ClassGroup> groupByDiagnosis(std::span<const ClassRow> rows) {
  std::vector<ClassGroup> groups;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const ClassDiagnosis& diagnosis : rows[i].diagnoses)
      add(groups, diagnosis.id, diagnosis.text, i);
  std::ranges::stable_sort(groups, [](const ClassGroup& a, const ClassGroup& b) {
    if (a.id.empty() != b.id.empty()) return b.id.empty();
    return a.rows.size() > b.rows.size();
  });
  return groups;
}

std::vector<ClassGroup> groupByOutcome(std::span<const ClassRow> rows) {
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return rows[i].outcome; });
  std::vector<ClassGroup> groups;
  for (const std::size_t i : order)
    add(groups, std::string(name(rows[i].outcome)), std::string(explanation(rows[i].outcome)), i);
  return groups;
}

std::vector<ItemFigures> itemFigures(std::span<const ClassRow> rows) {
  std::vector<ItemFigures> all;
  for (const ClassRow& row : rows)
    for (const ClassItem& item : row.items) {
      auto figures = std::ranges::find(all, item.id, &ItemFigures::id);
      if (figures == all.end())
        figures = all.insert(figures, {item.id, item.title, item.kind, 0, 0, 0});
      if (!item.judged || !std::isfinite(item.earned + item.points)) continue;
      const double missing = lostPoints(item);
      figures->judged += 1;
      figures->lost += missing > kEpsilon ? 1 : 0;
      figures->share += item.points > 0 ? std::clamp(1 - missing / item.points, 0.0, 1.0) : 1;
    }
  for (ItemFigures& figures : all)
    if (figures.judged > 0) figures.share /= double(figures.judged);
  std::ranges::stable_sort(all, [](const ItemFigures& a, const ItemFigures& b) {
    if ((a.judged == 0) != (b.judged == 0)) return b.judged == 0;
    return a.share < b.share;
  });
  return all;
}

} // namespace ggrade::report
