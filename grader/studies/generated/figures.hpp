#pragma once
/// \file
/// What gradings of generated programs say of the grader, held against the rule of fairness: a
/// fault costs the points of the step whose work is wrong.

#include "calibration/page.hpp"
#include "calibration/programs.hpp"

namespace ggrade::generated {

/// Points that a right program may lose, and from which on a wrong one counts as found.
inline constexpr double kFree = 2;
/// What a fault may cost beyond the points of its step.
inline constexpr double kBeyondStep = 10;

/// What became of one program.
enum class Fate {
  notDrawn,   ///< it doesn't compile, or ends itself: left out
  fair,       ///< right and not charged; or wrong, found, and charged no more than its step
  tooLow,     ///< right and charged, or wrong and charged more than its step and `kBeyondStep`
  survived,   ///< wrong, shown by a scene that may be asked for, and not charged
  equivalent, ///< wrong by its text alone: no scene shows it, and it isn't charged. Left out.
  unseen      ///< charged, although no scene shows it
};
std::string_view name(Fate fate);

/// What the first diagnosis of a wrong program was worth.
enum class Told { right, generic, silent, wrong };
std::string_view name(Told told);

struct Case {
  std::string name; ///< "wrong-012"
  bool isRight = false;
  std::string program; ///< the program that it is made from: a variant's name, or "reference"
  std::string change;  ///< what was done to it, a line each
  std::string todo;    ///< wrong: in whose block that is
  calibration::Score score;
  double lost = 0;      ///< points
  double bonusLost = 0; ///< of these, the bonus of its step: nothing is said of that
  double allowed = 0;   ///< that it may lose
  std::string shownIn;  ///< the scene in which a window is another than the reference's, or empty
  std::string answer;   ///< the first diagnosis' ID, or its text where it has none
  std::string step;     ///< and the heading that it says to read
  Fate fate = Fate::notDrawn;
  Told told = Told::silent; ///< of a wrong program that lost points
};

struct Figures {
  std::string part;
  std::uint64_t seed = 0;
  std::vector<Case> cases; ///< right ones first
  std::size_t scenes = 0;  ///< drawn for each survivor, at most
  /// How well one number tells right from wrong: the area under the ROC curve, by name; the
  /// rubric's is "points lost".
  std::vector<std::pair<std::string, double>> areas;

  std::size_t count(bool isRight, Fate fate) const;
  /// Of the wrong ones that a scene shows; 0 to 1, 1 without any.
  double killed() const;
  double chargedTooMuch() const;
};

/// Did frames come? Scores of others say nothing of the rubric.
bool isDrawn(const Case& found);

/// Sets `lost`, `fate` and `told` by what was found.
/// \param most what a right program earns
/// \param heading of the handout's step about `found.todo`, as diagnoses name it
void settle(Case& found, double most, const std::string& heading);

/// What must hold, a line for each that doesn't; empty: all of it holds.
std::string failuresOf(const Figures& figures);
calibration::Section sectionOf(const Figures& figures, const Target& target);
nlohmann::json toJson(const Figures& figures);

} // namespace ggrade::generated
