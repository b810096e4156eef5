#include "calibration/tolerances.hpp"

#include "image/compare.hpp"
#include "report/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ggrade::calibration {

using nlohmann::json;
using report::number;

std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (double steps : {0.5, 1.5, 2.5, 3.5, 5.5, 7.5})
    for (int radius : {0, 1, 2}) all.push_back({steps, radius});
  return all;
}

Setting publishedSetting() {
  return {std::round(double(kTolerance) * 255 * 10) / 10, kRadius};
}

int halfOf(const std::string& name) {
  // FNV-1a: the same on every machine.
  std::uint32_t hash = 2166136261u;
  for (unsigned char c : name) hash = (hash ^ c) * 16777619u;
  return int((hash >> 16) & 1);
}

namespace {

/// Does a setting do better on a half than another: fewer errors, then the wider margin?
bool better(const TrialErrors& a, const TrialErrors& b, int half) {
  if (a.errors[half] != b.errors[half]) return a.errors[half] < b.errors[half];
  return a.margin[half] > b.margin[half] + 1e-6;
}

std::string nameOf(const Setting& setting) {
  return fmt::format("{} steps, {} pixel{}", number(setting.steps), setting.radius,
                     setting.radius == 1 ? "" : "s");
}

} // namespace

CrossValidation crossValidate(const std::string& part, const std::vector<ItemDeclaration>& items,
                              const std::vector<Trial>& trials) {
  CrossValidation result;
  for (const Trial& trial : trials) {
    TrialErrors errors{trial.setting, {}, {}};
    std::size_t programs[2] = {};
    std::fill(std::begin(errors.margin), std::end(errors.margin),
              std::numeric_limits<double>::infinity());
    const Verdicts verdicts = judge(part, items, trial.measured);
    result.seeds = verdicts.seeds;
    for (const Row& row : verdicts.rows) {
      const int half = halfOf(row.name);
      ++programs[half];
      errors.errors[half] += !row.failures.empty();
      errors.margin[half] = std::min(errors.margin[half], row.margin);
    }
    std::copy(std::begin(programs), std::end(programs), result.programs);
    if (errors.setting == publishedSetting())
      result.publishedHolds = errors.errors[0] + errors.errors[1] == 0;
    result.trials.push_back(errors);
  }
  for (int half : {0, 1}) {
    const TrialErrors* best = nullptr;
    for (const TrialErrors& one : result.trials)
      if (!best || better(one, *best, half)) best = &one;
    if (!best) continue;
    result.chosen[half] = best->setting;
    result.errorsOnOther[half] = best->errors[1 - half];
  }
  return result;
}

json toJson(const CrossValidation& result) {
  const auto toJson = [](const Setting& setting) {
    return json{{"tolerance_steps", setting.steps}, {"radius", setting.radius}};
  };
  json trials = json::array();
  for (const TrialErrors& one : result.trials) {
    json trial = toJson(one.setting);
    trial["errors"] = {one.errors[0], one.errors[1]};
    trials.push_back(trial);
  }
  return {{"seeds", result.seeds},
          {"programs", {result.programs[0], result.programs[1]}},
          {"trials", trials},
          {"chosen", {toJson(result.chosen[0]), toJson(result.chosen[1])}},
          {"errors_on_other_half", {result.errorsOnOther[0], result.errorsOnOther[1]}},
          {"published", toJson(publishedSetting())},
          {"published_holds", result.publishedHolds}};
}

Section sectionOf(const CrossValidation& result) {
  Section section;
  section.title = "Are the tolerances tuned to these programs?";
  section.text = fmt::format(
      "The mistakes and right answers were split in two halves by a hash of their names, {} and {} "
      "programs, and judged on seed {} with other tolerances than the published ones ({}). Chosen "
      "on the first half alone, the tolerances would be {}: they get {} of the second half wrong. "
      "Chosen on the second, they would be {}: they get {} of the first half wrong. The published "
      "ones get {} of {} wrong. The table counts programs that break a limit, first half + second "
      "half.",
      result.programs[0], result.programs[1], fmt::join(result.seeds, ", "),
      nameOf(publishedSetting()), nameOf(result.chosen[0]), result.errorsOnOther[0],
      nameOf(result.chosen[1]), result.errorsOnOther[1],
      [&] {
        for (const TrialErrors& one : result.trials)
          if (one.setting == publishedSetting()) return one.errors[0] + one.errors[1];
        return std::size_t(0);
      }(),
      result.programs[0] + result.programs[1]);
  section.columns = {"tolerance"};
  std::vector<int> radii;
  for (const TrialErrors& one : result.trials)
    if (std::find(radii.begin(), radii.end(), one.setting.radius) == radii.end())
      radii.push_back(one.setting.radius);
  for (int radius : radii)
    section.columns.push_back(fmt::format("{} pixel{}", radius, radius == 1 ? "" : "s"));
  for (const TrialErrors& one : result.trials) {
    const std::string steps = number(one.setting.steps) + " steps";
    if (section.rows.empty() || section.rows.back()[0] != steps) section.rows.push_back({steps});
    section.rows.back().push_back(
        fmt::format("{} + {}{}", one.errors[0], one.errors[1],
                    one.setting == publishedSetting() ? " (published)" : ""));
  }
  return section;
}

} // namespace ggrade::calibration
