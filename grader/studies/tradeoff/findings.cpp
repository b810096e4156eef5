#include "tradeoff/findings.hpp"

#include "gradebook/csv.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ggrade::tradeoff {

using gradebook::csvCell;

namespace {

/// A number from 0 with one of the units behind it, each with what it multiplies by.
double parseUnit(const std::string& option, const std::string& text,
                 const std::vector<std::pair<std::string, double>>& units,
                 const std::string& example) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  const std::string unit(read.ptr, end);
  for (const auto& [name, factor] : units)
    if (read.ec == std::errc() && unit == name && std::isfinite(value) && value >= 0)
      return value * factor;
  throw UsageError(fmt::format("{} {}: must be {}", option, text, example));
}

std::vector<std::size_t> indicesOf(const Measured& measured, const std::vector<json>& settings) {
  std::vector<std::size_t> indices;
  for (const json& setting : settings)
    for (std::size_t i = 0; i < measured.points.size(); ++i)
      if (measured.points[i].setting == setting) indices.push_back(i);
  return indices;
}

json rowOf(const Point& point) {
  json errors = json::object();
  for (const truth::Error& error : point.errors) errors[error.name] = error.value;
  json row = jsonOf(point.cost);
  row.update({{"setting", point.setting}, {"errors", errors}});
  return row;
}

std::string growthText(const Growth& growth) {
  return fmt::format("{:.2f} (fit to within {:.0f}%)", growth.exponent, 100 * growth.deviation);
}

} // namespace

double parseMs(const std::string& text) {
  return parseUnit("--budget", text, {{"", 1}, {"ms", 1}, {"s", 1000}, {"us", 1e-3}},
                   "a time such as 5ms");
}

double parseError(const std::string& text) {
  return parseUnit("--error", text, {{"", 1}, {"%", 0.01}}, "an error such as 1% or 0.01");
}

std::string Table::name() const {
  std::string text;
  for (const std::string& number : numbers) text += (text.empty() ? "" : "-") + number;
  return text;
}

Findings findingsOf(const Measured& measured, const Wishes& wishes) {
  const std::vector<Point>& points = measured.points;
  Findings findings;
  findings.front = paretoFront(points);
  findings.presets = presetsOf(points, referenceSetting(measured.sweep));
  for (const Named& named : measured.sweep.compare)
    for (std::size_t i = 0; i < points.size(); ++i)
      if (holds(points[i].setting, named.setting)) {
        findings.compared.push_back({named.name, i});
        break; // what it doesn't say doesn't matter to it
      }
  if (wishes.budgetMs)
    findings.advice.push_back(
        {"at most " + msText(*wishes.budgetMs), withinBudget(points, *wishes.budgetMs)});
  if (wishes.error)
    findings.advice.push_back(
        {"an error of at most " + errorText(*wishes.error), withinError(points, *wishes.error)});
  for (const Number& number : measured.sweep.numbers) {
    Curve curve{number,
                {{number.name}, indicesOf(measured, settingsOf(measured.sweep, number.name))},
                {},
                {}};
    std::vector<std::string> labels;
    std::vector<double> errors, values, costs;
    for (std::size_t index : curve.table.points) {
      const json& value = points[index].setting.at(number.name);
      labels.push_back(value.dump());
      errors.push_back(points[index].error());
      values.push_back(value);
      costs.push_back(points[index].cost.hidden() ? 0 : points[index].cost.median);
    }
    curve.fall = fallText(number.name, labels, errors);
    if (!number.note.empty()) curve.fall += ' ' + number.note;
    if (number.amount) curve.growth = growthOf(values, costs);
    findings.tables.push_back(curve.table);
    findings.curves.push_back(std::move(curve));
  }
  for (const auto& names : measured.sweep.together)
    findings.tables.push_back({names, indicesOf(measured, settingsOf(measured.sweep, names))});
  return findings;
}

