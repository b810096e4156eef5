#include "grading/charges.hpp"

#include "report/summary.hpp"

#include <algorithm>
#include <set>

namespace ggrade::grading {

using results::Item;
using results::ItemKind;
using results::ProvedCause;

namespace {

/// An item that lost no more of its points is as good as whole.
constexpr double kFreeShare = 0.05;
/// What was right before and was spoiled costs so many points at most once that is proved.
constexpr double kSpoiledPoints = 10;

bool names(const ItemDeclaration& declared, const std::string& unit) {
  return std::ranges::find(declared.work, unit) != declared.work.end();
}

double lostBy(const Item& item) {
  return item.kind == ItemKind::bonus ? 0 : report::lost(item);
}

} // namespace

Charges::Charges(const std::vector<ItemDeclaration>& items) {
  for (const ItemDeclaration& declared : items) declared_[declared.id] = declared;
}

bool Charges::isNamed(const ProvedCause& cause) const {
  return std::ranges::any_of(declared_,
                             [&](const auto& one) { return names(one.second, cause.unit); });
}

bool Charges::isWorkOf(const ProvedCause& cause, const std::string& item,
                       const std::vector<ProvedCause>& causes) const {
  const ItemDeclaration& declared = declared_.at(item);
  const bool isKeep = declared.kind == ItemKind::keep;
  if (cause.todos.empty()) return isKeep;
  if (isKeep) return false;
  // What a step got wrong besides follows from the rest of its work.
  const bool namedAlone = std::ranges::all_of(causes, [&](const ProvedCause& other) {
    return other.todos != cause.todos || isNamed(other);
  });
  return namedAlone ? names(declared, cause.unit) : cause.todos.contains(declared.step);
}

bool Charges::areWorkOf(const std::vector<ProvedCause>& causes, const std::string& item) const {
  return std::ranges::all_of(
      causes, [&](const ProvedCause& cause) { return isWorkOf(cause, item, causes); });
}

void Charges::settle(std::vector<Item>& items, const std::vector<Item>& before,
                     const std::vector<ProvedCause>& causes) const {
  std::map<std::set<std::string>, ProvedCause> works; // one for each
  for (const ProvedCause& cause : causes) works.emplace(cause.todos, cause);
  for (const auto& [todos, cause] : works) {
    bool paid = false;
    double worth = 0;
    for (const Item& item : items) {
      if (!isWorkOf(cause, item.id, causes)) continue;
      paid |= lostBy(item) > kFreeShare * item.points;
      if (item.kind == ItemKind::gain) worth += item.points;
    }
    if (paid) continue;
    const auto given = [&](std::size_t i) { return lostBy(before[i]) - lostBy(items[i]); };
    std::size_t worst = 0;
    for (std::size_t i = 1; i < items.size(); ++i)
      if (given(i) > given(worst)) worst = i;
    if (given(worst) <= 0) continue;
    Item charged = before[worst];
    charged.earned += std::max(0.0, given(worst) - (worth == 0 ? kSpoiledPoints : worth));
    items[worst] = charged;
  }
  double spoiled = 0;
  for (const Item& item : items)
    if (item.kind == ItemKind::keep) spoiled -= item.earned;
  for (Item& item : items)
    if (item.kind == ItemKind::keep && spoiled > kSpoiledPoints)
      item.earned *= kSpoiledPoints / spoiled;
}

} // namespace ggrade::grading
