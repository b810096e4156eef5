#include "reload.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <sstream>
#include <string_view>

#include "words/words.hpp"
#include <gg/error.hpp>

namespace gg::detail {

namespace {

struct WatchedProgram {
  std::weak_ptr<ProgramState> state;
  std::string error; // of the files as they stand
};
std::vector<WatchedProgram> watchedPrograms;

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

// Letters in the window are ASCII: it names only the place of what is said in others.
std::string forWindow(const std::string& error) {
  constexpr std::string_view kError = ": error: ";
  std::istringstream lines(error);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(kError);
    if (at != line.npos && std::ranges::any_of(line, [](char c) { return (c & 0x80) != 0; }))
      line = line.substr(0, at) + std::string(kError) + "see the terminal";
    all += (all.empty() ? "" : "\n") + line;
  }
  return all;
}

bool isTime() {
  using Clock = std::chrono::steady_clock;
  static Clock::time_point last;
  if (Clock::now() - last < std::chrono::milliseconds(200)) return false;
  last = Clock::now();
  return true;
}

} // namespace

void lookAfter(const std::shared_ptr<ProgramState>& state) {
  watchedPrograms.push_back({state, {}});
}

std::string labelOf(GLuint program) {
  for (const WatchedProgram& one : watchedPrograms)
    if (const auto state = one.state.lock(); state && static_cast<GLuint>(state->name) == program)
      return state->label();
  return say("program {}", program);
}

Reloaded reloadPrograms() {
  Reloaded reloaded;
  const bool look = isTime();
  std::erase_if(watchedPrograms, [](const WatchedProgram& one) { return one.state.expired(); });
  for (WatchedProgram& one : watchedPrograms) {
    const std::shared_ptr<ProgramState> state = one.state.lock();
    if (look && isChanged(*state)) {
      try {
        rebuild(*state);
        one.error.clear();
        reloaded.any = true;
        std::fprintf(stderr, "%s\n", say("{}: reloaded", state->label()).c_str());
      } catch (const ShaderError& error) {
        one.error = forWindow(error.what());
        std::fprintf(stderr, "%s\n", error.what());
      }
    }
    if (!one.error.empty()) reloaded.errors += (reloaded.errors.empty() ? "" : "\n") + one.error;
  }
  return reloaded;
}

} // namespace gg::detail
