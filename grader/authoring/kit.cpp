#include "authoring/kit.hpp"

#include "authoring/derive.hpp"
#include "authoring/expected_of.hpp"
#include "authoring/handout.hpp"
#include "authoring/quiz.hpp"
#include "check/expected.hpp"
#include "grading/toolchain.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>
#include <set>

namespace ggrade::authoring {

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = toolchain::kSourceFolder;

/// Copies a folder with all that is in it but hidden files, to where nothing stands yet.
void copyTree(const fs::path& from, const fs::path& to) {
  report::makeFolder(to);
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".")) continue;
    if (entry.is_directory())
      copyTree(entry.path(), to / name);
    else if (entry.is_regular_file())
      fs::copy_file(entry.path(), to / name);
  }
}

/// Parts by ID; an assignment's ID stands for all of its parts. Throws UsageError.
std::set<std::string> partsNamed(const std::vector<std::string>& names) {
  std::set<std::string> ids;
  for (const std::string& name : names)
    for (const Part& part : findTarget(kRoot / "assignments", name).parts) ids.insert(part.id);
  return ids;
}

} // namespace

std::vector<HandedOut> choose(const KitOptions& options) {
  const std::set<std::string> parts = partsNamed(options.parts);
  std::set<std::string> unknown(options.blank.begin(), options.blank.end());
  std::vector<HandedOut> all;
  for (const Assignment& assignment : loadAssignments(kRoot / "assignments")) {
    HandedOut one{assignment, {}, {}, {}};
    for (const Part& part : assignment.parts) {
      bool any = false;
      for (const Todo& todo : part.todos) {
        unknown.erase(todo.id);
        const bool named = std::ranges::find(options.blank, todo.id) != options.blank.end();
        const bool isBlank = options.blank.empty() ? parts.empty() || parts.count(part.id) : named;
        (isBlank ? one.blank : one.filled).insert(todo.id);
        any = any || isBlank;
        if (named && !parts.empty() && !parts.count(part.id))
          throw UsageError(fmt::format("--blank {}: part {} is not one of --parts {}", todo.id,
                                       part.id, fmt::join(options.parts, ",")));
      }
      if (any) one.parts.push_back(part);
    }
    if (!one.parts.empty()) all.push_back(std::move(one));
  }
  if (!unknown.empty())
    throw UsageError(fmt::format("--blank: there is no TODO {}; TODOs are named as mirror.2",
                                 fmt::join(unknown, ", ")));
  return all;
}

namespace {

/// A TODO that comes filled in is none any more.
void markDone(const fs::path& file, const std::set<std::string>& filled) {
  std::string text = readFile(file);
  bool changed = false;
  for (const std::string& todo : filled)
    for (std::size_t at; (at = text.find("TODO(" + todo + ")")) != text.npos; changed = true)
      text.replace(at, 4, "DONE");
  if (changed) report::writeFile(file, text);
}

/// Says in a part's handouts which of its steps come filled in.
void noteDone(const HandedOut& handedOut, const fs::path& folder) {
  const gg::Language chosen = gg::language();
  for (const Written& written : kWritten)
    for (const Part& part : handedOut.assignment.parts) {
      const fs::path file =
          folder / ((handedOut.assignment.isOnePart() ? "README" : part.id) + written.ending);
      std::vector<std::string> done;
      for (const Todo& todo : part.todos)
        if (handedOut.filled.count(todo.id)) done.push_back(todo.id);
      if (done.empty() || !fs::exists(file)) continue;
      gg::setLanguage(written.language);
      const std::string note =
          done.size() == part.todos.size()
              ? gg::say("In this kit all of this part comes filled in: where the text says "
                        "`TODO({})`, the files say `DONE({})`.",
                        done.front(), done.front())
              : gg::say("In this kit these steps come filled in, marked `DONE`: {}.",
                        fmt::join(done, ", "));
      report::writeFile(file, fmt::format("> {}\n\n{}", note, readFile(file)));
    }
  gg::setLanguage(chosen);
}

void writeAssignment(const HandedOut& handedOut, gg::Language comments, const fs::path& kit,
                     const grading::Progress& progress) {
  const Assignment& assignment = handedOut.assignment;
  const fs::path solutions = kRoot / "solutions" / assignment.id;
  const fs::path folder = kit / "assignments" / assignment.id;
  copyTree(assignment.folder, folder);
  writeSources(assignment, solutions, handedOut.filled, comments, folder);
  for (const std::string& file : assignment.files) markDone(folder / file, handedOut.filled);
  noteDone(handedOut, folder);
  std::vector<Part> parts = handedOut.parts;
  if (check::hasTogether(assignment)) parts.push_back(check::togetherOf(assignment));
  for (const Part& part : parts) {
    const fs::path expected = kit / "expected" / part.id;
    writeExpected(assignment, part, solutions, handedOut.blank, expected, progress);
    for (const std::string& file : assignment.files)
      fs::copy_file(folder / file, check::stubFolder(expected) / file,
                    fs::copy_options::overwrite_existing);
  }
}

/// The examples of help texts name a part that the kit has.
///   choice: what students are handed
void nameItsParts(const std::vector<HandedOut>& choice, const fs::path& kit) {
  std::set<std::string> known;
  for (const HandedOut& handedOut : choice) {
    known.insert(handedOut.assignment.id);
    for (const Part& part : handedOut.parts) known.insert(part.id);
  }
  const std::string first = choice.front().parts.front().id;
  static const std::regex example("ggrade (run|check|render|inspect) (mirror|shadow|floor)\\b");
  std::vector<fs::path> files = {kit / "framework" / "words" / "ja.json"};
  for (const char* folder : {"cmake/help", "grader/check", "grader/cli"})
    for (const fs::directory_entry& entry : fs::directory_iterator(kit / folder))
      files.push_back(entry.path());
  for (const fs::path& file : files) {
    const std::string text = readFile(file);
    std::string named;
    std::size_t done = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), example), end; at != end; ++at) {
      const std::size_t part = std::size_t(at->position(2));
      named += text.substr(done, part - done) + (known.count(at->str(2)) ? at->str(2) : first);
      done = part + std::size_t(at->length(2));
    }
    if (done) report::writeFile(file, named + text.substr(done));
  }
}

} // namespace

