#include "gradebook/overrides.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/cells.hpp"
#include "gradebook/csv.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

namespace ggrade::gradebook {
namespace {

std::string shownItem(const std::string& item) {
  return item.empty() ? "the total" : report::sanitizeLine(item, 100);
}

// One line checked by itself.
Override readLine(const Csv& csv, std::size_t row, const std::vector<std::size_t>& at,
                  const std::string& fileName) {
  const auto fault = [&](const std::string& what) {
    throw UsageError(fmt::format("{}:{}: {}", fileName, csv.line(row), what));
  };
  Override one{cellOf(csv, row, at[0]), cellOf(csv, row, at[1]), 0,
               cellOf(csv, row, at[3]), cellOf(csv, row, at[4]), csv.line(row)};
  if (csv.columns(row) > csv.columns(0))
    fault(fmt::format("{} cells, but the header has {}: put cells with a \"{}\" in them in quotes",
                      csv.columns(row), csv.columns(0), csv.delimiter()));
  if (one.student.empty()) fault("there is no student: write the identifier of the gradebook");
  const std::string points = cellOf(csv, row, at[2]);
  const auto number = readNumber(narrow(points));
  if (!number)
    fault(fmt::format("points is \"{}\": write a number such as 7.5",
                      report::sanitizeLine(points, 60)));
  one.points = *number;
  if (std::abs(one.points) > kMostPoints)
    fault(fmt::format("points is \"{}\": no item and no total has so many",
                      report::sanitizeLine(points, 60)));
  if (one.item.empty() && one.points < 0)
    fault(fmt::format("points is \"{}\": a total is never below 0", points));
  if (one.reason.empty()) fault("there is no reason: say why the points were changed");
  if (one.who.empty()) fault("there is no who: say who changed the points");
  return one;
}

/// "50 points are more than the 0 that keep can give": a sign, or the item, may be the wrong one.
std::string beyond(double points, double least, double most, const std::string& of) {
  if (points > most)
    return fmt::format("{} points are more than the {} that {} can give", writeNumber(points),
                       writeNumber(most), of);
  if (points < least)
    return fmt::format("{} points are less than the {} that {} can come to", writeNumber(points),
                       writeNumber(least), of);
  return {};
}

class Application {
public:
  Application(const std::vector<MachineScore>& scores, const std::string& fileName)
      : scores_(scores), fileName_(fileName) {
    for (const MachineScore& score : scores)
      result_.scores.push_back({score.student, score.score, score.score, {}});
  }

  void apply(const Override& one) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < scores_.size(); ++i)
      if (plainIdentifier(scores_[i].student) == plainIdentifier(one.student)) found.push_back(i);
    if (found.size() != 1)
      return remark(one, fmt::format("{} has \"{}\" as student",
                                     found.empty() ? "no submission" : "more than one submission",
                                     report::sanitizeLine(one.student, 100)));
    const MachineScore& machine = scores_[found.front()];
    Overridden& overridden = result_.scores[found.front()];
    if (one.item.empty()) {
      change(overridden, one, machine.score, beyond(one.points, 0, machine.most, "all items"));
      return;
    }
    const auto item = std::find_if(machine.items.begin(), machine.items.end(),
                                   [&](const MachineItem& each) { return each.id == one.item; });
    if (!machine.score)
      return remark(one, "the submission was not gradable, only its total can be given");
    if (item == machine.items.end())
      return remark(one, fmt::format("there is no item \"{}\"; there are {}",
                                     report::sanitizeLine(one.item, 100), ids(machine)));
    change(overridden, one, item->earned, beyond(one.points, item->least, item->most, item->id));
  }

  Overrides finish() {
    for (std::size_t i = 0; i < scores_.size(); ++i) total(scores_[i], result_.scores[i]);
    return std::move(result_);
  }

private:
  void remark(const Override& one, const std::string& what) {
    result_.remarks.push_back(fmt::format("{}:{}: {}", fileName_, one.line, what));
  }

  void change(Overridden& overridden, const Override& one, std::optional<double> machine,
              const std::string& beyond) {
    if (!beyond.empty())
      remark(one, fmt::format("{}: {}; they count, as they were given",
                              report::sanitizeLine(one.student, 100), beyond));
    overridden.changes.push_back({one.item, machine, one.points, one.reason, one.who, beyond});
  }

  static std::string ids(const MachineScore& score) {
    std::vector<std::string> all;
    for (const MachineItem& item : score.items) all.push_back(item.id);
    return fmt::format("{}", fmt::join(all, ", "));
  }

  void total(const MachineScore& machine, Overridden& overridden) {
    const auto& changes = overridden.changes;
    if (changes.empty()) return;
    const auto whole = std::find_if(changes.begin(), changes.end(),
                                    [](const Change& change) { return change.item.empty(); });
    if (whole != changes.end()) {
      overridden.score = whole->points;
      if (changes.size() > 1)
        result_.remarks.push_back(fmt::format("{}: {}: the total is given, whatever the items "
                                              "that are given, too",
                                              fileName_, machine.student));
      return;
    }
    double sum = 0;
    for (const MachineItem& item : machine.items) {
      const auto change = std::find_if(changes.begin(), changes.end(),
                                       [&](const Change& one) { return one.item == item.id; });
      sum += change == changes.end() ? item.earned : change->points;
    }
    overridden.score = std::max(0.0, std::round(sum * 10) / 10);
  }

  const std::vector<MachineScore>& scores_;
  const std::string& fileName_;
  Overrides result_;
};

} // namespace

std::vector<Override> readOverrides(std::string_view bytes, const std::string& fileName) {
  const Csv csv(bytes, fileName);
  const std::vector<std::size_t> at = columnsNamed(
      csv, fileName, {"student", "item", "points", "reason", "who"}, OtherColumns::refused);
  std::vector<Override> all;
  std::map<std::pair<std::string, std::string>, std::size_t> lines;
  for (std::size_t row = 1; row < csv.rows(); ++row) {
    if (csv.isBlank(row)) continue;
    all.push_back(readLine(csv, row, at, fileName));
    const Override& one = all.back();
    const auto [first, isNew] =
        lines.emplace(std::pair(plainIdentifier(one.student), one.item), one.line);
    if (!isNew)
      throw UsageError(fmt::format("{}:{}: {} of \"{}\" is given in line {}, too: keep one of the "
                                   "two lines",
                                   fileName, one.line, shownItem(one.item),
                                   report::sanitizeLine(one.student, 100), first->second));
  }
  return all;
}

Overrides applyOverrides(const std::vector<MachineScore>& scores,
                         const std::vector<Override>& overrides, const std::string& fileName) {
  Application application(scores, fileName);
  for (const Override& one : overrides) application.apply(one);
  return application.finish();
}

} // namespace ggrade::gradebook
