#include <gg/declarations.hpp>

#include <algorithm>
#include <numeric>

#include "json_positions.hpp"
#include "words/words.hpp"
#include <fmt/format.h>
#include <gg/error.hpp>
#include <gg/text_file.hpp>
#include <nlohmann/json.hpp>

namespace gg {

namespace {

using nlohmann::json;

constexpr double kFarthest = 1e9;    // positions: float still tells 64 units apart there
constexpr double kBrightest = 65504; // colours: the largest half float

KeyDeclaration integers(int length, double lowest, double highest, const char* about) {
  return {KeyType::integer, length, lowest, highest, false, {}, about};
}
KeyDeclaration reals(int length, double lowest, double highest, const char* about) {
  return {KeyType::real, length, lowest, highest, false, {}, about};
}
KeyDeclaration withDefault(KeyDeclaration key, SceneValue value) {
  key.hasDefault = true;
  key.defaultValue = std::move(value);
  return key;
}

using Numbers = std::vector<double>;

[[noreturn]] void fail(const std::string& name, const std::string& path, const std::string& what) {
  throw SceneError(fmt::format("{}: scene: {}: {}", name, path, what));
}

detail::JsonValue valueOf(const json& value) {
  detail::JsonValue result;
  using Kind = detail::JsonValue::Kind;
  result.shown = value.dump();
  if (value.is_boolean()) {
    result.kind = Kind::boolean;
    result.boolean = value;
  } else if (value.is_number()) {
    result.kind = Kind::number;
    result.number = value;
  } else if (value.is_string()) {
    result.kind = Kind::text;
    result.text = value;
  } else {
    result.kind = Kind::object;
  }
  return result;
}

KeyType typeNamed(const std::string& name, const std::string& path, const json& type) {
  if (type == "boolean") return KeyType::boolean;
  if (type == "integer") return KeyType::integer;
  if (type == "real") return KeyType::real;
  if (type == "text") return KeyType::text;
  fail(name, path, "type must be \"boolean\", \"integer\", \"real\" or \"text\"");
}

KeyDeclaration readKey(const std::string& name, const std::string& path, const json& source) {
  if (!source.is_object()) fail(name, path, "must be an object");
  for (const auto& [member, unused] : source.items())
    if (member != "type" && member != "range" && member != "default" && member != "about")
      fail(name, path, fmt::format("unknown member \"{}\"", member));

  KeyDeclaration key;
  key.type = typeNamed(name, path, source.value("type", json()));
  const bool isNumber = key.type == KeyType::integer || key.type == KeyType::real;
  if (isNumber != source.contains("range"))
    fail(name, path, isNumber ? "a number needs a range" : "only a number has a range");
  if (isNumber) {
    const json& range = source["range"];
    if (!range.is_array() || range.size() != 2 || !range[0].is_number() || !range[1].is_number() ||
        range[0] > range[1])
      fail(name, path, "range must be [lowest, highest]");
    key.lowest = range[0];
    key.highest = range[1];
    if (key.type == KeyType::integer && (key.lowest < -2147483648.0 || key.highest > 2147483647.0))
      fail(name, path, "an integer's range must lie within 32 bits");
  }
  if (source.contains("default")) {
    const auto value = detail::convert(key, valueOf(source["default"]));
    if (!value)
      fail(name, path,
           fmt::format("default must be {}, but is {}", Declarations::describe(key),
                       source["default"].dump()));
    key.hasDefault = true;
    key.defaultValue = *value;
  }
  key.about = source.value("about", "");
  return key;
}

json parseObject(std::string_view text, const std::string& name) {
  json object;
  try {
    object = json::parse(text);
  } catch (const json::exception& error) {
    throw SceneError(fmt::format("{}: is not valid JSON: {}", name, error.what()));
  }
  if (!object.is_object()) throw SceneError(name + ": must be an object: { ... }");
  return object;
}

// The settings of one preset.
Declarations::Preset readPreset(const std::string& name, const std::string& preset,
                                const json& source,
                                const std::map<std::string, KeyDeclaration, std::less<>>& keys) {
  const auto refuse = [&](const std::string& what) {
    throw SceneError(fmt::format("{}: {}: {}", name, preset, what));
  };
  if (!source.is_object()) refuse("must be an object of quality keys and their values");
  Declarations::Preset settings;
  for (const auto& [number, value] : source.items()) {
    const auto key = keys.find("quality." + number);
    if (key == keys.end()) refuse(fmt::format("\"{}\" is no declared key of quality", number));
    const auto converted = detail::convert(key->second, valueOf(value));
    if (!converted)
      refuse(fmt::format("{} must be {}, but is {}", number, Declarations::describe(key->second),
                         value.dump()));
    settings.emplace(key->first, *converted);
  }
  return settings;
}

// Number of single-character edits between two words (Levenshtein 1966).
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

} // namespace

Declarations::Declarations(const std::vector<std::string>& materials) : materials_(materials) {
  const Numbers white{1, 1, 1}, dim{0.2, 0.2, 0.2};
  keys_ = {
      {"size", withDefault(integers(2, 1, 16384, "width and height of the window, pixels"),
                           Numbers{640, 480})},
      {"background", withDefault(reals(3, 0, kBrightest, "colour"), Numbers{0, 0, 0})},
      {"camera.position", reals(3, -kFarthest, kFarthest, "where the eye is")},
      {"camera.target", reals(3, -kFarthest, kFarthest, "what it looks at")},
      {"camera.up",
       withDefault(reals(3, -kFarthest, kFarthest, "what is up in the picture"), Numbers{0, 1, 0})},
      {"camera.fov", reals(1, 0.01, 3.1, "vertical angle of view, radians")},
      {"camera.near", reals(1, 1e-6, kFarthest, "distance of the near plane")},
      {"camera.far", reals(1, 1e-6, kFarthest, "distance of the far plane")},
      {"light.position", reals(3, -kFarthest, kFarthest, "where the light is")},
      {"light.ambient", withDefault(reals(3, 0, kBrightest, "colour"), dim)},
      {"light.diffuse", withDefault(reals(3, 0, kBrightest, "colour"), white)},
      {"light.specular", withDefault(reals(3, 0, kBrightest, "colour"), white)},
  };
  for (const std::string& material : materials_) {
    const std::string path = "materials." + material;
    keys_[path + ".ambient"] = reals(3, 0, kBrightest, "colour");
    keys_[path + ".diffuse"] = reals(3, 0, kBrightest, "colour");
    keys_[path + ".specular"] = reals(3, 0, kBrightest, "colour");
    keys_[path + ".shininess"] = reals(1, 0.01, 10000, "Blinn-Phong exponent");
  }
}

Declarations Declarations::fromText(std::string_view text, const std::string& name) {
  const json assignment = parseObject(text, name);
  std::vector<std::string> materials;
  for (const json& material : assignment.value("materials", json::array())) {
    const bool usable = material.is_string() && material != "" &&
                        material.get_ref<const std::string&>().find('.') == std::string::npos;
    if (!usable) throw SceneError(name + ": materials: must be names without a dot");
    materials.push_back(material);
  }
  Declarations result(materials);
  const json scene = assignment.value("scene", json::object());
  if (!scene.is_object()) throw SceneError(name + ": scene: must be an object");
  for (const auto& [path, key] : scene.items()) {
    if (!result.keys_.emplace(path, readKey(name, path, key)).second)
      fail(name, path, "every scene has this key already");
  }
  for (const auto& [path, key] : result.keys_) {
    const auto next = result.keys_.upper_bound(path + ".");
    if (next != result.keys_.end() && next->first.starts_with(path + "."))
      fail(name, next->first, fmt::format("\"{}\" is a value, so it can't hold others", path));
  }
  return result;
}

void Declarations::addPresets(std::string_view text, const std::string& name) {
  const json presets = parseObject(text, name);
  for (const auto& [preset, settings] : presets.items())
    presets_[preset] = readPreset(name, preset, settings, keys_);
}

Declarations Declarations::fromFile(const std::string& file) {
  const std::filesystem::path path = fromUtf8(file);
  try {
    Declarations result = fromText(readFile(path), toUtf8(path.filename()));
    const std::filesystem::path presets = path.parent_path() / "presets.json";
    if (std::filesystem::exists(presets)) result.addPresets(readFile(presets), "presets.json");
    return result;
  } catch (const FileError& error) {
    throw SceneError(error.what());
  }
}

std::string Declarations::nearest(std::string_view key) const {
  std::string best;
  // More than a third of the letters wrong is another word.
  std::size_t bestDistance = key.size() / 3 + 1;
  const auto consider = [&](const std::string& candidate) {
    const std::size_t distance = editDistance(key, candidate);
    if (distance >= bestDistance) return;
    best = candidate;
    bestDistance = distance;
  };
  for (const auto& [path, unused] : keys_) {
    consider(path);
    for (std::size_t dot = path.find('.'); dot != path.npos; dot = path.find('.', dot + 1))
      consider(path.substr(0, dot));
  }
  return best;
}

std::string Declarations::describe(const KeyDeclaration& key) {
  if (key.type == KeyType::boolean) return say("true or false");
  if (key.type == KeyType::text) return say("a text in quotes");
  const bool whole = key.type == KeyType::integer;
  if (key.length == 1)
    return whole ? say("a whole number between {} and {}", key.lowest, key.highest)
                 : say("a number between {} and {}", key.lowest, key.highest);
  return whole
             ? say("an array of {} whole numbers between {} and {}", key.length, key.lowest,
                   key.highest)
             : say("an array of {} numbers between {} and {}", key.length, key.lowest, key.highest);
}

} // namespace gg
