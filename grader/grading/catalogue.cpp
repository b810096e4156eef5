#include "grading/catalogue.hpp"

#include "grading/overlay.hpp"
#include "grading/recipe.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;
using Header = std::map<std::string, std::string>;

namespace {

const char* const kPatch = ".patch";

/// The part's patches in a folder, by name.
std::vector<fs::path> patches(const fs::path& folder, const std::string& part) {
  std::vector<fs::path> all;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (entry.path().extension() == kPatch &&
        entry.path().filename().string().starts_with(part + '_'))
      all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

/// Tags of the scenes that are drawn where only this part is graded.
std::set<std::string> sceneTags(const fs::path& solutionFolder, const std::string& part) {
  std::set<std::string> tags;
  const json scenes = readJson(solutionFolder / "scenes.json");
  using Words = std::vector<std::string>;
  for (const json& scene : scenes.at("scenes"))
    if (scene.value("parts", Words{part}) == Words{part})
      for (const std::string& tag : scene.value("tags", Words())) tags.insert(tag);
  return tags;
}

std::vector<std::string> commaSeparated(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string one; std::getline(in, one, ',');) {
    const std::size_t first = one.find_first_not_of(' ');
    if (first != one.npos) all.push_back(one.substr(first, one.find_last_not_of(' ') + 1 - first));
  }
  return all;
}

/// What every header of one part is checked against, and the faults that were found.
class Checker {
public:
  Checker(const Assignment& assignment, const Part& part, const fs::path& solutionFolder)
      : assignment_(assignment), part_(part), tags_(sceneTags(solutionFolder, part.id)) {}

  std::vector<std::string> problems;

  template <class... Values>
  void fault(const fs::path& file, fmt::format_string<Values...> text, Values&&... values) {
    problems.push_back(file.string() + ": " + fmt::format(text, std::forward<Values>(values)...));
  }

  /// The header, or nothing where it can't be read.
  Header header(const fs::path& patch, const std::vector<std::string>& needed,
                const std::vector<std::string>& optional) {
    try {
      const Header header = patchHeader(patch, needed);
      for (const auto& [key, value] : header)
        if (!isIn(needed, key) && !isIn(optional, key))
          fault(patch, "\"{}:\" is no key; there are {}, and if need be {}", key,
                fmt::join(needed, ", "), fmt::join(optional, ", "));
      if (header.at("Grades") != part_.id)
        fault(patch, "Grades: \"{}\", but its name says {}", header.at("Grades"), part_.id);
      const std::vector<std::string> files = patchedFiles(assignment_, patch);
      if (files.empty()) fault(patch, "changes no file: the diff is missing");
      for (const std::string& file : files)
        if (!takes(assignment_, file)) fault(patch, "{} is no file that a student hands in", file);
      return header;
    } catch (const UsageError& error) {
      problems.push_back(error.what());
      return {};
    }
  }

  const ItemDeclaration* item(const fs::path& patch, const char* key, const std::string& id) {
    const auto found = std::find_if(part_.items.begin(), part_.items.end(),
                                    [&](const ItemDeclaration& one) { return one.id == id; });
    if (found != part_.items.end()) return &*found;
    std::vector<std::string> known;
    for (const ItemDeclaration& one : part_.items) known.push_back(one.id);
    fault(patch, "{}: {} has no item \"{}\"; there are {}", key, part_.id, id,
          fmt::join(known, ", "));
    return nullptr;
  }

  void step(const fs::path& patch, const std::string& id) {
    std::vector<std::string> known;
    for (const Todo& todo : part_.todos) known.push_back(todo.id);
    if (!isIn(known, id))
      fault(patch, "Step: {} has no step \"{}\"; there are {}", part_.id, id,
            fmt::join(known, ", "));
  }

  void tag(const fs::path& patch, const std::string& tag) {
    if (!tags_.count(tag))
      fault(patch, "Shows: no scene of {} has the tag \"{}\"; there are {}", part_.id, tag,
            fmt::join(tags_, ", "));
  }

  results::Outcome outcome(const fs::path& patch, const Header& header) {
    const auto named = header.find("Outcome");
    if (named == header.end()) return results::Outcome::graded;
    if (const auto known = results::parseOutcome(named->second)) return *known;
    fault(patch, "Outcome: \"{}\" is none", named->second);
    return results::Outcome::graded;
  }

private:
  static bool isIn(const std::vector<std::string>& list, const std::string& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  }

