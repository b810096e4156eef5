#pragma once
/// \file
/// Which known fault of one part a submission shows.

#include "diagnosis/generic.hpp"
#include "grading/catalogue.hpp"
#include "grading/signatures.hpp"

#include <functional>
#include <map>

namespace ggrade::grading {

/// What a submission showed, scene by scene of a plan; made where it is asked for.
struct Shown {
  std::function<diagnosis::SceneViews(std::size_t scene)> views;
  std::function<std::vector<Image>(std::size_t scene)> frames; ///< RGB, whole size
};

/// What was found out about a submission.
struct Cause {
  /// Of the mistake in the catalogue; "step.3": the program up to step 3; of the change, such as
  /// "upside_down". Empty: unknown.
  std::string id;
  std::vector<std::string> alike; ///< other names that fit as well
  std::optional<diagnosis::Generic> generic;
  std::optional<diagnosis::Slot> of; ///< the picture that `generic` is about; nothing: the window
  diagnosis::Identified::By by = diagnosis::Identified::By::everything;
  double confidence = 0; ///< 0 to 1
  /// The first wrong picture; its scene is a number of the plan.
  std::optional<diagnosis::FirstWrong> first;
};

/// What is known of one part's faults. Signatures are rendered when they are first needed: all that
/// can have cost a lost item in one scene, the likely ones in the others. What the reference shows
/// is kept for the next submission.
class Diagnoser {
public:
  /// Reads the catalogue. Everything that is passed must outlive this. Throws UsageError for a
  /// fault in the catalogue.
  /// \param only names of the mistakes and steps that are looked for; nothing: all
  Diagnoser(const Target& target, const Part& part, const std::filesystem::path& solutionFolder,
            const References& references, Progress progress,
            std::optional<std::set<std::string>> only = {});

  /// \param lost IDs of the part's items that lost points
  /// \param leftOut names of mistakes that are not to be known, for measuring
  Cause causeOf(const std::vector<std::string>& lost, const Shown& shown,
                const std::set<std::string>& leftOut = {});

  /// Do two mistakes of the catalogue (or "step.3") show the same in every scene of these items?
  bool showTheSame(const std::string& a, const std::string& b,
                   const std::vector<std::string>& lost);

  const Catalogue& catalogue() const { return catalogue_; }
  /// Numbers of the scenes of the plan in which these items can be lost.
  /// \param changed those that are a change of another scene, or those that aren't
  std::vector<std::size_t> scenesOf(const std::vector<std::string>& items, bool changed) const;

private:
  const diagnosis::SceneViews& reference(std::size_t scene);
  std::vector<Candidate> steps() const;
  Candidate candidateOf(const Mistake& mistake) const;
  std::vector<diagnosis::Signature> signaturesOf(const std::vector<Candidate>& programs,
                                                 const std::vector<std::size_t>& scenes);
  std::vector<Candidate> suspects(const std::vector<std::string>& lost,
                                  const std::set<std::string>& leftOut) const;
  std::optional<Cause> known(const std::vector<Candidate>& suspects,
                             const std::vector<std::size_t>& scenes, const diagnosis::Run& student,
                             double least);
  std::optional<Cause> changed(const std::vector<std::size_t>& scenes,
                               const diagnosis::Run& student, const Shown& shown,
                               const std::optional<diagnosis::FirstWrong>& first);

  const Target& target_;
  const Part& part_;
  std::filesystem::path solutionFolder_;
  const References& references_;
  Progress progress_;
  std::optional<std::set<std::string>> only_;
  Catalogue catalogue_;
  std::map<std::size_t, diagnosis::SceneViews> referenceViews_;
};

} // namespace ggrade::grading
