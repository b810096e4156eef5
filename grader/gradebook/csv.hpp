#pragma once
/// \file
/// Comma-separated values (RFC 4180) that keep their bytes, and tables in them whose columns have
/// names.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::gradebook {

/// A table whose cells are read decoded and replaced one by one. All bytes but those of replaced
/// cells stay as they were: byte-order mark, line ends (LF, CRLF, CR, mixed), quotes where none are
/// needed, empty lines, a missing line end at the end.
///
/// The delimiter is the one of `,` `;` and tab that splits the first line into most cells. An empty
/// line is a row with one empty cell. Rows may differ in length.
class Csv {
public:
  static constexpr std::size_t kMaxBytes = 64u << 20;
  static constexpr std::size_t kMaxRows = 100'000;
  static constexpr std::size_t kMaxColumns = 1000;

  /// Throws UsageError with the file, the line and the remedy for what is not UTF-8, for quotes
  /// that are never closed or stand in the middle of a cell, and for more than the limits above.
  Csv(std::string_view bytes, const std::string& fileName);

  std::size_t rows() const { return rows_.size(); }
  std::size_t columns(std::size_t row) const;
  /// Line of the file on which the row starts, from 1. Cells with line ends in them make it differ
  /// from the number of the row.
  std::size_t line(std::size_t row) const { return rows_.at(row).line; }
  char delimiter() const { return delimiter_; }

  /// The text without the quotes around it. Throws std::out_of_range if there is no such cell.
  std::string cell(std::size_t row, std::size_t column) const;
  /// Whether all cells of the row are empty or blank.
  bool isBlank(std::size_t row) const;
  /// Replaces one cell; it is quoted if it was or if the text needs it. Throws std::out_of_range if
  /// there is no such cell, std::invalid_argument for what is not UTF-8 or holds NUL.
  void set(std::size_t row, std::size_t column, std::string text);

  std::string bytes() const;

private:
  struct Row {
    std::size_t firstCell, line;
  };
  struct Range {
    std::uint32_t begin, end; // in bytes_, with the quotes
  };
  struct Replacement {
    std::string text;
    bool isQuoted; // whether or not the text needs it
  };
  void checkEncoding() const;
  void findDelimiter();
  void read();
  std::size_t cellEnd(std::size_t begin, std::size_t line, std::size_t column) const;
  std::size_t index(std::size_t row, std::size_t column) const;
  bool isQuoted(const Range& cell) const;

  std::string fileName_, bytes_;
  std::size_t start_ = 0; // of the first cell, after the byte-order mark
  char delimiter_ = ',';
  std::vector<Row> rows_;
  std::vector<Range> cells_;
  std::map<std::size_t, Replacement> replaced_; // by index in cells_
};

/// `text` as one cell: quoted if it holds one of `delimiters`, a quote or a line end, or starts or
/// ends with a blank.
std::string csvCell(std::string_view text, std::string_view delimiters = ",;\t");

enum class OtherColumns { allowed, refused };

/// Where the columns `names` stand in the first row, whatever their order and case. Throws
/// UsageError with the file and the header to write if one is missing, stands there twice or is
/// none of them.
std::vector<std::size_t> columnsNamed(const Csv& csv, const std::string& fileName,
                                      const std::vector<std::string>& names, OtherColumns others);

/// The cell without blanks at its ends; empty where the row is too short.
std::string cellOf(const Csv& csv, std::size_t row, std::size_t column);

} // namespace ggrade::gradebook
