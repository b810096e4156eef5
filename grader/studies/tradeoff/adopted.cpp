#include "tradeoff/adopted.hpp"

#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>

namespace ggrade::tradeoff {

namespace {

/// Stands for a cost that the noise of the frame's time hides, and for a power without one or whose
/// line fits worse than this.
const std::string kHidden = "–";
constexpr double kWorstFit = 0.4;
/// How much less than this a power is, nobody can tell: two runs of one measurement differ by as
/// much.
constexpr double kLeastPower = 0.1;

/// Of the first format (see adopted.hpp).
bool isOld(const json& figures) {
  return figures.value("format", 1) < kFormat;
}

std::string oldCostText(double ms) {
  return ms > 0 ? msText(ms) : kHidden;
}

constexpr const char* kPresets[] = {"fast", "balanced", "accurate", "reference"};

/// The page's colours on white: no page stands around the chart.
constexpr const char* kStyle =
    "<style>text{font:13px system-ui,sans-serif;fill:#1c2430}text.tick,text.axis{font-size:12px;"
    "fill:#5b6675}text.label{font-weight:650;paint-order:stroke;stroke:#fff;stroke-width:4px}"
    ".spread{stroke:#1d5fbf;stroke-width:5;stroke-opacity:.3}.grid{stroke:#dde2e8}.other{fill:#"
    "5b6675;fill-opacity:.4}.best{fill:#1d5fbf;stroke:#fff;"
    "stroke-width:1.5}.front{fill:none;stroke:#1d5fbf;stroke-width:1.8;stroke-linejoin:round}"
    "</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>";

std::string settingCell(const json& setting) {
  std::string text;
  for (const auto& [number, value] : setting.items())
    text += fmt::format("{}`{}` {}", text.empty() ? "" : ", ", number, value.dump());
  return text;
}

/// What stands in a measurement as English, in the language that was chosen.
std::string inWords(const json& english) {
  return std::string(gg::words(english.get<std::string>()));
}

/// What was drawn. Of a program that draws nothing without this part there is no more to say.
std::string sceneText(const json& sweep) {
  const std::string about = inWords(sweep.at("about"));
  const std::string width = sweep.at("size")[0].dump(), height = sweep.at("size")[1].dump();
  const double without = sweep.at("frame_without_ms");
  return without > 0 ? gg::say("{} {} x {} pixels; without this part a frame takes {}.", about,
                               width, height, msText(without))
                     : gg::say("{} {} x {} pixels.", about, width, height);
}

std::string numberText(const json& number) {
  const std::string fall = fallInWords(number.at("error_falls"));
  if (number.value("cost_exponent", 0.0) > 0 && number.at("cost_deviation") <= kWorstFit)
    return gg::say("{} Its cost grows with the power {:.2f} of it.", fall,
                   number.at("cost_exponent").get<double>());
  return fall;
}

std::vector<PresetRow> presetRows(const json& sweep, bool old) {
  const std::string error = sweep.at("error");
  std::vector<PresetRow> rows;
  for (const char* const name : kPresets) {
    if (!sweep.at("presets").contains(name)) continue;
    const json& preset = sweep.at("presets").at(name);
    addPreset(rows, {{name},
                     preset.at("setting"),
                     old ? Cost{.median = preset.at("ms")} : costFrom(preset),
                     preset.at("errors").at(error)});
  }
  return rows;
}

std::string presetTable(const std::vector<PresetRow>& rows, const std::string& error, bool old) {
  std::string text =
      (old ? gg::say("| preset | time of this part | {} | setting |", error) +
                 "\n| --- | ---: | ---: | --- |\n"
           : gg::say("| preset | time of this part | whole frame | {} | setting |", error) +
                 "\n| --- | ---: | ---: | ---: | --- |\n");
  for (const PresetRow& row : rows)
    text += fmt::format("| {} | {} | {} | {} |\n", row.name(),
                        old ? oldCostText(row.cost.median)
                            : fmt::format("{} | {}", costText(row.cost), msText(row.cost.whole)),
                        errorText(row.error), settingCell(row.setting));
  return text;
}

/// Named settings side by side, with every error.
std::string comparedTable(const json& rows) {
  std::string text = gg::say("| setting | time of this part |"), line = "\n| --- | ---: |";
  for (const json& error : rows.at(0).at("errors")) {
    text += fmt::format(" {} |", inWords(error.at("name")));
    line += " ---: |";
  }
  text += line + '\n';
  for (const json& row : rows) {
    text += fmt::format("| {} | {} |", inWords(row.at("name")), costText(costFrom(row)));
    for (const json& error : row.at("errors"))
      text += fmt::format(" {} |", errorText(error.at("value")));
    text += '\n';
  }
  return text;
}

std::string sweepText(const json& sweep, bool old) {
  const std::string part = sweep.at("part"), name = sweep.at("scene_name"),
                    error = sweep.at("error"), errorInWords = inWords(error);
  const std::vector<PresetRow> rows = presetRows(sweep, old);
  std::string text = sceneText(sweep) + "\n\n";
  if (!old) text += tradeText(rows) + "\n\n";
  text += presetTable(rows, errorInWords, old);
  const json compared = sweep.value("compared", json::array());
  if (!compared.empty()) text += '\n' + comparedTable(compared);
  const std::string settings = sweep.at("settings").dump();
  text += fmt::format("\n![{}](handout/{})\n\n",
                      gg::say("Time against {} of {} settings", errorInWords, settings),
                      chartFile(part, name, gg::language()));
  for (const auto& [number, found] : sweep.at("numbers").items())
    text += "- " + numberText(found) + '\n';
  return text;
}

/// The power with which a cost grows.
std::string powerText(const json& row, bool hidden) {
  if (hidden || !row.contains("exponent")) return kHidden;
  const double exponent = row.at("exponent");
  return exponent < kLeastPower ? fmt::format("< {}", kLeastPower)
                                : fmt::format("{:.2f}", exponent);
}

/// Of a scene that needs less against one that needs all.
std::string timeText(const json& row, bool old) {
  const double needed = row.at("needed").at("ms"), all = row.at("against").at("ms");
  const bool less = old ? needed < all : !costFrom(row.at("saved")).hidden();
  return less ? gg::say("{} of {}", msText(needed), msText(all))
              : gg::say("no less ({} and {})", msText(needed), msText(all));
}

std::string growthTable(const json& growth, bool old) {
  std::string text = gg::say("| part | against | its cost in a frame | grows with the power |") +
                     "\n| --- | --- | --- | ---: |\n";
  for (const json& row : growth) {
    std::string costs;
    bool hidden = row.value("deviation", 0.0) > kWorstFit;
    for (std::size_t i = 0; i < row.at("values").size(); ++i) {
      const Cost cost = old ? Cost{.median = row.at("ms")[i]} : costFrom(row.at("costs")[i]);
      costs += fmt::format("{}{:.0f}: {}", i == 0 ? "" : ", ", row.at("values")[i].get<double>(),
                           old ? oldCostText(cost.median) : costText(cost));
      hidden = hidden || (old ? cost.median <= 0 : cost.hidden());
    }
    text += fmt::format("| {} | {} | {} | {} |\n", row.at("part").get<std::string>(),
                        inWords(row.at("series")), costs, powerText(row, hidden));
  }
  return text;
}

std::string savedTable(const json& saved, bool old) {
  const auto mebibytes = [](const json& need) {
    return need.at("image_bytes").get<double>() / (1 << 20);
  };
  std::string text =
      gg::say("| scene | passes | memory | a frame's time |") + "\n| --- | ---: | ---: | ---: |\n";
  for (const json& row : saved) {
    const json &needed = row.at("needed"), &against = row.at("against");
    text += fmt::format(
        "| {} | {} | {} | {} |\n", inWords(row.at("scene")),
        gg::say("{} of {}", needed.at("passes").dump(), against.at("passes").dump()),
        gg::say("{:.1f} of {:.1f} MiB", mebibytes(needed), mebibytes(against)), timeText(row, old));
  }
  return text;
}

/// A number of a preset, and the part that decides it.
struct Decided {
  std::string part;
  json value;
};

/// By preset and number, see `adoptedPresets`.
std::map<std::string, std::map<std::string, Decided>> decided(const json& figures) {
  std::map<std::string, std::map<std::string, Decided>> all;
  for (const json& sweep : figures.at("sweeps"))
    for (const auto& [name, preset] : sweep.at("presets").items())
      for (const auto& [number, value] : preset.at("setting").items())
        if (Decided& by = all[name][number]; by.part != sweep.at("part").get<std::string>())
          by = {sweep.at("part"), value}; // the first scene's
  return all;
}

bool hasInTable(const json& figures, const std::string& part, const std::string& preset,
                const std::string& number) {
  return std::ranges::any_of(figures.at("sweeps"), [&](const json& sweep) {
    const json& presets = sweep.at("presets");
    return sweep.at("part") == part && presets.contains(preset) &&
           presets.at(preset).at("setting").contains(number);
  });
}

/// Which numbers of a part's tables presets.json has otherwise, since a later part decides them.
std::string decidedElsewhere(const json& figures, const std::string& part) {
  std::map<std::string, std::string> values, parts; // by number
  auto all = decided(figures);
  for (const char* const name : kPresets)
    for (const auto& [number, by] : all[name])
      if (by.part != part && hasInTable(figures, part, name, number)) {
        std::string& text = values[number];
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, by.value.dump());
        parts[number] = by.part;
      }
  std::string text;
  for (const auto& [number, settings] : values)
    text += "- " +
            gg::say("`presets.json` has `{}` as part {} asks, which has it, too: {}.", number,
                    parts[number], settings) +
            '\n';
  return text;
}

} // namespace

