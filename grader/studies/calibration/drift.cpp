#include "calibration/drift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace ggrade::calibration {

using nlohmann::json;

namespace {

/// By part and name, which is unique in a part.
std::map<std::string, const json*> programsIn(const json& calibration) {
  std::map<std::string, const json*> programs;
  for (const json& part : calibration.at("parts"))
    for (const json& program : part.at("programs"))
      programs[part.at("part").get<std::string>() + '/' + program.at("name").get<std::string>()] =
          &program;
  return programs;
}

} // namespace

Drift driftOf(const std::string& variant, const json& before, const json& after, double limit) {
  Drift drift;
  drift.variant = variant;
  const auto others = programsIn(after);
  for (const auto& [name, program] : programsIn(before)) {
    const auto other = others.find(name);
    const json& scores = program->at("scores");
    if (other == others.end() || other->second->at("scores").size() != scores.size()) {
      drift.failures.push_back(name + ": not graded as often");
      continue;
    }
    if (program->at("accepted") != other->second->at("accepted"))
      drift.failures.push_back(name + ": another verdict");
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const json &one = scores[i], &two = other->second->at("scores")[i];
      ++drift.gradings;
      if (one.at("outcome") != two.at("outcome"))
        drift.failures.push_back(fmt::format(
            "{}, seed {}: {} became {}", name, one.at("seed").dump(),
            one.at("outcome").get<std::string>(), two.at("outcome").get<std::string>()));
      const auto moved = [&](const char* points) {
        return std::abs(one.at(points).get<double>() - two.at(points).get<double>());
      };
      const double distance = std::max(moved("score"), moved("bonus"));
      if (distance == 0) continue;
      ++drift.moved;
      if (distance > drift.furthest) {
        drift.furthest = distance;
        drift.where = name;
      }
      if (distance > limit)
        drift.failures.push_back(fmt::format("{}, seed {}: the score moved by {:.2f}", name,
                                             one.at("seed").dump(), distance));
    }
  }
  return drift;
}

std::string tableOf(const std::vector<Drift>& drifts) {
  std::string text = fmt::format("{:<28} {:>8} {:>6} {:>9}  {}\n", "drawn with", "gradings",
                                 "moved", "furthest", "where");
  for (const Drift& drift : drifts)
    text += fmt::format("{:<28} {:>8} {:>6} {:>9.2f}  {}\n", drift.variant, drift.gradings,
                        drift.moved, drift.furthest, drift.where);
  return text;
}

json toJson(const std::vector<Drift>& drifts) {
  json all = json::array();
  for (const Drift& drift : drifts)
    all.push_back({{"variant", drift.variant},
                   {"gradings", drift.gradings},
                   {"moved", drift.moved},
                   {"furthest", drift.furthest},
                   {"where", drift.where},
                   {"failures", drift.failures}});
  return all;
}

} // namespace ggrade::calibration
