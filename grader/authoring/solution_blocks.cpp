#include "authoring/solution_blocks.hpp"

#include "assignment/assignment.hpp"

#include <fmt/format.h>

#include <regex>

namespace ggrade::authoring {

namespace {

const std::regex& marker() {
  static const std::regex kMarker(R"(\s*//\s*(BEGIN|END) SOLUTION\(([a-z0-9_]+\.[0-9]+)\)\s*)");
  return kMarker;
}

} // namespace

std::vector<BlockLine> blockLines(std::string_view text, const std::string& file) {
  std::vector<BlockLine> lines;
  std::string open;
  std::size_t openedAt = 0;
  for (std::size_t start = 0; start < text.size();) {
    std::size_t end = text.find('\n', start);
    if (end == text.npos) end = text.size();
    std::string line(text.substr(start, end - start));
    start = end + 1;
    const std::size_t number = lines.size() + 1;
    std::smatch match;
    if (!std::regex_match(line, match, marker())) {
      lines.push_back({line, open, false});
      continue;
    }
    const std::string todo = match[2];
    if (match[1] == "BEGIN") {
      if (!open.empty())
        throw UsageError(fmt::format("{}:{}: SOLUTION({}) begins inside SOLUTION({}) of line {}",
                                     file, number, todo, open, openedAt));
      open = todo;
      openedAt = number;
    } else {
      if (open != todo)
        throw UsageError(
            fmt::format("{}:{}: END SOLUTION({}) has no BEGIN before it", file, number, todo));
      open.clear();
    }
    lines.push_back({line, todo, true});
  }
  if (!open.empty())
    throw UsageError(fmt::format("{}:{}: SOLUTION({}) is never closed", file, openedAt, open));
  return lines;
}

bool isBlockMarker(const std::string& line) {
  return std::regex_match(line, marker());
}

std::string withFilled(std::string_view text, const std::string& file,
                       const std::set<std::string>& filled) {
  std::string out;
  bool removed = false; // was something taken out since the last line written?
  bool blank = true;    // was the last line written blank?
  for (const BlockLine& line : blockLines(text, file)) {
    if (line.marker || (!line.todo.empty() && !filled.count(line.todo))) {
      removed = true;
      continue;
    }
    const bool nowBlank = line.text.find_first_not_of(" \t\r") == line.text.npos;
    if (!(removed && blank && nowBlank)) {
      out += line.text + '\n';
      blank = nowBlank;
    }
    removed = false;
  }
  return out;
}

std::vector<std::string> blocks(std::string_view text, const std::string& file) {
  std::vector<std::string> found;
  for (const BlockLine& line : blockLines(text, file)) {
    if (line.marker) {
      if (line.text.find("BEGIN") != line.text.npos) found.emplace_back();
    } else if (!line.todo.empty()) {
      found.back() += line.text + '\n';
    }
  }
  return found;
}

std::map<std::string, std::string> blocksByTodo(std::string_view text, const std::string& file) {
  std::map<std::string, std::string> found;
  for (const BlockLine& line : blockLines(text, file))
    if (!line.marker && !line.todo.empty()) found[line.todo] += line.text + '\n';
  return found;
}

std::vector<std::pair<std::size_t, std::size_t>> stringsOf(const std::string& line) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t at = 0; (at = line.find('"', at)) != line.npos; ++at) {
    std::size_t end = at + 1;
    while (end < line.size() && line[end] != '"') end += line[end] == '\\' ? 2 : 1;
    found.emplace_back(at, end);
    at = end;
  }
  return found;
}

std::size_t codeLength(const std::string& line) {
  const auto strings = stringsOf(line);
  for (std::size_t at = 0; (at = line.find("//", at)) != line.npos; at += 2)
    if (std::ranges::none_of(strings,
                             [&](const auto& one) { return one.first < at && at < one.second; }))
      return at;
  return line.size();
}

bool isPlainStatement(const std::string& line) {
  static const std::regex kStatement(
      R"(\s+(?!(?:return|throw|else|case|using|const|for|if|while|break|continue|discard|struct|in|out|)"
      R"(uniform|auto|static)\b)[\w:.\->\[\]]+)"
      R"((?: [-+*/|&]?= [^{};]+|\([^{};]*\)(?:\.[^{};]+)?|\+\+|--);\s*)");
  static const std::regex kDeclaration(R"(\s+[\w:<>,]+[&*]? \w+(?:\[\w*\])?(?: = .*|\(.*\))?;\s*)");
  const std::string code = line.substr(0, codeLength(line));
  return std::regex_match(code, kStatement) && !std::regex_match(code, kDeclaration);
}

} // namespace ggrade::authoring