  const Assignment& assignment_;
  const Part& part_;
  std::set<std::string> tags_;
};

void readMistake(const fs::path& patch, Checker& checker, Catalogue& into) {
  const Header header =
      checker.header(patch, {"Title", "Grades", "Symptom", "Hint", "Fails", "Step", "Shows"},
                     {"Outcome", "Same", "Try"});
  if (header.empty()) return;
  checker.item(patch, "Fails", header.at("Fails"));
  checker.step(patch, header.at("Step"));
  checker.tag(patch, header.at("Shows"));
  const auto inWords = [&](const char* key) { return std::string(gg::words(header.at(key))); };
  into.mistakes.push_back({patch.stem().string(), patch, inWords("Title"), header.at("Symptom"),
                           inWords("Hint"), header.count("Try") ? inWords("Try") : std::string(),
                           header.at("Fails"), header.at("Step"), header.at("Shows"),
                           checker.outcome(patch, header),
                           header.count("Same") ? header.at("Same") : std::string()});
}

void readVariant(const fs::path& patch, Checker& checker, Catalogue& into) {
  const Header header = checker.header(patch, {"Title", "Grades"}, {"Loses", "Outcome"});
  if (header.empty()) return;
  Variant variant{
      patch.stem().string(), patch, header.at("Title"), {}, checker.outcome(patch, header)};
  if (header.count("Loses")) variant.loses = commaSeparated(header.at("Loses"));
  for (const std::string& id : variant.loses)
    if (const ItemDeclaration* item = checker.item(patch, "Loses", id))
      if (!item->beyondLecture && item->kind != results::ItemKind::bonus)
        checker.fault(patch,
                      "Loses: {} is required; a right answer may lose only items beyond "
                      "the lecture",
                      id);
  into.variants.push_back(std::move(variant));
}

void readPairs(const fs::path& file, Checker& checker, Catalogue& into) {
  if (!fs::exists(file)) return;
  std::istringstream in(readFile(file));
  int number = 0;
  std::set<std::pair<std::string, std::string>> known;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<std::string> names;
    for (std::string word; words >> word;) names.push_back(word);
    if (names.empty()) continue;
    const fs::path at = fmt::format("{}:{}", file.string(), number);
    if (names.size() != 2) {
      checker.fault(at, "expected the names of two mistakes");
      continue;
    }
    bool good = true;
    for (std::string& name : names) {
      if (!into.mistake(name) && into.mistake(into.part + '_' + name))
        name = into.part + '_' + name;
      if (into.mistake(name)) continue;
      checker.fault(at, "there is no mistake \"{}\"", name);
      good = false;
    }
    if (!good) continue;
    if (names[0] == names[1]) {
      checker.fault(at, "{} twice is no pair", names[0]);
    } else if (!known.insert(std::minmax(names[0], names[1])).second) {
      checker.fault(at, "{} and {} stand there twice", names[0], names[1]);
    } else {
      into.pairs.emplace_back(names[0], names[1]);
    }
  }
}

} // namespace

const Mistake* Catalogue::mistake(const std::string& name) const {
  const auto found = std::find_if(mistakes.begin(), mistakes.end(),
                                  [&](const Mistake& one) { return one.name == name; });
  return found == mistakes.end() ? nullptr : &*found;
}

Catalogue loadCatalogue(const Assignment& assignment, const Part& part,
                        const fs::path& solutionFolder, const fs::path& folder) {
  addWords(solutionFolder);
  Checker checker(assignment, part, solutionFolder);
  Catalogue all;
  all.part = part.id;
  for (const fs::path& patch : patches(folder / "mistakes", part.id))
    readMistake(patch, checker, all);
  for (const fs::path& patch : patches(folder / "variants", part.id))
    readVariant(patch, checker, all);
  for (Mistake& mistake : all.mistakes) {
    if (mistake.same.empty()) continue;
    if (!all.mistake(mistake.same) && all.mistake(part.id + '_' + mistake.same))
      mistake.same = part.id + '_' + mistake.same;
    if (!all.mistake(mistake.same) || mistake.same == mistake.name)
      checker.fault(mistake.patch, "Same: there is no other mistake \"{}\"", mistake.same);
  }
  readPairs(folder / "mistakes" / (part.id + ".pairs"), checker, all);
  if (!checker.problems.empty())
    throw UsageError(fmt::format("{}", fmt::join(checker.problems, "\n")));
  return all;
}

} // namespace ggrade::grading
