#pragma once
/// \file
/// What the grader is measured on: programs whose answer is known to be right or wrong, and
/// pictures that no program drew.

#include "grading/catalogue.hpp"
#include "grading/recipe.hpp"
#include "rubric/evidence.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::calibration {

enum class Kind { reference, variant, mistake, pair, pictures, stub };

/// "reference", "variant", ...
std::string_view name(Kind kind);

/// Is this a right answer?
inline bool isRight(Kind kind) {
  return kind == Kind::reference || kind == Kind::variant;
}

/// One row of the measurement, and what must become of it.
struct KnownAnswer {
  Kind kind = Kind::mistake;
  std::string name;
  std::string title;
  grading::Recipe recipe;                              ///< of nothing: pictures
  std::string fails;                                   ///< mistake: the item that must fail
  std::vector<std::string> loses;                      ///< variant: the items that it may lose
  results::Outcome outcome = results::Outcome::graded; ///< how grading must end
  std::vector<std::string> of;                         ///< pair: its two mistakes
  double most = 0;                                     ///< pictures, stub: what they may score
};

/// The reference, the stub, every patch of the catalogue, every pair, and the pictures (see
/// PictureKind). Those named in `only` (a name, with or without the part's prefix, or a kind) and
/// what their judgement needs; all if it is empty. Throws UsageError for a name that is not there.
std::vector<KnownAnswer> programsOf(const Assignment& assignment,
                                    const grading::Catalogue& catalogue,
                                    const std::filesystem::path& solutionFolder,
                                    const std::vector<std::string>& only);

/// What a whole-image measure says of a submission's pictures.
struct PictureError {
  double worst = 0; ///< of all pictures: 0 right, more is worse
  double ms = 0;    ///< processor time for a picture

  bool operator==(const PictureError&) const = default;
};

/// One grading of one program.
struct Score {
  std::uint64_t seed = 0;
  results::Outcome outcome = results::Outcome::graded;
  std::string detail;
  double score = 0, bonus = 0;
  double seconds = 0; ///< that rendering and judging took; building and pictures come on top
  double judgeMs = 0; ///< of them: the first judging, for a picture, by the clock
  std::map<std::string, double> earned;        ///< by item; keep items 0 or less
  std::map<std::string, double> asDrawn;       ///< before each was counted once; empty: no other
  std::map<std::string, std::string> messages; ///< of items that lost something
  std::map<std::string, PictureError>
      measures; ///< by name, if they were asked for; see whole_image.hpp

  const std::map<std::string, double>& drawn() const { return asDrawn.empty() ? earned : asDrawn; }
  bool operator==(const Score&) const = default;
};

/// One program with all its gradings.
struct Measured {
  KnownAnswer program;
  std::vector<Score> scores;
  std::string problem; ///< why it could not be graded at all: a patch that doesn't apply
};

/// A submission that is pictures only, without any pass: what someone could hand over who has
/// understood nothing, or who has the pictures of another scene.
struct PictureKind {
  std::string name, title;
  double most = 0; ///< that they may score
};

/// What right first frames, shown again and again, may score: they are right in scenes of one
/// frame.
inline constexpr double kStillScore = 20;

const std::vector<PictureKind>& pictureKinds();

/// The frames of scene `index` as this kind has them, of the sizes and times that are wanted. `all`
/// are the reference's frames by scene; `isPublic` says which of them a student knows.
std::vector<rubric::RawFrame> pictures(const std::string& kind,
                                       const std::vector<std::vector<rubric::RawFrame>>& all,
                                       const std::vector<bool>& isPublic, std::size_t index);

} // namespace ggrade::calibration
