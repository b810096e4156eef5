#include "gradebook/cells.hpp"

#include "report/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace ggrade::gradebook {
namespace {

// UTF-8 of U+FF01 starts with EF BC 81, of U+FF40 with EF BD 80.
char narrowCharacter(std::string_view text) {
  if (text.starts_with("\u3000")) return ' ';
  if (text.size() < 3 || text[0] != '\xEF') return 0;
  const int low = static_cast<unsigned char>(text[2]) - 0x80;
  if (text[1] == '\xBC' && low >= 0x01 && low < 0x40) return char(0x20 + low);
  if (text[1] == '\xBD' && low >= 0 && low <= 0x1E) return char(0x60 + low);
  return 0;
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

// The one of `all` that the text starts with; empty if none.
template <std::size_t N>
std::string_view startOf(std::string_view text, const std::array<std::string_view, N>& all) {
  for (const std::string_view one : all)
    if (text.starts_with(one)) return one;
  return {};
}

// What spreadsheets and people overlook in front of a formula.
constexpr std::array<std::string_view, 18> kOverlooked = {
    " ",      "\"",     "'",      "\u00A0", "\u3000", "\u200B", "\u200C", "\u200D", "\u2060",
    "\uFEFF", "\u00AD", "\u2009", "\u202F", "\uFF02", "\uFF07", "\u201C", "\u201D", "\u2019"};
constexpr std::array<std::string_view, 16> kFormulaStarts = {
    "=",      "+",      "-",      "@",      "\t",     "\r",     "\n",     "\uFF1D",
    "\uFF0B", "\uFF0D", "\uFF20", "\u2212", "\uFE66", "\uFE62", "\uFE63", "\uFE6B"};

} // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

std::string narrow(std::string_view text) {
  std::string all;
  while (!text.empty()) {
    const char c = narrowCharacter(text);
    all += c ? c : text[0];
    text.remove_prefix(c ? 3 : 1);
  }
  return std::string(trimmed(all));
}

std::string foldedHeader(std::string_view text) {
  std::string folded;
  for (const char c : narrow(text)) {
    const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!blank) folded += lower(c);
    if (blank && folded.back() != ' ') folded += ' ';
  }
  return folded;
}

std::string plainIdentifier(std::string_view text) {
  const std::string plain = narrow(text);
  const std::string folded = foldedHeader(plain);
  for (const std::string_view word : {"participant", "参加者"}) {
    if (!folded.starts_with(word)) continue;
    const std::string number = narrow(std::string_view(folded).substr(word.size()));
    if (!number.empty() && number.find_first_not_of("0123456789") == number.npos) return number;
  }
  return plain;
}

std::string neutralized(std::string_view text) {
  std::string_view rest = text;
  for (std::string_view skip; !(skip = startOf(rest, kOverlooked)).empty();)
    rest.remove_prefix(skip.size());
  const bool runs = !startOf(rest, kFormulaStarts).empty();
  return runs ? "'" + std::string(text) : std::string(text);
}

std::string feedbackCell(std::string_view text) {
  std::string html;
  for (const char c : report::sanitize(text)) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else if (c == '\n')
      html += "<br>";
    else
      html += c;
  }
  return neutralized(html);
}

std::optional<double> readNumber(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value, std::chars_format::fixed);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) return {};
  return value;
}

std::optional<MarkedNumber> readMarkedNumber(std::string_view text, char mark) {
  std::string number = narrow(text);
  const std::size_t at = number.find_first_of(".,");
  if (at != number.npos) {
    mark = number[at];
    number[at] = '.';
  }
  const std::optional<double> value = readNumber(number);
  if (!value) return {};
  return MarkedNumber{*value, mark};
}

std::string writeNumber(double value, char mark) {
  std::string text = report::number(value, 2);
  std::replace(text.begin(), text.end(), '.', mark);
  return text;
}

} // namespace ggrade::gradebook
