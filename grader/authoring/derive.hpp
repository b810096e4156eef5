#pragma once
/// \file
/// What an assignment hands out, made from its solution.

#include "assignment/assignment.hpp"
#include "grading/references.hpp"
#include "words/words.hpp"

#include <filesystem>
#include <set>

namespace ggrade::authoring {

/// The first TODOs of a part.
std::set<std::string> firstTodos(const Part& part, std::size_t count);

/// The editable files with the given TODOs filled in and their comments in a language, into a
/// folder that is there. See comments.hpp.
void writeSources(const Assignment& assignment, const std::filesystem::path& solutions,
                  const std::set<std::string>& filled, gg::Language comments,
                  const std::filesystem::path& into);

/// Writes the stub with comments in a language, the handout's texts in all of them and, with
/// `pictures`, the picture of every step (in `into/handout`; the programs are built and run for
/// them) into `into`. Throws UsageError for a solution with a fault.
void deriveInto(const Assignment& assignment, const std::filesystem::path& solutions,
                gg::Language comments, const std::filesystem::path& into,
                const grading::Progress& pictures);

} // namespace ggrade::authoring
