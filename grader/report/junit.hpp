#pragma once
/// \file
/// JUnit XML for continuous integration.

#include "report/results.hpp"

#include <string>

namespace ggrade::report {

/// One testsuite a part, one testcase an item (classname `assignment.part`). Lost points are a
/// failure with the message; an item that was never judged is an error that says why; a bonus not
/// earned is skipped. Outcome, seed, score and sandbox stand in the properties. The instructor's
/// file: it holds everything. Well-formed XML 1.0 whatever the texts hold.
std::string junit(const Result& result);

} // namespace ggrade::report
