#pragma once
/// \file
/// Which command of one tape does what which command of another does.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ggrade::repair {

/// Commands that draw into the same images, one after the other; or one that moves pixels.
struct Pass {
  std::size_t frame = 0;
  std::size_t ordinal = 0;           ///< within the frame
  std::vector<std::size_t> commands; ///< indices, of draws and clears in their order
};

/// The passes of a tape's commands, in order.
std::vector<Pass> passesOf(const nlohmann::json& commands);

/// What a draw draws, whatever it draws it with; of other commands what they are.
nlohmann::json meshOf(const nlohmann::json& command);

/// The shaders that a command draws with, as one word; empty: it doesn't draw.
std::string shadersOf(const std::vector<std::vector<std::byte>>& blobs,
                      const nlohmann::json& command);

/// Passes have the same role, in this scene and in others, that draw with the same shaders into the
/// same kind of place: all steps down a pyramid, say.
std::string roleOf(const std::vector<std::vector<std::byte>>& blobs, const nlohmann::json& commands,
                   const Pass& pass);

/// The role of a pass with this draw alone.
std::string drawRole(const std::vector<std::vector<std::byte>>& blobs, const nlohmann::json& draw);

struct CommandPair {
  std::optional<std::size_t> one, other; ///< indices; nothing: the other tape alone has it
  /// Where the other alone has it: the first's command (or swap) that it would come before;
  /// nothing: its frames end earlier.
  std::optional<std::size_t> before = {};
};

/// A pass of the other tape, with what does the same in the first: what is drawn tells, wherever it
/// is drawn into.
struct PassPair {
  Pass other;
  std::vector<CommandPair> commands; ///< in the order in which they come
};

/// All passes of the other tape, in order. Throws std::runtime_error for frames of more than some
/// thousand draws.
std::vector<PassPair> align(const nlohmann::json& one, const nlohmann::json& other);

} // namespace ggrade::repair
