#include "gradebook/csv.hpp"

#include "assignment/usage_error.hpp"
#include "gradebook/cells.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdexcept>

namespace ggrade::gradebook {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kDelimiters = ",;\t";

// LF, CRLF and CR count one each.
std::size_t lineEnds(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    count += text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'));
  return count;
}

bool needsQuotes(std::string_view text, std::string_view delimiters) {
  if (text.empty()) return false;
  return text.find_first_of(delimiters) != text.npos || text.find_first_of("\"\r\n") != text.npos ||
         text.front() == ' ' || text.back() == ' ' || text.starts_with(kByteOrderMark);
}

std::string quoted(std::string_view text) {
  std::string cell = "\"";
  for (const char c : text) {
    if (c == '"') cell += '"';
    cell += c;
  }
  return cell + '"';
}

} // namespace

std::string csvCell(std::string_view text, std::string_view delimiters) {
  return needsQuotes(text, delimiters) ? quoted(text) : std::string(text);
}

Csv::Csv(std::string_view bytes, const std::string& fileName)
    : fileName_(fileName), bytes_(bytes.substr(0, kMaxBytes)) {
  if (bytes.size() > kMaxBytes)
    throw UsageError(fmt::format("{}: {} bytes are more than the {} MiB that a table may have",
                                 fileName, bytes.size(), kMaxBytes >> 20));
  checkEncoding();
  if (bytes_.starts_with(kByteOrderMark)) start_ = kByteOrderMark.size();
  findDelimiter();
  read();
}

void Csv::checkEncoding() const {
  const std::string_view remedy = "save it as \"CSV UTF-8\" (in Excel: File, Save As)";
  const std::string_view text = bytes_;
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") || text.find('\0') != text.npos)
    throw UsageError(fmt::format("{}: this is UTF-16 or no text at all: {}", fileName_, remedy));
  const std::size_t valid = report::validUtf8(text);
  if (valid == text.size()) return;
  throw UsageError(
      fmt::format("{}: line {}: this is not UTF-8, Excel may have saved it in the encoding of the "
                  "computer (CP932, Shift_JIS): {}",
                  fileName_, lineEnds(text.substr(0, valid)) + 1, remedy));
}

void Csv::findDelimiter() {
  std::size_t counts[kDelimiters.size()] = {};
  bool inQuotes = false;
  for (std::size_t i = start_; i < bytes_.size(); ++i) {
    const char c = bytes_[i];
    if (c == '"') inQuotes = !inQuotes;
    if (inQuotes) continue;
    if (c == '\n' || c == '\r') break;
    const std::size_t known = kDelimiters.find(c);
    if (known != kDelimiters.npos) ++counts[known];
  }
  delimiter_ = kDelimiters[std::max_element(std::begin(counts), std::end(counts)) - counts];
}

void Csv::read() {
  std::size_t at = start_, line = 1;
  while (at < bytes_.size()) {
    if (rows_.size() == kMaxRows)
      throw UsageError(fmt::format("{}: line {}: a table may have {} rows at most; remove the rest",
                                   fileName_, line, kMaxRows));
    rows_.push_back({cells_.size(), line});
    for (std::size_t column = 1;; ++column) {
      if (column > kMaxColumns)
        throw UsageError(
            fmt::format("{}: line {}: a row may have {} columns at most; remove the rest",
                        fileName_, line, kMaxColumns));
      const std::size_t end = cellEnd(at, line, column);
      cells_.push_back({std::uint32_t(at), std::uint32_t(end)});
      line += lineEnds(std::string_view(bytes_).substr(at, end - at));
      at = end;
      if (at == bytes_.size() || bytes_[at] != delimiter_) break;
      ++at;
    }
    if (at < bytes_.size()) at += bytes_.compare(at, 2, "\r\n") == 0 ? 2 : 1;
    ++line;
  }
}

std::size_t Csv::cellEnd(std::size_t begin, std::size_t line, std::size_t column) const {
  const auto fault = [&](std::string_view what) {
    throw UsageError(fmt::format("{}: line {}: {} (column {}); a cell with quotes in it stands in "
                                 "quotes, and each of its own is doubled: \"a \"\"b\"\" c\"",
                                 fileName_, line, what, column));
  };
  const char stops[] = {delimiter_, '\r', '\n', '"', 0};
  if (begin == bytes_.size() || bytes_[begin] != '"') {
    const std::size_t end = std::min(bytes_.find_first_of(stops, begin), bytes_.size());
    if (end < bytes_.size() && bytes_[end] == '"')
      fault("a quote in a cell that doesn't start with one");
    return end;
  }
  std::size_t end = begin;
  do {
    end = bytes_.find('"', end + 1);
    if (end == bytes_.npos) fault("a quote is never closed");
    ++end; // behind the quote: another one would make it a quote of the text
  } while (end < bytes_.size() && bytes_[end] == '"');
  if (end < bytes_.size() && std::string_view(stops).find(bytes_[end]) == std::string_view::npos)
    fault("text after a closing quote");
  return end;
}

