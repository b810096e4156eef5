#pragma once
/// \file
/// Truths that are asked for again: many settings of one scene have the same.

#include "truth/truth.hpp"

#include <map>
#include <memory>

namespace ggrade::truth {

/// What the truth of a scene depends on, as a key: all but how well it is drawn.
std::string keyOf(const Rendered& rendered);

/// `make(rendered)`, kept for the scenes that were asked for last. Not for several threads.
template <class Made, class Make>
std::shared_ptr<const Made> kept(const Rendered& rendered, Make make) {
  constexpr std::size_t kMost = 4; // shadows take 30 MiB at 640x480
  static std::map<std::string, std::shared_ptr<const Made>> all;
  const std::string key = keyOf(rendered);
  if (const auto found = all.find(key); found != all.end()) return found->second;
  if (all.size() == kMost) all.clear();
  return all[key] = std::make_shared<const Made>(make(rendered));
}

} // namespace ggrade::truth
