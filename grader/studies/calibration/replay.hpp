#pragma once
/// \file
/// Are tapes whole? Every program of the catalogue is taped in the scenes of one seed and drawn
/// again from the tape alone: bit for bit what it drew?

#include "calibration/page.hpp"
#include "calibration/programs.hpp"
#include "grading/progress.hpp"

#include <nlohmann/json.hpp>

namespace ggrade::calibration {

/// One program in one scene.
struct Replayed {
  std::string program, scene;
  std::string difference; ///< from what the program drew, or why there is no tape; empty: none
  bool refused = false;   ///< the tape said so itself
  double megabytes = 0;   ///< of the tape
  double drawn = 0, taped = 0, played = 0; ///< seconds, by the clock
};

struct ReplayFigures {
  std::string part;
  std::vector<Replayed> all;

  std::size_t equal() const;
};

/// \param programs pictures are left out, and what draws nothing
ReplayFigures measureReplay(const Target& target, const std::filesystem::path& solutionFolder,
                            const std::vector<KnownAnswer>& programs, unsigned jobs,
                            const grading::Progress& progress);

nlohmann::json toJson(const ReplayFigures& figures);
Section sectionOf(const ReplayFigures& figures);

} // namespace ggrade::calibration
