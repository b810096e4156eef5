#pragma once
/// \file
/// Places in a student's files, told as compilers tell them, so that editors find them:
/// "assignments/floor/floor.cpp:141:7: error: ...".

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::check {

struct Place {
  std::string file; ///< as it is printed, see `shown`
  int line = 0;     ///< from 1
  int column = 0;   ///< from 1; 0: unknown
};

/// What an editor lists.
struct Problem {
  Place place;
  std::string severity; ///< "error", "warning" or "note", as GCC has it in every language
  std::string text;     ///< one line
};

/// A path from the current folder, unless it lies elsewhere.
std::string shown(const std::filesystem::path& file);

/// "floor.cpp:141:7: error: text", without a column that isn't known.
std::string lineOf(const Problem& problem);
/// The other way, of GCC's lines and of shaders'; nothing for any other line.
std::optional<Problem> problemIn(const std::string& line);

/// Where a TODO is to be done in `files` of `folder`, one place a file: at the comment that begins
/// with "TODO(mirror.2):", or where that is gone after the last line before it that still stands
/// there. `stub` holds the files as they were handed out.
std::vector<Place> placesOf(const std::string& todo, const std::vector<std::string>& files,
                            const std::filesystem::path& stub, const std::filesystem::path& folder);

/// Puts first the one shader among them that names most of the samplers by which a pass reads: it
/// is the one that draws it. (Some names stand in what it includes.)
void putReaderFirst(std::vector<Place>& places, const std::set<std::string>& samplers);

/// The one of `todos` in whose place lies what a message names at its end, such as
/// "glClear(GL_DEPTH_BUFFER_BIT) (floor.cpp:12)": the last that begins there or before. Empty: it
/// names no place, or none begins before.
std::string todoAt(const std::string& message, const std::vector<std::string>& todos,
                   const std::filesystem::path& stub, const std::filesystem::path& folder);

/// The line of `text` at which what was line `number` of `stub` begins: after the nearest line
/// before it that stands in both once. Lines count from 1; nothing if no line is left.
std::optional<int> lineNow(std::string_view stub, std::string_view text, int number);

/// What compiler, shaders or OpenGL said of files by their names alone, with their paths from the
/// current folder in GCC's form. "(floor.cpp:12)" at a line's end, as OpenGL's errors have it, goes
/// to its begin.
std::string withPaths(const std::string& said, const std::filesystem::path& folder);

} // namespace ggrade::check
