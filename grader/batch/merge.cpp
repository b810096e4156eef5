#include "batch/merge.hpp"

#include "assignment/assignment.hpp"
#include "batch/record.hpp"
#include "batch/state.hpp"
#include "grading/workspace.hpp"
#include "report/text.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

namespace ggrade::batch {

namespace fs = std::filesystem;

namespace {

bool sameResult(const Record& a, const Record& b) {
  const auto earned = [](const Record& record) {
    std::map<std::string, double> all;
    for (const report::ClassItem& item : record.row.items) all[item.id] = item.earned;
    return all;
  };
  return a.upload == b.upload && a.row.outcome == b.row.outcome && a.row.score == b.row.score &&
         a.row.bonus == b.row.bonus && earned(a) == earned(b);
}

void requireAlike(const Record& one, const fs::path& folder, const Record& first,
                  const fs::path& firstFolder) {
  const auto refuse = [&](const std::string& what) {
    throw UsageError(
        fmt::format("{} and {} can't be joined: {}", firstFolder.string(), folder.string(), what));
  };
  if (one.target != first.target)
    refuse(fmt::format("they are about {} and {}", first.target, one.target));
  if (one.seed != first.seed)
    refuse(fmt::format("they were graded with seeds {} and {}", first.seed, one.seed));
  if (one.grader != first.grader)
    refuse(fmt::format("{} in one and {} in the other were graded by other builds of the tool "
                       "or another Mesa, with another --quality or with other points; --resume "
                       "with one build on both",
                       first.row.name, one.row.name));
}

} // namespace

Merged mergeClasses(const std::vector<fs::path>& from, const fs::path& out) {
  makeClassFolder(out);
  if (!fs::is_empty(out))
    throw UsageError(fmt::format("{} is not empty: name a new folder with --out", out.string()));
  const Lock lock(out);
  Merged merged;
  State joined;
  std::map<std::string, std::pair<Record, fs::path>> taken;
  std::set<std::string> refused; // each share has looked at the whole class
  std::set<std::string> machines;
  std::map<std::string, fs::path> damaged; // names of results that can't be read, and where
  for (const fs::path& folder : from) {
    const auto state = loadState(folder);
    if (!state) throw UsageError(fmt::format("{} holds no graded class", folder.string()));
    joined.target = merged.target = state->target;
    if (folder == from.front()) joined.draw = state->draw;
    refused.insert(state->refused.begin(), state->refused.end());
    // Each share was tried on a machine of its own; where one was not, none is told.
    if (folder == from.front() || state->selfTest.empty()) joined.selfTest = state->selfTest;
    if (!state->isFinished)
      merged.remarks.push_back(
          fmt::format("{} is not finished: go on with it by --resume", folder.string()));
    std::vector<std::string> unread;
    for (Record& record : loadRecords(folder, &unread)) {
      const std::string name = record.row.folder;
      if (!record.machine.empty()) machines.insert(record.machine);
      if (!taken.empty())
        requireAlike(record, folder, taken.begin()->second.first, taken.begin()->second.second);
      if (const auto earlier = taken.find(name); earlier != taken.end()) {
        const auto& [other, where] = earlier->second;
        if (!sameResult(record, other))
          merged.conflicts.push_back(
              fmt::format("{}: {} in {}, {} in {}; the first was kept", record.row.name,
                          other.row.score + other.row.bonus, where.string(),
                          record.row.score + record.row.bonus, folder.string()));
        continue;
      }
      if (grading::interrupted) throw grading::Interrupted{};
      grading::TemporaryFolder copy(out);
      fs::copy(folder / name, copy.path(),
               fs::copy_options::recursive | fs::copy_options::overwrite_existing);
      copy.publish(out / name);
      ++merged.copied;
      record.row.thumbnail.clear();
      taken.emplace(name, std::pair{std::move(record), folder});
    }
    for (const std::string& name : unread) damaged.emplace(name, folder);
  }
  for (const auto& [name, folder] : damaged)
    if (!taken.contains(name))
      merged.conflicts.push_back(fmt::format(
          "{} is missing here: its record in {} can't be read; grade it again there with "
          "--resume, then merge anew",
          report::sanitizeLine(name, 80), (folder / name).string()));
  joined.isFinished = merged.remarks.empty();
  if (machines.size() > 1) {
    std::string all;
    for (const std::string& machine : machines) all += (all.empty() ? "" : "; ") + machine;
    merged.remarks.push_back(
        fmt::format("drawn on unlike machines: {}. Single pixels may differ by a few levels "
                    "between them, which no score should show",
                    all));
  }
  joined.refused = merged.refused = {refused.begin(), refused.end()};
  merged.selfTest = joined.selfTest;
  saveState(out, joined);
  return merged;
}

} // namespace ggrade::batch
