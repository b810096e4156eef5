#pragma once
/// \file
/// Runs the reference in every setting: how long a part takes, and how far its picture is from the
/// truth. One program at a time, so that runs don't disturb each other.

#include "grading/references.hpp"
#include "tradeoff/analysis.hpp"
#include "tradeoff/plan.hpp"

namespace ggrade::tradeoff {

/// How long is measured. Every round runs every setting once, in the other direction than the round
/// before, so that a machine that slows down hits all alike.
struct Effort {
  unsigned rounds = 3;
  unsigned frames = 8; ///< of a run that are measured, after the first kWarmUp
};

/// Frames of a run that are not measured: shaders are compiled and textures made in the first.
inline constexpr unsigned kWarmUp = 3;

/// A sweep with what was measured in it.
struct Measured {
  Sweep sweep;
  std::vector<Point> points; ///< one a setting, in the order of allSettings
  Spread offMs;              ///< milliseconds of a frame without what the part adds
  Image truth;               ///< small; may be empty
};

/// The cost of a part along a series, and of a frame without it.
struct GrowthRow {
  std::string part, series;
  std::vector<double> values;
  std::vector<Spread> ms;
  std::optional<Growth> growth;
};

/// What a frame takes.
struct Need {
  std::size_t passes = 0;
  std::uint64_t bytes = 0; ///< of the textures and renderbuffers that the program holds
  Spread ms;
};

/// What a scene takes, and what it would take.
struct SavedRow {
  std::string name;
  Need needed, against;
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

  /// What the times depend on: the renderer and its settings.
  const std::vector<std::pair<std::string, std::string>>& machine() const { return machine_; }
  const Effort& effort() const { return effort_; }

private:
  /// Milliseconds of scenes[0], ... in `frame`, less the median of scenes[off[i]] of the same
  /// round.
  struct Timed {
    std::vector<std::vector<double>> costs; ///< by scene, a value a frame of every round
    std::vector<Spread> whole;              ///< by scene: of the whole frame
  };
  Timed time(const std::vector<json>& scenes, const std::vector<std::size_t>& off,
             const rubric::Moments& frame, const std::string& what);
  /// The same frame again and again, after those before it.
  std::vector<double> frames(const json& scene, const rubric::Moments& frame);
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
