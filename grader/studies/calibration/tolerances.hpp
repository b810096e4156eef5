#pragma once
/// \file
/// Are the published tolerances a lucky guess? They are chosen anew on one half of the catalogue
/// and tried on the other.

#include "calibration/page.hpp"
#include "grading/references.hpp"

#include <string>
#include <vector>

namespace ggrade::calibration {

/// What a comparison allows.
struct Setting {
  double steps = 0; ///< tolerance in steps of 8 bits
  int radius = 0;   ///< pixels
  bool operator==(const Setting&) const = default;
};

/// The settings that are tried; the published one is among them.
std::vector<Setting> settings();
Setting publishedSetting();

/// The catalogue judged with one setting.
struct Trial {
  Setting setting;
  std::vector<Measured> measured;
};

/// Errors of one setting on both halves.
struct TrialErrors {
  Setting setting;
  std::size_t errors[2] = {}; ///< programs that break a limit
  double margin[2] = {};      ///< least margin in points
};

struct CrossValidation {
  std::vector<std::uint64_t> seeds;
  std::size_t programs[2] = {};    ///< in each half
  std::vector<TrialErrors> trials; ///< in the order of settings()
  Setting chosen[2]; ///< on each half: of those with the fewest errors the widest margin
  std::size_t errorsOnOther[2] = {}; ///< of chosen[half] on the other half
  bool publishedHolds = false;       ///< no error on either half
};

/// Which half of the catalogue a program is in, by a hash of its name: 0 or 1.
int halfOf(const std::string& name);

/// Splits by half. All trials have the same programs.
CrossValidation crossValidate(const std::string& part, const std::vector<ItemDeclaration>& items,
                              const std::vector<Trial>& trials);

/// Draws the catalogue's single programs once a seed, in the scenes of `quality`, and judges them
/// with every setting. Kept in the cache like other gradings. No pass is carried forward: the items
/// stand for themselves.
std::vector<Trial> tryTolerances(const Target& target, const std::filesystem::path& solutionFolder,
                                 const std::vector<KnownAnswer>& programs,
                                 const std::vector<std::uint64_t>& seeds, grading::Quality quality,
                                 unsigned jobs, const grading::Progress& progress);

nlohmann::json toJson(const CrossValidation& result);
Section sectionOf(const CrossValidation& result);

} // namespace ggrade::calibration
