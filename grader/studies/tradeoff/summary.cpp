#include "tradeoff/summary.hpp"

#include "words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ggrade::tradeoff {

std::string PresetRow::name() const {
  return fmt::format("{}", fmt::join(names, ", "));
}

void addPreset(std::vector<PresetRow>& rows, PresetRow preset) {
  const auto same = std::ranges::find(rows, preset.setting, &PresetRow::setting);
  if (same == rows.end())
    rows.push_back(std::move(preset));
  else
    same->names.insert(same->names.end(), preset.names.begin(), preset.names.end());
}

std::vector<PresetRow> presetRows(const std::vector<Point>& points,
                                  const std::vector<Preset>& presets) {
  std::vector<PresetRow> rows;
  for (const Preset& preset : presets) {
    const Point& point = points.at(preset.point);
    addPreset(rows, {{preset.name}, point.setting, point.cost, point.error()});
  }
  return rows;
}

std::string tradeText(const std::vector<PresetRow>& rows) {
  const PresetRow &first = rows.front(), &last = rows.back();
  const auto figures = [](const PresetRow& row) {
    return gg::say("{}, error {}", costText(row.cost), errorText(row.error));
  };
  if (rows.size() == 1)
    return gg::say("{} are one setting ({}): there is nothing to trade.", first.name(),
                   figures(first));
  const std::string time = faster(first.cost, last.cost)
                               ? gg::say("a frame takes {} instead of {}", msText(last.cost.whole),
                                         msText(first.cost.whole))
                               : gg::say("a frame takes no longer");
  const bool falls = last.error < first.error && !nearlyEqual(last.error, first.error);
  const std::string error =
      falls ? gg::say("the error falls to {} of it", errorText(last.error / first.error))
            : gg::say("the error does not fall");
  const auto text = gg::say("Between {} ({}) and {} ({}), {}, and {}.", first.names.front(),
                            figures(first), last.names.back(), figures(last), time, error);
  // Only what lies between them is news.
  for (const PresetRow& row : rows)
    if (&row != &first && &row != &last && row.names.back() == "accurate" &&
        faster(row.cost, last.cost))
      return gg::say("{} With {} ({}) the error is nearly the least.", text, row.names.back(),
                     figures(row));
  return text;
}

} // namespace ggrade::tradeoff
