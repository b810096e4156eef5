#pragma once
/// \file
/// What every report says first: how items stand, what was lost, where it shows.

#include "results/results.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::report {

/// Points are at most hundreds: less is rounding.
constexpr double kEpsilon = 1e-6;

enum class Standing { full, part, none, unjudged };

/// A `keep` item is full when nothing was taken away.
Standing standing(const results::Item& item);

/// Points missing from what the item could give (gain, bonus), or taken away (keep). Never
/// negative.
double lost(const results::Item& item);

/// Scored, and every gain and keep item is full. The bonus doesn't count.
bool perfect(const results::Result& result);

/// Frames came and were judged: `graded` and `glError`.
bool scored(results::Outcome outcome);

/// One sentence: how it ended, in words, or how many items lost points.
std::string headline(const results::Result& result);

/// "Judged with the reference's scene and bright pass in place of yours." Empty where nothing was
/// carried forward.
std::string carriedText(const results::Item& item);

/// The first wrong picture with how much of it is wrong, and where: "the texture that objects are
/// drawn into: 31% of it differs, around (212, 340) of 1024x1024 (scene public)". Empty if unknown.
std::string whatIsWrong(const results::Diagnosis& diagnosis);

/// Gain and keep items that lost points, most points first, at most `count`. Empty unless scored.
std::vector<const results::Item*> worstItems(const results::Result& result, std::size_t count);

/// The scene in which the item got least credit; null when it is full in every scene of `result`.
const results::Scene* worstScene(const results::Result& result, const results::Item& item);

/// The frame with the largest share of wrong pixels among those with a picture; the first on a tie.
struct FrameIndex {
  std::size_t scene = 0, frame = 0;
  bool found = false;
};
FrameIndex worstFrame(const results::Result& result);

/// What a list of results says of one: small enough to keep for a whole class.
struct Summary {
  std::string submission; ///< one line, safe to print
  results::Outcome outcome = results::Outcome::notGradable;
  bool perfect = false;
  std::string headline;
  std::string reason; ///< the diagnosis, what lost most, or the evidence; may be empty
  double score = 0, bonus = 0, maxScore = 0;
  Image thumbnail;  ///< the submission's worst frame, at most 224 x 168 pixels; may be empty
  std::string link; ///< path of the result's page, relative to the list's; empty: no link
};
Summary summarize(const results::Result& result, const std::string& link = "");

/// The class that colours the whole: "full", "part", "none" or "unjudged" (not gradable).
std::string_view stateOf(const Summary& summary);

/// "12 / 20", "+5 / 10" (bonus), "−4" or "kept" (keep), "not judged".
std::string pointsText(const results::Item& item);

/// Wall-clock seconds of the whole grading.
double totalSeconds(const results::Result& result);

} // namespace ggrade::report
