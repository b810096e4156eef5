#pragma once
/// \file
/// Which TODOs somebody has begun, told from the text of the files.

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::check {

/// The TODOs in whose places `text` differs from `stub`, the file as it was handed out. A place
/// begins at a comment that names one TODO, "TODO(mirror.3)" (or DONE, where it comes filled in),
/// and ends at the next one that names any; one that names several is nobody's. A statement right
/// above a comment that begins with the
/// TODO is changed for its sake. White space and lines that were only taken out (a comment, once it
/// has been read) don't count.
std::set<std::string> begunIn(std::string_view stub, std::string_view text);

/// Those of all files that stand in both folders.
std::set<std::string> begun(const std::filesystem::path& stub, const std::filesystem::path& folder);

} // namespace ggrade::check
