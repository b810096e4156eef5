#include "parts.hpp"

#include <stdexcept>

#include "words/words.hpp"
#include <fmt/format.h>
#include <gg/error.hpp>
#include <gg/text_file.hpp>
#include <nlohmann/json.hpp>

namespace gg::detail {

namespace {

using nlohmann::json;

json read(const std::filesystem::path& file) {
  try {
    return json::parse(readFile(file));
  } catch (const json::exception& error) {
    throw SceneError(fmt::format("{}: {}", toUtf8(file.filename()), error.what()));
  } catch (const FileError& error) {
    throw SceneError(error.what());
  }
}

} // namespace

std::string sceneOfPart(const std::filesystem::path& folder, const std::string& part) {
  json scene = read(folder / "scene.json");
  const json assignment = read(folder / "assignment.json");
  bool found = part.empty();
  std::string known;
  for (const json& one : assignment.value("parts", json::array())) {
    const std::string id = one.value("id", "");
    known += (known.empty() ? "" : ", ") + id;
    if (!part.empty() && id != part) continue;
    found = true;
    scene.merge_patch(one.value("scene", json::object()));
  }
  if (!found) throw std::invalid_argument(say("--part {}: there are {}", part, known));
  return scene.dump(2);
}

} // namespace gg::detail
