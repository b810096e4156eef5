#pragma once
/// \file
/// A shader's source as its functions and the rest.

#include <map>
#include <set>
#include <string>

namespace ggrade::repair {

/// A function of a source, from its type to its closing brace.
struct GlslFunction {
  std::size_t begin = 0, end = 0; ///< in the source
  std::string words;              ///< its text without comments, one space between words
  std::set<std::string> lines{};  ///< likewise, line by line
};

/// By name; functions of one name are one entry each: "lit", "lit 2".
std::map<std::string, GlslFunction> functionsOf(const std::string& source);

/// The source without comments and functions: equal rests declare the same.
std::string restOf(const std::string& source);

/// The lines of the source that stand for something: without comments and lone braces.
std::set<std::string> linesOf(const std::string& source);

} // namespace ggrade::repair
