#include "check/keys.hpp"

#include <poll.h>
#include <unistd.h>

namespace ggrade::check {

Keys::Keys() {
  // Whoever changes a terminal from the background is stopped.
  if (tcgetpgrp(STDIN_FILENO) != getpgrp() || tcgetattr(STDIN_FILENO, &before_) != 0) return;
  termios keys = before_;
  keys.c_lflag &= ~tcflag_t(ICANON | ECHO);
  keys.c_cc[VMIN] = 1;
  keys.c_cc[VTIME] = 0;
  open_ = tcsetattr(STDIN_FILENO, TCSANOW, &keys) == 0;
}

Keys::~Keys() {
  if (open_) tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

char Keys::next(std::chrono::milliseconds wait) {
  pollfd in{STDIN_FILENO, POLLIN, 0};
  // Without descriptors it only waits.
  if (poll(&in, open_ ? 1 : 0, int(wait.count())) <= 0) return 0;
  char key = 0;
  if (read(STDIN_FILENO, &key, 1) == 1) return key;
  open_ = false; // the terminal has gone
  return 0;
}

} // namespace ggrade::check
