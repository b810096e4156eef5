#include "diagnosis/match.hpp"

#include "diagnosis/correspondence.hpp"
#include "image/compare.hpp"
#include "image/mask.hpp"
#include "image/neighbourhood.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <span>

namespace ggrade::diagnosis {

namespace {

/// A difference of values from which on a pixel is as wrong as can be: beyond it, where something
/// is wrong says more than by how much.
constexpr float kWhole = 0.15f;
/// Where a program filters in another way, at most this share of a pass differs.
constexpr double kAnotherWay = 0.1;
/// Windows that are as unlike as this may be the same.
constexpr double kNoise = 0.002;
/// Side of the window that is searched for most of what is wrong, in pixels of reduced pictures.
constexpr int kWindow = 12;
/// What all passes of a scene count together, where its windows count 1.
constexpr double kPasses = 0.6;

/// How far values lie outside of ranges, where that is more than what is known already.
void raiseBeyond(const float* values, const float* low, const float* high, float* apart,
                 std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const float below = low[i] - values[i], above = values[i] - high[i];
    const float most = below > above ? below : above;
    apart[i] = most > apart[i] ? most : apart[i];
  }
}

using Distances = std::vector<float>;

double mean(const Distances& distances) {
  return distances.empty()
             ? 0
             : std::accumulate(distances.begin(), distances.end(), 0.0) / double(distances.size());
}

/// One picture of the reference with the same one of a run.
struct Cell {
  const Image* reference;
  const Image* picture;
  bool window;
  Slot slot;
};

const Image* pictureAt(const SceneViews& scene, const Slot& slot) {
  const PassView* found = scene.find(slot);
  return found ? &found->picture : nullptr;
}

const Image* windowAt(const SceneViews& scene, std::size_t frame) {
  return frame < scene.windows.size() ? &scene.windows[frame] : nullptr;
}

std::vector<Cell> cellsOf(const SceneViews& reference, const SceneViews& run) {
  std::vector<Cell> cells;
  for (const PassView& pass : reference.passes)
    cells.push_back({&pass.picture, pictureAt(run, pass.slot), false, pass.slot});
  for (std::size_t i = 0; i < reference.windows.size(); ++i)
    cells.push_back({&reference.windows[i], windowAt(run, i), true, {}});
  return cells;
}

bool equal(const Image* a, const Image* b) {
  return a == b || (a && b && sameSize(*a, *b) && std::ranges::equal(a->values(), b->values()));
}

/// Is no value further from the other's than the tolerance?
bool within(std::span<const float> a, std::span<const float> b) {
  unsigned apart = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    apart |= unsigned(!(std::abs(a[i] - b[i]) <= kTolerance));
  return apart == 0;
}

bool within(const Image& a, const Image& b) {
  return sameSize(a, b) && a.channels() == b.channels() && within(a.values(), b.values());
}

/// An image at the other's size: itself, or, if it has another one, what is kept in `made`.
const Image& atSizeOf(const Image& other, const Image& image, Image& made) {
  if (sameSize(other, image)) return image;
  return made = resized(image, other.width(), other.height());
}

/// The slots of all scenes, in the order in which they are made.
std::vector<Slot> slotsOf(const Run& reference) {
  std::vector<Slot> slots;
  for (const SceneViews& scene : reference)
    for (const PassView& pass : scene.passes)
      if (std::ranges::find(slots, pass.slot) == slots.end()) slots.push_back(pass.slot);
  return slots;
}

/// Adds up what is wrong, and what of it is wrong in another way.
struct Sum {
  double weight = 0, like = 0;

  void add(double wrong, double unlike, double times = 1) {
    if (wrong < kFaintShare) return;
    // A small fault counts less than a large one, but its noise is larger.
    const double w = times * std::sqrt(wrong);
    weight += w;
    like += w * (1 - unlike / wrong);
  }
  double mean() const { return weight > 0 ? std::clamp(like / weight, 0.0, 1.0) : 0; }
};

} // namespace

