#pragma once
/// \file
/// What stands in a cell: identifiers that are compared, numbers, text that no spreadsheet may run.
/// All of it without any locale.

#include <optional>
#include <string>
#include <string_view>

namespace ggrade::gradebook {

/// Without blanks and line ends at the ends.
std::string_view trimmed(std::string_view text);

/// Full-width ASCII (U+FF01 to U+FF5E) and the ideographic space as ASCII, no blanks at the ends.
std::string narrow(std::string_view text);

/// As `narrow`, in lower case, runs of blanks as one: two headers that a person takes for the same
/// are equal.
std::string foldedHeader(std::string_view text);

/// What a student is compared by: "Participant 1234", "参加者１２３４" and "1234" are all "1234"
/// (Moodle writes the number behind its word for a hidden user). Other text comes back narrow.
std::string plainIdentifier(std::string_view text);

/// With an apostrophe in front if a spreadsheet could take the text for a formula: where the first
/// character is one of `= + - @` or their full-width forms, a tab or a line end, whatever blanks,
/// invisible characters and quotes stand before it (CWE-1236).
std::string neutralized(std::string_view text);

/// Plain text as one cell of HTML, which is what Moodle keeps feedback as: `&<>` as entities, line
/// ends as `<br>`, neutralized. Bytes that aren't UTF-8 and control characters become U+FFFD.
std::string feedbackCell(std::string_view text);

/// A decimal number such as "12", "-0.5" or "87.25", and nothing else around it; none for all other
/// text, exponents, "inf" and "nan" included.
std::optional<double> readNumber(std::string_view text);

/// A number as a worksheet writes it, with the mark that its site takes.
struct MarkedNumber {
  double value = 0;
  char mark = '.'; ///< `.` or `,`
};
/// "100", "100.00" and "100,00", with blanks around it. A number without decimals leaves the mark
/// open: it is `mark` then. None for text with several marks ("1,000.00").
std::optional<MarkedNumber> readMarkedNumber(std::string_view text, char mark);

/// At most two decimals, no exponent, no trailing zeros: "87.5", or "87,5" for the mark `,`.
/// \param value finite
std::string writeNumber(double value, char mark = '.');

} // namespace ggrade::gradebook
