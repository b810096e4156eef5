#include "grading/scenes.hpp"

#include "words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gg/error.hpp>
#include <gg/scene.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Draws values. std::uniform_real_distribution differs between libraries; this doesn't.
class Drawer {
public:
  explicit Drawer(std::uint64_t seed) : engine_(seed) {}

  json draw(const json& from) {
    if (from.is_object() && from.size() == 1 && from.contains("between"))
      return between(from["between"].at(0), from["between"].at(1));
    if (from.is_object() && from.size() == 1 && from.contains("choose")) {
      const json& all = from["choose"];
      if (!all.is_array() || all.empty()) throw UsageError("choose: needs a list with values");
      return all[std::min<std::size_t>(std::size_t(unit() * double(all.size())), all.size() - 1)];
    }
    if (!from.is_structured()) return from;
    json to = from;
    for (json& value : to) value = draw(value);
    return to;
  }

private:
  double unit() { return double(engine_() >> 11) * 0x1p-53; }

  json between(const json& low, const json& high) {
    if (low.is_number_integer() && high.is_number_integer()) {
      const auto first = low.get<std::int64_t>(), last = high.get<std::int64_t>();
      return first + std::int64_t(std::floor(unit() * double(last - first + 1)));
    }
    if (low.is_number() && high.is_number()) {
      const double value = low.get<double>() + unit() * (high.get<double>() - low.get<double>());
      return std::round(value * 1e4) / 1e4; // short numbers, so that a scene can be read and quoted
    }
    if (!low.is_array() || !high.is_array() || low.size() != high.size())
      throw UsageError("between: needs two numbers or two lists of one length");
    json all = json::array();
    for (std::size_t i = 0; i < low.size(); ++i) all.push_back(between(low[i], high[i]));
    return all;
  }

  std::mt19937_64 engine_;
};

/// `change` with `plus` and `times` worked out from the values of `base` at the same places.
json changed(const json& base, const json& change, const std::string& where) {
  const bool plus = change.is_object() && change.size() == 1 && change.contains("plus");
  const bool times = change.is_object() && change.size() == 1 && change.contains("times");
  if (!plus && !times) {
    json to = change;
    if (change.is_object())
      for (const auto& [key, value] : change.items())
        to[key] = changed(base.is_object() ? base.value(key, json()) : json(), value,
                          where.empty() ? key : where + "." + key);
    return to;
  }
  const json& by = change[plus ? "plus" : "times"];
  const auto one = [&](const json& from, const json& step) -> json {
    if (!from.is_number() || !step.is_number())
      throw UsageError(
          fmt::format("{}: plus and times need numbers in the scene that it is like", where));
    const double value =
        plus ? from.get<double>() + step.get<double>() : from.get<double>() * step.get<double>();
    const double rounded = std::round(value * 1e4) / 1e4;
    // A size of pixels must stay a whole number where it can.
    if (from.is_number_integer() && rounded == std::floor(rounded)) return std::int64_t(rounded);
    return rounded;
  };
  if (!base.is_array()) return one(base, by);
  if (by.is_array() && by.size() != base.size())
    throw UsageError(fmt::format("{}: {} values where the scene that it is like has {}", where,
                                 by.size(), base.size()));
  json all = json::array();
  for (std::size_t i = 0; i < base.size(); ++i)
    all.push_back(one(base[i], by.is_array() ? by[i] : by));
  return all;
}

bool shareATag(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

/// The parts that a declared scene shows: those that it names, else all that are graded.
std::vector<std::string> partsOf(const json& declared, const Target& target) {
  if (declared.contains("parts")) return declared["parts"].get<std::vector<std::string>>();
  std::vector<std::string> all;
  for (const Part& part : target.parts) all.push_back(part.id);
  return all;
}

} // namespace

