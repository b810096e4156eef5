#pragma once
/// \file
/// From a judged submission to the words of its diagnosis.

#include "grading/diagnoser.hpp"
#include "grading/submitted.hpp"

namespace ggrade::grading {

/// The items of a part that lost points, without the bonus.
std::vector<std::string> lostItems(const report::Result& result, const Part& part);

/// What lies in a submission's folders of frames and passes, by scene.
Shown shown(const std::vector<std::filesystem::path>& folders);

/// At most one diagnosis a part that lost points, and none where nothing was lost; one for all
/// where the outcome says it. What known mistakes show is rendered and kept the first time it is
/// needed. `result` has its outcome, its items and the compiler's output. Throws UsageError for a
/// fault in the catalogue, and Interrupted.
std::vector<report::Diagnosis> diagnose(const Target& target,
                                        const std::filesystem::path& solutionFolder,
                                        const Submitted& submitted, const report::Result& result,
                                        const Progress& progress);

} // namespace ggrade::grading
