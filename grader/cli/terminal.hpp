#pragma once
/// \file
/// What the tool says while it works.

#include <mutex>
#include <string>

namespace ggrade::cli {

/// Shows how far long work is: one line that is rewritten on a terminal, a line for each new kind
/// of work in a log. Everything goes to stderr, so that stdout stays for results. May be called
/// from several threads.
class Progress {
public:
  explicit Progress(std::string title);
  ~Progress();
  void operator()(const std::string& what, std::size_t done, std::size_t total);
  /// Takes the line away, before something else is printed.
  void clear();

private:
  std::mutex mutex_;
  std::string title_, last_;
  bool terminal_, shown_ = false;
};

/// Writes to stderr. Whether it gets there is no matter of anybody's grade: a log on a full disk
/// stops nothing.
void tell(const std::string& text);

/// Is stdout a terminal that wants colour (NO_COLOR unset)?
bool wantsColour();

} // namespace ggrade::cli