json partScene(const Assignment& assignment, const std::vector<std::string>& ids) {
  json scene = readJson(assignment.folder / "scene.json");
  for (const Part& part : assignment.parts)
    if (std::find(ids.begin(), ids.end(), part.id) != ids.end()) scene.merge_patch(part.scene);
  return scene;
}

namespace {

void checkText(const Assignment& assignment, const std::string& text, const std::string& name) {
  try {
    // Read here: what the machine can't read is no fault of the scene's.
    const std::string json = "assignment.json", presets = "presets.json";
    gg::Declarations declared =
        gg::Declarations::fromText(readFile(assignment.folder / json), json);
    if (fs::exists(assignment.folder / presets))
      declared.addPresets(readFile(assignment.folder / presets), presets);
    gg::Scene::fromText(text, name, declared);
  } catch (const gg::SceneError& error) {
    throw UsageError(error.what());
  }
}

} // namespace

void checkScene(const Assignment& assignment, const json& scene, const std::string& name) {
  checkText(assignment, scene.dump(2), name);
}

json readScene(const Assignment& assignment, const fs::path& file) {
  const json scene = readJson(file);
  // As it stands in the file: the line of a wrong key is its line there.
  checkText(assignment, readFile(file), file.string());
  return scene;
}

namespace {

/// What handout.json changes for a step; nothing for the picture before the first one.
json stepOf(const Part& part, const json& settings, std::size_t k) {
  if (k == 0) return json::object();
  return settings.value("steps", json::object()).value(part.todos.at(k - 1).id, json::object());
}

} // namespace

json handoutScene(const Assignment& assignment, const Part& part, const json& settings,
                  std::size_t k) {
  json scene = partScene(assignment, {part.id});
  scene.merge_patch(settings.value("scene", json::object()));
  json step = stepOf(part, settings, k);
  step.erase("before"); // its frames
  scene.merge_patch(step);
  return scene;
}

Moments handoutTimes(const json& settings, const json& one, const std::string& name) {
  const std::string where = "handout.json: " + name;
  Moments times(settings.at("times").get<std::vector<double>>());
  const json& from = one.contains("before") ? one : settings;
  times.before = rubric::readBefore(from.value("before", json::array()), where);
  rubric::checkFrames(times, where);
  return times;
}

Moments handoutTimes(const Part& part, const json& settings, std::size_t k) {
  return handoutTimes(settings, stepOf(part, settings, k), fmt::format("{}-{}", part.id, k));
}

namespace {

/// Draws one scene of scenes.json after another into a plan.
class Planner {
public:
  Planner(const Target& target, const fs::path& path, const json& probes, ScenePlan& plan)
      : target_(target), path_(path), probes_(probes), plan_(plan) {}

