#include "calibration/verdicts.hpp"

#include "report/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>

namespace ggrade::calibration {

using report::number;

namespace {

/// Scores are tenths of a point, sums of them not quite.
constexpr double kRounding = 1e-6;

/// What one grading is worth: how far it lies inside its limit, and in words why not.
struct Check {
  double margin = std::numeric_limits<double>::infinity();
  std::string problem; ///< of the nearest limit; empty where it holds

  void require(double found, double limit, const std::string& words) {
    if (found - limit >= margin) return;
    margin = found - limit;
    problem = margin < -kRounding ? words : std::string();
  }
};

class Judge {
public:
  Judge(const std::vector<ItemDeclaration>& items, const std::vector<Measured>& all)
      : items_(items), all_(all) {
    for (const ItemDeclaration& item : items)
      if (item.kind == results::ItemKind::gain) full_ += item.points;
  }

  /// Points that an item lost: of a keep item, what it took away.
  double lost(const std::map<std::string, double>& earned, const ItemDeclaration& item) const {
    const auto found = earned.find(item.id);
    const double value = found == earned.end() ? 0 : found->second;
    return item.kind == results::ItemKind::keep ? -value : item.points - value;
  }

  const ItemDeclaration* item(const std::string& id) const {
    const auto found = std::find_if(items_.begin(), items_.end(),
                                    [&](const ItemDeclaration& one) { return one.id == id; });
    return found == items_.end() ? nullptr : &*found;
  }

  /// The score with what the program may lose given back.
  double allowed(const KnownAnswer& program, const Score& score) const {
    double sum = score.score;
    for (const std::string& id : program.loses)
      if (const ItemDeclaration* one = item(id); one && one->kind == results::ItemKind::gain)
        sum += lost(score.earned, *one);
    return sum;
  }

  Check check(const KnownAnswer& program, const Score& score) const {
    Check result;
    if (isRight(program.kind)) {
      const double points = allowed(program, score);
      result.require(points, kRightScore,
                     fmt::format("it scores {}; a right answer has at least {}{}", number(points),
                                 number(kRightScore), losses(program, score)));
    } else if (program.kind == Kind::mistake) {
      checkMistake(program, score, result);
    } else if (program.kind == Kind::pair) {
      checkPair(program, score, result);
    } else {
      result.require(program.most, score.score,
                     fmt::format("it scores {} instead of {}{}", number(score.score),
                                 program.most > 0 ? "at most " : "", number(program.most)));
    }
    if (score.outcome != program.outcome && program.kind != Kind::pair) {
      result.margin = std::min(result.margin, -1.0);
      result.problem = fmt::format("it ends as {} instead of {}{}", results::name(score.outcome),
                                   results::name(program.outcome),
                                   score.detail.empty() ? "" : ": " + score.detail);
    }
    return result;
  }

private:
  void checkMistake(const KnownAnswer& program, const Score& score, Check& result) const {
    const ItemDeclaration& named = *item(program.fails);
    const double loss = lost(score.drawn(), named);
    const auto message = score.messages.find(named.id);
    const bool keep = named.kind == results::ItemKind::keep;
    const bool bonus = named.kind == results::ItemKind::bonus;
    const double share = keep ? kKeepLoss : kItemLoss;
    result.require(loss, share * named.points,
                   fmt::format("{} loses {} of {} points; {}% of them must go{}", named.id,
                               number(loss), number(named.points), number(100 * share),
                               message == score.messages.end() ? "" : ": " + message->second));
    if (named.beyondLecture || bonus) return;
    const auto require = [&](double cost, double least) {
      result.require(cost, least,
                     fmt::format("it costs {} points in all; a mistake in a required item costs at "
                                 "least {}",
                                 number(cost), number(least)));
    };
    double cost = 0;
    for (const ItemDeclaration& one : items_)
      if (one.kind != results::ItemKind::bonus) cost += lost(score.drawn(), one);
    require(std::min(cost, full_), kRequiredCost);
    require(full_ - score.score, kOnceCost);
  }

  void checkPair(const KnownAnswer& program, const Score& score, Check& result) const {
    for (const std::string& name : program.of) {
      const Score* alone = scoreOf(name, score.seed);
      if (!alone) continue;
      const double together = score.score + score.bonus, one = alone->score + alone->bonus;
      result.require(one, together,
                     fmt::format("it scores {}, more than {} alone with {}", number(together), name,
                                 number(one)));
    }
  }

  /// What a right answer lost and shouldn't have, with the rubric's words.
  std::string losses(const KnownAnswer& program, const Score& score) const {
    std::string text;
    for (const ItemDeclaration& one : items_) {
      const bool mayGo =
          std::find(program.loses.begin(), program.loses.end(), one.id) != program.loses.end();
      const double points = lost(score.earned, one);
      if (mayGo || one.kind == results::ItemKind::bonus || points <= kRounding) continue;
      const auto message = score.messages.find(one.id);
      text += fmt::format("; {} loses {}{}", one.id, number(points),
                          message == score.messages.end() ? "" : " (" + message->second + ")");
    }
    return text;
  }

