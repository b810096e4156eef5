#pragma once
/// \file
/// What stands in a cell: identifiers that are compared, text that no spreadsheet may run.

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

} // namespace ggrade::gradebook
