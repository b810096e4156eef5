#pragma once
/// \file
/// Runs the reference in every setting: how long a part takes, and how far its picture is from the
/// truth. One program at a time, so that runs don't disturb each other.

#include "grading/references.hpp"
#include "tradeoff/analysis.hpp"
#include "tradeoff/plan.hpp"

namespace ggrade::tradeoff {

/// How long is measured. Every round runs every setting that isn't known well enough (`needsMore`)
/// and its scene without the part one after the other: the one first in even rounds, the other in
/// odd ones, and the settings the other way round.
struct Effort {
  unsigned rounds = 24; ///< at most; at least kLeastPairs
  unsigned frames = 8;  ///< of a run that are measured, after the first kWarmUp
};

/// Frames of a run that are not measured: shaders are compiled and textures made in the first.
inline constexpr unsigned kWarmUp = 2;

/// A sweep with what was measured in it.
struct Measured {
  Sweep sweep;
  std::vector<Point> points; ///< one a setting, in the order of allSettings
  double offMs = 0;          ///< milliseconds of a frame without what the part adds
  Image truth;               ///< small; may be empty
};

/// The cost of a part along a series, and of a frame without it.
struct GrowthRow {
  std::string part, series;
  std::vector<double> values;
  std::vector<Cost> costs;
  std::optional<Growth> growth;
};

/// What a frame takes.
struct Need {
  std::size_t passes = 0;
  std::uint64_t bytes = 0; ///< of the textures and renderbuffers that the program holds
  double ms = 0;
};

/// What a scene takes, and what it would take.
struct SavedRow {
  std::string name;
  Need needed, against;
  Cost saved; ///< what `against` costs more
};

/// Throws UsageError unless every part that is swept has a truth.
void requireTruths(const Plan& plan, const std::filesystem::path& solutionFolder);

/// The reference, built once.
class Bench {
public:
  /// Throws UsageError where it doesn't build.
  Bench(const Assignment& assignment, const std::filesystem::path& solutionFolder, Effort effort,
        grading::Progress progress);

  /// Throws std::runtime_error naming the setting where a run fails, Interrupted.
  Measured measure(const Sweep& sweep);
  std::vector<GrowthRow> growth(const Plan& plan);
  std::vector<SavedRow> saved(const Plan& plan);

  /// What the times depend on: the renderer and its settings, and the clock.
  const std::vector<std::pair<std::string, std::string>>& machine() const { return machine_; }
  const Effort& effort() const { return effort_; }

private:
  struct Compared {
    json with, without; ///< scenes
  };
  std::vector<Pairs> time(const std::vector<Compared>& scenes, const rubric::Moments& frame,
                          const std::string& what);
  double frameMs(const json& scene, const rubric::Moments& frame);
  grading::Rendering run(const json& scene, const rubric::Moments& times,
                         const trace::Request& request);
  truth::Judgement judge(const Sweep& sweep, const json& scene);

  grading::Program program_;
  Effort effort_;
  grading::Progress progress_;
  grading::TemporaryFolder work_;
  std::filesystem::path shaders_;
  std::vector<std::pair<std::string, std::string>> machine_;
};

} // namespace ggrade::tradeoff
