#pragma once
/// \file
/// Errors are not counted twice: what builds on a pass that failed is judged once more with the
/// reference's output of that pass in place of the submission's.

#include "grading/grade.hpp"

namespace ggrade::grading {

/// For each item that failed (less than 90% of its points) and whose passes' outputs are found in
/// the submission and the reference, of equal number, size and format: renders the first frame of
/// the scenes that show the items after it with the outputs replaced, in the sandbox, and lets
/// these items be judged again. If the next pass in the chain still fails, it is replaced as well.
/// Each item keeps the better of all runs, scene by scene, and then says what was replaced for it.
/// What a second run writes to its output goes nowhere; one whose passes are others than in the
/// first run counts for nothing. Returns how many runs there were (of all scenes at once); 0 for a
/// submission whose passes are right. `threads` scenes are rendered at a time. `begins` is called
/// before the first of them, if there is one. `problem` says why the judge could not go on. Throws
/// Interrupted.
int carryForward(const Target& target, Judge& judge, Graded& graded, unsigned threads,
                 const std::function<void()>& begins, std::string& problem);

/// Takes from `again`, the same item judged once more, what is better, scene by scene. Did the item
/// earn more by it? Then its message is that of the scene that is the worst now.
bool takeBetter(results::Item& item, const results::Item& again);

} // namespace ggrade::grading
