#include "batch/turns.hpp"

#include <algorithm>

namespace ggrade::batch {

using grading::Runs;

void Turns::ask(int who, Runs kind, Clock::time_point now) {
  if (kind != kind_) running_.erase(who); // else it goes on
  waiting_.erase(who);
  if (kind != Runs::none) waiting_[who] = {kind, now};
}

std::vector<int> Turns::grant(Clock::time_point now) {
  std::vector<std::pair<int, Wish>> order(waiting_.begin(), waiting_.end());
  std::ranges::sort(order, {}, [](const auto& one) { return one.second.since; });
  if (running_.empty()) kind_ = order.empty() ? Runs::none : order.front().second.kind;
  const bool othersWaitLong = std::ranges::any_of(order, [&](const auto& one) {
    return one.second.kind != kind_ && now - one.second.since >= kPatience;
  });
  const bool isClosed = !running_.empty() && othersWaitLong;
  std::vector<int> granted;
  for (const auto& [who, wish] : order)
    if (wish.kind == kind_ && (!isClosed || running_.contains(who))) {
      granted.push_back(who);
      running_.insert(who);
      waiting_.erase(who);
    }
  return granted;
}

} // namespace ggrade::batch
