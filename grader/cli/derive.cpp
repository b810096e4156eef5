#include "authoring/derive.hpp"
#include "authoring/comments.hpp"
#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "grading/owners.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

namespace ggrade::cli {

namespace fs = std::filesystem;

namespace {

/// What grading by repair would else have to learn first.
void keepOwners(const Assignment& assignment, const fs::path& solutions) {
  requireSandbox();
  Progress progress("learning " + assignment.id);
  try {
    grading::keepOwners(assignment, solutions, std::ref(progress));
    progress.clear();
  } catch (const grading::NoTape& error) {
    progress.clear();
    fmt::print("{}: faults can't be repaired when it is graded: {}\n", assignment.id, error.what());
  }
}

struct DeriveOptions {
  std::string id, out;
  int done = -1;
  bool noPictures = false;
};

void derive(const DeriveOptions& options) {
  const Target target = findTarget(assignmentsFolder(), options.id);
  const Assignment& assignment = target.assignment;
  const fs::path solutions = solutionFolder(assignment.id);
  // What lies in assignments/ is English, whoever derives it.
  const gg::Language comments = options.out.empty() ? gg::Language::english : gg::language();
  if (options.done >= 0) {
    if (target.parts.size() != 1)
      throw UsageError(fmt::format(
          "--done counts the TODOs of one part, and {} has several: name the part", options.id));
    const Part& part = target.parts[0];
    if (std::size_t(options.done) > part.todos.size())
      throw UsageError(
          fmt::format("--done {}: {} has {} TODOs", options.done, part.id, part.todos.size()));
    if (options.out.empty()) throw UsageError("--done needs --out: name the folder for the files");
    report::makeFolder(options.out);
    authoring::writeSources(assignment, solutions,
                            authoring::firstTodos(part, std::size_t(options.done)), comments,
                            options.out);
    return;
  }
  const fs::path into = options.out.empty() ? assignment.folder : fs::path(options.out);
  Progress progress("handout pictures of " + assignment.id);
  grading::Progress pictures;
  if (!options.noPictures) pictures = std::ref(progress);
  authoring::deriveInto(assignment, solutions, comments, into, pictures);
  progress.clear();
  if (options.out.empty()) keepOwners(assignment, solutions);
  for (const std::string& text : authoring::outOfStep(assignment, solutions))
    fmt::print("{}\n", text);
  fmt::print("{}: stub and handout are in step with {}\n", into.string(), solutions.string());
}

} // namespace

void addDerive(CLI::App& app) {
  auto* command = app.add_subcommand(
      "derive", "Makes an assignment's stub, handout and pictures from its solution");
  auto options = std::make_shared<DeriveOptions>();
  command->add_option("ID", options->id, "Assignment, or with --done a part")->required();
  command
      ->add_option("--done", options->done,
                   "The program with the first N TODOs of the part filled in")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--out", options->out, "Where the files go (default: assignments/ID)");
  command->add_flag("--no-pictures", options->noPictures,
                    "Leave the handout's pictures as they are");
  command->footer(
      "Examples:\n"
      "  ggrade derive floor                          after every change of solutions/floor\n"
      "  ggrade derive mirror --done 3 --out out/step3\n"
      "  ggrade derive floor --lang ja --out out/ja   the stub's comments in Japanese\n"
      "What lies in assignments/ has English comments.");
  command->callback([options] { derive(*options); });
}

} // namespace ggrade::cli
