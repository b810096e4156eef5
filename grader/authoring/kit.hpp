#pragma once
/// \file
/// What is released: the kit that students receive, and the archive of an autograder.

#include "assignment/assignment.hpp"
#include "grading/references.hpp"
#include "words/words.hpp"

#include <set>

namespace ggrade::authoring {

struct KitOptions {
  std::vector<std::string> parts, blank; ///< as `release` takes them
  bool devcontainer = false;
  gg::Language language = gg::Language::english; ///< of comments, of an autograder's reports
};

/// What a kit hands out of one assignment.
struct HandedOut {
  Assignment assignment;
  std::vector<Part> parts;     ///< that have something to do
  std::set<std::string> blank; ///< TODOs to do
  std::set<std::string> filled;
};

/// This tree's assignments with what is to be done in them. Throws UsageError for a part or TODO
/// that isn't there.
std::vector<HandedOut> choose(const KitOptions& options);

/// Writes a kit's files to the folder `kit`, which is there.
void writeKit(const KitOptions& options, const std::filesystem::path& kit,
              const grading::Progress& progress);

/// Writes the quizzes of a kit's parts to `folder`, which is there, for whoever teaches: in each
/// language PART.md with answers and reasons, and PART.gift.txt for Moodle. Returns whether there
/// are any.
bool writeQuizzes(const KitOptions& options, const std::filesystem::path& folder);

/// The one target that an autograder grades. Throws UsageError unless there is one.
std::string graded(const KitOptions& options);
/// Writes an autograder's files to `folder`, which is there.
void writeAutograder(const KitOptions& options, const std::filesystem::path& folder);

} // namespace ggrade::authoring
