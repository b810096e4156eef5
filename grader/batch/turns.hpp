#pragma once
/// \file
/// Whose runs may go beside whose.

#include "grading/grade.hpp"

#include <chrono>
#include <map>
#include <set>
#include <vector>

namespace ggrade::batch {

/// Keeps runs of which students are told something apart in time from runs that see hidden scenes,
/// across all workers: two programs can always notice each other's work. Any number of one kind go
/// together.
class Turns {
public:
  using Clock = std::chrono::steady_clock;

  /// So long may others of the kind that goes on now still join while the other kind waits.
  static constexpr std::chrono::seconds kPatience{2};

  /// `who` has ended what it did and wants to go on with runs of this kind; `none` wants nothing.
  /// With the same kind as before it gives up nothing.
  void ask(int who, grading::Runs kind, Clock::time_point now = Clock::now());
  /// Those who waited and may go on now, the longest-waiting first.
  std::vector<int> grant(Clock::time_point now = Clock::now());

private:
  struct Wish {
    grading::Runs kind;
    Clock::time_point since;
  };

  grading::Runs kind_ = grading::Runs::none; ///< of all that go on
  std::set<int> running_;
  std::map<int, Wish> waiting_;
};

} // namespace ggrade::batch
