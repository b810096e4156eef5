#include "repair/glsl.hpp"

#include <cctype>

namespace ggrade::repair {

namespace {

/// Comments become spaces, so that places stay.
std::string withoutComments(std::string text) {
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != '/') continue;
    std::size_t end = i;
    if (text[i + 1] == '/')
      end = std::min(text.find('\n', i), text.size());
    else if (text[i + 1] == '*')
      end = text.find("*/", i + 2) == text.npos ? text.size() : text.find("*/", i + 2) + 2;
    for (; i < end; ++i)
      if (text[i] != '\n') text[i] = ' ';
  }
  return text;
}

std::string wordsOf(const std::string& text) {
  std::string words;
  const auto isName = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  bool space = false;
  for (const char c : text) {
    if (std::isspace(static_cast<unsigned char>(c))) {
      space = true;
      continue;
    }
    if (space && !words.empty() && isName(words.back()) && isName(c)) words += ' ';
    space = false;
    words += c;
  }
  return words;
}

/// The lines from `begin` to `end` that hold more than a brace, each as its words.
std::set<std::string> linesIn(const std::string& text, std::size_t begin, std::size_t end) {
  std::set<std::string> lines;
  for (std::size_t at = begin; at < end;) {
    const std::size_t line = std::min(text.find('\n', at), end);
    if (std::string words = wordsOf(text.substr(at, line - at)); words.size() > 1)
      lines.insert(std::move(words));
    at = line + 1;
  }
  return lines;
}

/// The closing bracket to the one at `open`, or the end.
std::size_t closing(const std::string& text, std::size_t open, char opens, char closes) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == opens) ++depth;
    if (text[i] == closes && --depth == 0) return i;
  }
  return text.size();
}

/// Where the declaration begins that ends at `end`.
std::size_t declarationStart(const std::string& text, std::size_t end) {
  std::size_t start = text.find_last_of(";}\n", end == 0 ? 0 : end - 1);
  start = start == text.npos ? 0 : start + 1;
  while (start < end && std::isspace(static_cast<unsigned char>(text[start]))) ++start;
  return start;
}

} // namespace

std::map<std::string, GlslText> functionsOf(const std::string& source) {
  std::map<std::string, GlslText> functions;
  const std::string text = withoutComments(source);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{') { // a block or struct at the outermost level
      i = closing(text, i, '{', '}');
      continue;
    }
    if (text[i] != '(') continue;
    const std::size_t end = closing(text, i, '(', ')');
    const std::size_t body = text.find_first_not_of(" \t\r\n", end + 1);
    if (body == text.npos || text[body] != '{') {
      i = end;
      continue;
    }
    std::size_t nameEnd = i;
    while (nameEnd > 0 && std::isspace(static_cast<unsigned char>(text[nameEnd - 1]))) --nameEnd;
    std::size_t nameStart = nameEnd;
    while (nameStart > 0 && (std::isalnum(static_cast<unsigned char>(text[nameStart - 1])) ||
                             text[nameStart - 1] == '_'))
      --nameStart;
    GlslText function;
    function.begin = declarationStart(text, nameStart);
    function.end = std::min(closing(text, body, '{', '}') + 1, text.size());
    function.words = wordsOf(text.substr(function.begin, function.end - function.begin));
    function.lines = linesIn(text, function.begin, function.end);
    const std::string name = text.substr(nameStart, nameEnd - nameStart);
    std::string key = name;
    for (int k = 2; functions.contains(key); ++k) key = name + ' ' + std::to_string(k);
    i = function.end - 1;
    functions.emplace(key, std::move(function));
  }
  return functions;
}

std::map<std::string, GlslText> stepsOf(const std::string& source, const GlslText& function) {
  static const std::string kMark = "TODO(";
  if (source.find(kMark, function.begin) >= function.end) return {}; // as most are
  const std::string text = withoutComments(source);
  const auto find = [&](std::size_t from) {
    std::size_t at = source.find(kMark, from);
    while (at < function.end && text[at] != ' ') at = source.find(kMark, at + 1); // no comment
    return std::min(at, function.end);
  };
  std::map<std::string, GlslText> steps;
  for (std::size_t at = find(function.begin), next; at < function.end; at = next) {
    next = find(at + 1);
    const std::size_t name = at + kMark.size();
    const std::size_t close = source.find(')', name);
    const auto [step, isNew] =
        steps.try_emplace(source.substr(name, close - name), GlslText{at, next, {}, {}});
    if (!isNew) return {};
    step->second.words = wordsOf(text.substr(at, next - at));
    step->second.lines = linesIn(text, at, next);
  }
  if (steps.size() < 2) steps.clear();
  return steps;
}

std::string restOf(const std::string& source) {
  std::string text = withoutComments(source);
  for (const auto& [name, function] : functionsOf(source))
    for (std::size_t i = function.begin; i < function.end; ++i) text[i] = ' ';
  return wordsOf(text);
}

std::set<std::string> linesOf(const std::string& source) {
  return linesIn(withoutComments(source), 0, source.size());
}

} // namespace ggrade::repair
