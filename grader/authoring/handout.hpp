#pragma once
/// \file
/// Handouts: prose with code taken from the stub and points taken from assignment.json, so that no
/// handout shows what isn't so.

#include "assignment/assignment.hpp"
#include "words/words.hpp"

#include <functional>
#include <string>

namespace ggrade::authoring {

/// A language that texts are handed out in: how their files end, and what a text in the other one
/// says of this one.
struct Written {
  gg::Language language;
  const char *ending, *name;
};
inline constexpr Written kWritten[] = {{gg::Language::english, ".md", "English"},
                                       {gg::Language::japanese, ".ja.md", "日本語"}};

/// Replaces directives, each alone on its line. `{{excerpt FILE "ANCHOR"}}` becomes a fenced code
/// block: the lines of `stub(FILE)` from the first one that contains ANCHOR to the end of what
/// begins there (the line that closes its braces, or the line itself). `{{points PART}}` becomes a
/// table of the part's rubric items, `{{tradeoff PART}}` (or without a part) `measured(PART)`: what
/// was measured of time and error. Throws UsageError as `name:line: ...` when the file, the
/// anchor or the part isn't there.
std::string expandHandout(const std::string& text, const std::string& name,
                          const Assignment& assignment,
                          const std::function<std::string(const std::string& file)>& stub,
                          const std::function<std::string(const std::string& part)>& measured);

} // namespace ggrade::authoring
