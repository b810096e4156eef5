#pragma once
/// \file
/// A shader's source as its functions and the rest.

#include <map>
#include <set>
#include <string>

namespace ggrade::repair {

/// A piece of a source: a function, from its type to its closing brace, or what stands below a
/// TODO.
struct GlslText {
  std::size_t begin = 0, end = 0; ///< in the source
  std::string words;              ///< its text without comments, one space between words
  std::set<std::string> lines{};  ///< likewise, line by line
};

/// By name; functions of one name are one entry each: "lit", "lit 2".
std::map<std::string, GlslText> functionsOf(const std::string& source);

/// A function in which several TODOs stand, cut at the comments that name them: by TODO, what
/// stands below its comment, down to the next or the function's end. Empty: it has fewer than two,
/// or one twice.
std::map<std::string, GlslText> stepsOf(const std::string& source, const GlslText& function);

/// The source without comments and functions: equal rests declare the same.
std::string restOf(const std::string& source);

/// The lines of the source that stand for something: without comments and lone braces.
std::set<std::string> linesOf(const std::string& source);

} // namespace ggrade::repair
