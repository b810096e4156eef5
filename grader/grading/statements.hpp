#pragma once
/// \file
/// The solution with each of the statements left out that students write: compiled once, each
/// behind a switch.

#include "grading/references.hpp"

#include <string>
#include <vector>

namespace ggrade::grading {

class Statements {
public:
  /// Those of the target's TODOs: C++ alone, one a line.
  Statements(const Target& target, const std::filesystem::path& solutionFolder);

  std::size_t size() const { return todos_.size(); }
  /// In whose block a statement stands. \param at from 0
  const std::string& todoOf(std::size_t at) const { return todos_.at(at); }

  /// As Program::render, without that statement. May be called by several threads.
  Rendering renderWithout(std::size_t at, const nlohmann::json& scene, const Moments& times,
                          const ShaderCache& shaders, const trace::Request& trace);

private:
  /// The text with a switch before each statement. Those of the target's TODOs are counted.
  std::string withSwitches(const std::string& text, const std::string& file);

  const Target& target_;
  TemporaryFolder sources_, programs_;
  std::vector<std::string> todos_;
  std::optional<Program> program_;
};

} // namespace ggrade::grading
