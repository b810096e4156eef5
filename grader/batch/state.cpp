#include "batch/state.hpp"

#include "assignment/assignment.hpp"
#include "grading/workspace.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>

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

void removeOurs(const fs::path& folder) {
  struct stat status {};
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) return;
  if (status.st_uid != geteuid() ||
      !folder.filename().string().starts_with(grading::kTemporaryMark))
    return;
  std::error_code none;
  fs::remove_all(folder, none);
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

Lock::Lock(const fs::path& out) {
  const fs::path path = out / kLock;
  file_ = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  if (file_ < 0)
    throw UsageError(fmt::format("can't write to {}: {}", out.string(), std::strerror(errno)));
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  close(file_);
  throw UsageError(fmt::format("another ggrade is at work in {}: wait for it, or name another "
                               "folder with --out",
                               out.string()));
}

Lock::~Lock() {
  close(file_);
}

void sweep(const fs::path& out, const State& state) {
  if (!state.work.empty()) removeOurs(state.work);
  for (const fs::directory_entry& entry : fs::directory_iterator(out)) removeOurs(entry.path());
}

} // namespace ggrade::batch