std::vector<float> distance(const Image* a, const Image* b) {
  if (!a && !b) return {};
  if (!a || !b) return Distances((a ? a : b)->pixelCount(), 1.0f);
  if (a->channels() != b->channels()) return Distances(a->pixelCount(), 1.0f);
  Image made;
  const Image& fitted = atSizeOf(*a, *b, made);
  const auto channels = std::size_t(a->channels());
  Distances distances;
  distances.reserve(a->pixelCount());
  NeighbourhoodRows around(*a, 1), aroundFitted(fitted, 1);
  std::vector<float> apart;
  for (int y = 0; y < a->height(); ++y) {
    const auto rowA = a->row(y), rowB = fitted.row(y);
    if (within(rowA, rowB)) { // nor is any neighbourhood further away
      distances.insert(distances.end(), rowA.size() / channels, 0.0f);
      continue;
    }
    around.moveTo(y);
    aroundFitted.moveTo(y);
    apart.assign(rowA.size(), 0);
    raiseBeyond(rowA.data(), aroundFitted.low().data(), aroundFitted.high().data(), apart.data(),
                apart.size());
    raiseBeyond(rowB.data(), around.low().data(), around.high().data(), apart.data(), apart.size());
    for (auto pixel = apart.begin(); pixel != apart.end(); pixel += std::ptrdiff_t(channels)) {
      const float most = *std::max_element(pixel, pixel + std::ptrdiff_t(channels));
      distances.push_back(std::clamp((most - kTolerance) / (kWhole - kTolerance), 0.0f, 1.0f));
    }
  }
  return distances;
}

double differingShare(const Image* a, const Image* b) {
  return equal(a, b) || (a && b && within(*a, *b)) ? 0 : mean(distance(a, b));
}

bool alike(const Image* a, const Image* b) {
  return differingShare(a, b) < kWrongShare;
}

bool sameWindows(const SceneViews& a, const SceneViews& b) {
  return std::ranges::equal(a.windows, b.windows,
                            [](const Image& one, const Image& two) { return alike(&one, &two); });
}

bool samePictures(const SceneViews& a, const SceneViews& b) {
  return a.passes.size() == b.passes.size() &&
         std::ranges::all_of(a.passes,
                             [&](const PassView& pass) {
                               const PassView* other = b.find(pass.slot);
                               return other && alike(&pass.picture, &other->picture);
                             }) &&
         sameWindows(a, b);
}

bool isOneColour(const Image& picture) {
  for (int c = 0; c < picture.channels(); ++c) {
    float low = picture.at(0, 0, c), high = low;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        low = std::min(low, picture.at(x, y, c));
        high = std::max(high, picture.at(x, y, c));
      }
    if (!(high - low <= kTolerance)) return false;
  }
  return true;
}

std::optional<FirstWrong> firstWrong(const Run& student, const Run& reference, double least) {
  std::optional<FirstWrong> first;
  const auto consider = [&](std::size_t scene, std::optional<Slot> slot, std::size_t frame,
                            const Image* ours, const Image& theirs, int width, int height) {
    const Distances distances = distance(&theirs, ours);
    const double wrong = mean(distances);
    if (wrong < least || (first && wrong <= first->share)) return;
    const auto wrongOnes = std::ranges::count_if(distances, [](float one) { return one > 0; });
    const double differing = double(wrongOnes) / double(distances.size());
    FirstWrong found{scene,     slot, frame, ours == nullptr, wrong,
                     differing, 0.5,  0.5,   width,           height};
    Mask wrongPixels(theirs.width(), theirs.height());
    for (int y = 0; y < theirs.height(); ++y)
      for (int x = 0; x < theirs.width(); ++x)
        wrongPixels.set(
            x, y, distances[std::size_t(y) * std::size_t(theirs.width()) + std::size_t(x)] > 0.3f);
    if (const Window window = densestWindow(wrongPixels, kWindow); window.pixels > 0) {
      found.x = (window.middleX + 0.5) / theirs.width();
      found.y = (window.middleY + 0.5) / theirs.height();
    }
    first = found;
  };
  for (const Slot& slot : slotsOf(reference)) {
    for (std::size_t i = 0; i < reference.size(); ++i)
      if (const Image* theirs = pictureAt(reference[i], slot)) {
        const PassView* ours = student[i].find(slot);
        consider(i, slot, 0, ours ? &ours->picture : nullptr, *theirs, ours ? ours->width : 0,
                 ours ? ours->height : 0);
      }
    if (first) return first;
  }
  for (std::size_t i = 0; i < reference.size(); ++i)
    for (std::size_t frame = 0; frame < reference[i].windows.size(); ++frame)
      consider(i, std::nullopt, frame, windowAt(student[i], frame), reference[i].windows[frame],
               student[i].width, student[i].height);
  return first;
}

