#pragma once
/// \file
/// One fault, one loss: where a submission lost points, what it drew is drawn again with one thing
/// after the other as the reference has it (grader/repair), until the smallest set of things is
/// found that makes it right. That is the cause, proved by drawing it; each costs what it costs
/// when all else is right.

#include "grading/judge.hpp"
#include "grading/references.hpp"
#include "repair/compare.hpp"
#include "replay/tape.hpp"

#include <map>
#include <mutex>
#include <set>

namespace ggrade::grading {

struct Graded;

/// Tapes of our own programs, and whose work which unit is. Made when first asked for, and kept.
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

/// Whether gradings of this process repair: scores depend on it.
bool& repairs();

/// One fault can have cost more than once: more than one item lost something.
bool isWorthRepair(const results::Result& result);

/// Finds the causes and gives back what they cost more than once. Nothing: no set of causes makes
/// it right, and the items stay as they are. Throws Interrupted.
/// \param why the reason where nothing was found
std::vector<results::ProvedCause> repairFaults(const Target& target, OwnTapes& own, Judge& judge,
                                               Graded& graded, std::string& why);

} // namespace ggrade::grading
