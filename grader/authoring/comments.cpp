#include "authoring/comments.hpp"

#include "authoring/solution_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

namespace ggrade::authoring {

namespace fs = std::filesystem;

namespace {

constexpr const char* kTable = "comments.ja.json";

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool isOfWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Where the comment of a line begins, not inside a literal; npos: it has none.
std::size_t commentAt(const std::string& line) {
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != '\0') {
      if (c == '\\')
        ++i;
      else if (c == quote)
        quote = '\0';
    } else if (c == '"' || (c == '\'' && (i == 0 || !isOfWord(line[i - 1])))) { // not 1'000
      quote = c;
    } else if (line.compare(i, 2, "//") == 0) {
      return i;
    }
  }
  return line.npos;
}

std::string markAt(const std::string& line, std::size_t column) {
  for (const char* mark : {"///<", "///"})
    if (line.compare(column, std::string_view(mark).size(), mark) == 0) return mark;
  return "//";
}

void addWords(std::string& text, const std::string& line) {
  std::istringstream in(line);
  for (std::string word; in >> word;) text += (text.empty() ? "" : " ") + word;
}

/// Neither (0,0) nor what clang-format writes at a namespace's end.
bool needsTranslation(const std::string& text) {
  return std::ranges::any_of(text, [](unsigned char c) { return std::isalpha(c) != 0; }) &&
         !text.starts_with("namespace");
}

} // namespace

std::vector<Comment> commentsIn(std::string_view source) {
  std::vector<Comment> comments;
  const std::vector<std::string> lines = linesOf(source);
  bool goesOn = false; // may the last one?
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const std::size_t column = isBlockMarker(line) ? line.npos : commentAt(line);
    if (column == line.npos) {
      goesOn = false;
      continue;
    }
    const std::string mark = markAt(line, column);
    const bool isAlone = line.find_first_not_of(" \t") == column;
    if (!goesOn || !isAlone || comments.back().column != column || comments.back().mark != mark)
      comments.push_back({i, 0, column, mark, ""});
    ++comments.back().count;
    addWords(comments.back().text, line.substr(column + mark.size()));
    goesOn = true;
  }
  return comments;
}

Translations translationsIn(const fs::path& solutions) {
  const fs::path file = solutions / kTable;
  if (!fs::exists(file)) return {};
  try {
    return readJson(file).get<Translations>();
  } catch (const nlohmann::json::exception& error) {
    throw UsageError(
        fmt::format("{}: must be lists of lines by comment: {}", file.string(), error.what()));
  }
}

std::string translated(std::string_view source, const Translations& translations) {
  const std::vector<std::string> lines = linesOf(source);
  std::string out;
  std::size_t next = 0;
  for (const Comment& comment : commentsIn(source)) {
    const auto found = translations.find(comment.text);
    if (found == translations.end()) continue;
    for (; next < comment.line; ++next) out += lines[next] + '\n';
    std::string before = lines[comment.line].substr(0, comment.column);
    for (const std::string& line : found->second) {
      out += before + comment.mark + (line.empty() ? "" : " ") + line + '\n';
      before.assign(comment.column, ' ');
    }
    next += comment.count;
  }
  for (; next < lines.size(); ++next) out += lines[next] + '\n';
  return out;
}

std::vector<std::string> outOfStep(const Assignment& assignment, const fs::path& solutions) {
  if (!fs::exists(solutions / kTable)) return {};
  const Translations translations = translationsIn(solutions);
  std::vector<std::string> all;
  std::set<std::string> used;
  for (const std::string& file : assignment.files)
    for (const Comment& comment : commentsIn(readFile(solutions / file))) {
      used.insert(comment.text);
      if (needsTranslation(comment.text) && !translations.contains(comment.text))
        all.push_back(fmt::format("{}:{}: this comment has no Japanese in {}: {}",
                                  (solutions / file).string(), comment.line + 1, kTable,
                                  comment.text));
    }
  for (const auto& [text, lines] : translations)
    if (!used.contains(text))
      all.push_back(fmt::format("{}: no file has this comment any more: {}",
                                (solutions / kTable).string(), text));
  return all;
}

} // namespace ggrade::authoring
