#include "cli/batch_options.hpp"

#include "cli/commands.hpp"
#include "report/text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include <unistd.h>

namespace ggrade::cli {

namespace {

constexpr int kBarColumns = 24;

batch::Shard readShard(const std::string& text) {
  batch::Shard shard;
  const char* const end = text.data() + text.size();
  const auto [slash, error] = std::from_chars(text.data(), end, shard.index);
  bool ok = error == std::errc() && slash != end && *slash == '/';
  if (ok) {
    const auto [last, other] = std::from_chars(slash + 1, end, shard.of);
    ok = other == std::errc() && last == end && shard.index >= 1 && shard.index <= shard.of;
  }
  if (!ok)
    throw UsageError(fmt::format("--shard {}: write i/n with i from 1 to n, such as 1/4", text));
  return shard;
}

std::string minutes(double seconds) {
  const long whole = std::lround(seconds);
  return whole >= 3600 ? fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60)
                       : fmt::format("{}:{:02}", whole / 60, whole % 60);
}

} // namespace

void declareBooks(CLI::App& app, batch::BookOptions& books) {
  app.add_option("--gradebook", books.gradebooks,
                 "moodle=FILE or canvas=FILE: an exported gradebook; a copy with the grades filled "
                 "in goes to OUT/moodle.csv or OUT/canvas.csv");
  app.add_option("--columns", books.columns,
                 "Headers of a Moodle worksheet that are not found: "
                 "identifier=...,grade=...,feedback=...,max=...");
  app.add_option("--canvas-column", books.canvasColumn,
                 "The assignment's name in Canvas (default: its title here)");
  app.add_option("--overrides", books.overrides,
                 "A table student,item,points,reason,who of points that you decided (default: "
                 "OUT/overrides.csv if it is there)");
  app.add_option("--submitted", books.submitted, "A table student,submitted of times");
  app.add_option("--due", books.due, "The deadline, such as 2026-11-20T23:59+09:00");
  app.add_option("--late", books.late,
                 "What lateness costs, such as \"10% per day, at most 50%, 15 min grace\"");
}

void declare(CLI::App& app, BatchCommand& command) {
  app.add_option("ID", command.id, "Assignment or part (see ggrade list)")->required();
  app.add_option("DIR", command.how.uploads,
                 "A folder of uploads (folders, zip and tar archives, single files; Moodle's and "
                 "Canvas' downloads), or the archive of all")
      ->required();
  app.add_option("--out", command.out, "Where the results go (default out/batch/ID)");
  app.add_option("--jobs", command.how.jobs, "Submissions at a time (default: the cores)")
      ->check(CLI::Range(1, 256));
  app.add_flag("--resume", command.how.resume,
               "Go on with what is in OUT: grade what is missing, not gradable or has changed");
  app.add_flag("--regrade", command.how.regrade, "Grade all of it again, and list what changes");
  app.add_option("--only", command.how.only, "Only these students (name, ID or result folder)");
  app.add_option("--shard", command.shard, "i/n: every n-th upload, for n machines; see merge");
  app.add_option("--seed", command.seed,
                 "Draws other hidden scenes (default: the assignment's); one for the whole class")
      ->check(notAWholeNumber);
  declareQuality(app, command.quality, "How closely to look");
  app.add_option("--reveal", command.reveal, "What the students' pages say of hidden scenes")
      ->check(CLI::IsMember({"none", "names", "details"}))
      ->capture_default_str();
  app.add_option("--sandbox", command.sandbox,
                 "none: run strangers' programs as yourself. Only for uploads that you trust")
      ->check(CLI::IsMember({"bwrap", "none"}))
      ->capture_default_str();
  declareContext(app);
  app.add_flag("--no-diagnosis", command.noDiagnosis,
               "Don't look for the likeliest cause of lost points");
  declareRepair(app);
  declareBooks(app, command.books);
  app.add_flag("--json", command.json, "Print JSON on stdout");
  app.footer(
      "OUT has gradebook.csv, index.html (the class), and a folder with the pages and files "
      "of `grade` for each\n"
      "student. Stopped by Ctrl-C, kill or a full disk, it goes on with --resume.\n"
      "Exit codes: 0 all graded (whatever the scores), 1 somebody has no score (not gradable, "
      "or several\nuploads that look like one student's), 2 usage, 3 no sandbox.\n\n"
      "Examples:\n"
      "  ggrade batch mirror uploads --out class\n"
      "  ggrade batch mirror uploads --out class --resume\n"
      "  ggrade batch mirror moodle.zip --out class --gradebook moodle=worksheet.csv\n"
      "  ggrade batch mirror uploads --out class --regrade --only ada");
}

void finish(const CLI::App& app, BatchCommand& command) {
  command.how.draw.quality = grading::parseQuality(command.quality);
  if (app.count("--seed") > 0) command.how.draw.seed = command.seed;
  if (app.count("--jobs") == 0) command.how.jobs = grading::workers();
  if (!command.shard.empty()) command.how.shard = readShard(command.shard);
  command.how.diagnosis = !command.noDiagnosis;
}

ClassProgress::ClassProgress(const std::string& title)
    : preparing_("grading " + title), terminal_(isatty(2)) {}

void ClassProgress::operator()(const batch::Step& step) {
  const std::string name = report::sanitizeLine(step.name, 40);
  const batch::Reply& reply = step.reply;
  std::string how = reply.problem.empty() ? report::spaced(reply.outcome)
                                          : "NOT GRADED: " + report::sanitizeLine(reply.problem);
  if (reply.problem.empty() && reply.outcome != "not_gradable")
    how += fmt::format(", {} of {}", report::number(reply.score, 1),
                       report::number(reply.maxScore, 1));
  if (!terminal_) {
    tell(fmt::format("{}/{} {}: {} ({:.1f} s)\n", step.done, step.total, name, how, reply.seconds));
    return;
  }
  preparing_.clear();
  if (!started_) {
    start_ = Clock::now() - std::chrono::milliseconds(std::lround(reply.seconds * 1000));
    started_ = true;
  }
  const double passed = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left = passed / double(step.done) * double(step.total - step.done);
  const auto full = int(double(kBarColumns) * double(step.done) / double(step.total));
  tell(fmt::format("\r\033[K[{:#<{}}{:.<{}}] {}/{}, {} left; {}: {}", "", full, "",
                   kBarColumns - full, step.done, step.total, minutes(left), name, how));
  shown_ = true;
}

void ClassProgress::clear() {
  preparing_.clear();
  if (shown_) tell("\r\033[K");
  shown_ = false;
}

} // namespace ggrade::cli
