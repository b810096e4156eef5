#include "diagnosis/correspondence.hpp"

#include "diagnosis/match.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace ggrade::diagnosis {

namespace {

/// Each channel's range is cut into so many parts.
constexpr int kLevels = 8;
/// From this correlation ratio on, both ways, two pictures hold the same. Parts of one eighth
/// explain 63/64 of what is even; edges, whose pixels are means, a little less.
constexpr double kHoldTheSame = 0.9;

/// Each pixel's part of the range of all channels, as one number.
std::vector<int> partsOf(const Image& image) {
  std::vector<int> parts(image.pixelCount(), 0);
  for (int c = 0; c < image.channels(); ++c) {
    float low = image.at(0, 0, c), high = low;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        low = std::min(low, image.at(x, y, c));
        high = std::max(high, image.at(x, y, c));
      }
    const float step = std::max((high - low) / kLevels, 1e-6f);
    std::size_t i = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x, ++i)
        parts[i] =
            parts[i] * kLevels + std::min(int((image.at(x, y, c) - low) / step), kLevels - 1);
  }
  return parts;
}

/// Of the values that pixels of one part have.
struct Moments {
  double count = 0;
  std::array<double, 4> sum{}, squares{};

  double variation(int channels) const {
    double all = 0;
    for (std::size_t c = 0; c < std::size_t(channels); ++c)
      all += squares[c] - sum[c] * sum[c] / count;
    return all;
  }
};

bool sameKind(const Slot& a, const Slot& b) {
  return std::tie(a.depth, a.mesh, a.octave) == std::tie(b.depth, b.mesh, b.octave);
}

} // namespace

double correlationRatio(const Image& a, const Image& b) {
  const Image fitted = resized(b, a.width(), a.height());
  const std::vector<int> parts = partsOf(a);
  std::map<int, Moments> moments;
  Moments all;
  std::size_t i = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x, ++i)
      for (Moments* const one : {&moments[parts[i]], &all}) {
        ++one->count;
        for (int c = 0; c < fitted.channels(); ++c) {
          const auto value = double(fitted.at(x, y, c));
          one->sum[std::size_t(c)] += value;
          one->squares[std::size_t(c)] += value * value;
        }
      }
  const double total = all.variation(fitted.channels());
  // A part of few pixels fits them by chance: variances are divided by what is free to vary.
  const double freeInParts = all.count - double(moments.size());
  if (total < 1e-6 * all.count || freeInParts < all.count / 2) return 0;
  double within = 0;
  for (const auto& [part, one] : moments) within += one.variation(fitted.channels());
  return std::clamp(1 - within / freeInParts * (all.count - 1) / total, 0.0, 1.0);
}

bool holdTheSame(const Image& a, const Image& b) {
  return correlationRatio(a, b) >= kHoldTheSame && correlationRatio(b, a) >= kHoldTheSame;
}

namespace {

SceneViews corresponding(const SceneViews& scene, const SceneViews& reference) {
  SceneViews out = scene;
  out.passes.clear();
  std::vector<const PassView*> ours, theirs;
  for (const PassView& pass : scene.passes) ours.push_back(&pass);
  for (const PassView& pass : reference.passes) theirs.push_back(&pass);
  const auto pair = [&](const PassView* own, const PassView* right, bool same) {
    out.passes.push_back(*own);
    out.passes.back().slot = right->slot;
    if (same) out.passes.back().picture = right->picture;
    std::erase(ours, own);
    std::erase(theirs, right);
  };
  // Nearly all of a program's passes are where the reference's are.
  for (const PassView& right : reference.passes)
    if (const PassView* own = scene.find(right.slot); own && alike(&right.picture, &own->picture))
      pair(own, &right, false);
  struct Candidate {
    double differs;
    const PassView *own, *right;
    bool same;
  };
  std::vector<Candidate> candidates;
  for (const PassView* own : ours)
    for (const PassView* right : theirs)
      if (sameKind(own->slot, right->slot)) {
        const double differs = differingShare(&right->picture, &own->picture);
        const bool same = differs < kWrongShare || holdTheSame(right->picture, own->picture);
        // What holds the same comes first, but what looks the same before it.
        candidates.push_back({same ? differs - 1 : differs, own, right, same});
      }
  std::ranges::stable_sort(candidates, {}, &Candidate::differs);
  for (const Candidate& one : candidates)
    if (std::ranges::find(ours, one.own) != ours.end() &&
        std::ranges::find(theirs, one.right) != theirs.end())
      pair(one.own, one.right, one.same);
  // In the order in which the reference makes them.
  std::ranges::sort(out.passes, {}, [&](const PassView& pass) {
    return std::ranges::find(reference.passes, pass.slot, &PassView::slot) -
           reference.passes.begin();
  });
  return out;
}

} // namespace

Run corresponding(const Run& run, const Run& reference) {
  Run out;
  for (std::size_t i = 0; i < run.size(); ++i) out.push_back(corresponding(run[i], reference[i]));
  return out;
}

Run withPassesOf(const Run& run, const Run& reference) {
  Run out = reference;
  for (std::size_t i = 0; i < out.size(); ++i)
    std::erase_if(out[i].passes, [&](const PassView& pass) { return !run[i].find(pass.slot); });
  return out;
}

} // namespace ggrade::diagnosis
