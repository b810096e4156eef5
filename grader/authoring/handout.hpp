#pragma once
/// \file
/// Handouts: prose with code taken from the stub, so that no handout shows code that isn't there.

#include <filesystem>
#include <functional>
#include <string>

namespace ggrade::authoring {

/// Replaces every line `{{excerpt FILE "ANCHOR"}}` of `text` by a fenced code block: the lines of
/// `stub(FILE)` from the first one that contains ANCHOR to the end of what begins there (the line
/// that closes its braces, or the line itself). Throws UsageError as `name:line: ...` when the file
/// or the anchor isn't there.
std::string expandExcerpts(const std::string& text, const std::string& name,
                           const std::function<std::string(const std::string& file)>& stub);

} // namespace ggrade::authoring
