#pragma once
/// \file
/// What a check found, as a page and for a terminal.

#include "check/check.hpp"

namespace ggrade::check {

/// One part that was looked at.
struct Looked {
  const Part* part = nullptr;
  const Expected* expected = nullptr;
  std::string handout; ///< its file, from the kit's root: "assignments/floor/mirror.md"
  Checked checked;
};

/// "done", "wrong", "not begun" and so on, in the chosen language.
std::string nameOf(State state);

/// The file and the heading of the handout's step to read now: that of the wrong TODO, else of the
/// next one to begin; what to do when all is done; empty where nothing was drawn.
std::string stepToRead(const Looked& looked);

/// A self-contained HTML page. `watched`: it shows itself anew every second.
std::string page(const std::string& title, const std::vector<Looked>& all, bool watched);

/// A table a part, what is wrong first, and its likely cause. `colour`: with escape sequences.
std::string table(const std::vector<Looked>& all, bool colour);

/// For `--json`.
nlohmann::json toJson(const std::vector<Looked>& all);

} // namespace ggrade::check
