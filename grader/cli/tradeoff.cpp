#include "cli/commands.hpp"

#include "cli/terminal.hpp"
#include "grading/workspace.hpp"
#include "report/write_file.hpp"
#include "tradeoff/adopted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace ggrade::cli {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct TradeoffOptions {
  std::string id, out, budget, error;
  std::vector<std::string> only;
  tradeoff::Effort effort;
  bool growth = false, noGrowth = false, json = false, adopt = false;
};

/// What is measured of one assignment.
struct Work {
  Assignment assignment;
  fs::path solutions;
  tradeoff::Plan plan;
};

/// What the ID names, everywhere where there is a quality.json.
std::vector<Work> workOf(const TradeoffOptions& options) {
  std::vector<Work> all;
  bool known = options.id == "all";
  for (Assignment& assignment : loadAssignments(assignmentsFolder())) {
    std::vector<std::string> parts;
    for (const Part& part : assignment.parts)
      if (options.id == "all" || options.id == assignment.id || options.id == part.id)
        parts.push_back(part.id);
    if (parts.empty()) continue;
    known = true;
    const fs::path solutions = solutionFolder(assignment.id);
    if (!fs::exists(solutions / "quality.json")) {
      if (options.id != "all")
        throw UsageError(fmt::format("{} is not there: it says which quality numbers to measure",
                                     (solutions / "quality.json").string()));
      continue;
    }
    auto plan = tradeoff::readPlan(assignment, parts, solutions / "quality.json");
    all.push_back({std::move(assignment), solutions, std::move(plan)});
  }
  if (!known) findTarget(assignmentsFolder(), options.id); // says what there is
  for (Work& work : all) tradeoff::keepOnly(work.plan, options.only);
  return all;
}

json jsonOf(const tradeoff::PageAssignment& of) {
  json sweeps = json::array(), growth = json::array(), saved = json::array();
  for (std::size_t i = 0; i < of.measured.size(); ++i)
    sweeps.push_back(tradeoff::jsonOf(of.measured[i], of.findings[i]));
  for (const auto& row : of.growth) growth.push_back(tradeoff::jsonOf(row));
  for (const auto& row : of.saved) saved.push_back(tradeoff::jsonOf(row));
  return {{"assignment", of.id},     {"format", tradeoff::kFormat},
          {"complete", of.complete}, {"machine", json(of.machine)},
          {"sweeps", sweeps},        {"growth", growth},
          {"saved", saved}};
}

json jsonOf(const std::vector<tradeoff::PageAssignment>& all) {
  json assignments = json::array();
  for (const auto& assignment : all) assignments.push_back(jsonOf(assignment));
  return {{"assignments", assignments}};
}

/// Everything that has been measured so far, in one step: what is broken off later leaves this.
void publish(const std::vector<tradeoff::PageAssignment>& all, const fs::path& out) {
  grading::TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  for (const auto& assignment : all) {
    const fs::path folder = work.makeVisible(assignment.id);
    for (std::size_t i = 0; i < assignment.measured.size(); ++i) {
      const auto& [measured, findings] = std::tie(assignment.measured[i], assignment.findings[i]);
      for (const tradeoff::Table& table : findings.tables) {
        const std::string name = table.name() + measured.sweep.suffix;
        report::writeFile(folder / (name + ".csv"), tradeoff::csvOf(measured, table));
        report::writeFile(folder / (name + ".json"),
                          tradeoff::jsonOf(measured, findings, table).dump(1) + '\n');
      }
    }
    report::writeFile(folder / "presets.json",
                      tradeoff::presetsJson(assignment.measured, assignment.findings).dump(1) +
                          '\n');
  }
  report::writeFile(work.path() / "tradeoff.json", jsonOf(all).dump(1) + '\n');
  report::writeFile(work.path() / "index.html", tradeoff::tradeoffPage(all));
  work.publish(out);
}

/// Keeps what handouts and scenes use (tradeoff/adopted.hpp) with the solution.
void adopt(const tradeoff::PageAssignment& measured, const fs::path& folder) {
  fs::remove_all(folder);
  report::makeFolder(folder);
  report::writeFile(folder / "figures.json", jsonOf(measured).dump(1) + '\n');
  for (std::size_t i = 0; i < measured.measured.size(); ++i) {
    const tradeoff::Measured& sweep = measured.measured[i];
    report::writeFile(folder / tradeoff::chartFile(sweep.sweep.part, sweep.sweep.name),
                      tradeoff::chartSvg(sweep, measured.findings[i]));
  }
}

