#pragma once
/// \file
/// Is the diagnosis right? Measured on mistakes that are known, and on the same mistakes as if they
/// were not.

#include "calibration/page.hpp"
#include "grading/diagnose.hpp"

#include <optional>

namespace ggrade::calibration {

/// What one answer was worth.
enum class Answered {
  right,   ///< the mistake, or one that shows the same; an outcome that was observed; the step
  generic, ///< not the mistake's name, but a change of the picture that was measured on it
  unknown,
  wrong
};

/// "right", "generic", ...
std::string_view name(Answered answered);

/// One diagnosis of one mistake.
struct DiagnosisCase {
  std::string mistake;
  std::string variant; ///< the right answer that the mistake was made in; empty: the reference
  std::uint64_t seed = 0;
  bool leftOut = false; ///< the mistake's own signature was not known
  std::string answer;   ///< the ID; empty: unknown
  double confidence = 0;
  Answered worth = Answered::unknown;
};

/// All diagnoses of one part's mistakes.
struct DiagnosisFigures {
  std::string part;
  std::vector<std::uint64_t> seeds;
  std::vector<DiagnosisCase> cases;
  std::vector<std::string> notApplied; ///< mistakes that no variant could be combined with

  /// Counts of each kind of answer, in the order of `Answered`.
  std::array<std::size_t, 4> counts(bool leftOut) const;
  /// Share of known mistakes whose first answer is right, 0 to 1: made in the reference, as the
  /// catalogue has them, or `elsewhere`, in right answers that are written in another way. Empty
  /// where none could be made.
  std::optional<double> rightShare(bool elsewhere) const;
  /// Share of unknown mistakes that were given a wrong name; 0 to 1.
  double wrongShare() const;
};

/// What must hold: least share of right first answers to the catalogue's mistakes, least share of
/// those made elsewhere, where a mistake may look like nothing that is known and unknown is the
/// honest answer, and greatest share of wrong ones.
inline constexpr double kRightAnswers = 0.95, kRightElsewhere = 0.8, kWrongAnswers = 0.01;

struct DiagnosisOptions {
  std::vector<std::uint64_t> seeds; ///< others than those that the thresholds were chosen on
  grading::Quality quality = grading::Quality::balanced;
  std::size_t variants = 2;      ///< programs that each mistake is made in, besides the reference
  std::vector<std::string> only; ///< names of mistakes; empty: all
  unsigned jobs = grading::workers();
  grading::Progress progress;
};

/// Makes every mistake of `part` (the only one of `target`) in the reference and in some of the
/// catalogue's right answers, where both patches apply, grades that with every seed, and asks for
/// two diagnoses: with the mistake's signature known and left out. Throws UsageError and
/// Interrupted.
DiagnosisFigures measureDiagnosis(const Target& target, const std::filesystem::path& solutionFolder,
                                  const DiagnosisOptions& options);

/// The figures for the page: shares, counts, and a row for each answer that isn't right.
Section sectionOf(const DiagnosisFigures& figures);
nlohmann::json toJson(const DiagnosisFigures& figures);

} // namespace ggrade::calibration
