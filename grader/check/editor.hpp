#pragma once
/// \file
/// Opens a student's editor at a place.

#include "check/places.hpp"

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace ggrade::check {

/// What the shell is to run, with "{file}" and "{line}" in it: `given`, else by $VISUAL, else by
/// $EDITOR. Throws UsageError if there is none, or where it doesn't say {file}.
std::string editorCommand(const std::string& given);

/// Does it run in the terminal, where nobody else can write at the same time?
bool needsTerminal(const std::string& command);

/// With the place in it, quoted for the shell.
std::string withPlace(const std::string& command, const Place& place);

/// Editors with windows of their own, beside this process and without its terminal.
class Beside {
public:
  void open(const std::string& command);
  /// The exit code of one that has ended badly since this was asked last.
  std::optional<int> failed();

private:
  std::vector<pid_t> running_;
};

/// Runs an editor here and waits until it is closed.
void openHere(const std::string& command);

} // namespace ggrade::check
