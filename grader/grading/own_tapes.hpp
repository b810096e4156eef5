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

  /// The TODOs whose work it is: those without which the solution alone has another unit (of a
  /// function: one that lacks a line that this one lacks, too), or the step of the handout with
  /// which it comes. None: it is there and right from the start.
  std::set<std::string> ownersOf(const repair::Difference& difference);

  /// What the solution with this patch differs in from the solution, in the first scene. Empty, if
  /// that program has no tape.
  const std::set<repair::Unit>& unitsOf(const std::filesystem::path& patch);

private:
  tape::Tape record(const Recipe& recipe, const rubric::SceneFolders& scene);
  void learnOwners();
  /// What differs from the reference before a step and doesn't after it is this step's work.
  void addStep(const std::string& todo, const repair::Comparison& before,
               const repair::Comparison& after);

  const Target& target_;
  const std::filesystem::path solutionFolder_;
  const References& references_;
  std::mutex mutex_, patches_;
  std::map<std::size_t, tape::Tape> reference_;
  /// TODOs, each with the lines that a function lacks without it.
  std::map<repair::Unit, std::map<std::string, std::set<std::string>>> changedBy_;
  std::once_flag learned_;
  std::map<std::filesystem::path, std::set<repair::Unit>> unitsOf_;
};

} // namespace ggrade::grading
