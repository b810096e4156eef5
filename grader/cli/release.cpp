#include "cli/commands.hpp"

#include "check/expected.hpp"
#include "cli/derive.hpp"
#include "cli/expected_of.hpp"
#include "cli/kit_files.hpp"
#include "cli/terminal.hpp"
#include "cli/zip.hpp"
#include "grading/toolchain.hpp"
#include "grading/workspace.hpp"
#include "report/write_file.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ggrade::cli {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::string out;
  std::vector<std::string> parts, blank;
  bool gradescope = false, devcontainer = false;
  gg::Language language = gg::Language::english; ///< of an autograder's reports
};

/// What a kit hands out of one assignment.
struct HandedOut {
  Assignment assignment;
  std::vector<Part> parts;     ///< that have something to do
  std::set<std::string> blank; ///< TODOs to do
  std::set<std::string> filled;
};

/// Parts by ID; an assignment's ID stands for all of its parts. Throws UsageError.
std::set<std::string> partsNamed(const std::vector<std::string>& names) {
  std::set<std::string> ids;
  for (const std::string& name : names)
    for (const Part& part : findTarget(assignmentsFolder(), name).parts) ids.insert(part.id);
  return ids;
}

/// Throws UsageError for a TODO that isn't there.
std::vector<HandedOut> choose(const Options& options) {
  const std::set<std::string> parts = partsNamed(options.parts);
  std::set<std::string> unknown(options.blank.begin(), options.blank.end());
  std::vector<HandedOut> all;
  for (const Assignment& assignment : loadAssignments(assignmentsFolder())) {
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

/// A TODO that comes filled in is none any more.
void markDone(const fs::path& file, const std::set<std::string>& filled) {
  std::string text = readFile(file);
  bool changed = false;
  for (const std::string& todo : filled)
    for (std::size_t at; (at = text.find("TODO(" + todo + ")")) != text.npos; changed = true)
      text.replace(at, 4, "DONE");
  if (changed) report::writeFile(file, text);
}

void writeAssignment(const HandedOut& handedOut, const fs::path& kit, Progress& progress) {
  const Assignment& assignment = handedOut.assignment;
  const fs::path solutions = solutionFolder(assignment.id);
  const fs::path folder = kit / "assignments" / assignment.id;
  copyTree(assignment.folder, folder);
  writeSources(assignment, solutions, handedOut.filled, folder);
  for (const std::string& file : assignment.files) markDone(folder / file, handedOut.filled);
  for (const Part& part : handedOut.parts) {
    const fs::path expected = kit / "expected" / part.id;
    writeExpected(assignment, part, solutions, handedOut.blank, expected, std::ref(progress));
    for (const auto& entry : fs::directory_iterator(check::stubFolder(expected)))
      markDone(entry.path(), handedOut.filled);
  }
}

void writeKit(const Options& options, const fs::path& kit, Progress& progress) {
  const fs::path root = toolchain::kSourceFolder;
  for (const char* name : {"CMakeLists.txt", "CMakePresets.json", "ggrade", ".clang-format"})
    if (fs::exists(root / name)) fs::copy_file(root / name, kit / name);
  for (const char* name : {"cmake", "framework", "grader"}) copyTree(root / name, kit / name);
  fs::remove_all(kit / "grader" / "authoring" / "new"); // has a solution of its own
  report::makeFolder(kit / "assignments");
  fs::copy_file(root / "assignments" / "CMakeLists.txt", kit / "assignments" / "CMakeLists.txt");
  const fs::path texts = root / "grader" / "authoring" / "kit";
  fs::remove_all(kit / "grader" / "authoring" / "kit");
  for (const char* name : {"README.md", "README.ja.md"}) fs::copy_file(texts / name, kit / name);
  if (options.devcontainer) copyTree(texts / "devcontainer", kit / ".devcontainer");
  for (const HandedOut& handedOut : choose(options)) writeAssignment(handedOut, kit, progress);
}

/// The one target that an autograder grades.
std::string graded(const Options& options) {
  if (options.parts.size() == 1) return options.parts.front();
  throw UsageError("--gradescope grades one assignment or part: name it with --parts, such as "
                   "--parts mirror");
}

void writeAutograder(const Options& options, const fs::path& folder) {
  const std::string id = graded(options);
  const Target target = findTarget(assignmentsFolder(), id);
  const fs::path root = toolchain::kSourceFolder, texts = root / "grader" / "authoring" / "kit";
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
    fs::copy_file(root / name, tool / name);
  for (const char* name : {"cmake", "framework", "grader"}) copyTree(root / name, tool / name);
  for (const char* side : {"assignments", "solutions"}) {
    report::makeFolder(tool / side);
    for (const auto& entry : fs::directory_iterator(root / side))
      if (entry.is_regular_file())
        fs::copy_file(entry.path(), tool / side / entry.path().filename());
    copyTree(root / side / target.assignment.id, tool / side / target.assignment.id);
  }
}

std::string listOf(const std::vector<HandedOut>& all) {
  std::string text;
  for (const HandedOut& one : all) {
    text += fmt::format("  {}: to do {}\n", one.assignment.id, fmt::join(one.blank, ", "));
    if (!one.filled.empty())
      text += fmt::format("  {}: comes filled in, so its answer is in this kit: {}\n",
                          one.assignment.id, fmt::join(one.filled, ", "));
  }
  return text;
}

void release(const Options& options) {
  const fs::path out = outputFolder(options.out);
  fs::path zip = out;
  zip += ".zip";
  const std::vector<HandedOut> chosen = choose(options);
  if (options.gradescope) graded(options);
  Progress progress("release");
  grading::TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  if (options.gradescope)
    writeAutograder(options, work.path());
  else
    writeKit(options, work.path(), progress);
  progress("packing", 0, 1);
  // An autograder's files lie at the top of its archive, a kit's in a folder.
  writeZip(work.path(), options.gradescope ? "" : out.filename().string(), zip);
  work.publish(out);
  progress.clear();
  fmt::print("{}\n{} ({:.1f} MB)\n", out.string(), zip.string(), double(fs::file_size(zip)) / 1e6);
  if (options.gradescope)
    fmt::print(
        "  grades {}; it holds the solution: upload it as the autograder, hand it to nobody\n",
        graded(options));
  else
    fmt::print("{}", listOf(chosen));
}

} // namespace

void addRelease(CLI::App& app) {
  auto* command = app.add_subcommand(
      "release", "Makes what students receive: a kit without solutions that checks itself");
  auto options = std::make_shared<Options>();
  command->add_option("--out", options->out, "The kit's folder; beside it the same as a .zip")
      ->required();
  command
      ->add_option("--parts", options->parts,
                   "Parts (or assignments) that are to be done; all other TODOs come filled in")
      ->delimiter(',');
  command
      ->add_option("--blank", options->blank,
                   "TODOs that are to be done; all other TODOs come filled in")
      ->delimiter(',');
  command->add_flag(
      "--gradescope", options->gradescope,
      "An autograder's archive instead, for the one of --parts; --lang: of its reports");
  command->add_flag("--devcontainer", options->devcontainer,
                    "With a description of a container to work in");
  command->footer(
      "A part or TODO that comes filled in gives its answer away: release such a kit when that "
      "part is "
      "over.\n\nExamples:\n"
      "  ggrade release --out out/kit                           everything is to be done\n"
      "  ggrade release --parts mirror,shadow,bloom --out out/floor\n"
      "  ggrade release --parts shadow --out out/week2          the mirror comes filled in\n"
      "  ggrade release --blank mirror.4,mirror.5 --out out/short\n"
      "  ggrade release --gradescope --parts mirror --out out/autograder");
  command->callback([options] {
    options->language = gg::language();
    gg::setLanguage(gg::Language::english); // translated where it is read
    release(*options);
  });
}

void addExpect(CLI::App& app) {
  // Not listed: `ggrade check` in a tree with solutions calls it first.
  auto* command = app.add_subcommand("expect", "Makes what `check` compares with")->group("");
  struct Wanted {
    std::string id, out;
  };
  auto wanted = std::make_shared<Wanted>();
  command->add_option("--out", wanted->out)->required();
  command->add_option("ID", wanted->id)->required();
  command->callback([wanted] {
    gg::setLanguage(gg::Language::english); // as in a kit
    requireSandbox();
    Progress progress("expect");
    const Target target = findTarget(assignmentsFolder(), wanted->id);
    updateExpected(target, solutionFolder(target.assignment.id), wanted->out, std::ref(progress));
    progress.clear();
  });
}

} // namespace ggrade::cli
