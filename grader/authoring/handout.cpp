#include "authoring/handout.hpp"

#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
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

std::string fenced(const std::string& file, const std::string& code) {
  const bool glsl = file.ends_with(".vert") || file.ends_with(".frag") || file.ends_with(".glsl");
  return fmt::format("```{}\n{}```\n", glsl ? "glsl" : "cpp", code);
}

/// A row an item: points, what must be so, the step to read.
std::string pointsTable(const Part& part) {
  std::string table = gg::say("| points | what | step |") + "\n| ---: | --- | --- |\n";
  for (const ItemDeclaration& item : part.items) {
    const bool keep = item.kind == results::ItemKind::keep;
    const bool bonus = item.kind == results::ItemKind::bonus;
    table += fmt::format("| {}{} | {} | {} |\n",
                         keep    ? "−"
                         : bonus ? "+"
                                 : "",
                         item.points,
                         bonus                ? gg::say("{} (bonus)", item.title)
                         : item.beyondLecture ? gg::say("{} (beyond the lecture)", item.title)
                                              : item.title,
                         item.step.substr(item.step.find('.') + 1));
  }
  return table;
}

} // namespace

std::string expandHandout(const std::string& text, const std::string& name,
                          const Assignment& assignment,
                          const std::function<std::string(const std::string&)>& stub,
                          const std::function<std::string(const std::string&)>& measured) {
  static const std::regex kExcerpt("\\{\\{excerpt ([A-Za-z0-9_.]+) \"([^\"]+)\"\\}\\}\\s*");
  static const std::regex kTradeoff("\\{\\{tradeoff( [a-z0-9_]+)?\\}\\}\\s*");
  static const std::regex kPoints("\\{\\{points ([a-z0-9_]+)\\}\\}\\s*");
  std::istringstream in(text);
  std::string out;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const auto problem = [&](const std::string& what) {
      return UsageError(fmt::format("{}:{}: {}", name, number, what));
    };
    std::smatch match;
    if (std::regex_match(line, match, kExcerpt)) {
      const std::string file = match[1], anchor = match[2];
      const std::string code = excerpt(stub(file), anchor);
      if (code.empty()) throw problem(fmt::format("{} has no line with \"{}\"", file, anchor));
      out += fenced(file, code);
    } else if (std::regex_match(line, match, kPoints)) {
      const auto part = std::find_if(assignment.parts.begin(), assignment.parts.end(),
                                     [&](const Part& p) { return p.id == match[1]; });
      if (part == assignment.parts.end())
        throw problem(fmt::format("{} has no part {}", assignment.id, match[1].str()));
      out += pointsTable(*part);
    } else if (std::regex_match(line, match, kTradeoff)) {
      const std::string part = match[1].length() > 0 ? match[1].str().substr(1) : "";
      const std::string text = measured(part);
      if (text.empty())
        throw problem(fmt::format("{}: nothing was measured; ggrade tradeoff {} --adopt does it",
                                  line, assignment.id));
      out += text;
    } else if (line.find("{{") != line.npos) {
      throw problem(line + " is none of {{excerpt FILE \"ANCHOR\"}}, {{points PART}}, "
                           "{{tradeoff PART}} and {{tradeoff}}");
    } else {
      out += line + '\n';
    }
  }
  return out;
}

} // namespace ggrade::authoring
