#include "calibration/look.hpp"

#include "report/text.hpp"

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

} // namespace ggrade::calibration
