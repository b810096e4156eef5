#include "cli/commands.hpp"

#include "cli/terminal.hpp"
#include "grading/grade.hpp"
#include "intake/names.hpp"
#include "report/results_json.hpp"
#include "report/terminal.hpp"
#include "report/text.hpp"
#include "rubric/rubric.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

namespace ggrade::cli {

namespace fs = std::filesystem;

namespace {

struct GradeOptions {
  std::string id, upload, out, reveal = "names", sandbox = "bwrap", quality = "balanced";
  std::uint64_t seed = 0;
  bool haveSeed = false, solution = false, noDiagnosis = false, json = false;
};

/// The table on stdout, or results.json.
void print(const results::Result& result, const fs::path& out, bool json) {
  if (json) {
    std::cout << report::resultsJson(result, report::Reveal::details);
    return;
  }
  report::TerminalStyle style;
  style.colour = wantsColour();
  std::cout << report::terminalTable(result, style)
            << fmt::format("\n{}\n", report::sanitizeLine((out / "index.html").string(), 4096));
}

void grade(const GradeOptions& options) {
  const Target target = findTarget(assignmentsFolder(), options.id);
  const fs::path solutions = solutionFolder(target.assignment.id);
  const fs::path upload = fs::path(options.upload).lexically_normal();
  const std::string name = fs::weakly_canonical(upload).filename().string();
  for (const std::string& argument : afterDashes)
    if (!argument.starts_with("--gtest_"))
      throw UsageError(fmt::format("\"{}\": after -- stand arguments for GoogleTest, such as "
                                   "--gtest_filter=mirror.shading",
                                   argument));
  const fs::path out = outputFolder(options.out.empty() ? fs::path("out") / options.id / name
                                                        : fs::path(options.out));
  if (!fs::exists(upload))
    throw UsageError(fmt::format("{}: there is no such folder or archive. Name what holds {}",
                                 upload.string(), fmt::join(target.assignment.files, ", ")));
  chooseSandbox(options.sandbox);

  Progress progress("grading " + report::sanitizeLine(name)); // whoever hands in names the folder
  grading::Draw draw;
  draw.quality = grading::parseQuality(options.quality);
  if (options.haveSeed) draw.seed = options.seed;
  grading::GraderOptions how;
  how.judgeArguments = afterDashes;
  how.diagnosis = !options.noDiagnosis;
  how.progress = std::ref(progress);
  grading::Grader grader(target, solutions, grading::drawScenes(target, solutions, draw), how);
  results::Result result;
  if (options.solution) {
    result = grader.gradeTrusted(upload);
  } else {
    intake::Upload one;
    one.sources = {{fs::canonical(upload), intake::decodeOrEscape(name)}};
    result = grader.gradeUpload(one);
  }
  result.submission = report::sanitizeLine(name);
  progress.clear();
  grading::publishReports(result, out, *report::parseReveal(options.reveal));
  print(result, out, options.json);
  if (result.outcome == results::Outcome::notGradable) exitCode = kNotGradable;
}

} // namespace

void addGrade(CLI::App& app) {
  auto* command = app.add_subcommand("grade", "Grades one submission");
  auto options = std::make_shared<GradeOptions>();
  command->add_option("ID", options->id, "Assignment or part (see ggrade list)")->required();
  command->add_option("DIR", options->upload, "The submitted files: a folder, a zip or tar archive")
      ->required();
  command->add_option("--out", options->out, "Where the results go (default out/ID/NAME)");
  auto* seed = command
                   ->add_option("--seed", options->seed,
                                "Draws other hidden scenes (default: the assignment's)")
                   ->check(notAWholeNumber);
  declareQuality(*command, options->quality, "How closely to look");
  command->add_option("--reveal", options->reveal, "What the student's page says of hidden scenes")
      ->check(CLI::IsMember({"none", "names", "details"}))
      ->capture_default_str();
  command
      ->add_option("--sandbox", options->sandbox,
                   "none: run the program as yourself. Only for one that you trust")
      ->check(CLI::IsMember({"bwrap", "none"}))
      ->capture_default_str();
  declareContext(*command);
  command->add_flag("--solution", options->solution, "DIR is a trusted folder of solutions/");
  command->add_flag("--no-diagnosis", options->noDiagnosis,
                    "Don't look for the likeliest cause of lost points");
  declareRepair(*command);
  command->add_flag("--json", options->json, "Print results.json on stdout");
  command->footer(
      "After -- stand arguments for GoogleTest, such as --gtest_filter=mirror.where.\n"
      "Exit codes: 0 graded (whatever the score), 1 could not be graded, 2 usage, 3 no sandbox.\n\n"
      "Examples:\n"
      "  ggrade grade mirror uploads/ada\n"
      "  ggrade grade mirror uploads/ada.zip\n"
      "  ggrade grade mirror solutions/floor --solution\n"
      "  ggrade grade mirror uploads/ada --seed 7 -- --gtest_filter='mirror.shading'");
  command->callback([options, seed] {
    options->haveSeed = seed->count() > 0;
    grade(*options);
  });
}

void addJudge(CLI::App& app) {
  // Not listed: whoever grades starts this in a process of its own.
  auto* command =
      app.add_subcommand("judge", "Judges what submissions drew, as stdin names them")->group("");
  struct Options {
    std::string evidence;
    bool many = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("EVIDENCE", options->evidence)->required();
  command->add_flag("--many", options->many);
  // What a comparison allows, for who wants to know what another tolerance would do.
  command->add_option("--tolerance", tolerances().tolerance);
  command->add_option("--radius", tolerances().radius);
  command->callback([options] { exitCode = rubric::serveJudge(options->evidence, options->many); });
}

} // namespace ggrade::cli
