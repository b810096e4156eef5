#pragma once
/// \file
/// Whose work what a submission differs in is: learnt by drawing the solution without each of its
/// TODOs, and without each of their statements.

#include "grading/references.hpp"
#include "repair/compare.hpp"
#include "replay/tape.hpp"

#include <map>
#include <set>

namespace ggrade::grading {

/// One of our own programs can't be recorded: it does what no tape holds, or doesn't run.
struct NoTape : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a program of ours draws in a scene, from the cache if it was recorded before. Throws
/// NoTape.
tape::Tape recordOwn(const Target& target, const Recipe& recipe, const rubric::SceneFolders& scene,
                     const ShaderCache& shaders);

/// Is the scene tagged as one in which another step does the work of one that the public scene
/// shows?
bool isOfOtherSteps(const SceneCase& scene);

class Owners {
public:
  /// Those of each of the target's parts.
  Owners(const Target& target, const std::filesystem::path& solutionFolder);

  /// What is known of a part, as it is kept: as `derive` has left it beside the solution, if that
  /// was of the same files; else learnt now, for half a minute, and kept in the cache. Throws
  /// NoTape.
  static std::string textOfPart(const Target& part, const std::filesystem::path& solutionFolder);

  /// The TODOs whose work it is: those without which the solution alone has another unit (of a
  /// function: one that lacks a line that this one lacks, too), or the step of the handout with
  /// which it comes. None: it is there and right from the start; so are lines that no TODO adds.
  std::set<std::string> ownersOf(const repair::Difference& difference) const;

  /// The TODOs with a statement that decides the unit: without it alone the solution has another,
  /// and no other TODO has one without which so little else is another. None: no statement does,
  /// or it is a shader.
  /// \param elsewhere is it another in no scene but those of other steps?
  std::set<std::string> decidersOf(const repair::Unit& unit, bool elsewhere) const;

  /// The TODOs without which passes of a role lack their draws.
  std::set<std::string> drawersOf(const std::string& role) const;

  /// The TODOs of whose work the submission has nothing that could be judged where this is put
  /// right: because it isn't there, or comes with the reference's draws and shaders.
  /// \param all what differs besides in that scene
  /// \param compared units that both have
  std::set<std::string> missingIn(const repair::Difference& difference,
                                  const std::vector<repair::Difference>& all,
                                  const repair::UnitsInDraws& compared) const;
  /// Is nothing of a TODO's work there, in any unit that it is the work of?
  bool isUntouched(const std::string& todo, const std::vector<repair::Difference>& differences,
                   const repair::UnitsInDraws& compared) const;

private:
  Owners() = default;
  void learn(const Target& target, const std::filesystem::path& solutionFolder,
             const rubric::SceneFolders& scene, const ShaderCache& shaders,
             const tape::Tape& reference);
  void learnDeciders(const Target& target, const std::filesystem::path& solutionFolder,
                     const rubric::SceneFolders& scene, const ShaderCache& shaders,
                     const tape::Tape& reference);
  void add(const std::string& todo, const repair::Difference& difference,
           const std::set<std::string>& lines);
  /// What differs from the reference before a step and doesn't after it is this step's work.
  void addStep(const std::string& todo, const repair::Comparison& before,
               const repair::Comparison& after);
  /// Does anything stand in the place of a TODO's lines? Of a whole shader: in the functions that
  /// are another one without it.
  bool isWrittenOtherwise(const std::string& todo, const repair::Difference& difference,
                          const std::vector<repair::Difference>& all) const;
  /// Of the passes of a role, what the submission has nowhere.
  std::set<std::string> broughtWith(const std::string& role,
                                    const repair::UnitsInDraws& compared) const;
  std::string text(const std::string& key) const;
  void addText(const std::string& text);

  /// What a unit lacks without a TODO.
  struct Share {
    std::set<std::string> lines;   ///< of a function
    std::set<std::string> shaders; ///< of the draws in which it is another
  };
  std::map<repair::Unit, std::map<std::string, Share>> changedBy_;
  std::map<repair::Unit, std::set<std::string>> decidedBy_;
  std::map<repair::Unit, std::set<std::string>> elsewhereBy_; ///< in scenes of other steps
};

/// Where those of a part are kept beside its solution.
std::filesystem::path ownersFile(const std::filesystem::path& solutionFolder,
                                 const std::string& part);

/// Whether what is kept there was learnt of these files.
bool areOwnersKept(const Target& part, const std::filesystem::path& solutionFolder);

/// Keeps those of each part of an assignment beside its solution.
void keepOwners(const Assignment& assignment, const std::filesystem::path& solutionFolder,
                const Progress& progress);

} // namespace ggrade::grading
