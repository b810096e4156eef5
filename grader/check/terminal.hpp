#pragma once
/// \file
/// What a check found, for a terminal and for programs.

#include "check/looked.hpp"

namespace ggrade::check {

/// A table a part, what is wrong first, and as much of the cause as is told. What has a place in a
/// file is a line as compilers write them. `colour`: with escape sequences. `ask`: how to be told
/// more.
std::string table(const std::vector<Looked>& all, bool colour, const std::string& ask);

/// For `--format json`: all that is known, whatever was told.
nlohmann::json toJson(const std::vector<Looked>& all);

} // namespace ggrade::check
