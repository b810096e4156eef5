#pragma once
/// \file
/// From a judged submission to the words of its diagnosis.

#include "grading/diagnoser.hpp"
#include "grading/submitted.hpp"

namespace ggrade::grading {

/// The items of a part that lost points, without the bonus.
std::vector<std::string> lostItems(const report::Result& result, const Part& part);

/// What lies in a submission's folders of frames and passes, by scene.
Shown shown(const std::vector<std::filesystem::path>& folders);

/// Words for one submission after the other, graded in the same scenes.
class Diagnosing {
public:
  /// Everything that is passed must outlive this.
  Diagnosing(const Target& target, std::filesystem::path solutionFolder, const ScenePlan& plan,
             const References& references, Progress progress);

  /// At most one diagnosis a part that lost points, and none where nothing was lost; one for all
  /// where the outcome says it. What known mistakes show is rendered and kept the first time it is
  /// needed. `result` has its outcome, its items and the compiler's output. Throws UsageError for
  /// a fault in the catalogue, and Interrupted.
  std::vector<report::Diagnosis> operator()(const Submitted& submitted,
                                            const report::Result& result);

private:
  Diagnoser& diagnoserOf(const Part& part);

  const Target& target_;
  std::filesystem::path solutionFolder_;
  const ScenePlan& plan_;
  const References& references_;
  Progress progress_;
  std::map<std::string, Diagnoser> diagnosers_; ///< by part
};

} // namespace ggrade::grading
