#include "grading/owners.hpp"

#include "grading/parallel.hpp"
#include "grading/replay.hpp"
#include "grading/statements.hpp"
#include "grading/toolchain.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;
using repair::Unit;

namespace {

/// In one step.
void keepText(std::string_view text, const fs::path& file) {
  TemporaryFolder work(file.parent_path());
  report::writeFile(work.path() / "text", text);
  keep(work.path() / "text", file);
}

/// A hash of all that they are learnt of: the solution, what all programs are built with, how they
/// are recorded and compared. The same on every machine.
std::string keyOf(const Target& target, const fs::path& solutionFolder,
                  const std::vector<SceneCase>& scenes) {
  static const std::string tools = [] {
    const fs::path sources = toolchain::kSourceFolder;
    std::string all;
    for (const char* folder : {"framework/include", "framework/shaders", "framework/src",
                               "grader/capture", "grader/repair", "grader/replay"})
      all += hashOfFolder(sources / folder) + ' ';
    for (const char* file : {"grader/grading/owners.cpp", "grader/grading/statements.cpp",
                             "grader/authoring/solution_blocks.cpp"})
      all += hashOf(readFile(sources / file)) + ' ';
    return all;
  }();
  std::string drawn;
  for (const SceneCase& scene : scenes) drawn += scene.scene.dump() + json(scene.times).dump();
  return hashOf(tools + sourcesKey(target.assignment, solutionFolder) + target.id + drawn);
}

/// The public scene, and those in which another step does the work of one that the public scene
/// shows.
ScenePlan scenesOf(const Target& part, const fs::path& solutionFolder) {
  ScenePlan plan = drawScenes(part, solutionFolder);
  const auto first = plan.scenes.begin() + 1;
  plan.scenes.erase(std::remove_if(first, plan.scenes.end(),
                                   [](const SceneCase& scene) { return !isOfOtherSteps(scene); }),
                    plan.scenes.end());
  return plan;
}

/// Is the file there, and was it learnt of what has this key?
bool isOf(const fs::path& file, const std::string& key) {
  return fs::exists(file) && readJson(file).at("key") == key;
}

} // namespace

bool isOfOtherSteps(const SceneCase& scene) {
  return std::ranges::find(scene.tags, "other_steps") != scene.tags.end();
}

