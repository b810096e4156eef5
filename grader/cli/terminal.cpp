#include "cli/terminal.hpp"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

namespace ggrade::cli {

Progress::Progress(std::string title) : title_(std::move(title)), terminal_(isatty(2)) {}

Progress::~Progress() {
  clear();
}

void Progress::operator()(const std::string& what, std::size_t done, std::size_t total) {
  const std::lock_guard lock(mutex_);
  if (terminal_) {
    tell(fmt::format("\r\033[K{}: {} [{}/{}]", title_, what, done, total));
    shown_ = true;
  } else if (what != last_ && what != "done") {
    tell(fmt::format("{}: {}\n", title_, what));
  }
  last_ = what;
}

void Progress::clear() {
  if (shown_) tell("\r\033[K");
  shown_ = false;
}

void tell(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

bool wantsColour() {
  const char* no = std::getenv("NO_COLOR");
  return isatty(1) && !(no && *no);
}

} // namespace ggrade::cli
