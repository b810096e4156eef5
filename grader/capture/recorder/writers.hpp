#pragma once
/// \file
/// Which pass drew last into each level and layer of each image.

#include "trace/records.hpp"

#include <compare>
#include <cstdint>
#include <map>
#include <utility>

namespace ggrade::capture::recorder {

/// A texture or renderbuffer of a share group, or the window of a context.
struct Place {
  std::uint32_t kind;  ///< trace::ImageKind
  std::uint32_t group; ///< of contexts that share their objects; for a window, its context
  std::uint32_t name;
  auto operator<=>(const Place&) const = default;
};

class Writers {
public:
  /// `layer` kNone: all layers.
  void set(const Place& place, std::uint32_t level, std::uint32_t layer, std::uint32_t pass) {
    Levels& levels = places_[place];
    if (layer == trace::kNone) erase(levels, level);
    levels[{level, layer}] = pass;
  }

  /// The level has been uploaded, or the whole image deleted.
  void forget(const Place& place, std::uint32_t level) {
    const auto found = places_.find(place);
    if (found != places_.end()) erase(found->second, level);
  }
  void forget(const Place& place) { places_.erase(place); }

  /// The latest writer of the level `first`; if there is none, of the levels after it up to `last`.
  std::uint32_t of(const Place& place, std::uint32_t first, std::uint32_t last) const {
    const auto found = places_.find(place);
    if (found == places_.end()) return trace::kNone;
    const std::uint32_t pass = latest(found->second, first, first);
    return pass != trace::kNone ? pass : latest(found->second, first, last);
  }

private:
  using Levels = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;

  static void erase(Levels& levels, std::uint32_t level) {
    levels.erase(levels.lower_bound({level, 0}), levels.upper_bound({level, trace::kNone}));
  }
  static std::uint32_t latest(const Levels& levels, std::uint32_t first, std::uint32_t last) {
    std::uint32_t pass = trace::kNone;
    const auto end = levels.upper_bound({last, trace::kNone});
    for (auto entry = levels.lower_bound({first, 0}); entry != end; ++entry) {
      if (pass == trace::kNone || entry->second > pass) pass = entry->second;
    }
    return pass;
  }

  std::map<Place, Levels> places_;
};

} // namespace ggrade::capture::recorder
