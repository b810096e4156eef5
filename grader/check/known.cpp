#include "check/known.hpp"

#include "diagnosis/outcome.hpp"
#include "grading/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ggrade::check {

using diagnosis::samePictures;
using diagnosis::sameWindows;
using diagnosis::SceneViews;

namespace {

/// A pass of which less differs may be right in another way, such as with another filter.
constexpr double kAnotherWay = 0.02;

} // namespace

std::vector<const Fault*> KnownMistakes::like(std::size_t scene) const {
  std::vector<const Fault*> faults = like(scene, step_);
  if (faults.empty() && step_ < expected_.todos.size() &&
      !sameWindows(*shown_[scene], expected_.steps[step_][scene]))
    faults = like(scene, expected_.todos.size());
  return faults;
}

bool KnownMistakes::isExactly(const Fault& fault, std::size_t scene) const {
  return samePictures(viewsOf(fault, scene), *shown_[scene]);
}

std::set<std::string> KnownMistakes::spoiling(const diagnosis::FirstWrong& first) const {
  std::set<std::string> todos;
  for (const Fault& fault : expected_.faults)
    if (fault.step == step_ && !isRuledOut(fault) &&
        fault.scenes.count(first.scene) == fault.spoils.count(first.scene) &&
        std::ranges::any_of(
            fault.spoils, [&](const auto& spoiled) { return spoiled.second.first == first.slot; }))
      todos.insert(fault.todo);
  return todos;
}

std::set<std::string> KnownMistakes::hidingTheStep() const {
  std::set<std::string> todos;
  for (const Fault& fault : expected_.faults)
    if (step_ > 0 && fault.step == step_ && fault.scenes.count(0) && begun_.count(fault.todo) &&
        fault.todo != expected_.todos[step_ - 1] && !todos.count(fault.todo) &&
        samePictures(viewsOf(fault, 0), expected_.steps[step_ - 1][0]))
      todos.insert(fault.todo);
  return todos;
}

bool KnownMistakes::isWrongIn(std::size_t scene) const {
  const auto [known, fresh] = wrong_.try_emplace(scene);
  if (fresh)
    known->second =
        diagnosis::firstWrong({*shown_[scene]}, {expected_.steps[step_][scene]}).has_value();
  return known->second;
}

/// Is the program right, or its window, in a scene in which this mistake is seen, or its window's
/// fault is?
bool KnownMistakes::isRuledOut(const Fault& fault) const {
  return std::ranges::any_of(fault.spoils, [&](const auto& spoiled) {
    const auto& [scene, what] = spoiled;
    if (scene >= shown_.size() || !shown_[scene]) return false;
    return (what.window && fault.step == step_ &&
            sameWindows(*shown_[scene], expected_.steps[step_][scene])) ||
           !isWrongIn(scene);
  });
}

SceneViews KnownMistakes::viewsOf(const Fault& fault, std::size_t scene) const {
  return check::viewsOf(expected_, std::size_t(&fault - expected_.faults.data()), scene);
}

/// Among mistakes in a program that has done so many TODOs.
std::vector<const Fault*> KnownMistakes::like(std::size_t scene, std::size_t step) const {
  diagnosis::KnownFaults known;
  known.reference = {expected_.steps[step][scene]};
  known.forEach = [](std::size_t count, const std::function<void(std::size_t)>& task) {
    grading::inParallel(count, grading::workers(), task); // somebody waits for it
  };
  std::vector<const Fault*> faults;
  const std::vector<diagnosis::Slot> own = ownPasses(expected_, *shown_[scene], scene);
  for (const Fault& fault : expected_.faults) {
    if (fault.step != step || !fault.scenes.count(scene)) continue;
    const SceneViews views = viewsOf(fault, scene);
    // One that lacks a pass of its own lacks another one for another reason.
    if (!std::ranges::all_of(own, [&](const auto& slot) { return views.find(slot); })) continue;
    faults.push_back(&fault);
    known.signatures.push_back(fault.signature);
    known.signatures.back().run = {views};
  }
  for (std::size_t k = 0; k < expected_.steps.size(); ++k)
    known.signatures.push_back({fmt::format("step-{}", k), "", {expected_.steps[k][scene]}, true});
  const auto found = known.identify({*shown_[scene]});
  if (!found) return {};
  std::vector<std::size_t> alike = found->alike;
  alike.insert(alike.begin(), found->signature);
  // What shows the very same goes before what is only like it.
  const auto isExact = [&](std::size_t i) {
    return i < faults.size() && samePictures(known.signatures[i].run[0], *shown_[scene]);
  };
  if (std::ranges::any_of(alike, isExact))
    std::erase_if(alike, [&](std::size_t i) { return !isExact(i); });
  std::vector<const Fault*> same;
  for (const std::size_t i : alike) {
    // An unfinished program is no mistake, unless somebody has done that step already.
    if (i >= faults.size() && step != step_) return {};
    if (i < faults.size() && begun_.count(faults[i]->todo) && isWrongWhere(*faults[i]) &&
        !isWrongBefore(*faults[i], scene))
      same.push_back(faults[i]);
  }
  keepLikeliest(same);
  return same;
}

/// In an unfinished program what showed after an earlier step was looked at then: of those that
/// nothing tells apart, the latest step is the likelier one. A finished one may never have been
/// looked at. And two of one group are one mistake, if they are made in one TODO.
void KnownMistakes::keepLikeliest(std::vector<const Fault*>& faults) const {
  const auto firstShown = [&](const Fault* fault) {
    std::size_t first = fault->step;
    for (const Fault& other : expected_.faults)
      if (other.signature.group == fault->signature.group) first = std::min(first, other.step);
    return first;
  };
  if (step_ < expected_.todos.size()) {
    std::size_t latest = 0;
    for (const Fault* fault : faults) latest = std::max(latest, firstShown(fault));
    std::erase_if(faults, [&](const Fault* fault) { return firstShown(fault) != latest; });
  }
  std::ranges::stable_sort(faults, std::ranges::greater(), [&](const Fault* fault) {
    return std::ranges::find(expected_.todos, fault->todo) - expected_.todos.begin();
  });
  std::set<std::pair<std::string, std::string>> told;
  std::erase_if(faults, [&](const Fault* fault) {
    return !told.emplace(fault->signature.group, fault->todo).second;
  });
}

/// Is the first wrong picture of the program one that this mistake leaves right?
bool KnownMistakes::isWrongBefore(const Fault& fault, std::size_t scene) const {
  const SceneViews& should = expected_.steps[step_][scene];
  const auto first = diagnosis::firstWrong({*shown_[scene]}, {should});
  if (!first || !first->slot) return false;
  const SceneViews theirs = viewsOf(fault, scene);
  if (first->missing) // or is another one meant for it?
    return theirs.find(*first->slot) && ownPasses(expected_, *shown_[scene], scene).empty();
  const diagnosis::PassView* pass = theirs.find(*first->slot);
  return pass && first->share > kAnotherWay &&
         diagnosis::alike(&pass->picture, &should.find(*first->slot)->picture);
}

/// Is the program wrong in all scenes in which this mistake is seen, and this mistake seen in the
/// first of those in which the program is wrong? Two may look alike where nothing is drawn any
/// more.
bool KnownMistakes::isWrongWhere(const Fault& fault) const {
  const auto first = std::ranges::find_if(
      fault.scenes, [&](std::size_t scene) { return shown_[scene] && isWrongIn(scene); });
  return !isRuledOut(fault) && (first == fault.scenes.end() || fault.spoils.count(*first));
}

} // namespace ggrade::check