namespace {

/// A run's picture and how far it is from the reference's, at the reference's size; nothing where
/// they are equal.
struct Compared : Cell {
  Distances distances;

  bool isRight() const { return distances.empty(); }
};

/// Of one scene each.
using ComparedRun = std::vector<std::vector<Compared>>;

ComparedRun compared(const Run& run, const Run& reference) {
  ComparedRun all;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    all.emplace_back();
    for (const Cell& cell : cellsOf(reference[i], run[i]))
      all.back().push_back({cell, equal(cell.picture, cell.reference)
                                      ? Distances()
                                      : distance(cell.reference, cell.picture)});
  }
  return all;
}

/// How far the pictures of two runs, not both right, are from each other, at the reference's size.
Distances between(const Compared& a, const Compared& b) {
  if (a.isRight() || b.isRight()) return a.isRight() ? b.distances : a.distances;
  if (!a.picture || !b.picture)
    return Distances(a.distances.size(), a.picture || b.picture ? 1.0f : 0.0f);
  Image made;
  return distance(&atSizeOf(*a.reference, *a.picture, made), b.picture);
}

Likeness likeness(const ComparedRun& student, const ComparedRun& signature, const Run& reference) {
  /// One pass over all scenes.
  struct Pass {
    Slot slot;
    double ours = 0, theirs = 0; ///< most that is wrong in a scene
    Sum sum;
  };
  Sum windows, all;
  std::vector<Pass> slots;
  for (const Slot& slot : slotsOf(reference)) slots.push_back({slot, 0, 0, {}});
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const auto passes = double(reference[i].passes.size());
    for (std::size_t k = 0; k < student[i].size(); ++k) {
      const Compared &ours = student[i][k], &theirs = signature[i][k];
      if (ours.isRight() && theirs.isRight()) continue;
      const Distances apart = between(ours, theirs);
      double wrong = 0;
      for (std::size_t p = 0; p < apart.size(); ++p)
        wrong += double(std::max(ours.isRight() ? 0 : ours.distances[p],
                                 theirs.isRight() ? 0 : theirs.distances[p]));
      wrong /= double(apart.size());
      const double unlike = mean(apart);
      if (ours.window) {
        windows.add(wrong, unlike);
        all.add(wrong, unlike);
        continue;
      }
      all.add(wrong, unlike, kPasses / passes);
      const auto pass = std::ranges::find(slots, ours.slot, &Pass::slot);
      pass->ours = std::max(pass->ours, mean(ours.distances));
      pass->theirs = std::max(pass->theirs, mean(theirs.distances));
      pass->sum.add(wrong, unlike);
    }
  }
  // Among what either has wrong, the first pass must be wrong in both.
  const auto first = std::ranges::find_if(slots, [](const Pass& pass) {
    return pass.ours >= kWrongShare || pass.theirs >= kWrongShare;
  });
  const bool both =
      first != slots.end() && first->ours >= kWrongShare && first->theirs >= kWrongShare;
  return {windows.mean(), all.mean(), both ? first->sum.mean() : 0};
}

} // namespace

Likeness likeness(const Run& student, const Run& signature, const Run& reference) {
  return likeness(compared(student, reference), compared(signature, reference), reference);
}

