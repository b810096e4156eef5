#pragma once
/// \file
/// When a scene is drawn, frame by frame.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace ggrade::rubric {

/// A frame that a program draws before the first one that is looked at.
struct Moment {
  double earlier =
      0; ///< so many seconds before the first one that is looked at; less than 0: later
  /// Of the window in this frame, pixels; 0: as in the frames that are looked at.
  std::uint32_t width = 0, height = 0;

  bool operator==(const Moment&) const = default;
};

/// The frames of one run. Those of `before` belong to it, so that what comes of an earlier frame
/// can show, but nobody looks at them: the first frame of all that is recorded, judged and told is
/// the first of `shown`.
struct Moments {
  std::vector<Moment> before;
  std::vector<double> shown; ///< seconds, one a frame

  Moments() = default;
  Moments(std::initializer_list<double> times) : shown(times) {}
  Moments(std::vector<double> times) : shown(std::move(times)) {}
  Moments(std::vector<Moment> first, std::vector<double> times)
      : before(std::move(first)), shown(std::move(times)) {}

  /// Of the whole run.
  std::size_t frames() const { return before.size() + shown.size(); }
  /// This one frame with what comes before it.
  Moments of(double time) const { return {before, {time}}; }
  /// The first frame that is looked at, with what comes before it.
  Moments first() const { return of(shown.at(0)); }

  bool operator==(const Moments&) const = default;
};

/// What tells one row of frames from another: a list of seconds where there is none before it.
void to_json(nlohmann::json& to, const Moments& moments);

/// As a file declares them, each by how many seconds earlier it is than the first frame that is
/// looked at: `0.04`, or `{"seconds": 0.04, "size": [320, 240]}`. Throws UsageError that
/// begins with `where`, and names the entry and its value.
std::vector<Moment> readBefore(const nlohmann::json& declared, const std::string& where);
/// The other way round.
nlohmann::json toJson(const std::vector<Moment>& before);

/// Throws UsageError that begins with `where`, unless one run can have these frames: not too many,
/// and none before the second 0.
void checkFrames(const Moments& moments, const std::string& where);

} // namespace ggrade::rubric