void writeKit(const KitOptions& options, const fs::path& kit, const grading::Progress& progress) {
  for (const char* name : {"CMakeLists.txt", "CMakePresets.json", "ggrade", ".clang-format"})
    if (fs::exists(kRoot / name)) fs::copy_file(kRoot / name, kit / name);
  for (const char* name : {"cmake", "framework", "grader"}) copyTree(kRoot / name, kit / name);
  fs::remove_all(kit / "grader" / "authoring" / "new"); // has a solution of its own
  report::makeFolder(kit / "assignments");
  fs::copy_file(kRoot / "assignments" / "CMakeLists.txt", kit / "assignments" / "CMakeLists.txt");
  const fs::path texts = kRoot / "grader" / "authoring" / "kit";
  fs::remove_all(kit / "grader" / "authoring" / "kit");
  for (const char* name : {"README.md", "README.ja.md"}) fs::copy_file(texts / name, kit / name);
  copyTree(texts / "vscode", kit / ".vscode");
  if (options.devcontainer) copyTree(texts / "devcontainer", kit / ".devcontainer");
  const std::vector<HandedOut> choice = choose(options);
  nameItsParts(choice, kit);
  for (const HandedOut& handedOut : choice)
    writeAssignment(handedOut, options.language, kit, progress);
}

bool writeQuizzes(const KitOptions& options, const fs::path& folder) {
  bool any = false;
  const gg::Language chosen = gg::language();
  for (const Written& written : kWritten) {
    gg::setLanguage(written.language);
    for (const HandedOut& handedOut : choose(options))
      for (const Part& part : handedOut.parts) {
        const auto quiz = quizOf(kRoot / "solutions" / handedOut.assignment.id, part.id);
        if (!quiz) continue;
        any = true;
        const fs::path page = part.id + written.ending;
        const std::string name = page.stem().string(); // "mirror.ja"
        report::writeFile(folder / page, quizPage(*quiz, part.title, true));
        report::writeFile(folder / (name + ".gift.txt"), quizGift(*quiz, name));
      }
  }
  gg::setLanguage(chosen);
  return any;
}

std::string graded(const KitOptions& options) {
  if (options.parts.size() == 1) return options.parts.front();
  throw UsageError("--gradescope grades one assignment or part: name it with --parts, such as "
                   "--parts mirror");
}

void writeAutograder(const KitOptions& options, const fs::path& folder) {
  const std::string id = graded(options);
  const Target target = findTarget(kRoot / "assignments", id);
  const fs::path texts = kRoot / "grader" / "authoring" / "kit";
  for (const char* name : {"setup.sh", "run_autograder"}) {
    std::string text = readFile(texts / "gradescope" / name);
    for (const auto& [mark, value] : {std::pair<std::string, std::string>{"@ID@", id},
                                      {"@ASSIGNMENT@", target.assignment.id},
                                      {"@LANGUAGE@", std::string(gg::name(options.language))}})
      for (std::size_t at; (at = text.find(mark)) != text.npos;)
        text.replace(at, mark.size(), value);
    report::writeFile(folder / name, text);
    fs::permissions(folder / name,
                    fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add);
  }
  const fs::path tool = folder / "ggrade";
  report::makeFolder(tool);
  for (const char* name : {"CMakeLists.txt", "CMakePresets.json", "ggrade"})
    fs::copy_file(kRoot / name, tool / name);
  for (const char* name : {"cmake", "framework", "grader"}) copyTree(kRoot / name, tool / name);
  for (const char* side : {"assignments", "solutions"}) {
    report::makeFolder(tool / side);
    for (const auto& entry : fs::directory_iterator(kRoot / side))
      if (entry.is_regular_file())
        fs::copy_file(entry.path(), tool / side / entry.path().filename());
    copyTree(kRoot / side / target.assignment.id, tool / side / target.assignment.id);
  }
}

} // namespace ggrade::authoring
