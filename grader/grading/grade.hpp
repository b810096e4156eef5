#pragma once
/// \file
/// Grading: from an upload to a result that the reports are written from.

#include "grading/diagnoser.hpp"
#include "grading/judge.hpp"
#include "grading/references.hpp"
#include "grading/repair.hpp"
#include "intake/find_uploads.hpp"
#include "report/reveal.hpp"
#include "results/results.hpp"

#include <memory>
#include <optional>

namespace ggrade::grading {

/// A scene of a grading: what it is, where the pictures lie that were made in it, and how the
/// submission's run there went.
struct GradedScene : rubric::SceneFolders {
  Rendering rendering;          ///< frames alone: passes lie in `student`
  std::uint64_t copyBytes = 0;  ///< what copies of its passes may still take on disk
  std::uint32_t copiesLost = 0; ///< that had no room
};

/// A submission that was built, to be graded with one seed or several.
struct Built {
  results::Result result; ///< what every grading of it says, its outcome included
  std::shared_ptr<Program> program;
};

/// A submission on its way through a grading. What it drew goes with this.
struct Graded {
  results::Result result;
  std::shared_ptr<Program> program;
  std::vector<GradedScene> scenes; ///< the public one first; none where it wasn't built
  std::optional<Rendering> again;  ///< the public scene's second run
  diagnosis::Facts facts;          ///< of the first scene
  ShaderCache shaders;             ///< what the program has compiled
  std::unique_ptr<TemporaryFolder> work;

  /// Folders of frames and passes, by scene.
  std::vector<std::filesystem::path> students() const;
};

/// Runs by what they may tell whom, see docs/security.md: of those that are told, output and
/// pictures reach the student; hidden ones see hidden scenes.
enum class Runs { none, told, hidden };

struct GraderOptions {
  std::vector<std::string> judgeArguments = {}; ///< GoogleTest's
  bool pictures = true; ///< false for who wants scores only: the result has items but no scenes
  /// Does the public scene run a second time (not with quality `fast`, nor if the program draws the
  /// reference's picture) to see whether the program draws the same again?
  bool twice = true;
  bool diagnosis = true; ///< is the likeliest cause of lost points looked for?
  /// Of the mistakes in the catalogue and the steps ("step.2") those that it looks for; nothing:
  /// all.
  std::optional<std::set<std::string>> suspects = {};
  bool repair = repairs();
  bool many = false; ///< is more than one submission to come?
  /// Called before runs of a kind begin, and with `none` when they are over; may wait until no run
  /// of the other kind goes on for another submission.
  std::function<void(Runs)> begins = [](Runs) {};
  unsigned threads = workers(); ///< scenes rendered at a time; 1: nothing goes on beside another
  Progress progress = [](const std::string&, std::size_t, std::size_t) {};
};

/// Grades submissions of one target in the scenes of one plan. Keeps what they share: the
/// references, the judge, and what is known of mistakes. Several threads may ask.
/// \code
/// Grader grader(target, solutions, drawScenes(target, solutions), {});
/// const results::Result result = grader.gradeUpload(upload);
/// \endcode
class Grader {
public:
  /// Nothing is rendered before it is needed. `references`: rendered already.
  Grader(const Target& target, std::filesystem::path solutionFolder, ScenePlan plan,
         GraderOptions options, std::optional<References> references = {});

  /// Renders the references and starts the judge. Throws UsageError where our own programs fail,
  /// and Interrupted, as everything does that follows.
  void prepare();

  /// From an upload as it came to the result. What can't be unpacked, or holds nothing of the
  /// assignment, was not built, and the result says why.
  results::Result gradeUpload(const intake::Upload& upload);
  /// The same of a folder whose other files are expected. Throws UsageError where it isn't there or
  /// holds nothing of the assignment.
  results::Result gradeTrusted(const std::filesystem::path& folder);
  /// The steps of all that: builds, draws, judges, diagnoses.
  results::Result grade(const std::shared_ptr<Program>& program, bool trusted);

  /// Builds the program. One that doesn't build is no error: see the result's outcome.
  Built build(const std::shared_ptr<Program>& program, bool trusted);
  /// Renders it in the first `scenes` scenes of the plan. The public one goes first and leaves its
  /// shader cache for the hidden ones: so no run can tell another what it saw of a hidden scene.
  Graded draw(const Built& built, std::size_t scenes = std::size_t(-1));
  /// Judges what was drawn and, where a pass failed, what follows it once more with the
  /// reference's. A fault of ours makes the result not gradable.
  void judge(Graded& graded);
  /// Looks for the likeliest cause of lost points. What known mistakes show is rendered and kept
  /// the first time it is needed.
  /// \param leftOut names of mistakes that are not to be known, for measuring
  void diagnose(Graded& graded, const std::set<std::string>& leftOut = {});

  const ScenePlan& plan() const { return plan_; }
  const References& references();
  /// The judge of the plan's scenes.
  Judge& theJudge();

private:
  const Target& target_;
  const std::filesystem::path solutionFolder_;
  const ScenePlan plan_;
  const GraderOptions options_;
  std::once_flag prepared_, started_, taped_;
  std::optional<References> references_;
  std::optional<Judge> judge_;
  std::optional<OwnTapes> tapes_;
  ReferencePictures pictures_;
  std::mutex diagnosing_;
  std::map<std::string, Diagnoser> diagnosers_; ///< by part
};

/// The result of a submission of which nothing was built, for the reason `detail`.
results::Result ungraded(const Target& target, const ScenePlan& plan, results::Outcome outcome,
                         const std::string& detail);

/// The score and the bonus that `result.items` add up to.
void addUp(results::Result& result);

/// Writes results.json, junit.xml, index.html and student.html to `out`, all or none.
void publishReports(const results::Result& result, const std::filesystem::path& out,
                    report::Reveal reveal);

} // namespace ggrade::grading
