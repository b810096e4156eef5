#include "authoring/handout.hpp"

#include "assignment/assignment.hpp"

#include <fmt/format.h>

#include <regex>
#include <sstream>

namespace ggrade::authoring {

namespace {

/// The lines of `code` from the one with `anchor` to the one that closes the braces opened on the
/// way.
std::string excerpt(const std::string& code, const std::string& anchor) {
  std::istringstream in(code);
  std::string found;
  bool inside = false, opened = false;
  int depth = 0;
  for (std::string line; std::getline(in, line);) {
    if (!inside && line.find(anchor) == line.npos) continue;
    inside = true;
    found += line + '\n';
    for (char c : line.substr(0, line.find("//"))) {
      depth += c == '{' ? 1 : c == '}' ? -1 : 0;
      opened |= c == '{';
    }
    const std::size_t last = line.find_last_not_of(" \t");
    const bool statementEnds = last != line.npos && line[last] == ';';
    if (depth <= 0 && (opened || statementEnds)) return found;
  }
  return found;
}

} // namespace

std::string expandExcerpts(const std::string& text, const std::string& name,
                           const std::function<std::string(const std::string&)>& stub) {
  static const std::regex kDirective("\\{\\{excerpt ([A-Za-z0-9_.]+) \"([^\"]+)\"\\}\\}\\s*");
  std::istringstream in(text);
  std::string out;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::smatch match;
    if (!std::regex_match(line, match, kDirective)) {
      if (line.find("{{") != line.npos)
        throw UsageError(
            fmt::format("{}:{}: {} is not {{{{excerpt FILE \"ANCHOR\"}}}}", name, number, line));
      out += line + '\n';
      continue;
    }
    const std::string code = excerpt(stub(match[1]), match[2]);
    if (code.empty())
      throw UsageError(fmt::format("{}:{}: {} has no line with \"{}\"", name, number,
                                   match[1].str(), match[2].str()));
    const std::string file = match[1];
    out += fmt::format("```{}\n{}```\n", file.ends_with(".cpp") ? "cpp" : "glsl", code);
  }
  return out;
}

} // namespace ggrade::authoring
