#include "cli/commands.hpp"

#include "batch/batch.hpp"
#include "batch/books.hpp"
#include "batch/merge.hpp"
#include "batch/worker.hpp"
#include "cli/batch_options.hpp"
#include "cli/terminal.hpp"
#include "grading/program.hpp"
#include "grading/workspace.hpp"
#include "report/attention.hpp"
#include "report/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

namespace ggrade::cli {

namespace fs = std::filesystem;

namespace {

void printEnd(const std::vector<report::ClassRow>& rows, const batch::PageNotes& notes,
              const batch::Outcome& outcome, const fs::path& out, bool asJson) {
  std::size_t notGradable = 0;
  for (const report::ClassRow& row : rows)
    notGradable += row.outcome == results::Outcome::notGradable;
  if (notGradable || !outcome.unfinished.empty() || !notes.missing.empty()) exitCode = kNotGradable;
  const std::vector<report::Attention> needs = report::needingAPerson(rows);
  // An override that looks wrong counts, as the instructor said: only who has no score is missing.
  const auto alike = std::ranges::count_if(
      rows, [](const report::ClassRow& row) { return !row.lookAlikes.empty(); });
  if (std::ranges::any_of(needs, &report::Attention::lacksScore)) exitCode = kNotGradable;
  if (asJson) {
    nlohmann::json list = nlohmann::json::array(), changes = nlohmann::json::array();
    for (const report::ClassRow& row : rows)
      list.push_back({{"student", row.student},
                      {"name", row.name},
                      {"folder", row.folder},
                      {"outcome", results::name(row.outcome)},
                      {"score", row.score + row.bonus},
                      {"final_score", row.finalScore},
                      {"max_score", row.maxScore}});
    for (const report::ScoreChange& change : outcome.changes)
      changes.push_back(
          {{"folder", change.folder}, {"before", change.before}, {"after", change.after}});
    nlohmann::json persons = nlohmann::json::array(), refused = notes.refused;
    for (const report::Attention& one : needs)
      persons.push_back({{"student", rows[one.row].student},
                         {"folder", rows[one.row].folder},
                         {"reasons", one.reasons}});
    for (const report::ClassRow& row : rows)
      for (const std::string& line : row.refused) refused.push_back(row.name + ": " + line);
    nlohmann::json protections = nlohmann::json::object();
    for (const auto& [key, text] : notes.protections) protections[key] = text;
    std::cout << nlohmann::json{{"submissions", list},
                                {"graded", outcome.graded},
                                {"kept", outcome.kept},
                                {"unfinished", outcome.unfinished},
                                {"changes", changes},
                                {"needs_person", persons},
                                {"refused", refused},
                                {"protections", protections},
                                {"without_sandbox", notes.unprotected},
                                {"remarks", notes.remarks}}
                     .dump(2, ' ', false, nlohmann::json::error_handler_t::replace)
              << '\n';
    return;
  }
  for (const std::string& one : notes.refused)
    fmt::print("refused: {}\n", report::sanitizeLine(one));
  for (const std::string& remark : notes.remarks)
    fmt::print("note: {}\n", report::sanitizeLine(remark));
  for (const report::ScoreChange& change : outcome.changes)
    fmt::print("{}: {} {} -> {}\n", change.after < change.before ? "drop" : "rise",
               report::sanitizeLine(change.name), report::number(change.before),
               report::number(change.after));
  for (const std::string& one : outcome.unfinished)
    fmt::print("NOT GRADED {}\n", report::sanitizeLine(one));
  for (const report::Attention& one : needs) {
    const report::ClassRow& row = rows[one.row];
    for (const std::string& reason : one.reasons)
      fmt::print("NEEDS A PERSON {}: {}\n",
                 report::sanitizeLine(row.quoted.empty() ? row.name : row.quoted, 100), reason);
  }
  fmt::print("{} graded, {} kept from before, {} not gradable{}{}\n{}\n{}\n", outcome.graded,
             outcome.kept, notGradable,
             alike ? fmt::format(", {} look alike and have no grade", alike) : "",
             exitCode == kDone ? "" : ": mend the cause and run the same again with --resume",
             (out / "gradebook.csv").string(), (out / "index.html").string());
}

void runBatch(const BatchCommand& command) {
  const Target target = findTarget(assignmentsFolder(), command.id);
  const fs::path solutions = solutionFolder(target.assignment.id);
  batch::BatchOptions how = command.how;
  how.out =
      fs::absolute(command.out.empty() ? fs::path("out/batch") / command.id : fs::path(command.out))
          .lexically_normal();
  if (!how.out.has_filename()) how.out = how.out.parent_path();
  how.reveal = *report::parseReveal(command.reveal);
  const std::vector<std::string> escapes = chooseSandbox(command.sandbox);
  if (!escapes.empty())
    how.selfTest = fmt::format("{} escapes were tried, all refused: {}", escapes.size(),
                               fmt::join(escapes, ", "));
  if (!fs::exists(how.uploads))
    throw UsageError(fmt::format("{}: there is no such folder or archive", how.uploads.string()));
  batch::BookOptions given = command.books;
  if (given.canvasColumn.empty()) given.canvasColumn = target.title();
  const batch::Books books(given, how.out);

  ClassProgress progress(command.id);
  const batch::Outcome outcome =
      batch::gradeClass(target, solutions, how, std::ref(progress.preparing()),
                        [&](const batch::Step& step) { progress(step); });
  progress.clear();
  batch::PageNotes notes;
  notes.title = target.title();
  notes.selfTest = how.selfTest;
  notes.refused = outcome.refused;
  notes.changes = outcome.changes;
  notes.remarks = outcome.remarks;
  if (how.shard.of > 1)
    notes.remarks.push_back(fmt::format("this is share {} of {}: ggrade merge joins them",
                                        how.shard.index, how.shard.of));
  const auto rows = books.write(how.out, notes);
  printEnd(rows, notes, outcome, how.out, command.json);
}

void runMerge(const std::vector<std::string>& from, const std::string& outText,
              const batch::BookOptions& options, bool asJson) {
  const fs::path out = fs::absolute(outText).lexically_normal();
  const std::vector<fs::path> folders(from.begin(), from.end());
  const batch::Books books(options, out);
  const batch::Merged merged = batch::mergeClasses(folders, out);
  batch::PageNotes notes;
  notes.title = findTarget(assignmentsFolder(), merged.target).title();
  notes.selfTest = merged.selfTest;
  notes.refused = merged.refused;
  notes.remarks = merged.remarks;
  notes.remarks.insert(notes.remarks.end(), merged.conflicts.begin(), merged.conflicts.end());
  const auto rows = books.write(out, notes);
  batch::Outcome outcome;
  outcome.kept = merged.copied;
  printEnd(rows, notes, outcome, out, asJson);
  if (!merged.conflicts.empty()) exitCode = kNotGradable;
}

} // namespace

void addBatch(CLI::App& app) {
  auto* command = app.add_subcommand("batch", "Grades a class");
  auto options = std::make_shared<BatchCommand>();
  declare(*command, *options);
  command->callback([command, options] {
    finish(*command, *options);
    runBatch(*options);
  });
}

void addMerge(CLI::App& app) {
  auto* command = app.add_subcommand("merge", "Joins the shares of a class that --shard has made");
  struct Options {
    std::vector<std::string> from;
    std::string out;
    batch::BookOptions books;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("DIR", options->from, "Folders that batch has written")->required();
  command->add_option("--out", options->out, "A new folder for the whole class")->required();
  declareBooks(*command, options->books);
  command->add_flag("--json", options->json, "Print JSON on stdout");
  command->footer("Exit codes: 0 joined, 1 with conflicts (named) or students without a score (not "
                  "gradable,\nor several uploads that look like one student's), 2 usage.\n\n"
                  "Example:\n"
                  "  ggrade batch mirror uploads --shard 1/2 --out share1    (on one machine)\n"
                  "  ggrade batch mirror uploads --shard 2/2 --out share2    (on another)\n"
                  "  ggrade merge share1 share2 --out class --gradebook moodle=grades.csv");
  command->callback(
      [options] { runMerge(options->from, options->out, options->books, options->json); });
}

void addWorker(CLI::App& app) {
  // Not listed: `batch` starts this, as many times as there are jobs at a time.
  auto* command = app.add_subcommand("worker", "Grades uploads that stdin names")->group("");
  struct Options {
    std::string id, reveal = "names", sandbox = "bwrap", quality = "balanced", out;
    batch::WorkerOptions how;
    std::uint64_t seed = 0;
    bool noDiagnosis = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("ID", options->id)->required();
  command->add_option("--out", options->out)->required();
  command->add_option("--run", options->how.run);
  auto* seed = command->add_option("--seed", options->seed)->check(notAWholeNumber);
  command->add_option("--quality", options->quality);
  command->add_option("--reveal", options->reveal);
  command->add_option("--sandbox", options->sandbox);
  command->add_flag("--no-diagnosis", options->noDiagnosis);
  declareRepair(*command);
  command->callback([options, seed] {
    const Target target = findTarget(assignmentsFolder(), options->id);
    batch::WorkerOptions how = options->how;
    how.out = options->out;
    how.reveal = *report::parseReveal(options->reveal);
    how.diagnosis = !options->noDiagnosis;
    how.draw.quality = grading::parseQuality(options->quality);
    if (seed->count() > 0) how.draw.seed = options->seed;
    // Tried by the parent.
    if (options->sandbox == "none") grading::isolation() = sandbox::Isolation::none;
    batch::work(target, solutionFolder(target.assignment.id), how);
  });
}

} // namespace ggrade::cli
