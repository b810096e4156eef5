#pragma once
/// \file
/// What a submission's tape and the reference's differ in, as *units*: one thing of one pass, such
/// as its viewport, a uniform, a function of a shader, what a sampler reads. Each with the patch
/// that puts the reference's in its place.

#include "replay/tape.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace ggrade::repair {

struct Unit {
  std::size_t pass = 0; ///< the reference's pass, counted within a frame
  std::string name;     ///< "viewport", "uniform uLight", "function visibility in fragment"
  auto operator<=>(const Unit&) const = default;
};

struct Difference {
  Unit unit;
  nlohmann::json patch = nlohmann::json::array(); ///< RFC 6902, of Comparison::tape's commands
  /// Of a function: the reference's lines that the submission's lacks.
  std::set<std::string> lacks{};
};

struct Comparison {
  tape::Tape tape; ///< the submission's, with blobs and images that patches name
  std::vector<Difference> differences;       ///< narrow ones first
  std::set<Unit> compared;                   ///< units that both have, different or not
  std::map<std::size_t, std::size_t> passes; ///< of the submission's first frame: the reference's
};

/// Throws nlohmann::json::exception for a tape that isn't made as tapes are.
Comparison compare(const tape::Tape& submission, const tape::Tape& reference);

} // namespace ggrade::repair
