#include "cli/commands.hpp"

#include "cli/terminal.hpp"
#include "grading/grade.hpp"
#include "grading/recipe.hpp"
#include "grading/workspace.hpp"
#include "report/html.hpp"
#include "report/reports.hpp"
#include "report/terminal.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <iostream>

namespace ggrade::cli {

namespace fs = std::filesystem;

namespace {

/// One submission of the demo, and how it must end.
struct Example {
  std::string name, target, outcome;
  fs::path patch; ///< applied to the solution; empty: `folder` as it is
  fs::path folder;
  bool solution = false;
};

/// None for an assignment without an examples folder.
std::vector<Example> examples(const Assignment& assignment, const fs::path& solutions) {
  std::vector<Example> all;
  if (!fs::exists(solutions / "examples")) return all;
  std::vector<std::string> targets;
  for (const Part& part : assignment.parts) targets.push_back(part.id);
  if (targets.size() > 1) targets.push_back(assignment.id);
  for (const std::string& target : targets) {
    all.push_back({target + "-reference", target, "graded", {}, solutions, true});
    all.push_back({target + "-stub", target, "graded", {}, assignment.folder, false});
  }
  std::vector<fs::path> patches;
  for (const auto& entry : fs::directory_iterator(solutions / "examples"))
    if (entry.path().extension() == ".patch") patches.push_back(entry.path());
  std::sort(patches.begin(), patches.end());
  for (const fs::path& patch : patches) {
    const auto header = grading::patchHeader(patch);
    all.push_back(
        {patch.stem().string(), header.at("Grades"), header.at("Outcome"), patch, {}, false});
  }
  return all;
}

void demo(const std::string& outText, bool asJson) {
  const fs::path out = outputFolder(outText);
  requireSandbox();
  Progress progress("demo");
  nlohmann::json list = nlohmann::json::array();
  std::vector<report::Summary> pages;
  std::string surprises;
  grading::TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  std::size_t count = 0;
  for (const Assignment& assignment : loadAssignments(assignmentsFolder())) {
    const fs::path solutions = solutionFolder(assignment.id);
    const std::vector<Example> all = examples(assignment, solutions);
    count += all.size();
    for (const Example& example : all) {
      if (grading::interrupted) throw grading::Interrupted{};
      progress(example.name, pages.size(), count);
      grading::TemporaryFolder patched;
      grading::GradeOptions how;
      how.upload = example.folder;
      how.solution = example.solution;
      how.draw.quality = grading::Quality::fast; // it is seen as well, and sooner
      how.diagnosis = !example.patch.empty();    // a stub's likeliest cause is known
      if (!example.patch.empty()) {
        how.upload = patched.path() / example.name;
        grading::writeFiles(assignment, {solutions, {example.patch}}, how.upload);
      }
      report::Result result =
          grading::grade(findTarget(assignmentsFolder(), example.target), solutions, how);
      result.submission = example.name;
      if (report::name(result.outcome) != example.outcome)
        surprises += fmt::format("{}: {} instead of {}: {}\n", example.name,
                                 report::name(result.outcome), example.outcome, result.detail);
      const fs::path folder = work.path() / example.name;
      report::writeReports(folder, result);
      pages.push_back(report::summarize(result, example.name + "/index.html"));
      list.push_back({{"submission", result.submission},
                      {"outcome", report::name(result.outcome)},
                      {"score", result.score},
                      {"max_score", result.maxScore},
                      {"bonus", result.bonus}});
    }
  }
  progress.clear();
  report::writeFile(
      work.path() / "index.html",
      report::overviewPage("ggrade demo",
                           "The bundled example submissions: the reference, the untouched "
                           "stub, and programs with typical faults.",
                           pages));
  work.publish(out);
  if (asJson) {
    std::cout << list.dump(2) << '\n';
  } else {
    report::TerminalStyle style;
    style.colour = wantsColour();
    std::cout << report::terminalTable(pages, style)
              << fmt::format("\n{}\n", (out / "index.html").string());
  }
  if (!surprises.empty()) {
    fmt::print(stderr, "ggrade: not every example ended as it must:\n{}", surprises);
    exitCode = kNotGradable;
  }
}

} // namespace

void addDemo(CLI::App& app) {
  auto* command = app.add_subcommand(
      "demo", "Grades the bundled example submissions and writes a page about them");
  struct Options {
    std::string out = "out/demo";
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("--out", options->out, "Where index.html goes")->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON on stdout");
  command->footer("Example:\n  ggrade demo --out out/demo");
  command->callback([options] { demo(options->out, options->json); });
}

} // namespace ggrade::cli