  /// `parts` as of partsOf; `round` 0, or 1 for the same scene drawn anew.
  void add(const json& declared, const std::vector<std::string>& parts, std::uint64_t index,
           std::uint64_t round) {
    // A generator of its own for every scene: adding one leaves the others as they were.
    Drawer drawer(plan_.seed * 0x9e3779b97f4a7c15ull + index + (round << 32));
    // Where several parts are graded, equal names of theirs are told apart.
    const bool prefixed = target_.parts.size() > 1 && declared.contains("parts");
    const auto withParts = [&](const std::string& name) {
      return prefixed ? fmt::format("{}: {}", fmt::join(parts, " + "), name) : name;
    };
    const auto named = [&](const std::string& english) {
      const std::string name = withParts(std::string(gg::words(english)));
      return round > 0 ? gg::say("{}, drawn anew", name) : name;
    };
    SceneCase one;
    one.name = named(declared.at("name"));
    one.english = withParts(declared.at("name")) + (round > 0 ? ", drawn anew" : "");
    one.isPublic = declared.value("public", false);
    one.tags = declared.value("tags", std::vector<std::string>{});
    if (declared.contains("like")) {
      const json change = drawer.draw(declared.value("scene", json::object()));
      const std::string base = named(declared.at("like"));
      const auto found = std::find_if(plan_.scenes.begin(), plan_.scenes.end(),
                                      [&](const SceneCase& scene) { return scene.name == base; });
      if (found == plan_.scenes.end())
        throw UsageError(fmt::format("{}: like \"{}\": no earlier scene of these parts has that "
                                     "name",
                                     one.name, declared.at("like").get<std::string>()));
      one.like = base;
      one.times = found->times.first();
      one.scene = found->scene;
      one.scene.merge_patch(changed(found->scene, change, ""));
    } else {
      one.times.shown = drawer.draw(declared.at("times")).get<std::vector<double>>();
      one.scene = partScene(target_.assignment, parts);
      one.scene.merge_patch(drawer.draw(declared.value("scene", json::object())));
    }
    // Last, so that a scene with it is drawn as without.
    if (declared.contains("before"))
      one.times.before = rubric::readBefore(drawer.draw(declared["before"]), one.name);
    rubric::checkFrames(one.times, one.name);
    addProbes(one);
    checkScene(target_.assignment, one.scene, path_.string() + ", " + one.name);
    for (const auto& [name, probe] : one.probes)
      checkScene(target_.assignment, probe, path_.string() + ", " + one.name + ", probe " + name);
    plan_.scenes.push_back(std::move(one));
  }

private:
  void addProbes(SceneCase& one) const {
    for (const json& declared : probes_) {
      const auto tags = declared.value("tags", std::vector<std::string>{});
      if (!tags.empty() && !shareATag(tags, one.tags)) continue;
      json probe = one.scene;
      probe.merge_patch(declared.at("scene"));
      one.probes[declared.at("name")] = probe;
    }
  }

  const Target& target_;
  const fs::path& path_;
  const json& probes_;
  ScenePlan& plan_;
};

} // namespace

Quality parseQuality(const std::string& name) {
  for (std::size_t i = 0; i < std::size(kQualities); ++i)
    if (name == kQualities[i]) return Quality(i);
  throw UsageError(
      fmt::format("quality \"{}\": it is one of {}", name, fmt::join(kQualities, ", ")));
}

ScenePlan drawScenes(const Target& target, const fs::path& solutionFolder, const Draw& draw) {
  const fs::path path = solutionFolder / "scenes.json";
  const json from = readJson(path);
  addWords(solutionFolder);
  try {
    ScenePlan plan;
    plan.seed = draw.seed ? *draw.seed : from.at("seed").get<std::uint64_t>();
    plan.quality = draw.quality;
    const json probes = from.value("probes", json::array());
    Planner planner(target, path, probes, plan);
    const std::uint64_t rounds = draw.quality == Quality::thorough ? 2 : 1;
    for (std::uint64_t round = 0; round < rounds; ++round) {
      std::uint64_t index = 0;
      for (const json& declared : from.at("scenes")) {
        ++index;
        const std::vector<std::string> parts = partsOf(declared, target);
        const auto graded = [&](const std::string& part) { return target.covers(part); };
        if (!std::all_of(parts.begin(), parts.end(), graded)) continue;
        if (draw.quality == Quality::fast && declared.contains("like")) continue;
        if (round > 0 && declared.value("public", false)) continue;
        planner.add(declared, parts, index, round);
      }
    }
    return plan;
  } catch (const json::exception& error) {
    throw UsageError(fmt::format("{}: {}", path.string(), error.what()));
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

std::string describe(const ScenePlan& plan) {
  std::map<std::string, std::string> english = {{"", ""}}; // of a scene's name
  json all = json::array();
  for (const SceneCase& one : plan.scenes) {
    english[one.name] = one.english.empty() ? one.name : one.english;
    all.push_back({english[one.name], one.isPublic, one.tags, one.times, one.scene,
                   english[one.like], one.probes});
  }
  return fmt::format("{} {} {}", plan.seed, nameOf(plan.quality), all.dump());
}

} // namespace ggrade::grading
