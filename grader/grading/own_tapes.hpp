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

/// One of our own programs can't be recorded: it does what no tape holds, or doesn't run.
struct NoTape : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Made when first asked for, and kept in the cache. May be asked by several threads.
class OwnTapes {
public:
  OwnTapes(const Target& target, std::filesystem::path solutionFolder,
           const References& references);

  /// The reference's, in a scene of the plan.
  const tape::Tape& reference(std::size_t scene);

  /// Learns whose work everything is, by drawing the solution without each of its TODOs, and
  /// without each of their statements: half a minute, once. Who isn't told to does each when
  /// first asked.
  void learn();

  /// The TODOs whose work it is: those without which the solution alone has another unit (of a
  /// function: one that lacks a line that this one lacks, too), or the step of the handout with
  /// which it comes. None: it is there and right from the start; so are lines that no TODO adds.
  std::set<std::string> ownersOf(const repair::Difference& difference);

  /// The TODOs with a statement that decides the unit: without it alone the solution has another,
  /// and no other TODO has one without which so little else is another. None: no statement does,
  /// or it is a shader.
  std::set<std::string> decidersOf(const repair::Unit& unit);

  /// The TODOs without which passes of a role lack their draws.
  std::set<std::string> drawersOf(const std::string& role);

  /// The TODOs of whose work the submission has nothing that could be judged where this is put
  /// right: because it isn't there, or comes with the reference's draws and shaders.
  /// \param compared units that both have
  std::set<std::string> missingIn(const repair::Difference& difference,
                                  const repair::UnitsInDraws& compared);

  /// What the solution with this patch differs in from the solution, in the first scene. Empty, if
  /// that program has no tape.
  const std::set<repair::Unit>& unitsOf(const std::filesystem::path& patch);

private:
  tape::Tape record(const Recipe& recipe, const rubric::SceneFolders& scene);
  void learnOwners();
  void learnDeciders();
  void learnAnew(const rubric::SceneFolders& scene);
  void learnDecidersAnew(const rubric::SceneFolders& scene);
  std::filesystem::path keptFile(const std::string& what) const;
  void add(const std::string& todo, const repair::Difference& difference,
           const std::set<std::string>& lines);
  /// Of the passes of a role, what the submission has nowhere.
  std::set<std::string> broughtWith(const std::string& role,
                                    const repair::UnitsInDraws& compared) const;
  /// What differs from the reference before a step and doesn't after it is this step's work.
  void addStep(const std::string& todo, const repair::Comparison& before,
               const repair::Comparison& after);

  const Target& target_;
  const std::filesystem::path solutionFolder_;
  const References& references_;
  std::mutex mutex_, patches_;
  std::map<std::size_t, tape::Tape> reference_;
  /// What a unit lacks without a TODO.
  struct Share {
    std::set<std::string> lines;   ///< of a function
    std::set<std::string> shaders; ///< of the draws in which it is another
  };
  std::map<repair::Unit, std::map<std::string, Share>> changedBy_;
  std::map<repair::Unit, std::set<std::string>> decidedBy_;
  std::once_flag owners_, deciders_;
  std::map<std::filesystem::path, std::set<repair::Unit>> unitsOf_;
};

} // namespace ggrade::grading
