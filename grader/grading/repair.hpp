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

  /// The TODOs whose work a unit is: the steps of the handout that change it. None: it is right
  /// from the start, and no step changes it.
  std::set<std::string> ownersOf(const repair::Unit& unit);

private:
  tape::Tape record(const Recipe& recipe, const rubric::SceneFolders& scene,
                    const ShaderCache& shaders);
  void learnOwners();

  const Target& target_;
  const std::filesystem::path solutionFolder_;
  const References& references_;
  std::mutex mutex_, owners_;
  std::map<std::size_t, tape::Tape> reference_;
  std::map<repair::Unit, std::set<std::string>> changedBy_; ///< TODOs
  bool learned_ = false;
};

/// Finds the causes and gives back what they cost more than once. Nothing: no set of causes makes
/// it right, and the items stay as they are. Throws Interrupted.
/// \param why the reason where nothing was found
std::vector<results::ProvedCause> repairFaults(const Target& target, OwnTapes& own, Judge& judge,
                                               Graded& graded, std::string& why);

} // namespace ggrade::grading
