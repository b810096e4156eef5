#include "reload.hpp"

#include <chrono>
#include <cstdio>
#include <map>

#include <gg/error.hpp>

namespace gg::detail {

namespace {

struct Live {
  std::weak_ptr<ProgramState> state;
  std::string error; // of the files as they stand
};
std::vector<Live> live;

// Was one of the program's files saved? Takes note of when.
bool isChanged(ProgramState& state) {
  bool changed = false;
  for (WatchedFile& file : state.watched) {
    std::error_code error;
    const auto saved = std::filesystem::last_write_time(file.path, error);
    if (error || saved == file.saved) continue; // an editor may be about to put it back
    file.saved = saved;
    changed = true;
  }
  return changed;
}

bool isTime() {
  using Clock = std::chrono::steady_clock;
  static Clock::time_point last;
  if (Clock::now() - last < std::chrono::milliseconds(200)) return false;
  last = Clock::now();
  return true;
}

} // namespace

void watch(const std::shared_ptr<ProgramState>& state) {
  live.push_back({state, {}});
}

Reloaded reloadPrograms() {
  Reloaded reloaded;
  const bool look = isTime();
  std::erase_if(live, [](const Live& one) { return one.state.expired(); });
  for (Live& one : live) {
    const std::shared_ptr<ProgramState> state = one.state.lock();
    if (look && isChanged(*state)) {
      try {
        rebuild(*state);
        one.error.clear();
        reloaded.any = true;
        std::fprintf(stderr, "%s: reloaded\n", state->label().c_str());
      } catch (const ShaderError& error) {
        one.error = error.what();
        std::fprintf(stderr, "%s\n", error.what());
      }
    }
    if (!one.error.empty()) reloaded.errors += (reloaded.errors.empty() ? "" : "\n") + one.error;
  }
  return reloaded;
}

} // namespace gg::detail
