#include "tradeoff/plan.hpp"

#include "grading/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace ggrade::tradeoff {

namespace fs = std::filesystem;

namespace {

/// They leave room for those that are timed.
constexpr std::size_t kMostBefore = 32;

/// The file being read, and where in it: every error names both.
class Reader {
public:
  Reader(const Assignment& assignment, const fs::path& file)
      : assignment_(assignment), file_(file.string()) {}

  [[noreturn]] void fail(const std::string& key, const std::string& why) const {
    throw UsageError(fmt::format("{}: {}: {}", file_, key, why));
  }

  void checkKeys(const json& object, const std::string& at,
                 const std::vector<std::string>& known) const {
    if (!object.is_object()) fail(at, fmt::format("must be an object, but is {}", object.dump()));
    for (const auto& [key, value] : object.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        fail(at.empty() ? key : at + "." + key,
             fmt::format("there is no such key here; there are: {}", join(known)));
  }

  const json& get(const json& object, const std::string& at, const std::string& key) const {
    const auto found = object.find(key);
    if (found == object.end()) fail(at, fmt::format("lacks the key \"{}\"", key));
    return *found;
  }

  std::string text(const json& object, const std::string& at, const std::string& key) const {
    const json& value = get(object, at, key);
    if (!value.is_string() || value.get<std::string>().empty())
      fail(at + "." + key, fmt::format("must be text, but is {}", value.dump()));
    return value;
  }

  const json& list(const json& object, const std::string& at, const std::string& key) const {
    const json& value = get(object, at, key);
    if (!value.is_array() || value.empty())
      fail(at + "." + key,
           fmt::format("must be a list that is not empty, but is {}", value.dump()));
    return value;
  }

  /// `base` with `patch` over it, which assignment.json must allow.
  json scene(json base, const json& patch, const std::string& at) const {
    if (!patch.is_object()) fail(at, fmt::format("must be an object, but is {}", patch.dump()));
    base.merge_patch(patch);
    try {
      grading::checkScene(assignment_, base, at);
    } catch (const UsageError& error) {
      throw UsageError(fmt::format("{}: {}", file_, error.what()));
    }
    return base;
  }

  std::vector<rubric::Moment> before(const json& object, const std::string& at) const {
    const auto frames =
        rubric::readBefore(object.value("before", json::array()), file_ + ": " + at);
    if (frames.size() > kMostBefore)
      fail(at + ".before", fmt::format("{} frames are more than {}", frames.size(), kMostBefore));
    return frames;
  }

  static std::string join(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
  }

private:
  const Assignment& assignment_;
  std::string file_;
};

Number readNumber(const Reader& reader, const json& scene, const std::string& at,
                  const std::string& name, const json& values) {
  const std::string key = at + ".numbers." + name;
  if (!values.is_array() || values.empty())
    reader.fail(key, fmt::format("must be a list of numbers, but is {}", values.dump()));
  if (!scene.at("quality").contains(name))
    reader.fail(key, "scene.json has no such quality number");
  Number number{name, {}, {}, false};
  for (const json& value : values) {
    if (!value.is_number()) reader.fail(key, fmt::format("{} is not a number", value.dump()));
    if (std::find(number.values.begin(), number.values.end(), value) != number.values.end())
      reader.fail(key, fmt::format("{} stands there twice", value.dump()));
    reader.scene(scene, {{"quality", {{name, value}}}}, key);
    number.values.push_back(value);
  }
  return number;
}

std::vector<std::string> namesOf(const Sweep& sweep) {
  std::vector<std::string> names;
  for (const Number& number : sweep.numbers) names.push_back(number.name);
  return names;
}

Sweep readSweep(const Reader& reader, const json& base, const json& off, const json& read,
                const std::string& part, const std::string& at) {
  reader.checkKeys(read, at,
                   {"name", "about", "time", "before", "scene", "truth", "numbers", "together",
                    "reference", "notes", "compare"});
  Sweep sweep;
  sweep.part = part;
  sweep.name = reader.text(read, at, "name");
  if (sweep.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != sweep.name.npos)
    reader.fail(at + ".name",
                fmt::format("\"{}\" may hold small letters, digits and _ only", sweep.name));
  sweep.about = reader.text(read, at, "about");
  const json& time = reader.get(read, at, "time");
  if (!time.is_number() || time.get<double>() < 0)
    reader.fail(at + ".time", fmt::format("must be seconds from 0, but is {}", time.dump()));
  sweep.time = time;
  sweep.before = reader.before(read, at);
  sweep.truth = read.value("truth", json());
  sweep.scene = reader.scene(base, read.value("scene", json::object()), at + ".scene");
  sweep.off = reader.scene(sweep.scene, off, "parts." + part + ".off");
  const json& numbers = reader.get(read, at, "numbers");
  if (!numbers.is_object() || numbers.empty())
    reader.fail(at + ".numbers", fmt::format("must name numbers, but is {}", numbers.dump()));
  for (const auto& [name, values] : numbers.items())
    sweep.numbers.push_back(readNumber(reader, sweep.scene, at, name, values));
  const json notes = read.value("notes", json::object());
  reader.checkKeys(notes, at + ".notes", namesOf(sweep));
  for (Number& number : sweep.numbers)
    if (notes.contains(number.name)) number.note = reader.text(notes, at + ".notes", number.name);
  sweep.reference = read.value("reference", json::object());
  reader.checkKeys(sweep.reference, at + ".reference", namesOf(sweep));
  reader.scene(sweep.scene, {{"quality", sweep.reference}}, at + ".reference");
  for (const json& group : read.value("together", json::array())) {
    const std::string key = at + ".together";
    if (!group.is_array() || group.size() < 2)
      reader.fail(key,
                  fmt::format("must list groups of two or more numbers, but has {}", group.dump()));
    std::vector<std::string> names;
    for (const json& name : group) {
      if (!name.is_string() || !numbers.contains(name.get<std::string>()))
        reader.fail(key, fmt::format("{} is not one of this scene's numbers", name.dump()));
      if (std::find(names.begin(), names.end(), name.get<std::string>()) != names.end())
        reader.fail(key, fmt::format("{} stands twice in {}", name.dump(), group.dump()));
      names.push_back(name);
    }
    sweep.together.push_back(names);
  }
  for (const json& entry : read.value("compare", json::array())) {
    const std::string key = fmt::format("{}.compare[{}]", at, sweep.compare.size());
    reader.checkKeys(entry, key, {"name", "setting"});
    Named named{reader.text(entry, key, "name"), reader.get(entry, key, "setting")};
    if (!named.setting.is_object())
      reader.fail(key + ".setting",
                  fmt::format("must be an object, but is {}", named.setting.dump()));
    if (std::ranges::none_of(allSettings(sweep),
                             [&](const json& setting) { return holds(setting, named.setting); }))
      reader.fail(key + ".setting",
                  fmt::format("{} is not among the settings that are swept", named.setting.dump()));
    sweep.compare.push_back(std::move(named));
  }
  return sweep;
}

Series readSeries(const Reader& reader, const json& base, const json& read, const std::string& at) {
  reader.checkKeys(read, at, {"name", "steps"});
  Series series{reader.text(read, at, "name"), {}};
  for (const json& entry : reader.list(read, at, "steps")) {
    const std::string key = fmt::format("{}.steps[{}]", at, series.steps.size());
    reader.checkKeys(entry, key, {"value", "scene", "sphere"});
    Step step;
    step.scene = entry.value("scene", json::object());
    if (const auto rings = entry.find("sphere"); rings != entry.end()) {
      if (!rings->is_number_integer() || *rings < 2 || *rings > 1000)
        reader.fail(key + ".sphere",
                    fmt::format("must be 2 to 1000 rings, but is {}", rings->dump()));
      step.sphere = *rings;
      step.value = sphereTriangles(step.sphere);
      step.scene["mesh"] = sphereFile(step.sphere);
    } else {
      const json& value = reader.get(entry, key, "value");
      if (!value.is_number() || value.get<double>() <= 0)
        reader.fail(key + ".value", fmt::format("must be above 0, but is {}", value.dump()));
      step.value = value;
    }
    reader.scene(base, step.scene, key + ".scene");
    series.steps.push_back(std::move(step));
  }
  return series;
}

SavedCase readSaved(const Reader& reader, const json& base, const json& read,
                    const std::string& at) {
  reader.checkKeys(read, at, {"name", "scene", "against"});
  SavedCase saved;
  saved.name = reader.text(read, at, "name");
  saved.scene = reader.scene(base, read.value("scene", json::object()), at + ".scene");
  saved.against =
      reader.scene(saved.scene, read.value("against", json{{"debug", {{"draw_all_passes", true}}}}),
                   at + ".against");
  return saved;
}

/// The values of the numbers in `names`, all combinations of them, over `setting`.
void combine(const Sweep& sweep, const std::vector<std::string>& names, std::size_t next,
             json setting, std::vector<json>& into) {
  if (next == names.size()) {
    into.push_back(std::move(setting));
    return;
  }
  for (const Number& number : sweep.numbers) {
    if (number.name != names[next]) continue;
    for (const json& value : number.values) {
      setting[number.name] = value;
      combine(sweep, names, next + 1, setting, into);
    }
  }
}

} // namespace

Plan readPlan(const Assignment& assignment, const std::vector<std::string>& parts,
              const fs::path& file) {
  const json read = readJson(file);
  const Reader reader(assignment, file);
  reader.checkKeys(read, "", {"size", "parts", "amounts", "growth", "saved"});
  Plan plan;
  std::set<std::string> known;
  const json size = {{"size", reader.get(read, "size", "size")}};
  const json& all = reader.get(read, "parts", "parts");
  for (const auto& [part, unused] : all.items())
    if (std::none_of(assignment.parts.begin(), assignment.parts.end(),
                     [&part = part](const Part& declared) { return declared.id == part; }))
      reader.fail("parts." + part, fmt::format("{} has no such part", assignment.id));
  for (const Part& declared : assignment.parts) {
    const std::string& part = declared.id;
    if (!all.contains(part)) continue;
    const json& settings = all[part];
    const std::string at = "parts." + part;
    reader.checkKeys(settings, at, {"off", "scenes"});
    const json shown = grading::partScene(assignment, {part});
    const json base = reader.scene(shown, size, "size");
    const json& off = reader.get(settings, at, "off");
    const bool wanted = std::find(parts.begin(), parts.end(), part) != parts.end();
    if (wanted) plan.parts.push_back({part, shown, reader.scene(shown, off, at + ".off")});
    std::size_t index = 0;
    std::set<std::string> names;
    for (const json& scene : reader.list(settings, at, "scenes")) {
      const std::string key = fmt::format("{}.scenes[{}]", at, index++);
      Sweep sweep = readSweep(reader, base, off, scene, part, key);
      if (!names.insert(sweep.name).second)
        reader.fail(key + ".name", fmt::format("\"{}\" is another scene of this part", sweep.name));
      for (const Number& number : sweep.numbers)
        if (!known.insert(number.name).second) sweep.suffix = '.' + sweep.name;
      if (wanted) plan.sweeps.push_back(std::move(sweep));
    }
  }
  for (const json& name : read.value("amounts", json::array())) {
    if (!name.is_string() || !known.count(name.get<std::string>()))
      reader.fail("amounts", fmt::format("{} is not a number that is swept", name.dump()));
    for (Sweep& sweep : plan.sweeps)
      for (Number& number : sweep.numbers)
        if (number.name == name.get<std::string>()) number.amount = true;
  }
  std::vector<std::string> everyPart;
  for (const Part& part : assignment.parts) everyPart.push_back(part.id);
  const json whole = grading::partScene(assignment, everyPart);
  const json plain = grading::partScene(assignment, {});
  for (const json& series : read.value("growth", json::array()))
    plan.growth.push_back(
        readSeries(reader, whole, series, fmt::format("growth[{}]", plan.growth.size())));
  for (const json& saved : read.value("saved", json::array()))
    plan.saved.push_back(
        readSaved(reader, plain, saved, fmt::format("saved[{}]", plan.saved.size())));
  return plan;
}

void keepOnly(Plan& plan, const std::vector<std::string>& only) {
  if (only.empty()) return;
  const auto wanted = [&](const std::string& name) {
    return std::find(only.begin(), only.end(), name) != only.end();
  };
  std::vector<std::string> known;
  for (const Sweep& sweep : plan.sweeps)
    for (const std::string& name : namesOf(sweep)) known.push_back(name);
  for (const std::string& name : only)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw UsageError(fmt::format("--only {}: no sweep has this number; there are: {}", name,
                                   Reader::join(known)));
  for (Sweep& sweep : plan.sweeps) {
    std::erase_if(sweep.numbers, [&](const Number& number) { return !wanted(number.name); });
    std::erase_if(sweep.together, [&](const std::vector<std::string>& names) {
      return !std::all_of(names.begin(), names.end(), wanted);
    });
    std::erase_if(sweep.compare, [&](const Named& named) {
      return !std::ranges::all_of(named.setting.items(),
                                  [&](const auto& entry) { return wanted(entry.key()); });
    });
  }
  std::erase_if(plan.sweeps, [](const Sweep& sweep) { return sweep.numbers.empty(); });
}

json defaultSetting(const Sweep& sweep) {
  json setting = json::object();
  for (const Number& number : sweep.numbers)
    setting[number.name] = sweep.scene.at("quality").at(number.name);
  return setting;
}

json referenceSetting(const Sweep& sweep) {
  json setting = json::object();
  for (const Number& number : sweep.numbers)
    setting[number.name] = sweep.reference.value(number.name, number.values.back());
  return setting;
}

std::vector<json> settingsOf(const Sweep& sweep, const std::string& number) {
  return settingsOf(sweep, std::vector<std::string>{number});
}

std::vector<json> settingsOf(const Sweep& sweep, const std::vector<std::string>& together) {
  std::vector<json> settings;
  combine(sweep, together, 0, defaultSetting(sweep), settings);
  return settings;
}

std::vector<json> allSettings(const Sweep& sweep) {
  std::vector<json> all;
  const auto add = [&](const std::vector<json>& settings) {
    for (const json& setting : settings)
      if (std::find(all.begin(), all.end(), setting) == all.end()) all.push_back(setting);
  };
  add({defaultSetting(sweep)});
  for (const Number& number : sweep.numbers) add(settingsOf(sweep, number.name));
  for (const auto& names : sweep.together) add(settingsOf(sweep, names));
  add({referenceSetting(sweep)});
  return all;
}

bool holds(const json& setting, const json& part) {
  json both = setting;
  both.update(part);
  return both == setting;
}

json withSetting(json scene, const json& setting) {
  scene.at("quality").update(setting);
  return scene;
}

std::string sphereFile(int rings) {
  return fmt::format("sphere-{}.obj", rings);
}

double sphereTriangles(int rings) {
  return 4.0 * rings * (rings - 1);
}

std::string sphereObj(int rings) {
  if (rings < 2) throw std::invalid_argument("a sphere has at least 2 rings");
  const int around = 2 * rings;
  std::string text;
  for (int i = 0; i <= rings; ++i)
    for (int k = 0; k <= around; ++k) {
      const double latitude = std::numbers::pi * i / rings;
      const double longitude = std::numbers::pi * k / rings;
      const double x = std::sin(latitude) * std::sin(longitude), y = -std::cos(latitude),
                   z = std::sin(latitude) * std::cos(longitude);
      text += fmt::format("v {:.6f} {:.6f} {:.6f}\nvn {:.6f} {:.6f} {:.6f}\n", 0.5 * x,
                          0.5 * y + 0.5, 0.5 * z, x, y, z);
    }
  const auto triangle = [&](int a, int b, int c) {
    text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a, b, c);
  };
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      const int low = i * (around + 1) + k + 1, high = low + around + 1;
      if (i > 0) triangle(low, low + 1, high + 1); // at the pole it has no area
      if (i + 1 < rings) triangle(low, high + 1, high);
    }
  return text;
}

} // namespace ggrade::tradeoff
