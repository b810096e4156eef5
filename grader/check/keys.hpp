#pragma once
/// \file
/// Keys of the terminal, one at a time.

#include <chrono>

#include <termios.h>

namespace ggrade::check {

/// While this lives a key comes without Enter and isn't printed; Ctrl-C still interrupts. The
/// terminal is as it was before when this ends. Where stdin is no terminal, or is another job's, no
/// key ever comes.
class Keys {
public:
  Keys();
  ~Keys();
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;

  bool areThere() const { return open_; }
  /// The next key; 0 if none comes in this time, or a signal does.
  char next(std::chrono::milliseconds wait);

private:
  bool open_ = false;
  termios before_{};
};

} // namespace ggrade::check
