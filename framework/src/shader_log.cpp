#include "shader_log.hpp"

#include <optional>
#include <regex>

#include <fmt/format.h>

namespace gg::detail {

namespace {

struct Diagnosis {
  int line = 0;           // as #line numbers it
  int column = 0;         // from 1; 0 if unknown
  bool collapsed = false; // the column counts each run of blanks as one
  std::string kind;       // error or warning
  std::string message;
};

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::optional<Diagnosis> parse(const std::string& line) {
  constexpr std::size_t kLongest = 1000; // std::regex recurses once a character
  if (line.size() > kLongest) return {};
  // Mesa: 0:12(5): error: `foo' undeclared
  static const std::regex mesa(R"(\d+:(\d+)\((\d+)\): (?:preprocessor )?(error|warning): (.*))");
  // NVIDIA: 0(12) : error C1503: undefined variable "foo"
  static const std::regex nvidia(R"(\d+\((\d+)\) : (?:fatal )?(error|warning)(?: C\d+)?: (.*))");
  // AMD, Intel, Apple: ERROR: 0:12: 'foo' : undeclared identifier
  static const std::regex others(R"((ERROR|WARNING): \d+:(\d+): (.*))");
  std::smatch match;
  const auto number = [&](int group) {
    const std::string digits = match[group];
    return digits.size() < 9 ? std::stoi(digits) : 0;
  };
  if (std::regex_match(line, match, mesa))
    return Diagnosis{number(1), number(2), true, match[3], match[4]};
  if (std::regex_match(line, match, nvidia))
    return Diagnosis{number(1), 0, false, match[2], match[3]};
  if (std::regex_match(line, match, others))
    return Diagnosis{number(2), 0, false, lower(match[1]), match[3]};
  return {};
}

// Mesa's preprocessor makes one space of each run of blanks before the compiler counts columns.
int originalColumn(const std::string& line, int column) {
  const auto isBlank = [&](std::size_t i) { return line[i] == ' ' || line[i] == '\t'; };
  std::size_t at = 0;
  for (int counted = 1; counted < column && at < line.size(); ++counted) {
    if (!isBlank(at++)) continue;
    while (at < line.size() && isBlank(at)) ++at;
  }
  return static_cast<int>(at) + 1;
}

// The spaces that bring a caret under the column: tabs stay tabs, so that it lines up.
std::string indent(const std::string& line, int column) {
  std::string spaces;
  for (int i = 0; i + 1 < column && i < static_cast<int>(line.size()); ++i)
    spaces += line[static_cast<std::size_t>(i)] == '\t' ? '\t' : ' ';
  return spaces;
}

std::string describe(const Diagnosis& diagnosis, const ShaderSource& source) {
  const auto file = static_cast<std::size_t>(diagnosis.line / ShaderSource::kLinesPerFile);
  const auto line = static_cast<std::size_t>(diagnosis.line % ShaderSource::kLinesPerFile);
  if (file >= source.files.size())
    return fmt::format("{}: {}\n", diagnosis.kind, diagnosis.message);

  const ShaderFile& where = source.files[file];
  const bool isLine = line >= 1 && line <= where.lines.size();
  const std::string written = isLine ? where.lines[line - 1] : "";
  const int column =
      diagnosis.collapsed && isLine ? originalColumn(written, diagnosis.column) : diagnosis.column;
  std::string text = fmt::format("{}:{}", where.name, line);
  if (column > 0) text += fmt::format(":{}", column);
  text += fmt::format(": {}: {}\n", diagnosis.kind, diagnosis.message);
  if (isLine) text += written + "\n";
  if (isLine && column > 0) text += indent(written, column) + "^\n";
  return text;
}

} // namespace

std::string translateLog(std::string_view log, const ShaderSource& source, bool onlyWarnings) {
  constexpr int kMost = 20; // one mistake can make hundreds of messages
  std::string text;
  int count = 0;
  for (std::size_t start = 0; start < log.size() && count < kMost;) {
    const std::size_t end = std::min(log.find('\n', start), log.size());
    std::string line(log.substr(start, end - start));
    start = end + 1;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\0'))
      line.pop_back();
    if (line.empty()) continue;
    const std::optional<Diagnosis> diagnosis = parse(line);
    if (onlyWarnings && (!diagnosis || diagnosis->kind != "warning")) continue;
    text += diagnosis ? describe(*diagnosis, source) : line + "\n";
    ++count;
  }
  return text;
}

} // namespace gg::detail
