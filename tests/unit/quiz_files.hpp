#pragma once
/// \file
/// The quizzes of this repository, for tests.

#include "assignment/assignment.hpp"
#include "authoring/quiz.hpp"

namespace quizzes {

/// A part and its quiz, in the language that was chosen.
struct OfPart {
  ggrade::Assignment assignment;
  ggrade::Part part;
  ggrade::authoring::Quiz quiz;
};

inline std::vector<OfPart> all() {
  const std::filesystem::path root = GGRADE_SOURCE_DIR;
  std::vector<OfPart> found;
  for (const ggrade::Assignment& assignment : ggrade::loadAssignments(root / "assignments"))
    for (const ggrade::Part& part : assignment.parts)
      if (auto quiz = ggrade::authoring::quizOf(root / "solutions" / assignment.id, part.id))
        found.push_back({assignment, part, std::move(*quiz)});
  return found;
}

} // namespace quizzes
