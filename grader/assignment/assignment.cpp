#include "assignment/assignment.hpp"

#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <map>
#include <set>
#include <system_error>

namespace ggrade {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// What a student reads, in the language that was chosen.
std::string inWords(const json& english) {
  return std::string(gg::words(english.get<std::string>()));
}

Todo readTodo(const json& from) {
  return {from.at("id"), inWords(from.at("title")), from.value("bonus", false),
          from.value("beyond_lecture", false)};
}

results::ItemKind readKind(const std::string& kind) {
  if (const auto known = results::parseItemKind(kind)) return *known;
  throw UsageError(fmt::format("kind must be gain, keep or bonus, but is \"{}\"", kind));
}

ItemDeclaration readItem(const json& from) {
  ItemDeclaration item;
  item.id = from.at("id");
  item.title = inWords(from.at("title"));
  item.looksAt = inWords(from.at("looks_at"));
  item.kind = readKind(from.at("kind"));
  item.points = from.at("points");
  if (!(item.points >= 0))
    throw UsageError(fmt::format("{}: points must not be negative", item.id));
  if (item.points > 1e6) // or their sum would be no number
    throw UsageError(fmt::format("{}: points must not be more than a million", item.id));
  item.cause = inWords(from.at("cause"));
  item.step = from.at("step");
  item.beyondLecture = from.value("beyond_lecture", false);
  item.scenes = from.value("scenes", std::vector<std::string>{});
  item.work = from.value("work", std::vector<std::string>());
  item.after = from.value("after", std::string());
  if (from.contains("output")) item.output = inWords(from.at("output"));
  return item;
}

Part readPart(const json& from) {
  Part part;
  part.id = from.at("id");
  part.title = inWords(from.at("title"));
  part.weight = from.value("weight", 1.0);
  if (!(part.weight > 0 && part.weight <= 1))
    throw UsageError(fmt::format("{}: weight must be above 0 and at most 1", part.id));
  part.scene = from.value("scene", json::object());
  for (const json& todo : from.at("todos")) part.todos.push_back(readTodo(todo));
  for (const json& item : from.value("items", json::array())) part.items.push_back(readItem(item));
  return part;
}

/// IDs of the assignment, its parts, TODOs and items name one thing each; a single part may be the
/// assignment.
void requireDifferentIds(const Assignment& assignment) {
  std::set<std::string> targets, todos, items;
  if (!assignment.isOnePart()) targets.insert(assignment.id);
  const auto add = [](std::set<std::string>& known, const std::string& id) {
    if (!known.insert(id).second) throw UsageError(fmt::format("\"{}\" stands there twice", id));
  };
  for (const Part& part : assignment.parts) {
    add(targets, part.id);
    for (const Todo& todo : part.todos) add(todos, todo.id);
    for (const ItemDeclaration& item : part.items) add(items, item.id);
  }
}

/// What an item is after is a pass of its own part, and nothing is after itself in the end.
void requireChains(const Assignment& assignment) {
  std::map<std::string, std::pair<const Part*, const ItemDeclaration*>> known;
  for (const Part& part : assignment.parts)
    for (const ItemDeclaration& item : part.items) known[item.id] = {&part, &item};
  for (const auto& [id, found] : known) {
    const Part* const part = found.first; // clang 14 lets no lambda have structured bindings
    const ItemDeclaration* const item = found.second;
    if (item->after.empty()) continue;
    const auto refuse = [&](const std::string& why) {
      throw UsageError(fmt::format("{}: after \"{}\": {}", item->id, item->after, why));
    };
    if (item->kind != results::ItemKind::gain) refuse("only an item of kind gain comes after one");
    const auto before = known.find(item->after);
    if (before == known.end()) refuse("there is no such item");
    if (before->second.first != part)
      refuse(fmt::format("that is an item of another part, \"{}\"", before->second.first->id));
    if (before->second.second->output.empty())
      refuse("that item doesn't say what its pass leaves (\"output\")");
    std::size_t steps = 0;
    for (auto at = before; at != known.end(); at = known.find(at->second.second->after))
      if (++steps > known.size()) refuse("items go round in a circle");
  }
}

/// An ID names one assignment or part of all.
void requireDifferentTargets(const std::vector<Assignment>& all) {
  std::map<std::string, const Assignment*> known;
  for (const Assignment& assignment : all) {
    std::set<std::string> ids = {assignment.id};
    for (const Part& part : assignment.parts) ids.insert(part.id);
    for (const std::string& id : ids)
      if (const auto [entry, fresh] = known.emplace(id, &assignment); !fresh)
        throw UsageError(fmt::format("\"{}\" stands in {} and in {}: give one of them another ID",
                                     id, (entry->second->folder / "assignment.json").string(),
                                     (assignment.folder / "assignment.json").string()));
  }
}

} // namespace