void measure(const TradeoffOptions& options) {
  tradeoff::Wishes wishes;
  if (options.adopt && !options.only.empty())
    throw UsageError("--adopt needs everything measured: leave out --only");
  if (!options.budget.empty()) wishes.budgetMs = tradeoff::parseMs(options.budget);
  if (!options.error.empty()) wishes.error = tradeoff::parseError(options.error);
  const fs::path out = outputFolder(options.out);
  const std::vector<Work> works = workOf(options);
  for (const Work& work : works) {
    tradeoff::requireTruths(work.plan, work.solutions);
    if (options.adopt && work.plan.parts.size() < work.assignment.parts.size())
      throw UsageError(fmt::format("--adopt needs everything measured: name {} instead of {}",
                                   work.assignment.id, options.id));
  }
  const bool growth = options.growth || (!options.noGrowth && options.only.empty());
  std::vector<tradeoff::PageAssignment> all;
  std::string text;
  for (const Work& work : works) {
    Progress progress("tradeoff " + work.assignment.id);
    tradeoff::Bench bench(work.assignment, work.solutions, options.effort, std::ref(progress));
    all.push_back(
        {work.assignment.id, work.assignment.title, {}, {}, {}, {}, {}, options.effort, false});
    for (const tradeoff::Sweep& sweep : work.plan.sweeps) {
      all.back().measured.push_back(bench.measure(sweep));
      all.back().findings.push_back(tradeoff::findingsOf(all.back().measured.back(), wishes));
      all.back().machine = bench.machine();
      text += tradeoff::textOf(all.back().measured.back(), all.back().findings.back()) + '\n';
      progress.clear();
      publish(all, out);
    }
    if (growth) {
      all.back().saved = bench.saved(work.plan);
      all.back().growth = bench.growth(work.plan);
      text += tradeoff::textOf(all.back().growth) + '\n' + tradeoff::textOf(all.back().saved);
    }
    all.back().complete = true;
    progress.clear();
    publish(all, out);
    if (options.adopt) {
      adopt(all.back(), work.solutions / "tradeoff");
      text += fmt::format("{} is new: now run ggrade derive {}\n",
                          (work.solutions / "tradeoff").string(), work.assignment.id);
    }
  }
  if (options.json)
    std::cout << jsonOf(all).dump(2) << '\n';
  else
    std::cout << text << (out / "index.html").string() << '\n';
}

} // namespace

void addTradeoff(CLI::App& app) {
  auto* command = app.add_subcommand(
      "tradeoff", "Measures time against error for every quality number of a reference");
  auto options = std::make_shared<TradeoffOptions>();
  command->add_option("ID", options->id, "An assignment, a part, or all")->required();
  declareContext(*command, true);
  command->add_option("--out", options->out, "Where the results go")->required();
  command->add_option("--budget", options->budget,
                      "Name the setting of least error within this time, such as 5ms");
  command->add_option("--error", options->error,
                      "Name the fastest setting with at most this error, such as 1%");
  command->add_option("--only", options->only, "Quality numbers; nothing else is swept");
  command
      ->add_option("--rounds", options->effort.rounds, "Each setting is run so many times at most")
      ->check(CLI::Range(tradeoff::kLeastPairs, 200U))
      ->capture_default_str();
  command->add_option("--frames", options->effort.frames, "So many frames of a run are timed")
      ->check(CLI::Range(1U, channel::kMaxFrames - tradeoff::kWarmUp))
      ->capture_default_str();
  auto* growth = command->add_flag("--growth", options->growth,
                                   "With --only, too: how cost grows with pixels, objects and "
                                   "triangles; what a scene doesn't need");
  auto* noGrowth =
      command->add_flag("--no-growth", options->noGrowth, "Leave these out")->excludes(growth);
  command
      ->add_flag("--adopt", options->adopt,
                 "Keep tables, charts and presets with the solution: ggrade derive puts them into "
                 "the handouts")
      ->excludes(noGrowth);
  command->add_flag("--json", options->json, "Print tradeoff.json on stdout");
  command->footer(
      "What is swept stands in solutions/ID/quality.json. Time is what a part costs: the\n"
      "processor's time of all passes of a frame, less the same scene without it, by pairs of\n"
      "runs until the 95% interval is narrower than a tenth of the frame. The error is the\n"
      "truth's (solutions/ID/truth.cpp). One program runs at a time.\n"
      "DIR/index.html is the page, DIR/ID/NUMBER.csv and .json the figures (NUMBER.SCENE for a\n"
      "number's second scene), DIR/ID/presets.json has fast, balanced, accurate and reference.\n"
      "They are written after every scene: what is broken off later leaves them.\n"
      "Exit codes: 0 measured, 1 the reference failed, 2 usage, 130 broken off.\n\n"
      "Examples:\n"
      "  ggrade tradeoff floor --out out/tradeoff\n"
      "  ggrade tradeoff shadow --out out/shadow --budget 5ms\n"
      "  ggrade tradeoff floor --out out/fine --error 1% --rounds 60\n"
      "  ggrade tradeoff mirror --out out/size --only mirror_size\n"
      "  ggrade tradeoff floor --out out/tradeoff --adopt && ggrade derive floor");
  command->callback([options] { measure(*options); });
}

} // namespace ggrade::cli