std::string csvOf(const Measured& measured, const Table& table) {
  std::string text;
  for (const std::string& number : table.numbers) text += csvCell(number, ",") + ',';
  text += "ms,low,high,frame_ms";
  for (const truth::Error& error : measured.points.at(table.points.at(0)).errors)
    text += ',' + csvCell(error.name, ",");
  text += '\n';
  for (std::size_t index : table.points) {
    const Point& point = measured.points[index];
    for (const std::string& number : table.numbers) text += point.setting.at(number).dump() + ',';
    const Cost& cost = point.cost;
    text +=
        fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}", cost.median, cost.low, cost.high, cost.whole);
    for (const truth::Error& error : point.errors) text += fmt::format(",{:.6g}", error.value);
    text += '\n';
  }
  return text;
}

json jsonOf(const Measured& measured, const Findings& findings, const Table& table) {
  const Sweep& sweep = measured.sweep;
  json rows = json::array();
  for (std::size_t index : table.points) rows.push_back(rowOf(measured.points[index]));
  json all = {{"numbers", table.numbers},
              {"part", sweep.part},
              {"scene_name", sweep.name},
              {"scene", sweep.scene},
              {"time", sweep.time},
              {"unit", "milliseconds of a frame; low and high: 95%"},
              {"rows", rows}};
  if (!sweep.before.empty()) all["before"] = rubric::toJson(sweep.before);
  for (const Curve& curve : findings.curves) {
    if (table.numbers != curve.table.numbers) continue;
    all["error_falls"] = curve.fall;
    if (curve.growth) all["cost_exponent"] = curve.growth->exponent;
  }
  return all;
}

json jsonOf(const Measured& measured, const Findings& findings) {
  json front = json::array(), compared = json::array(), presets = json::object(),
       advice = json::array(), numbers = json::object();
  for (std::size_t index : findings.front) front.push_back(rowOf(measured.points[index]));
  for (const Compared& one : findings.compared) {
    const Point& point = measured.points[one.point];
    json row = rowOf(point), errors = json::array(); // in the truth's order
    for (const truth::Error& error : point.errors)
      errors.push_back({{"name", error.name}, {"value", error.value}});
    row.update({{"name", one.name}, {"errors", errors}});
    compared.push_back(std::move(row));
  }
  for (const Preset& preset : findings.presets) {
    presets[preset.name] = rowOf(measured.points[preset.point]);
    presets[preset.name]["rule"] = preset.rule;
  }
  for (const Advice& answer : findings.advice) {
    json entry = {{"wish", answer.wish}, {"answer", nullptr}};
    if (answer.point) {
      entry["answer"] = rowOf(measured.points[*answer.point]);
      entry["paste"] = pasteOf(measured.points[*answer.point].setting);
    }
    advice.push_back(std::move(entry));
  }
  for (const Curve& curve : findings.curves) {
    json& number = numbers[curve.number.name] = {{"error_falls", curve.fall}};
    if (curve.growth)
      number.update(
          {{"cost_exponent", curve.growth->exponent}, {"cost_deviation", curve.growth->deviation}});
  }
  return {{"part", measured.sweep.part},
          {"scene_name", measured.sweep.name},
          {"about", measured.sweep.about},
          {"size", measured.sweep.scene.at("size")},
          {"error", measured.points.at(0).errors.at(0).name},
          {"settings", measured.points.size()},
          {"frame_without_ms", measured.offMs},
          {"front", front},
          {"compared", compared},
          {"presets", presets},
          {"advice", advice},
          {"numbers", numbers}};
}

json jsonOf(const GrowthRow& row) {
  json costs = json::array();
  for (const Cost& cost : row.costs) costs.push_back(jsonOf(cost));
  json all = {{"part", row.part}, {"series", row.series}, {"values", row.values}, {"costs", costs}};
  if (row.growth)
    all.update({{"exponent", row.growth->exponent}, {"deviation", row.growth->deviation}});
  return all;
}

json jsonOf(const SavedRow& row) {
  const auto needOf = [](const Need& need) {
    return json{{"passes", need.passes}, {"image_bytes", need.bytes}, {"ms", need.ms}};
  };
  return {{"scene", row.name},
          {"needed", needOf(row.needed)},
          {"against", needOf(row.against)},
          {"saved", jsonOf(row.saved)}};
}

