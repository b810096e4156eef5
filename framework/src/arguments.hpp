#pragma once
/// \file
/// What may stand on the command line of every program.

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace gg::detail {

struct Arguments {
  bool help = false;
  std::optional<std::string> scene; ///< file to read instead of scene.json
  std::optional<std::string> part;  ///< of the assignment, whose scene settings count
  std::optional<std::string> mesh;  ///< replaces the scene's key `mesh`
  std::optional<glm::ivec2> size;   ///< replaces the scene's size
};

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UsageError.
Arguments parseArguments(const std::vector<std::string>& words);

/// What --help prints.
std::string usage(const std::string& program);

} // namespace gg::detail