  const Score* scoreOf(const std::string& name, std::uint64_t seed) const {
    for (const Measured& one : all_)
      if (one.program.name == name)
        for (const Score& score : one.scores)
          if (score.seed == seed) return &score;
    return nullptr;
  }

  const std::vector<ItemDeclaration>& items_;
  const std::vector<Measured>& all_;
  double full_ = 0;
};

Row rowOf(const Judge& judge, const Measured& measured) {
  const KnownAnswer& program = measured.program;
  Row row;
  row.kind = program.kind;
  row.name = program.name;
  row.title = program.title;
  row.item = program.fails;
  row.gradings = measured.scores.size();
  if (!measured.problem.empty())
    row.failures.push_back(fmt::format("{}: {}", program.name, measured.problem));
  if (measured.scores.empty()) return row;

  row.lowest = std::numeric_limits<double>::infinity();
  row.highest = -row.lowest;
  row.margin = row.lowest;
  double sum = 0, lowestAllowed = row.lowest, highestAllowed = row.highest;
  std::vector<std::uint64_t> failing;
  std::string worst;
  for (const Score& score : measured.scores) {
    const Check check = judge.check(program, score);
    if (!check.problem.empty()) failing.push_back(score.seed);
    if (check.margin < row.margin) {
      row.margin = check.margin;
      worst = fmt::format("on seed {} {}", score.seed, check.problem);
    }
    row.accepted += isRight(program.kind) ? check.problem.empty() : !check.problem.empty();
    row.lowest = std::min(row.lowest, score.score);
    row.highest = std::max(row.highest, score.score);
    sum += score.score;
    const double points = judge.allowed(program, score);
    lowestAllowed = std::min(lowestAllowed, points);
    highestAllowed = std::max(highestAllowed, points);
    if (const ItemDeclaration* item = judge.item(program.fails)) {
      const double loss = item->points > 0 ? judge.lost(score.drawn(), *item) / item->points : 0;
      row.itemLoss = row.itemLoss < 0 ? loss : std::min(row.itemLoss, loss);
    }
  }
  row.mean = sum / double(measured.scores.size());
  if (!failing.empty())
    row.failures.push_back(fmt::format(
        "{}: {}{}", program.name, worst,
        failing.size() == 1 ? std::string()
                            : fmt::format(" (fails on {} of {} seeds: {})", failing.size(),
                                          measured.scores.size(), fmt::join(failing, ", "))));
  const double spread = highestAllowed - lowestAllowed;
  if (isRight(program.kind) && spread > kSpread + kRounding)
    row.failures.push_back(fmt::format("{}: its score moves by {} points from seed to seed, {} to "
                                       "{}; at most {} is allowed",
                                       program.name, number(spread), number(lowestAllowed),
                                       number(highestAllowed), number(kSpread)));
  return row;
}

} // namespace

std::vector<std::string> Verdicts::failures() const {
  std::vector<std::string> all;
  for (const Row& row : rows) all.insert(all.end(), row.failures.begin(), row.failures.end());
  return all;
}

Verdicts judge(const std::string& part, const std::vector<ItemDeclaration>& items,
               const std::vector<Measured>& all) {
  const Judge judge(items, all);
  Verdicts verdicts;
  verdicts.part = part;
  verdicts.lowestRight = std::numeric_limits<double>::infinity();
  verdicts.highestWrong = -verdicts.lowestRight;
  std::set<std::uint64_t> seeds;
  std::vector<double> seconds;
  for (const Measured& measured : all) {
    const Row row = rowOf(judge, measured);
    const bool right = isRight(row.kind);
    verdicts.confusion[right ? 0 : 1][0] += row.accepted;
    verdicts.confusion[right ? 0 : 1][1] += row.gradings - row.accepted;
    verdicts.pairs += row.kind == Kind::pair;
    for (const Score& score : measured.scores) {
      seeds.insert(score.seed);
      if (score.outcome == results::Outcome::graded && score.seconds > 0)
        seconds.push_back(score.seconds);
      const ItemDeclaration* item = judge.item(row.item);
      const bool small = item && (item->beyondLecture || item->kind == results::ItemKind::bonus);
      if (right)
        verdicts.lowestRight =
            std::min(verdicts.lowestRight, judge.allowed(measured.program, score));
      else if (!small && row.kind != Kind::pair)
        verdicts.highestWrong = std::max(verdicts.highestWrong, score.score);
    }
    verdicts.rows.push_back(row);
  }
  verdicts.seeds.assign(seeds.begin(), seeds.end());
  if (!seconds.empty()) {
    const auto middle = seconds.begin() + std::ptrdiff_t(seconds.size() / 2);
    std::ranges::nth_element(seconds, middle);
    verdicts.seconds = *middle;
  }
  return verdicts;
}

} // namespace ggrade::calibration
