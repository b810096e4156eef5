#pragma once
/// \file
/// A tape (tape_format.hpp) in memory. What a student's process wrote is a claim: every length is
/// checked, and commands are nested no deeper than tapes are.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace ggrade::tape {

struct Tape {
  std::vector<std::vector<std::byte>> blobs;
  nlohmann::json commands = nlohmann::json::array(); ///< objects with an "op"
};

/// Throws std::runtime_error with what is wrong.
Tape read(std::span<const std::byte> bytes);

/// The same tape as bytes.
std::vector<std::byte> write(const Tape& tape);

} // namespace ggrade::tape