tape::Tape recordOwn(const Target& target, const Recipe& recipe, const rubric::SceneFolders& scene,
                     const ShaderCache& shaders) {
  Program program(target.assignment, recipe);
  const trace::Request request = tapingRequest(scene.times);
  const fs::path file =
      cacheFolder() / "tapes" /
      hashOf(program.key() + scene.scene.dump() + json(scene.times).dump() + identity(request));
  if (!fs::exists(file)) {
    const Rendering taped = program.render(scene.scene, scene.times, shaders, request);
    if (taped.happened.outcome == results::Outcome::notGradable)
      throw std::runtime_error(taped.happened.detail); // the machine's fault
    if (!taped.happened.ok() || !taped.capture.tapeRefused.empty())
      throw NoTape("our own program has no tape: " + taped.happened.detail +
                   taped.capture.tapeRefused);
    const auto& bytes = taped.capture.tape;
    keepText({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file);
  }
  const std::string bytes = readFile(file);
  return tape::read(std::as_bytes(std::span(bytes)));
}

Owners::Owners(const Target& target, const fs::path& solutionFolder) {
  for (const Part& part : target.parts)
    addText(textOfPart({target.assignment, {part}, part.id}, solutionFolder));
}

std::string Owners::textOfPart(const Target& part, const fs::path& solutionFolder) {
  const ScenePlan plan = scenesOf(part, solutionFolder);
  const std::string key = keyOf(part, solutionFolder, plan.scenes);
  const fs::path cached = cacheFolder() / "owners" / key;
  for (const fs::path& file : {ownersFile(solutionFolder, part.id), cached})
    if (isOf(file, key)) return readFile(file);
  const References references = prepareReferences(
      part, solutionFolder, plan, [](const std::string&, std::size_t, std::size_t) {});
  Owners learnt;
  for (const rubric::SceneFolders& scene : references.scenes) {
    const tape::Tape reference = recordOwn(part, {solutionFolder}, scene, references.ownShaders);
    learnt.learn(part, solutionFolder, scene, references.ownShaders, reference);
    learnt.learnDeciders(part, solutionFolder, scene, references.ownShaders, reference);
  }
  const std::string text = learnt.text(key);
  keepText(text, cached);
  return text;
}

void Owners::addText(const std::string& text) {
  const json all = json::parse(text);
  for (const auto& [role, units] : all.at("units").items())
    for (const auto& [unit, known] : units.items()) {
      if (known.contains("without"))
        for (const auto& [todo, share] : known.at("without").items())
          changedBy_[{role, unit}][todo] = {share.at("lines"), share.at("shaders")};
      if (known.contains("decided by"))
        for (const json& todo : known.at("decided by")) decidedBy_[{role, unit}].insert(todo);
      if (known.contains("elsewhere by"))
        for (const json& todo : known.at("elsewhere by")) elsewhereBy_[{role, unit}].insert(todo);
    }
}

/// A unit a line, so that a change of one is a change of one line.
std::string Owners::text(const std::string& key) const {
  std::map<std::string, std::map<std::string, json>> roles;
  for (const auto& [unit, todos] : changedBy_)
    for (const auto& [todo, share] : todos)
      roles[unit.role][unit.name]["without"][todo] = {{"lines", share.lines},
                                                      {"shaders", share.shaders}};
  for (const auto& [unit, todos] : decidedBy_) roles[unit.role][unit.name]["decided by"] = todos;
  for (const auto& [unit, todos] : elsewhereBy_)
    if (const auto known = decidedBy_.find(unit);
        known == decidedBy_.end() || known->second != todos)
      roles[unit.role][unit.name]["elsewhere by"] = todos;
  std::vector<std::string> groups;
  for (const auto& [role, units] : roles) {
    std::vector<std::string> lines;
    for (const auto& [unit, known] : units)
      lines.push_back(fmt::format("   {}: {}", json(unit).dump(), known.dump()));
    groups.push_back(fmt::format("  {}: {{\n{}\n  }}", json(role).dump(), fmt::join(lines, ",\n")));
  }
  return fmt::format("{{\n \"key\": \"{}\",\n \"units\": {{\n{}\n }}\n}}\n", key,
                     fmt::join(groups, ",\n"));
}

fs::path ownersFile(const fs::path& solutionFolder, const std::string& part) {
  return solutionFolder / "owners" / (part + ".json");
}

bool areOwnersKept(const Target& part, const fs::path& solutionFolder) {
  return isOf(ownersFile(solutionFolder, part.id),
              keyOf(part, solutionFolder, scenesOf(part, solutionFolder).scenes));
}

void keepOwners(const Assignment& assignment, const fs::path& solutionFolder,
                const Progress& progress) {
  std::size_t done = 0;
  for (const Part& part : assignment.parts) {
    progress("whose work is what in " + part.id, done++, assignment.parts.size());
    const std::string text = Owners::textOfPart({assignment, {part}, part.id}, solutionFolder);
    const fs::path file = ownersFile(solutionFolder, part.id);
    report::makeFolder(file.parent_path());
    report::writeFile(file, text);
  }
}

void Owners::add(const std::string& todo, const repair::Difference& difference,
                 const std::set<std::string>& lines) {
  Share& share = changedBy_[difference.unit][todo];
  share.lines.insert(lines.begin(), lines.end());
  share.shaders.insert(difference.shaders.begin(), difference.shaders.end());
}

void Owners::addStep(const std::string& todo, const repair::Comparison& before,
                     const repair::Comparison& after) {
  for (const repair::Difference& one : before.differences) {
    if (one.passes.empty()) continue;
    const auto still = std::ranges::find(after.differences, one.unit, &repair::Difference::unit);
    const bool isGone = still == after.differences.end();
    std::set<std::string> added;
    std::ranges::copy_if(
        one.lacks, std::inserter(added, added.end()),
        [&](const std::string& line) { return isGone || !still->lacks.contains(line); });
    if (isGone || !added.empty()) add(todo, one, added);
  }
}

void Owners::learn(const Target& target, const fs::path& solutionFolder,
                   const rubric::SceneFolders& scene, const ShaderCache& shaders,
                   const tape::Tape& reference) {
  std::set<std::string> all, filled;
  std::vector<std::string> todos; // the target's, in their order
  for (const Part& part : target.assignment.parts)
    for (const auto& todo : part.todos) all.insert(todo.id);
  filled = all;
  for (const Part& part : target.parts)
    for (const auto& todo : part.todos) {
      todos.push_back(todo.id);
      filled.erase(todo.id);
    }
  // The solution without one TODO alone, each, then with none of them, with the first, and so on.
  std::vector<std::set<std::string>> programs;
  for (const std::string& todo : todos) {
    programs.push_back(all);
    programs.back().erase(todo);
  }
  programs.push_back(filled);
  for (const std::string& todo : todos) {
    filled.insert(todo);
    programs.push_back(filled);
  }
  std::vector<std::optional<repair::Comparison>> compared(programs.size());
  inParallel(programs.size(), workers(), [&](std::size_t i) {
    try {
      compared[i] = repair::compare(
          recordOwn(target, {solutionFolder, {}, programs[i]}, scene, shaders), reference);
    } catch (const NoTape&) {
      if (i >= todos.size()) throw; // a step of the handout draws
    }
  });
  for (std::size_t i = 0; i < todos.size(); ++i)
    if (compared[i])
      for (const repair::Difference& one : compared[i]->differences)
        if (!one.passes.empty() || one.unit.name == "draws" || !one.lacks.empty()) // the whole pass
          add(todos[i], one, one.lacks);
  // What can't be without a TODO, because its whole pass isn't drawn or nothing is, is the work of
  // the step with which it comes.
  const auto known = changedBy_;
  for (std::size_t i = 0; i < todos.size(); ++i) {
    const repair::Comparison &before = *compared[todos.size() + i],
                             &after = *compared[todos.size() + i + 1];
    if (!compared[i]) addStep(todos[i], before, after);
    for (const auto& [unit, shaders] : after.compared)
      if (!before.compared.contains(unit) && !known.contains(unit))
        changedBy_[unit][todos[i]].shaders = shaders;
  }
}

void Owners::learnDeciders(const Target& target, const fs::path& solutionFolder,
                           const rubric::SceneFolders& scene, const ShaderCache& shaders,
                           const tape::Tape& reference) {
  Statements statements(target, solutionFolder);
  std::vector<std::set<Unit>> changed(statements.size()); // without each statement
  inParallel(statements.size(), workers(), [&](std::size_t i) {
    const Rendering drawn =
        statements.renderWithout(i, scene.scene, scene.times, shaders, tapingRequest(scene.times));
    if (!drawn.happened.ok() || !drawn.capture.tapeRefused.empty()) return;
    for (const repair::Difference& one :
         repair::compare(tape::read(drawn.capture.tape), reference).differences)
      changed[i].insert(one.unit);
  });
  std::map<Unit, std::size_t> fewest; // units that the statement changes, with this one
  std::map<Unit, std::set<std::string>> decided;
  for (std::size_t i = 0; i < changed.size(); ++i)
    for (const Unit& unit : changed[i]) {
      const auto [known, isNew] = fewest.try_emplace(unit, changed[i].size());
      if (changed[i].size() > known->second) continue;
      if (changed[i].size() < known->second) decided[unit].clear();
      known->second = changed[i].size();
      decided[unit].insert(statements.todoOf(i));
    }
  auto& all = isOfOtherSteps(scene) ? elsewhereBy_ : decidedBy_;
  for (auto& [unit, todos] : decided) all[unit].merge(todos);
}

std::set<std::string> Owners::decidersOf(const Unit& unit, bool elsewhere) const {
  if (repair::isShader(unit.name)) return {}; // of these, lines tell
  if (const auto there = elsewhereBy_.find(unit); elsewhere && there != elsewhereBy_.end())
    return there->second;
  const auto found = decidedBy_.find(unit);
  return found == decidedBy_.end() ? std::set<std::string>() : found->second;
}

std::set<std::string> Owners::ownersOf(const repair::Difference& difference) const {
  const auto found = changedBy_.find(difference.unit);
  if (found == changedBy_.end()) return {};
  std::set<std::string> all, byLine;
  for (const auto& [todo, share] : found->second) {
    all.insert(todo);
    if (std::ranges::any_of(
            share.lines, [&](const std::string& line) { return difference.lacks.contains(line); }))
      byLine.insert(todo);
  }
  // Lines that lack and are no TODO's were handed out.
  return byLine.empty() && difference.lacks.empty() ? all : byLine;
}

std::set<std::string> Owners::drawersOf(const std::string& role) const {
  std::set<std::string> todos;
  if (const auto found = changedBy_.find({role, "draws"}); found != changedBy_.end())
    for (const auto& [todo, share] : found->second) todos.insert(todo);
  return todos;
}

bool Owners::isWrittenOtherwise(const std::string& todo, const repair::Difference& difference,
                                const std::vector<repair::Difference>& all) const {
  const auto& [role, name] = difference.unit;
  if (!difference.adds || !name.starts_with("shader ")) return difference.adds;
  bool known = false;
  for (const auto& [unit, todos] : changedBy_) {
    if (unit.role != role || repair::shaderOf(unit.name) != name || !todos.contains(todo)) continue;
    known = true;
    const auto function = std::ranges::find(all, unit, &repair::Difference::unit);
    if (function != all.end() && function->adds) return true;
  }
  return !known;
}

std::set<std::string> Owners::missingIn(const repair::Difference& difference,
                                        const std::vector<repair::Difference>& all,
                                        const repair::UnitsInDraws& compared) const {
  std::set<std::string> missing;
  if (difference.isUnseen) missing = ownersOf(difference);
  if (const auto own = changedBy_.find(difference.unit); own != changedBy_.end())
    for (const auto& [todo, share] : own->second)
      if (!share.lines.empty() && std::ranges::includes(difference.lacks, share.lines) &&
          !isWrittenOtherwise(todo, difference, all))
        missing.insert(todo);
  if (difference.isUnseen || difference.unit.name.starts_with("shader "))
    missing.merge(broughtWith(difference.unit.role, compared));
  return missing;
}

bool Owners::isUntouched(const std::string& todo,
                         const std::vector<repair::Difference>& differences,
                         const repair::UnitsInDraws& compared) const {
  for (const auto& [unit, todos] : changedBy_) {
    const auto share = todos.find(todo);
    if (share == todos.end()) continue;
    const auto found = std::ranges::find(differences, unit, &repair::Difference::unit);
    if (found == differences.end() ? compared.contains(unit)
                                   : !std::ranges::includes(found->lacks, share->second.lines))
      return false;
  }
  return true;
}

std::set<std::string> Owners::broughtWith(const std::string& role,
                                          const repair::UnitsInDraws& compared) const {
  std::set<std::string> brought, seen;
  for (const auto& [unit, todos] : changedBy_) {
    const auto both = compared.find(unit);
    for (const auto& [todo, share] : todos)
      if (both != compared.end() &&
          std::ranges::any_of(share.shaders, [&](const std::string& shaders) {
            return both->second.contains(shaders);
          }))
        seen.insert(todo);
      else if (unit.role == role)
        brought.insert(todo);
  }
  for (const std::string& todo : seen) brought.erase(todo);
  return brought;
}

} // namespace ggrade::grading
