#pragma once
/// \file
/// What `ggrade check` holds a program against, made from the solution.

#include "grading/references.hpp"

#include <set>

namespace ggrade::authoring {

/// Writes to `into`, a folder of this part's own, what check::Expected needs: the part's TODOs out
/// of `blank` are to be done, all others are done already (of check::togetherOf all of `blank`).
/// The public scenes come first, then those of the handout's steps that have a scene of their own,
/// and the `others` of handout.json. Also the reference's passes there as pictures and as raw
/// floats (see report::writePassFiles). Throws UsageError where a program fails.
void writeExpected(const Assignment& assignment, const Part& part,
                   const std::filesystem::path& solutions, const std::set<std::string>& blank,
                   const std::filesystem::path& into, const grading::Progress& progress);

/// Makes `into`/PART anew for each part of the target, and for several together, all TODOs to be
/// done, unless what is there was made by this tool from these files.
void updateExpected(const Target& target, const std::filesystem::path& solutions,
                    const std::filesystem::path& into, const grading::Progress& progress);

} // namespace ggrade::authoring
