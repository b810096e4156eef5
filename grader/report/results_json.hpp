#pragma once
/// \file
/// results.json in the keys that Gradescope reads.

#include "report/reveal.hpp"

#include <string>

namespace ggrade::report {

/// The whole of results.json, ending in a line feed.
/// `score` is the sum with the bonus; it is null for `not_gradable`, so that nobody takes our
/// failure for a zero. `output` and `tests` are what students see: they hold what `reveal` allows.
/// `extra_data` is the instructor's (Gradescope shows it to no student) and holds everything that
/// makes a regrade exact. Tests of kind `keep` have `max_score` 0 and a score of 0 or less. Source:
/// Gradescope's autograder specification, "Output format".
std::string resultsJson(const results::Result& result, Reveal reveal);

} // namespace ggrade::report
