#pragma once
/// \file
/// What a check found, as a page.

#include "check/looked.hpp"

namespace ggrade::check {

/// A self-contained HTML page; what is told bit by bit is folded. `watched`: it shows itself anew
/// every second.
std::string page(const std::string& title, const std::vector<Looked>& all, bool watched);

} // namespace ggrade::check
