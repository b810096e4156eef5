#include "authoring/new_assignment.hpp"

#include "assignment/assignment.hpp"
#include "report/text.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <cctype>

namespace ggrade::authoring {

namespace fs = std::filesystem;

namespace {

constexpr char kId[] = "new_assignment", kTitle[] = "A new assignment";
constexpr std::size_t kLongestId = 40, kLongestTitle = 100;

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
    text.replace(at, from.size(), to);
}

/// As it stands between the quotes of a JSON text.
std::string quoted(const std::string& text) {
  const std::string json = nlohmann::json(text).dump();
  return json.substr(1, json.size() - 2);
}

} // namespace

void requireFreeId(const std::string& id, const fs::path& root, const fs::path& buildFile) {
  const auto refuse = [&](const std::string& why) {
    throw UsageError(fmt::format("ID \"{}\": {}", report::sanitizeLine(id), why));
  };
  constexpr char kAllowed[] = "abcdefghijklmnopqrstuvwxyz0123456789_";
  if (id.empty() || id.size() > kLongestId || id.find_first_not_of(kAllowed) != id.npos)
    refuse(fmt::format("an ID is made of lower case letters, digits and _, 1 to {} of them, such "
                       "as soft_light",
                       kLongestId));
  for (const Assignment& assignment : loadAssignments(root / "assignments")) {
    if (assignment.id == id) refuse("there is such an assignment; choose another ID");
    for (const Part& part : assignment.parts)
      if (part.id == id)
        refuse(fmt::format("{} has a part of this name; choose another ID", assignment.id));
  }
  for (const char* side : {"assignments", "solutions"})
    if (const fs::path there = root / side / id; fs::exists(there))
      refuse(fmt::format("{} is there already; move it away or choose another ID", there.string()));
  if (fs::exists(buildFile) && readFile(buildFile).find("\nbuild " + id + ":") != std::string::npos)
    refuse("the build has a target of this name; choose another ID");
}

std::string titleOf(const std::string& id) {
  std::string title = id;
  replaceAll(title, "_", " ");
  if (!title.empty()) title[0] = char(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

void requireTitle(const std::string& title) {
  const auto refuse = [&](const std::string& why) {
    throw UsageError(fmt::format("title \"{}\": {}", report::sanitizeLine(title), why));
  };
  if (title.find_first_not_of(' ') == title.npos || report::sanitizeLine(title) != title ||
      title.size() > kLongestTitle)
    refuse(fmt::format("a title is one line of UTF-8 text, words with one space between, 1 to {} "
                       "bytes",
                       kLongestTitle));
  if (title.find("{{") != title.npos) refuse("{{ begins a directive of the handout; leave it out");
}

void writeTemplate(const fs::path& templates, const std::string& id, const std::string& title,
                   const fs::path& into) {
  for (const auto& entry : fs::recursive_directory_iterator(templates)) {
    if (!entry.is_regular_file()) continue;
    std::string name = entry.path().lexically_relative(templates).string();
    std::string text = readFile(entry.path());
    replaceAll(name, kId, id);
    replaceAll(text, kId, id);
    // After the ID, for a title may hold the template's.
    replaceAll(text, kTitle, name.ends_with(".json") ? quoted(title) : title);
    report::makeFolder((into / name).parent_path());
    report::writeFile(into / name, text);
  }
}

} // namespace ggrade::authoring