std::size_t Csv::columns(std::size_t row) const {
  const std::size_t first = rows_.at(row).firstCell;
  return (row + 1 < rows_.size() ? rows_[row + 1].firstCell : cells_.size()) - first;
}

std::size_t Csv::index(std::size_t row, std::size_t column) const {
  if (row >= rows_.size() || column >= columns(row))
    throw std::out_of_range(
        fmt::format("{} has no cell in row {}, column {}", fileName_, row, column));
  return rows_[row].firstCell + column;
}

bool Csv::isQuoted(const Range& cell) const {
  return cell.begin < cell.end && bytes_[cell.begin] == '"';
}

std::string Csv::cell(std::size_t row, std::size_t column) const {
  const std::size_t at = index(row, column);
  const auto replaced = replaced_.find(at);
  if (replaced != replaced_.end()) return replaced->second.text;
  const Range& range = cells_[at];
  if (!isQuoted(range)) return bytes_.substr(range.begin, range.end - range.begin);
  std::string text;
  for (std::size_t i = range.begin + 1; i + 1 < range.end; ++i) {
    text += bytes_[i];
    if (bytes_[i] == '"') ++i;
  }
  return text;
}

bool Csv::isBlank(std::size_t row) const {
  for (std::size_t column = 0; column < columns(row); ++column)
    if (!trimmed(cell(row, column)).empty()) return false;
  return true;
}

void Csv::set(std::size_t row, std::size_t column, std::string text) {
  const std::size_t at = index(row, column);
  if (report::validUtf8(text) < text.size() || text.find('\0') != text.npos)
    throw std::invalid_argument("a cell must be UTF-8 without NUL");
  replaced_.erase(at);
  if (cell(row, column) == text) return;
  // An empty cell alone in the last line would be no row any more.
  const bool alone = text.empty() && columns(row) == 1;
  replaced_[at] = {std::move(text), isQuoted(cells_[at]) || alone};
}

std::string Csv::bytes() const {
  std::string all;
  all.reserve(bytes_.size());
  std::size_t copied = 0;
  for (const auto& [at, replacement] : replaced_) {
    all.append(bytes_, copied, cells_[at].begin - copied);
    // In the first line any delimiter could be taken for the one of the table.
    const std::string_view delimiters =
        at < columns(0) ? kDelimiters : std::string_view(&delimiter_, 1);
    all += replacement.isQuoted ? quoted(replacement.text) : csvCell(replacement.text, delimiters);
    copied = cells_[at].end;
  }
  return all.append(bytes_, copied);
}

std::vector<std::size_t> columnsNamed(const Csv& csv, const std::string& fileName,
                                      const std::vector<std::string>& names, OtherColumns others) {
  const auto fault = [&](const std::string& what) {
    throw UsageError(fmt::format("{}:1: {}; the first line has the columns {}", fileName, what,
                                 fmt::join(names, ",")));
  };
  std::vector<std::size_t> found(names.size(), std::string::npos);
  for (std::size_t column = 0; csv.rows() > 0 && column < csv.columns(0); ++column) {
    const std::string header = csv.cell(0, column);
    const auto name = std::find(names.begin(), names.end(), foldedHeader(header));
    if (name == names.end()) {
      if (others == OtherColumns::refused)
        fault(fmt::format("unknown column \"{}\"", report::sanitizeLine(header)));
      continue;
    }
    std::size_t& place = found[name - names.begin()];
    if (place != std::string::npos) fault(fmt::format("two columns are called \"{}\"", *name));
    place = column;
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (found[i] == std::string::npos) fault(fmt::format("there is no column \"{}\"", names[i]));
  return found;
}

std::string cellOf(const Csv& csv, std::size_t row, std::size_t column) {
  return column < csv.columns(row) ? std::string(trimmed(csv.cell(row, column))) : "";
}

} // namespace ggrade::gradebook
