#pragma once
/// \file
/// Wrong programs that nobody has thought of: changes of single lines of a solution, drawn by a
/// seed. What is wrong in one is known: the TODO in whose block the line stands.

#include "assignment/assignment.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ggrade::generated {

/// A change of one line, or of two that follow each other, in a block that students write.
struct Mutant {
  std::string todo;                       ///< "mirror.5"
  std::string file;                       ///< of the solution, "mirror.hpp"
  int line = 0;                           ///< of the solution's file, from 1
  std::string change;                     ///< what kind: "another constant of OpenGL"
  std::vector<std::string> before, after; ///< lines

  bool operator==(const Mutant&) const = default;
};

/// `count` of them, or all that there are: for each the TODO is drawn first, then the kind of
/// change, then the place; constants would be most of them otherwise. Some don't compile, and some
/// change nothing. The same solution and the same seed draw the same on every machine. Throws
/// UsageError for a solution whose blocks aren't closed.
std::vector<Mutant> drawMutants(const Assignment& assignment, const Part& part,
                                const std::filesystem::path& solutionFolder, std::size_t count,
                                std::uint64_t seed);

/// The text of the solution's file with the change in it. Throws std::invalid_argument where the
/// lines aren't there.
std::string withChange(const std::string& text, const Mutant& mutant);

/// "mirror.hpp:57: `a` -> `b`", on one line.
std::string describe(const Mutant& mutant);

} // namespace ggrade::generated
