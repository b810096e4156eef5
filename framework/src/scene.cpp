#include <gg/scene.hpp>

#include "json_positions.hpp"
#include "words/words.hpp"
#include <fmt/format.h>
#include <gg/error.hpp>
#include <gg/text_file.hpp>
#include <glm/geometric.hpp>

namespace gg {

namespace {

using Values = std::map<std::string, SceneValue, std::less<>>;

// Where each key stands in the file, so that a message about two of them can name a line.
class Positions {
public:
  explicit Positions(const std::string& name) : name_(name) {}
  void add(const std::string& key, int line) { lines_[key] = line; }

  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    const auto found = lines_.find(key);
    const std::string line = found == lines_.end() ? "" : fmt::format(":{}", found->second);
    throw SceneError(fmt::format("{}{}: {}: {}", name_, line, key, what));
  }

private:
  std::string name_;
  std::map<std::string, int> lines_;
};

bool isPrefix(const Declarations& declarations, const std::string& path) {
  const auto next = declarations.keys().lower_bound(path + ".");
  return next != declarations.keys().end() && next->first.starts_with(path + ".");
}

// The settings of the preset that `"quality": NAME` or `"quality": { "preset": NAME }` asks for.
const Declarations::Preset& presetNamed(const Declarations& declarations,
                                        const detail::JsonEntry& entry,
                                        const Positions& positions) {
  const auto& presets = declarations.presets();
  std::string names;
  for (const auto& [name, unused] : presets) names += (names.empty() ? "" : ", ") + name;
  if (names.empty()) positions.fail(entry.path, say("this assignment has no presets"));
  const auto found = presets.find(entry.value.text);
  if (entry.value.kind != detail::JsonValue::Kind::text || found == presets.end())
    positions.fail(entry.path, say("must be a preset ({}), but is {}", names, entry.value.shown));
  return found->second;
}

Values readValues(std::string_view text, const std::string& name, const Declarations& declarations,
                  Positions& positions) {
  Values values;
  Declarations::Preset preset;
  for (const detail::JsonEntry& entry : detail::readJson(text, name)) {
    positions.add(entry.path, entry.line);
    const bool text = entry.value.kind == detail::JsonValue::Kind::text;
    if (entry.path == "quality.preset" || (entry.path == "quality" && text)) {
      preset = presetNamed(declarations, entry, positions);
      continue;
    }
    const auto known = declarations.keys().find(entry.path);
    if (known == declarations.keys().end()) {
      if (!isPrefix(declarations, entry.path)) {
        const std::string nearest = declarations.nearest(entry.path);
        positions.fail(entry.path,
                       nearest.empty()
                           ? say("is not a key of this scene")
                           : say("is not a key of this scene; did you mean {}?", nearest));
      }
      if (entry.value.kind != detail::JsonValue::Kind::object)
        positions.fail(entry.path,
                       say("must be an object {{ ... }}, but is {}", entry.value.shown));
      continue;
    }
    const auto value = detail::convert(known->second, entry.value);
    if (!value)
      positions.fail(entry.path, say("must be {}, but is {}", Declarations::describe(known->second),
                                     entry.value.shown));
    values.emplace(entry.path, *value);
  }
  for (const auto& [path, key] : declarations.keys()) {
    if (values.contains(path)) continue;
    if (const auto set = preset.find(path); set != preset.end()) {
      values.emplace(path, set->second);
      continue;
    }
    if (!key.hasDefault)
      positions.fail(path, say("is missing; it must be {}", Declarations::describe(key)));
    values.emplace(path, key.defaultValue);
  }
  return values;
}

const std::vector<double>& numbers(const Values& values, const std::string& key) {
  return std::get<std::vector<double>>(values.find(key)->second);
}

float single(const Values& values, const std::string& key) {
  return static_cast<float>(std::get<double>(values.find(key)->second));
}

glm::vec3 vector(const Values& values, const std::string& key) {
  const std::vector<double>& v = numbers(values, key);
  return {v[0], v[1], v[2]};
}

Camera readCamera(const Values& values, const Positions& positions) {
  Camera camera;
  camera.position = vector(values, "camera.position");
  camera.target = vector(values, "camera.target");
  camera.up = vector(values, "camera.up");
  camera.fov = single(values, "camera.fov");
  camera.near = single(values, "camera.near");
  camera.far = single(values, "camera.far");
  if (camera.position == camera.target)
    positions.fail("camera.target", say("is the same point as camera.position"));
  if (glm::length(camera.up) < 1e-3f) positions.fail("camera.up", say("must not be zero"));
  if (!(camera.near < camera.far))
    positions.fail("camera.far", say("must be more than camera.near"));
  return camera;
}

} // namespace

Scene Scene::fromText(std::string_view text, const std::string& name,
                      const Declarations& declarations) {
  Positions positions(name);
  Scene scene;
  scene.values_ = readValues(text, name, declarations, positions);
  const Values& values = scene.values_;

  const std::vector<double>& size = numbers(values, "size");
  scene.size = {size[0], size[1]};
  scene.background = vector(values, "background");
  scene.camera = readCamera(values, positions);
  scene.light = {glm::vec4(vector(values, "light.ambient"), 1),
                 glm::vec4(vector(values, "light.diffuse"), 1),
                 glm::vec4(vector(values, "light.specular"), 1),
                 glm::vec4(vector(values, "light.position"), 1)};
  for (const std::string& material : declarations.materials()) {
    const std::string path = "materials." + material;
    scene.materials_[material] = {.ambient = glm::vec4(vector(values, path + ".ambient"), 1),
                                  .diffuse = glm::vec4(vector(values, path + ".diffuse"), 1),
                                  .specular = glm::vec4(vector(values, path + ".specular"), 1),
                                  .shininess = single(values, path + ".shininess")};
  }
  return scene;
}

Scene Scene::fromFile(const std::string& file, const Declarations& declarations) {
  const std::filesystem::path path = fromUtf8(file);
  try {
    return fromText(readFile(path), toUtf8(path.filename()), declarations);
  } catch (const FileError& error) {
    throw SceneError(error.what());
  }
}

const Material& Scene::material(std::string_view name) const {
  const auto found = materials_.find(name);
  if (found == materials_.end())
    throw std::invalid_argument(say("the assignment has no material \"{}\"", name));
  return found->second;
}

const SceneValue& Scene::value(std::string_view key) const {
  const auto found = values_.find(key);
  if (found == values_.end())
    throw std::invalid_argument(say("the assignment declares no scene key \"{}\"", key));
  return found->second;
}

namespace {

template <class T>
const T& as(const SceneValue& value, std::string_view key, std::string_view type) {
  if (const T* typed = std::get_if<T>(&value)) return *typed;
  throw std::invalid_argument(say("the scene key \"{}\" is not {}", key, type));
}

} // namespace

bool Scene::flag(std::string_view key) const {
  return as<bool>(value(key), key, words("a boolean: flag() can't read it"));
}

int Scene::integer(std::string_view key) const {
  return as<int>(value(key), key, words("an integer: integer() can't read it"));
}

double Scene::number(std::string_view key) const {
  const SceneValue& found = value(key);
  if (const int* whole = std::get_if<int>(&found)) return *whole;
  return as<double>(found, key, words("a single number: number() and real() can't read it"));
}

float Scene::real(std::string_view key) const {
  return static_cast<float>(number(key));
}

const std::string& Scene::text(std::string_view key) const {
  return as<std::string>(value(key), key, words("a text: text() can't read it"));
}

void Scene::setText(std::string_view key, const std::string& replacement) {
  text(key);
  values_.find(key)->second = replacement;
}

} // namespace gg
