#pragma once
/// \file
/// Draws that come out the same on every machine.

#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace ggrade::generated {

/// Random numbers of a seed and of what they are for.
class Chance {
public:
  Chance(std::uint64_t seed, std::string_view what) {
    std::uint64_t hash = 0xcbf29ce484222325; // FNV-1a
    for (const char c : what) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    engine_.seed(hash ^ seed * 0x9e3779b97f4a7c15);
  }

  /// 0 to count - 1; count is at least 1.
  std::size_t below(std::size_t count) { return engine_() % count; }

  template <class T> const T& of(const std::vector<T>& all) { return all[below(all.size())]; }

private:
  std::mt19937_64 engine_;
};

} // namespace ggrade::generated
