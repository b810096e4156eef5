#pragma once
/// \file
/// Programs as they are built from files, and built again when one of these is saved.

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gg/handle.hpp>

namespace gg::detail {

struct Uniform {
  GLint location;
  GLenum type;
};
using Uniforms = std::map<std::string, Uniform, std::less<>>;

/// A file that a program was built from.
struct WatchedFile {
  std::filesystem::path path;
  std::filesystem::file_time_type saved;
};

/// All that a Program knows.
struct ProgramState {
  Handle<ProgramTraits> name;
  std::vector<std::string> files; ///< one a stage
  std::filesystem::path folder;   ///< where they are
  std::string source;             ///< text of all stages
  Uniforms uniforms;
  std::set<std::string, std::less<>> complained; ///< of which uniforms
  std::vector<WatchedFile> watched;

  /// "object.vert + object.frag", for messages
  std::string label() const;
};

/// Reads, compiles and links. Throws ShaderError.
void build(ProgramState& state);

/// The same for a program that is in use already: it keeps its name and its uniforms' values.
/// Throws ShaderError, and then it goes on as it was.
void rebuild(ProgramState& state);

} // namespace gg::detail
