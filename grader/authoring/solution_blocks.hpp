#pragma once
/// \file
/// The marked places in a solution from which the student's stub is made.
///
/// A block is the lines between a comment `BEGIN SOLUTION(mirror.2)` and `END SOLUTION(mirror.2)`,
/// each alone on its line after `//`. Blocks don't nest; one TODO may have several blocks.

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::authoring {

/// A line of a solution's file.
struct BlockLine {
  std::string text;    ///< without the line's end
  std::string todo;    ///< in whose block it is; empty outside of blocks
  bool marker = false; ///< does a block begin or end here?
};

/// All lines in their order. Throws like withFilled.
std::vector<BlockLine> blockLines(std::string_view text, const std::string& file);

/// Does a block begin or end in this line?
bool isBlockMarker(const std::string& line);

/// The text with the blocks of `filled` kept and all others taken out; no marker stays. Where a
/// block goes, two blank lines that meet become one. Throws UsageError as `file:line: ...` for a
/// block that is not closed, closed twice or nested.
std::string withFilled(std::string_view text, const std::string& file,
                       const std::set<std::string>& filled);

/// The text of every block (without markers), in order. Throws like withFilled.
std::vector<std::string> blocks(std::string_view text, const std::string& file);

/// The text of all blocks of each TODO that has any (without markers). Throws like withFilled.
std::map<std::string, std::string> blocksByTodo(std::string_view text, const std::string& file);

/// From and to of each string in a line of code.
std::vector<std::pair<std::size_t, std::size_t>> stringsOf(const std::string& line);

/// How many characters of a line are code: the rest is a comment.
std::size_t codeLength(const std::string& line);

/// Is the line a whole statement that declares nothing and doesn't jump, such as a call or an
/// assignment?
bool isPlainStatement(const std::string& line);

} // namespace ggrade::authoring
