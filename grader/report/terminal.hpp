#pragma once
/// \file
/// Plain-text tables for a terminal or a log.

#include "report/summary.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace ggrade::report {

struct TerminalStyle {
  bool colour = false;     ///< ANSI colours; without, no escape sequence is written
  std::size_t width = 100; ///< columns; long texts wrap. At least 60 are used.
};

/// One result: how it ended, the score, and each item with its points, message, cause and step.
/// Everything is the instructor's; give it a studentView() for a student.
std::string terminalTable(const results::Result& result, const TerminalStyle& style = {});

/// Many results, a line each: submission, outcome, score, and what lost most.
std::string terminalTable(std::span<const Summary> results, const TerminalStyle& style = {});

} // namespace ggrade::report
