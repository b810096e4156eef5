#include "batch/state.hpp"

#include "assignment/assignment.hpp"
#include "grading/workspace.hpp"
#include "image/temporary_file.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ggrade::batch {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr char kState[] = ".ggrade-batch.json";
constexpr char kLock[] = ".ggrade-lock";

[[noreturn]] void refuse(const fs::path& out, const std::error_code& why) {
  throw UsageError(fmt::format("can't write to {}: {}. Name another folder with --out, or give "
                               "yourself write permission",
                               out.string(), why.message()));
}

void removeOurs(const fs::path& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0 || status.st_uid != geteuid()) return;
  const bool isOurs = S_ISDIR(status.st_mode)
                          ? path.filename().string().starts_with(grading::kTemporaryMark)
                          : S_ISREG(status.st_mode) && TemporaryFile::isOne(path);
  std::error_code none;
  if (isOurs) fs::remove_all(path, none);
}

/// Removes what a killed run left half-written in a folder. Listed first: it changes meanwhile.
void sweepFolder(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    paths.push_back(entry.path());
  for (const fs::path& path : paths) removeOurs(path);
}

} // namespace

std::optional<State> loadState(const fs::path& out) {
  const fs::path file = out / kState;
  if (!fs::exists(file)) return std::nullopt;
  try {
    const json kept = json::parse(readFile(file));
    State state;
    kept.at("target").get_to(state.target);
    if (!kept.at("seed").is_null()) state.draw.seed = kept.at("seed").get<std::uint64_t>();
    state.draw.quality = grading::parseQuality(kept.at("quality").get<std::string>());
    state.work = kept.at("work").get<std::string>();
    kept.at("run").get_to(state.run);
    kept.at("finished").get_to(state.isFinished);
    state.selfTest = kept.value("self_test", std::string());
    state.refused = kept.value("refused", std::vector<std::string>());
    kept.at("before").get_to(state.before);
    return state;
  } catch (const json::exception&) {
    throw UsageError(fmt::format("{} is damaged: move {} away and grade the class again",
                                 file.string(), out.string()));
  }
}

void saveState(const fs::path& out, const State& state) {
  const json kept = {{"target", state.target},
                     {"seed", state.draw.seed ? json(*state.draw.seed) : json(nullptr)},
                     {"quality", nameOf(state.draw.quality)},
                     {"work", state.work.string()},
                     {"run", state.run},
                     {"finished", state.isFinished},
                     {"self_test", state.selfTest},
                     {"refused", state.refused},
                     {"before", state.before}};
  report::writeFile(out / kState, kept.dump(2) + '\n');
}

void makeClassFolder(const fs::path& out) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error) refuse(out, error);
}

Lock::Lock(const fs::path& out) {
  const fs::path path = out / kLock;
  file_ = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  if (file_ < 0) refuse(out, std::error_code(errno, std::generic_category()));
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  const int error = errno;
  close(file_);
  if (error != EWOULDBLOCK) refuse(out, std::error_code(error, std::generic_category()));
  throw UsageError(fmt::format("another ggrade is at work in {}: wait for it, or name another "
                               "folder with --out",
                               out.string()));
}

Lock::~Lock() {
  close(file_);
}

void sweep(const fs::path& out, const std::optional<State>& state) {
  if (!state) {
    // Whose folder it is isn't known: only what was to become our state.
    const std::string begun = std::string(".") + fs::path(kState).stem().string() + '.';
    for (const fs::directory_entry& entry : fs::directory_iterator(out))
      if (entry.path().filename().string().starts_with(begun)) removeOurs(entry.path());
    return;
  }
  if (!state->work.empty()) removeOurs(state->work);
  sweepFolder(out);
  for (const fs::directory_entry& entry : fs::directory_iterator(out))
    if (entry.is_directory() && !entry.is_symlink()) // pages are adjusted in place
      sweepFolder(entry.path());
}

} // namespace ggrade::batch
