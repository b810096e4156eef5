#include "cli/commands.hpp"

#include "authoring/handout.hpp"
#include "authoring/solution_blocks.hpp"
#include "cli/terminal.hpp"
#include "grading/program.hpp"
#include "grading/references.hpp"
#include "grading/workspace.hpp"
#include "image/png.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <set>

namespace ggrade::cli {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct Options {
  std::string id, out;
  int done = -1;
  bool noPictures = false;
};

std::set<std::string> firstTodos(const Part& part, int count) {
  std::set<std::string> filled;
  for (int i = 0; i < count; ++i) filled.insert(part.todos[std::size_t(i)].id);
  return filled;
}

/// The editable files with the given TODOs filled in.
void writeSources(const Assignment& assignment, const fs::path& solutions,
                  const std::set<std::string>& filled, const fs::path& into) {
  for (const std::string& file : assignment.files) {
    const fs::path from = solutions / file;
    report::writeFile(into / file, authoring::withFilled(readFile(from), from.string(), filled));
  }
}

/// The window after each step of each part, as PNG files named `part-k.png`.
void writePictures(const Assignment& assignment, const fs::path& solutions, const fs::path& into) {
  const json settings = readJson(solutions / "handout.json");
  Progress progress("handout pictures of " + assignment.id);
  for (const Part& part : assignment.parts) {
    for (std::size_t k = 0; k <= part.todos.size(); ++k) {
      progress(part.id, k, part.todos.size());
      grading::TemporaryFolder work;
      writeSources(assignment, solutions, firstTodos(part, int(k)), work.path());
      for (const char* name : {"assignment.json", "scene.json"})
        fs::copy_file(assignment.folder / name, work.path() / name);
      const grading::Happened built =
          grading::buildProgram(assignment.id, work.path(), sandbox::Isolation::none);
      if (!built.ok())
        throw UsageError(fmt::format("step {} of {} doesn't build:\n{}", k, part.id, built.output));
      const json scene = grading::handoutScene(assignment, part, settings, k);
      const grading::Rendering rendering = grading::renderScene(
          assignment.id, work.path(), scene, settings.at("times").get<std::vector<double>>(), {},
          sandbox::Isolation::none);
      if (!rendering.happened.ok())
        throw UsageError(fmt::format("step {} of {} doesn't render: {}\n{}", k, part.id,
                                     rendering.happened.detail, rendering.happened.output));
      writePng(into / fmt::format("{}-{}.png", part.id, k),
               rubric::toImage(grading::rawFrames(rendering.capture).at(0)));
    }
  }
}

void derive(const Options& options) {
  const Target target = findTarget(assignmentsFolder(), options.id);
  const Assignment& assignment = target.assignment;
  const fs::path solutions = solutionFolder(assignment.id);
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
    writeSources(assignment, solutions, firstTodos(part, options.done), options.out);
    return;
  }
  const fs::path into = options.out.empty() ? assignment.folder : fs::path(options.out);
  report::makeFolder(into / "handout");
  writeSources(assignment, solutions, {}, into);
  if (fs::exists(solutions / "handout.md")) {
    const auto stub = [&](const std::string& file) {
      return authoring::withFilled(readFile(solutions / file), file, {});
    };
    report::writeFile(into / "README.md",
                      authoring::expandExcerpts(readFile(solutions / "handout.md"),
                                                (solutions / "handout.md").string(), stub));
    if (!options.noPictures) writePictures(assignment, solutions, into / "handout");
  }
  fmt::print("{}: stub and handout are in step with {}\n", into.string(), solutions.string());
}

} // namespace

void addDerive(CLI::App& app) {
  auto* command = app.add_subcommand(
      "derive", "Makes an assignment's stub, handout and pictures from its solution");
  auto options = std::make_shared<Options>();
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
      "  ggrade derive mirror --done 3 --out out/step3");
  command->callback([options] { derive(*options); });
}

} // namespace ggrade::cli
