#include "grading/own_tapes.hpp"

#include "grading/parallel.hpp"
#include "grading/replay.hpp"
#include "grading/statements.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

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

} // namespace

OwnTapes::OwnTapes(const Target& target, fs::path solutionFolder, const References& references)
    : target_(target), solutionFolder_(std::move(solutionFolder)), references_(references) {}

tape::Tape OwnTapes::record(const Recipe& recipe, const rubric::SceneFolders& scene) {
  Program program(target_.assignment, recipe);
  const trace::Request request = tapingRequest(std::uint32_t(scene.times.size()));
  const fs::path file =
      cacheFolder() / "tapes" /
      hashOf(program.key() + scene.scene.dump() + json(scene.times).dump() + identity(request));
  if (!fs::exists(file)) {
    const Rendering taped =
        program.render(scene.scene, scene.times, references_.ownShaders, request);
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

const tape::Tape& OwnTapes::reference(std::size_t scene) {
  const std::lock_guard lock(mutex_);
  const auto found = reference_.find(scene);
  if (found != reference_.end()) return found->second;
  return reference_.emplace(scene, record({solutionFolder_}, references_.scenes.at(scene)))
      .first->second;
}

void OwnTapes::add(const std::string& todo, const repair::Difference& difference,
                   const std::set<std::string>& lines) {
  Share& share = changedBy_[difference.unit][todo];
  share.lines.insert(lines.begin(), lines.end());
  share.shaders.insert(difference.shaders.begin(), difference.shaders.end());
}

void OwnTapes::addStep(const std::string& todo, const repair::Comparison& before,
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

fs::path OwnTapes::keptFile(const std::string& what) const {
  return cacheFolder() / "owners" /
         hashOf(what + toolHash() + referenceKey(target_, solutionFolder_) + target_.id +
                references_.scenes.at(0).scene.dump());
}

void OwnTapes::learn() {
  learnOwners();
  learnDeciders();
}

void OwnTapes::learnOwners() {
  std::call_once(owners_, [&] {
    const fs::path file = keptFile("owners");
    if (!fs::exists(file)) {
      learnAnew(references_.scenes.at(0));
      json kept = json::array();
      for (const auto& [unit, todos] : changedBy_)
        for (const auto& [todo, share] : todos)
          kept.push_back({{"role", unit.role},
                          {"unit", unit.name},
                          {"todo", todo},
                          {"lines", share.lines},
                          {"shaders", share.shaders}});
      keepText(kept.dump(), file);
      return;
    }
    for (const json& one : readJson(file))
      changedBy_[{one.at("role"), one.at("unit")}][one.at("todo")] = {one.at("lines"),
                                                                      one.at("shaders")};
  });
}

void OwnTapes::learnDeciders() {
  std::call_once(deciders_, [&] {
    const fs::path file = keptFile("deciders");
    if (!fs::exists(file)) {
      learnDecidersAnew(references_.scenes.at(0));
      json kept = json::array();
      for (const auto& [unit, todos] : decidedBy_)
        kept.push_back({{"role", unit.role}, {"unit", unit.name}, {"todos", todos}});
      keepText(kept.dump(), file);
      return;
    }
    for (const json& one : readJson(file))
      decidedBy_[{one.at("role"), one.at("unit")}] = one.at("todos");
  });
}

void OwnTapes::learnAnew(const rubric::SceneFolders& scene) {
  const tape::Tape& right = reference(0);
  std::set<std::string> all, filled;
  std::vector<std::string> todos; // the target's, in their order
  for (const Part& part : target_.assignment.parts)
    for (const auto& todo : part.todos) all.insert(todo.id);
  filled = all;
  for (const Part& part : target_.parts)
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
      compared[i] = repair::compare(record({solutionFolder_, {}, programs[i]}, scene), right);
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

void OwnTapes::learnDecidersAnew(const rubric::SceneFolders& scene) {
  const tape::Tape& right = reference(0);
  Statements statements(target_, solutionFolder_);
  std::vector<std::set<Unit>> changed(statements.size()); // without each statement
  inParallel(statements.size(), workers(), [&](std::size_t i) {
    const Rendering drawn =
        statements.renderWithout(i, scene.scene, scene.times, references_.ownShaders,
                                 tapingRequest(std::uint32_t(scene.times.size())));
    if (!drawn.happened.ok() || !drawn.capture.tapeRefused.empty()) return;
    for (const repair::Difference& one :
         repair::compare(tape::read(drawn.capture.tape), right).differences)
      changed[i].insert(one.unit);
  });
  std::map<Unit, std::size_t> fewest; // units that the statement changes, with this one
  for (std::size_t i = 0; i < changed.size(); ++i)
    for (const Unit& unit : changed[i]) {
      const auto [known, isNew] = fewest.try_emplace(unit, changed[i].size());
      if (changed[i].size() > known->second) continue;
      if (changed[i].size() < known->second) decidedBy_[unit].clear();
      known->second = changed[i].size();
      decidedBy_[unit].insert(statements.todoOf(i));
    }
}

std::set<std::string> OwnTapes::decidersOf(const Unit& unit) {
  if (repair::isShader(unit.name)) return {}; // of these, lines tell
  learnDeciders();
  const auto found = decidedBy_.find(unit);
  return found == decidedBy_.end() ? std::set<std::string>() : found->second;
}

const std::set<Unit>& OwnTapes::unitsOf(const fs::path& patch) {
  const std::lock_guard lock(patches_);
  if (const auto known = unitsOf_.find(patch); known != unitsOf_.end()) return known->second;
  std::set<Unit> units;
  try {
    const tape::Tape tape = record({solutionFolder_, {patch}}, references_.scenes.at(0));
    for (const repair::Difference& one : repair::compare(tape, reference(0)).differences)
      units.insert(one.unit);
  } catch (const NoTape&) {
  }
  return unitsOf_.emplace(patch, std::move(units)).first->second;
}

std::set<std::string> OwnTapes::ownersOf(const repair::Difference& difference) {
  learnOwners();
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

std::set<std::string> OwnTapes::drawersOf(const std::string& role) {
  learnOwners();
  std::set<std::string> todos;
  if (const auto found = changedBy_.find({role, "draws"}); found != changedBy_.end())
    for (const auto& [todo, share] : found->second) todos.insert(todo);
  return todos;
}

std::set<std::string> OwnTapes::missingIn(const repair::Difference& difference,
                                          const repair::UnitsInDraws& compared) {
  std::set<std::string> missing;
  if (difference.isUnseen) missing = ownersOf(difference);
  learnOwners();
  if (const auto own = changedBy_.find(difference.unit); own != changedBy_.end())
    for (const auto& [todo, share] : own->second)
      if (!share.lines.empty() && !difference.adds &&
          std::ranges::includes(difference.lacks, share.lines))
        missing.insert(todo);
  if (difference.isUnseen || difference.unit.name.starts_with("shader "))
    missing.merge(broughtWith(difference.unit.role, compared));
  return missing;
}

std::set<std::string> OwnTapes::broughtWith(const std::string& role,
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
