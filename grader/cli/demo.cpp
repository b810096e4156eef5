#include "cli/commands.hpp"

#include "cli/terminal.hpp"
#include "grading/grade.hpp"
#include "report/reports.hpp"
#include "report/terminal.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <iostream>

namespace ggrade::cli {

namespace fs = std::filesystem;

namespace {

/// One submission of the demo, how it must end, and the mistake or step that it shows, if that is
/// one of the catalogue.
struct Example {
  std::string name, target, outcome, mistake;
  grading::Recipe recipe;
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
    all.push_back({target + "-reference", target, "graded", "", {solutions}, true});
    all.push_back({target + "-stub", target, "graded", "", {assignment.folder}});
  }
  std::vector<fs::path> patches;
  for (const auto& entry : fs::directory_iterator(solutions / "examples"))
    if (entry.path().extension() == ".patch") patches.push_back(entry.path());
  std::sort(patches.begin(), patches.end());
  for (const fs::path& patch : patches) {
    auto header = grading::patchHeader(patch);
    all.push_back({patch.stem().string(),
                   header.at("Grades"),
                   header.at("Outcome"),
                   header["Mistake"],
                   {solutions, {patch}}});
  }
  return all;
}

/// What the page and the list say of an example.
struct Ended {
  report::Summary summary;
  nlohmann::json line;
  std::string surprise; ///< empty: it ended as it must
};

Ended gradeExample(grading::Grader& grader, const Assignment& assignment, const Example& example,
                   const fs::path& out) {
  grading::Graded graded = grader.draw(grader.build(
      std::make_shared<grading::Program>(assignment, example.recipe), example.solution));
  grader.judge(graded);
  if (!example.recipe.isFolder()) grader.diagnose(graded); // a stub's likeliest cause is known
  results::Result& result = graded.result;
  result.submission = example.name;
  report::writeReports(out / example.name, result);
  Ended ended{report::summarize(result, example.name + "/index.html"),
              {{"submission", result.submission},
               {"outcome", results::name(result.outcome)},
               {"score", result.score},
               {"max_score", result.maxScore},
               {"bonus", result.bonus}},
              ""};
  if (results::name(result.outcome) != example.outcome)
    ended.surprise = fmt::format("{}: {} instead of {}: {}\n", example.name,
                                 results::name(result.outcome), example.outcome, result.detail);
  return ended;
}

/// Those of one target have one grader; as many are graded at a time as there are cores.
void gradeExamples(const Assignment& assignment, const fs::path& solutions,
                   const std::vector<Example>& all, const fs::path& out, std::vector<Ended>& ended,
                   const grading::Progress& progress) {
  std::map<std::string, std::vector<std::size_t>> byTarget;
  for (std::size_t i = 0; i < all.size(); ++i) byTarget[all[i].target].push_back(i);
  const std::size_t before = ended.size();
  ended.resize(before + all.size());
  std::atomic<std::size_t> done{before};
  // The whole catalogue is drawn where somebody's grade depends on it: it takes minutes.
  std::set<std::string> mistakes;
  for (const Example& example : all) mistakes.insert(example.mistake);
  for (const auto& [id, examples] : byTarget) {
    const Target target = findTarget(assignmentsFolder(), id);
    grading::GraderOptions how;
    how.many = true;
    how.threads = 1;
    how.suspects = mistakes;
    grading::Draw draw;
    draw.quality = grading::Quality::fast; // it is seen as well, and sooner
    const grading::ScenePlan plan = grading::drawScenes(target, solutions, draw);
    progress("references of " + id, done, ended.size());
    grading::References references = grading::prepareReferences(
        target, solutions, plan, [](const std::string&, std::size_t, std::size_t) {});
    references.shaders = references.ownShaders; // as for all programs of ours: half of a run's time
    grading::Grader grader(target, solutions, plan, how, references);
    grader.prepare();
    grading::inParallel(examples.size(), grading::workers(), [&](std::size_t n) {
      if (grading::interrupted) throw grading::Interrupted{};
      const std::size_t i = examples[n];
      progress(all[i].name, done++, ended.size());
      ended[before + i] = gradeExample(grader, assignment, all[i], out);
    });
  }
}

/// Those of these assignments, or of all.
std::vector<Assignment> assignmentsOf(const std::vector<std::string>& ids) {
  if (ids.empty()) return loadAssignments(assignmentsFolder());
  std::vector<Assignment> some;
  for (const std::string& id : ids) {
    Assignment assignment = findTarget(assignmentsFolder(), id).assignment;
    if (std::ranges::find(some, assignment.id, &Assignment::id) == some.end())
      some.push_back(std::move(assignment));
  }
  return some;
}

void demo(const std::vector<std::string>& ids, const std::string& outText, bool asJson) {
  const std::vector<Assignment> assignments = assignmentsOf(ids);
  const fs::path out = outputFolder(outText);
  requireSandbox();
  Progress progress("demo");
  grading::TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  std::vector<Ended> ended;
  for (const Assignment& assignment : assignments) {
    const fs::path solutions = solutionFolder(assignment.id);
    gradeExamples(assignment, solutions, examples(assignment, solutions), work.path(), ended,
                  std::ref(progress));
  }
  nlohmann::json list = nlohmann::json::array();
  std::vector<report::Summary> pages;
  std::string surprises;
  for (Ended& one : ended) {
    pages.push_back(std::move(one.summary));
    list.push_back(std::move(one.line));
    surprises += one.surprise;
  }
  progress.clear();
  report::writeFile(
      work.path() / "index.html",
      report::overviewPage("ggrade demo",
                           "The bundled example submissions: the reference, the untouched "
                           "stub, and programs with typical faults. Causes are looked for among "
                           "these faults; grade and batch know the whole catalogue.",
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
    std::vector<std::string> ids;
    std::string out = "out/demo";
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("ID", options->ids, "The examples of these assignments (default: of all)");
  command->add_option("--out", options->out, "Where index.html goes")->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON on stdout");
  command->footer("Examples:\n  ggrade demo --out out/demo\n  ggrade demo ssao shadow_volume");
  command->callback([options] { demo(options->ids, options->out, options->json); });
}

} // namespace ggrade::cli
