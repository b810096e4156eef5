#include "batch/batch.hpp"

#include "batch/record.hpp"
#include "grading/grade.hpp"
#include "grading/scenes.hpp"
#include "grading/workspace.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <system_error>

namespace ggrade::batch {

namespace fs = std::filesystem;

namespace {

/// The uploads that `only` names, all if it names none. Throws UsageError for who isn't there.
void keepOnly(std::vector<intake::Upload>& uploads, const std::vector<std::string>& only) {
  std::vector<std::string> unknown;
  std::set<std::string> folders;
  for (const std::string& name : only) {
    bool found = false;
    for (const intake::Upload& upload : uploads)
      if (upload.student == name || upload.name == name || upload.folder == name) {
        folders.insert(upload.folder);
        found = true;
      }
    if (!found) unknown.push_back(name);
  }
  if (!unknown.empty())
    throw UsageError(fmt::format("--only: no upload is {}'s", fmt::join(unknown, "'s, none ")));
  if (!only.empty())
    std::erase_if(uploads, [&](const auto& upload) { return !folders.count(upload.folder); });
}

void keepShard(std::vector<intake::Upload>& uploads, const Shard& shard) {
  std::vector<intake::Upload> kept;
  for (std::size_t i = shard.index - 1; i < uploads.size(); i += shard.of)
    kept.push_back(std::move(uploads[i]));
  uploads = std::move(kept);
}

/// The folder's memory, ready for this run. Throws UsageError where it isn't ours, or holds a run
/// and nobody said what to do with it.
State open(const Target& target, const BatchOptions& options) {
  std::optional<State> found = loadState(options.out);
  sweep(options.out, found);
  if (!found) {
    for (const fs::directory_entry& entry : fs::directory_iterator(options.out))
      if (const std::string name = entry.path().filename().string();
          name != ".ggrade-lock" && name != "overrides.csv")
        grading::refuseForeign(options.out, name);
    State fresh;
    fresh.target = target.id;
    fresh.draw = options.draw;
    return fresh;
  }
  State state = *found;
  if (state.target != target.id)
    throw UsageError(fmt::format("{} holds results of {}: name another folder with --out",
                                 options.out.string(), state.target));
  if (!options.resume && !options.regrade)
    throw UsageError(fmt::format("{} holds an earlier run: --resume grades what is missing or has "
                                 "changed, --regrade all of it again",
                                 options.out.string()));
  if (state.draw != options.draw && !options.regrade)
    throw UsageError(fmt::format("{} was graded with {} and --quality {}: give the same, or "
                                 "--regrade",
                                 options.out.string(),
                                 state.draw.seed ? fmt::format("--seed {}", *state.draw.seed)
                                                 : std::string("the assignment's own seed"),
                                 nameOf(state.draw.quality)));
  state.draw = options.draw;
  // A run that was cut short goes on, and is compared with what stood before it.
  if (!state.isFinished) return state;
  state.isFinished = false;
  if (options.regrade && options.only.empty()) ++state.run;
  state.before.clear();
  for (const Record& record : loadRecords(options.out))
    state.before[record.row.folder] = record.row.score + record.row.bonus;
  return state;
}

std::vector<report::ScoreChange> changesSince(const State& state, const fs::path& out) {
  std::vector<report::ScoreChange> changes;
  for (const Record& record : loadRecords(out))
    if (const auto before = state.before.find(record.row.folder); before != state.before.end())
      if (const double now = record.row.score + record.row.bonus; now != before->second)
        changes.push_back({record.row.name, record.row.folder, before->second, now});
  std::ranges::stable_sort(
      changes, {}, [](const report::ScoreChange& change) { return change.after - change.before; });
  return changes;
}

} // namespace

Outcome gradeClass(const Target& target, const fs::path& solutionFolder,
                   const BatchOptions& options, const grading::Progress& preparing,
                   const std::function<void(const Step&)>& step) {
  makeClassFolder(options.out);
  const Lock lock(options.out);
  State state = open(target, options);
  grading::TemporaryFolder work;
  state.work = work.path();
  state.selfTest = options.selfTest;
  saveState(options.out, state);

  Outcome outcome;
  intake::Intake intake = intake::findUploads(options.uploads, target.assignment.files, work.path(),
                                              grading::isolation(), &grading::interrupted);
  outcome.remarks = std::move(intake.remarks);
  outcome.refused = state.refused = std::move(intake.refused);
  keepOnly(intake.uploads, options.only);
  keepShard(intake.uploads, options.shard);

  const grading::ScenePlan plan = grading::drawScenes(target, solutionFolder, options.draw);
  const grading::References references =
      grading::prepareReferences(target, solutionFolder, plan, preparing);
  if (grading::repairs()) { // now, and not by every worker at the same time
    preparing("whose work is what", 0, 1);
    try {
      grading::Owners(target, solutionFolder);
    } catch (const grading::NoTape&) {
      // Then nothing can be repaired, and every result says so.
    }
  }
  const std::string grader = graderOf(target, solutionFolder, plan);
  std::vector<Job> jobs;
  std::size_t otherGrader = 0;
  for (intake::Upload& upload : intake.uploads) {
    Job job{std::move(upload), {}};
    try {
      job.key = keyOf(job.upload);
    } catch (const std::system_error&) {
      // Its own row says why, if it can't be read then, either; the others are graded.
    }
    const auto record = loadRecord(options.out / job.upload.folder);
    const bool holds = record && record->upload == job.key && record->grader == grader &&
                       record->row.outcome != results::Outcome::notGradable &&
                       record->run == state.run;
    otherGrader += record && record->upload == job.key && record->grader != grader;
    if (holds && !(options.regrade && !options.only.empty()))
      ++outcome.kept;
    else
      jobs.push_back(std::move(job));
  }

  if (otherGrader > 0)
    outcome.remarks.push_back(fmt::format("{} of the results here are from before the tool, the "
                                          "points, the solution or the language changed: graded "
                                          "again",
                                          otherGrader));

  PoolOptions pool;
  pool.processes = options.jobs;
  pool.temporary = work.path();
  pool.worker = {"ggrade",
                 "worker",
                 target.id,
                 "--out",
                 fs::absolute(options.out).string(),
                 "--run",
                 std::to_string(state.run),
                 "--reveal",
                 std::string(report::name(options.reveal))};
  pool.worker.insert(pool.worker.end(), {"--quality", nameOf(options.draw.quality)});
  if (options.draw.seed)
    pool.worker.insert(pool.worker.end(), {"--seed", std::to_string(*options.draw.seed)});
  if (!options.diagnosis) pool.worker.push_back("--no-diagnosis");
  if (!grading::repairs()) pool.worker.push_back("--no-repair");
  if (grading::isolation() == sandbox::Isolation::none)
    pool.worker.insert(pool.worker.end(), {"--sandbox", "none"});
  // Who reads the class page must find everybody. What can't even be written now is done by
  // --resume.
  const auto ungraded = [&](const Job& job, const std::string& problem) {
    const results::Result result =
        grading::ungraded(target, plan, results::Outcome::notGradable, problem);
    try {
      publish(result, job, {options.out, options.reveal, grader, state.run});
      return problem;
    } catch (const std::exception& error) {
      return problem + "; " + error.what();
    }
  };
  runJobs(jobs, pool, [&](std::size_t job, const Reply& reply) {
    const std::string& name = jobs[job].upload.name;
    if (reply.problem.empty())
      ++outcome.graded;
    else
      outcome.unfinished.push_back(name + ": " + ungraded(jobs[job], reply.problem));
    if (step) step({outcome.graded + outcome.unfinished.size(), jobs.size(), name, reply});
  });

  outcome.changes = changesSince(state, options.out);
  state.isFinished = outcome.unfinished.empty();
  state.work.clear();
  sweep(options.out, state); // of workers that died
  saveState(options.out, state);
  return outcome;
}

} // namespace ggrade::batch
