#include "calibration/look.hpp"

#include "report/text.hpp"
#include "rubric/rubric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ggrade::calibration {

using nlohmann::json;

std::string nameOf(const Look& look) {
  std::string text = grading::nameOf(look.quality);
  if (look.scale != 1) text += fmt::format(", windows x {}", report::number(look.scale));
  if (look.hidden)
    text += fmt::format(", {} hidden scene{}", *look.hidden, *look.hidden == 1 ? "" : "s");
  return text;
}

void scaleWindows(grading::ScenePlan& plan, double scale) {
  const auto apply = [&](json& scene, const std::string& name) {
    if (!scene.contains("size"))
      throw UsageError(fmt::format("scene \"{}\" has no size that could be scaled", name));
    for (json& side : scene["size"]) side = std::max(1L, std::lround(side.get<double>() * scale));
  };
  for (grading::SceneCase& one : plan.scenes) {
    if (one.isPublic) continue;
    apply(one.scene, one.name);
    for (auto& [probe, scene] : one.probes) apply(scene, one.name);
  }
}

std::size_t scenesUpTo(const grading::ScenePlan& plan, std::size_t hidden) {
  std::size_t count = 0;
  for (; count < plan.scenes.size(); ++count)
    if (!plan.scenes[count].isPublic && hidden-- == 0) break;
  return count;
}

void keepScenes(std::vector<report::Item>& items, const std::vector<std::string>& scenes) {
  for (report::Item& item : items) {
    if (!item.judged) continue;
    double credit = 1;
    std::string message = "no scene shows it";
    std::vector<std::pair<std::string, double>> credits;
    std::vector<std::string> messages;
    for (std::size_t i = 0; i < item.credits.size(); ++i) {
      if (std::ranges::find(scenes, item.credits[i].first) == scenes.end()) continue;
      if (credits.empty() || item.credits[i].second < credit) {
        credit = item.credits[i].second;
        message = fmt::format("{}: {}", item.credits[i].first, item.messages[i]);
      }
      credits.push_back(item.credits[i]);
      messages.push_back(item.messages[i]);
    }
    item.credits = std::move(credits);
    item.messages = std::move(messages);
    item.message = message;
    item.earned = rubric::pointsOf(item.kind, item.points, credit);
  }
}

} // namespace ggrade::calibration
