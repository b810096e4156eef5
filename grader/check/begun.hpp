#pragma once
/// \file
/// Which TODOs somebody has begun, told from the text of the files.

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::check {

struct Begun {
  std::set<std::string> certain;
  /// Their comments were taken out where something is written now; or something new stands below
  /// them, where the file as handed out has them elsewhere: it is of another edition of the kit.
  std::set<std::string> possible;
};

/// The TODOs in whose places statements of `text` differ from `stub`, the file as it was handed
/// out; neither layout nor comments count, nor where a given statement stands. A place begins at a
/// comment line that names one TODO, "TODO(mirror.3)" (or DONE, where it comes filled in), and ends
/// at the next one that names any; one that names several is nobody's. A statement right above a
/// comment that begins with the TODO is changed for its sake. What is written between two
/// statements of the stub also belongs to the
/// TODO whose comment there has a name of the code that no other comment there has and that is used
/// in it, wherever it stands among them.
Begun begunIn(std::string_view stub, std::string_view text);

/// Those of all files that stand in both folders.
Begun begun(const std::filesystem::path& stub, const std::filesystem::path& folder);

} // namespace ggrade::check
