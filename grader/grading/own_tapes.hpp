#pragma once
/// \file
/// Tapes of our own programs, and whose work what they differ in is.

#include "grading/references.hpp"
#include "repair/compare.hpp"
#include "replay/tape.hpp"

#include <map>
#include <mutex>
#include <set>

namespace ggrade::grading {

/// Made when first asked for, and kept in the cache. May be asked by several threads.
class OwnTapes {
public:
  OwnTapes(const Target& target, std::filesystem::path solutionFolder,
           const References& references);

  /// The reference's, in a scene of the plan.
  const tape::Tape& reference(std::size_t scene);

  /// The TODOs whose work it is: the steps of the handout that change this unit (of a function:
  /// that write a line of those that it lacks). None: no step changes it, it is right from the
  /// start.
  std::set<std::string> ownersOf(const repair::Difference& difference);

  /// What the solution with this patch differs in from the solution, in the first scene. Empty, if
  /// that program has no tape.
  std::set<repair::Unit> unitsOf(const std::filesystem::path& patch);

private:
  tape::Tape record(const Recipe& recipe, const rubric::SceneFolders& scene);
  void learnOwners();

  const Target& target_;
  const std::filesystem::path solutionFolder_;
  const References& references_;
  std::mutex mutex_, owners_;
  std::map<std::size_t, tape::Tape> reference_;
  /// TODOs, each with the lines that it adds to a function.
  std::map<repair::Unit, std::map<std::string, std::set<std::string>>> changedBy_;
  bool learned_ = false;
};

} // namespace ggrade::grading