std::string readFile(const fs::path& path) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  std::string text(error ? 0 : size, '\0');
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!error && in.read(text.data(), std::streamsize(text.size()))) return text;
  if (!error) error.assign(errno ? errno : EIO, std::generic_category());
  const std::string what = gg::say("can't read {}", path.string());
  // A name or a right that somebody can mend; all else is the machine's fault.
  for (const std::errc mistake : {std::errc::no_such_file_or_directory, std::errc::not_a_directory,
                                  std::errc::is_a_directory, std::errc::permission_denied})
    if (error == mistake) throw UsageError(what + ": " + error.message());
  throw std::system_error(error, what);
}

json readJson(const fs::path& path) {
  const std::string text = readFile(path);
  const auto lineAt = [&](std::size_t at) {
    return 1 + std::count(text.begin(), text.begin() + std::min(at, text.size()), '\n');
  };
  // The parser would take it for the end.
  if (const std::size_t nul = text.find('\0'); nul != text.npos)
    throw UsageError(
        gg::say("{}:{}: holds a NUL byte; save the file as text", path.string(), lineAt(nul)));
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    throw UsageError(fmt::format("{}:{}: {}", path.string(), lineAt(error.byte), error.what()));
  } catch (const json::out_of_range& error) {
    // "number overflow parsing '1e999'": where, only the number tells.
    const std::string what = error.what();
    const std::size_t quote = what.find('\'');
    const std::string number =
        quote == what.npos ? "" : what.substr(quote + 1, what.rfind('\'') - quote - 1);
    throw UsageError(fmt::format("{}:{}: {}", path.string(), lineAt(text.find(number)), what));
  }
}

void addWords(const fs::path& folder) {
  try {
    gg::addWords(folder / "words.ja.json");
  } catch (const std::runtime_error& error) {
    throw UsageError(error.what());
  }
}

Assignment Assignment::load(const fs::path& folder) {
  const fs::path path = folder / "assignment.json";
  const json from = readJson(path);
  addWords(folder);
  try {
    Assignment assignment;
    assignment.id = from.at("id");
    assignment.title = inWords(from.at("title"));
    assignment.files = from.at("files");
    assignment.optionalFiles = from.value("files_optional", std::vector<std::string>{});
    assignment.drawsTogether = from.value("together", true);
    for (const json& part : from.at("parts")) assignment.parts.push_back(readPart(part));
    assignment.folder = folder;
    requireDifferentIds(assignment);
    requireChains(assignment);
    if (assignment.id != folder.filename())
      throw UsageError(fmt::format("id is \"{}\" but the folder is \"{}\"", assignment.id,
                                   folder.filename().string()));
    return assignment;
  } catch (const json::exception& error) {
    throw UsageError(fmt::format("{}: {}", path.string(), error.what()));
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

double Target::maxScore() const {
  double sum = 0;
  for (const ItemDeclaration& item : items())
    if (item.kind == results::ItemKind::gain) sum += item.points;
  return sum;
}

std::vector<ItemDeclaration> Target::items() const {
  std::vector<ItemDeclaration> all;
  for (const Part& part : parts)
    for (ItemDeclaration item : part.items) {
      if (parts.size() > 1) item.points *= part.weight;
      all.push_back(std::move(item));
    }
  return all;
}

bool Target::covers(const std::string& partId) const {
  return std::any_of(parts.begin(), parts.end(), [&](const Part& p) { return p.id == partId; });
}

std::vector<std::string> Assignment::dataFiles() const {
  std::vector<std::string> names = {"assignment.json", "scene.json"};
  if (fs::exists(folder / "presets.json")) names.push_back("presets.json");
  return names;
}

std::vector<Assignment> loadAssignments(const fs::path& folder) {
  std::vector<Assignment> all;
  if (!fs::exists(folder)) return all;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (fs::exists(entry.path() / "assignment.json")) all.push_back(Assignment::load(entry.path()));
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  requireDifferentTargets(all);
  return all;
}

Target findTarget(const fs::path& folder, const std::string& id) {
  std::string known;
  for (Assignment& assignment : loadAssignments(folder)) {
    if (assignment.id == id) {
      std::vector<Part> parts = assignment.parts;
      return {std::move(assignment), std::move(parts), id};
    }
    known += (known.empty() ? "" : ", ") + assignment.id;
    if (assignment.isOnePart()) continue;
    for (const Part& part : assignment.parts) {
      if (part.id == id) return {assignment, {part}, id};
      known += ", " + part.id;
    }
  }
  if (known.empty()) throw UsageError(gg::say("{} holds no assignment", folder.string()));
  throw UsageError(gg::say("there is no assignment or part \"{}\"; there are: {}", id, known));
}

} // namespace ggrade