std::string chartFile(const std::string& part, const std::string& sweep, gg::Language language) {
  return fmt::format("tradeoff-{}-{}{}.svg", part, sweep,
                     language == gg::Language::english ? "" : ".ja");
}

std::string chartInWords(const std::string& svg) {
  static const std::regex kAxis("(class=\"axis\"[^>]*>)([^<]*)<");
  std::string text;
  auto rest = svg.begin();
  for (std::sregex_iterator axis(svg.begin(), svg.end(), kAxis), none; axis != none; ++axis) {
    const std::ssub_match name = (*axis)[2];
    text.append(rest, name.first).append(gg::words(name.str()));
    rest = name.second;
  }
  return text.append(rest, svg.end());
}

std::string chartSvg(const Measured& measured, const Findings& findings) {
  std::string svg = frontChart(measured, findings, Labels::presets);
  svg.insert(svg.find('>') + 1, kStyle);
  svg.insert(svg.find(' '), " xmlns=\"http://www.w3.org/2000/svg\"");
  return svg + '\n';
}

json adoptedPresets(const json& figures) {
  json presets = json::object();
  for (const auto& [name, numbers] : decided(figures))
    for (const auto& [number, by] : numbers) presets[name][number] = by.value;
  return presets;
}

std::string handoutText(const json& figures, const std::string& part) {
  const bool old = isOld(figures);
  if (part.empty())
    return growthTable(figures.at("growth"), old) + '\n' + savedTable(figures.at("saved"), old);
  std::string text;
  for (const json& sweep : figures.at("sweeps"))
    if (sweep.at("part") == part) text += (text.empty() ? "" : "\n") + sweepText(sweep, old);
  return text + decidedElsewhere(figures, part);
}

} // namespace ggrade::tradeoff
