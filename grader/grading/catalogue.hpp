#pragma once
/// \file
/// The catalogue that the grader is measured on: mistakes and right answers of one part, each kept
/// as a patch of the solution (`solutions/<id>/mistakes/`, `solutions/<id>/variants/`).

#include "assignment/assignment.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ggrade::grading {

/// A program with one fault.
struct Mistake {
  std::string name; ///< the patch's file name without ".patch": "mirror_light_not_mirrored"
  std::filesystem::path patch;
  std::string title;   ///< names the mistake
  std::string symptom; ///< what one sees, one sentence
  std::string hint;    ///< for the student: the likely cause and what to look at
  /// For the student: what to do, and what is then seen if it is this mistake and none of those
  /// that look like it; or empty.
  std::string experiment;
  std::string fails; ///< the item that must fail
  std::string step;  ///< the TODO to read again
  std::string shows; ///< tag of the scenes that show it
  results::Outcome outcome = results::Outcome::graded;
  std::string same; ///< name of a mistake with the very same passes, or empty
};

/// A right answer, written in another way.
struct Variant {
  std::string name;
  std::filesystem::path patch;
  std::string title;
  std::vector<std::string> loses; ///< items beyond the lecture that it may lose
  results::Outcome outcome = results::Outcome::graded; ///< how it ends where it loses them
};

struct Catalogue {
  std::string part;
  std::vector<Mistake> mistakes; ///< by name
  std::vector<Variant> variants; ///< by name
  /// Names of two mistakes that one program can have together, as in `mistakes/<part>.pairs`.
  std::vector<std::pair<std::string, std::string>> pairs;

  /// Null if there is none of this name.
  const Mistake* mistake(const std::string& name) const;
};

/// Reads the patches `<part.id>_*.patch` and the pairs from `folder`, the solution's own or
/// another; a part without any has an empty catalogue. Titles, hints and experiments of mistakes
/// are in the language that was chosen, where the solution has them in it. Whether a patch applies
/// shows when it is applied (see writeFiles). Throws UsageError that names every patch with a fault
/// in its header and says what is wrong, a line each.
Catalogue loadCatalogue(const Assignment& assignment, const Part& part,
                        const std::filesystem::path& solutionFolder,
                        const std::filesystem::path& folder);

} // namespace ggrade::grading
