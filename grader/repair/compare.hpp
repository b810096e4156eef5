#pragma once
/// \file
/// What a submission's tape and the reference's differ in, as *units*: one thing of the passes of
/// one role, such as their viewport, a uniform, a function of a shader, what a sampler reads. Each
/// with the patch that puts the reference's in its place.

#include "replay/tape.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace ggrade::repair {

struct Unit {
  std::string role; ///< of the reference's passes, see roleOf (align.hpp)
  std::string name; ///< "viewport", "uniform uLight", "function visibility in fragment"
  auto operator<=>(const Unit&) const = default;
};

struct Difference {
  Unit unit;
  std::set<std::size_t> passes; ///< of the submission, counted within a frame that is looked at
  nlohmann::json patch = nlohmann::json::array(); ///< RFC 6902, of Comparison::tape's commands
  /// It puts in draws with shaders that the submission draws nothing with in such passes, nor
  /// anything else in their place.
  bool isUnseen = false;
  /// Of a function or shader: the reference's lines that the submission's lacks.
  std::set<std::string> lacks{};
  bool adds = false; ///< and has the submission's lines that the reference's lacks?
  /// Of a matrix or block: is it what the reference has elsewhere? Then it is passed to the wrong
  /// place, and not made wrong.
  bool isAnothers = false;
  std::string own{};               ///< what the submission has there, see own_value.hpp
  std::set<std::string> shaders{}; ///< of the reference's draws that it is of, see shadersOf
};

/// Units, and the shaders of the reference's draws that have them.
using UnitsInDraws = std::map<Unit, std::set<std::string>>;

struct Comparison {
  tape::Tape tape; ///< the submission's, with blobs and images that patches name
  std::vector<Difference> differences; ///< narrow ones first
  UnitsInDraws compared;               ///< that both have, different or not
};

/// Units by how much they replace, from 0 on: values, functions and a step's lines in them; what is
/// drawn, and into what; shaders.
inline constexpr int kWidths = 3;
int widthOf(const std::string& unit);

/// The function that a step's lines are in: "function main in fragment" of "lines mirror.5 of main
/// in fragment". Empty: it is none.
inline std::string functionOf(const std::string& unit) {
  return unit.starts_with("lines ") ? "function " + unit.substr(unit.find(" of ") + 4) : "";
}

/// The whole shader that a function, or a step's lines, is in: "shader fragment" of "function main
/// in fragment". Empty: it is neither.
inline std::string shaderOf(const std::string& unit) {
  return unit.starts_with("function ") || unit.starts_with("lines ")
             ? "shader " + unit.substr(unit.rfind(" in ") + 4)
             : "";
}

/// Is it a shader, or a part of one?
inline bool isShader(const std::string& unit) {
  return unit.starts_with("shader ") || !shaderOf(unit).empty();
}

/// Is it a part of OpenGL's state, which stays as it is from one pass to the next?
bool isState(const std::string& unit);

/// Throws nlohmann::json::exception for a tape that isn't made as tapes are.
/// \param before so many first frames nobody looks at; what they differ in counts as well
Comparison compare(const tape::Tape& submission, const tape::Tape& reference,
                   std::size_t before = 0);

} // namespace ggrade::repair