json jsonOf(const Cost& cost) {
  return {{"ms", cost.median},
          {"low", cost.low},
          {"high", cost.high},
          {"frame_ms", cost.whole},
          {"narrow", cost.narrow}};
}

Cost costFrom(const json& row) {
  return {row.at("ms"), row.at("low"), row.at("high"), row.at("frame_ms"), row.at("narrow")};
}

std::string roundsText(const std::vector<Point>& points, const Effort& effort) {
  const auto wide = std::ranges::count_if(points, [](const Point& p) { return !p.cost.narrow; });
  if (wide == 0) return "";
  return gg::say("Of {} of {} settings the cost is known less well: after {} rounds the interval "
                 "is still wider than {:.0f}% of the whole frame or {:.0f}% of the cost.",
                 wide, points.size(), effort.rounds, 100 * kNarrow, 100 * kNarrowOfCost);
}

json pasteOf(const json& setting) {
  return {{"quality", setting}};
}

json presetsJson(const std::vector<Measured>& all, const std::vector<Findings>& findings) {
  json parts = json::object();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const Preset& preset : findings[i].presets) {
      json& entry = parts[all[i].sweep.part][preset.name];
      entry["rule"] = preset.rule;
      for (const auto& [number, value] : all[i].points[preset.point].setting.items())
        entry["quality"].emplace(number, value);
    }
  return parts;
}

std::string textOf(const Measured& measured, const Findings& findings) {
  const auto line = [&](const std::string& name, std::size_t index) {
    const Point& point = measured.points[index];
    return fmt::format("  {:<18} {:>13} of {:>8}  {:>8}  {}\n", name, costText(point.cost),
                       msText(point.cost.whole), errorText(point.error()),
                       settingText(point.setting));
  };
  std::string text =
      fmt::format("{}, scene \"{}\": {} settings, {} of them on the front; error: {}\n",
                  measured.sweep.part, measured.sweep.name, measured.points.size(),
                  findings.front.size(), measured.points.at(0).errors.at(0).name);
  for (std::size_t index : findings.front) text += line("", index);
  text += " presets\n";
  for (const PresetRow& row : presetRows(measured.points, findings.presets))
    text += fmt::format("  {:<18} {:>13} of {:>8}  {:>8}  {}\n", row.name(), costText(row.cost),
                        msText(row.cost.whole), errorText(row.error), settingText(row.setting));
  for (const Advice& answer : findings.advice) {
    text += fmt::format(" {}\n", answer.wish);
    if (!answer.point)
      text += "  no setting that was measured\n";
    else
      text += line("", *answer.point) +
              fmt::format("  {}\n", pasteOf(measured.points[*answer.point].setting).dump());
  }
  for (const Curve& curve : findings.curves) {
    text += ' ' + curve.fall;
    if (curve.growth) text += " Exponent of cost: " + growthText(*curve.growth) + '.';
    text += '\n';
  }
  return text;
}

std::string textOf(const std::vector<GrowthRow>& rows) {
  std::string text;
  for (const GrowthRow& row : rows) {
    text += fmt::format("{} against {}: exponent {};", row.part, row.series,
                        row.growth ? growthText(*row.growth) : "not to be told");
    for (std::size_t i = 0; i < row.values.size(); ++i)
      text += fmt::format(" {:.0f}: {}{}", row.values[i], costText(row.costs[i]),
                          i + 1 < row.values.size() ? "," : "\n");
  }
  return text;
}

std::string textOf(const std::vector<SavedRow>& rows) {
  std::string text;
  for (const SavedRow& row : rows)
    text += fmt::format("saved, {}: {} instead of {} passes, {:.1f} instead of {:.1f} MiB, {} "
                        "instead of {}\n",
                        row.name, row.needed.passes, row.against.passes,
                        double(row.needed.bytes) / (1 << 20), double(row.against.bytes) / (1 << 20),
                        msText(row.needed.ms), msText(row.against.ms));
  return text;
}

} // namespace ggrade::tradeoff