namespace {

/// Has the first wrong pass one value all over, or is there none?
bool passShowsNothing(const Run& student, const std::optional<FirstWrong>& first) {
  return !first || !first->slot || first->missing ||
         isOneColour(*pictureAt(student[first->scene], *first->slot));
}

/// Is a picture of objects wrong, or more of a pass than another filter or size changes? Nothing
/// that only comes later explains that. Depths depend on the frustum, which anybody may choose.
bool passIsLost(const std::optional<FirstWrong>& first) {
  return first && first->slot && !first->slot->depth && !first->missing &&
         (first->slot->mesh || first->share > kAnotherWay);
}

/// Is the pass that is wrong in a signature right in the submission? Then the fault isn't there,
/// however alike the windows are.
bool passIsRight(const Run& student, const FirstWrong& theirs, const Run& reference) {
  const Image* const ours = pictureAt(student[theirs.scene], *theirs.slot);
  return ours && alike(pictureAt(reference[theirs.scene], *theirs.slot), ours);
}

bool windowsShowNothing(const Run& student) {
  return std::ranges::all_of(student, [](const SceneViews& scene) {
    return std::ranges::all_of(scene.windows, isOneColour);
  });
}

/// By passes of the same slots.
std::optional<Identified> identifyBySlots(const Run& student, const KnownFaults& known,
                                          const Thresholds& thresholds,
                                          const std::vector<bool>& leftOut) {
  const auto& [reference, signatures, forEach] = known;
  const ComparedRun ours = compared(student, reference);
  std::vector<Likeness> likes(signatures.size());
  forEach(signatures.size(), [&](std::size_t i) {
    if (i >= leftOut.size() || !leftOut[i])
      likes[i] = likeness(ours, compared(signatures[i].run, reference), reference);
  });
  const auto groupOf = [&](std::size_t i) {
    return signatures[i].group.empty() ? signatures[i].name : signatures[i].group;
  };
  const auto by = [&](double Likeness::*kind, Identified::By how,
                      double enough) -> std::optional<Identified> {
    Identified found;
    found.by = how;
    const bool all = how == Identified::By::everything;
    double most = -1;
    for (std::size_t i = 0; i < likes.size(); ++i)
      if (likes[i].*kind > most && (all || !signatures[i].wholly)) {
        most = likes[i].*kind;
        found.signature = i;
      }
    if (most < 0) return std::nullopt;
    found.likeness = likes[found.signature].*kind;
    if (found.likeness < enough) return std::nullopt;
    const double least = 1 - (1 - found.likeness) / thresholds.margin;
    for (std::size_t i = 0; i < likes.size(); ++i) {
      if (i == found.signature || (!all && signatures[i].wholly)) continue;
      // Only what is near enough to matter is worth comparing.
      if (groupOf(i) == groupOf(found.signature) ||
          (likes[i].*kind > least - 0.05 &&
           likeness(signatures[found.signature].run, signatures[i].run, reference).all >=
               thresholds.same))
        found.alike.push_back(i);
      else
        found.next = std::max(found.next, likes[i].*kind);
    }
    // Behind passes that are made in another way, windows are never quite alike.
    const double noise = how == Identified::By::windows ? kNoise : 0;
    const double unlike = std::max(1 - found.likeness, noise) / std::max(1 - found.next, 1e-9);
    if (unlike > thresholds.margin) return std::nullopt;
    found.confidence = found.likeness * (1 - unlike);
    if (found.confidence < thresholds.confidence) return std::nullopt;
    // It is one of them, and nothing tells which.
    std::set<std::string> groups = {groupOf(found.signature)};
    for (const std::size_t other : found.alike) groups.insert(groupOf(other));
    found.confidence /= double(groups.size());
    return found;
  };
  if (auto found = by(&Likeness::all, Identified::By::everything, thresholds.like)) return found;
  const std::optional<FirstWrong> wrong = firstWrong(student, reference);
  if (auto found = windowsShowNothing(student)
                       ? std::nullopt
                       : by(&Likeness::windows, Identified::By::windows, thresholds.like)) {
    const auto theirs = firstWrong(signatures[found->signature].run, reference);
    const bool onlyInWindow = !theirs || !theirs->slot;
    const bool elsewhere = !onlyInWindow && !passIsRight(student, *theirs, reference) &&
                           found->likeness >= thresholds.same;
    if (likes[found->signature].first >= 0.5 || (!passIsLost(wrong) && (onlyInWindow || elsewhere)))
      return found;
  }
  if (passShowsNothing(student, wrong)) return std::nullopt;
  return by(&Likeness::first, Identified::By::firstPass, thresholds.firstLike);
}

} // namespace

void inTurn(std::size_t count, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = 0; i < count; ++i) task(i);
}

std::optional<Identified> KnownFaults::identify(const Run& student, const Thresholds& thresholds,
                                                const std::vector<bool>& leftOut) const {
  if (auto found = identifyBySlots(student, *this, thresholds, leftOut)) return found;
  const Run ours = corresponding(student, reference);
  KnownFaults known{withPassesOf(ours, reference), signatures, forEach};
  // Passes that are missing aren't compared here: where the others are right, an empty window alone
  // would name a fault.
  if (windowsShowNothing(ours) && passShowsNothing(ours, firstWrong(ours, known.reference)))
    return std::nullopt;
  forEach(known.signatures.size(), [&](std::size_t i) {
    known.signatures[i].run = corresponding(known.signatures[i].run, reference);
  });
  return identifyBySlots(ours, known, thresholds, leftOut);
}

} // namespace ggrade::diagnosis
