#pragma once
/// \file
/// Text from people and programs that we don't trust, made safe to print anywhere.

#include <cstddef>
#include <string>
#include <string_view>

namespace ggrade::report {

/// Bytes of `text` before the first one that isn't UTF-8; all of them if it is UTF-8.
std::size_t validUtf8(std::string_view text);

/// Makes any bytes valid UTF-8 that shows what it holds.
/// Terminal escape sequences are taken out, CR and CRLF become LF. Bytes that aren't UTF-8, control
/// characters other than tab and LF, the characters that turn the direction of text (Trojan Source,
/// CVE-2021-42574), line separators and noncharacters each become U+FFFD. Never fails; the result
/// is allowed in XML 1.0.
std::string sanitize(std::string_view text);

/// As `sanitize`, on one line: runs of white space become one space, none at the ends. Longer than
/// `limit` code points: cut, with an ellipsis.
std::string sanitizeLine(std::string_view text, std::size_t limit = 400);

/// The first three quarters and the last quarter of `limit` bytes, cut between lines where a line
/// end is near, with a note of how much is left out between. Text that fits comes back unchanged.
/// \param text valid UTF-8
std::string capped(std::string text, std::size_t limit);

/// `&<>"'` as entities, for XML text and attributes. Calls `sanitize` first.
std::string escapeXml(std::string_view text);

/// A relative path as a URL: each byte outside `A-Za-z0-9-_.~/` is percent-encoded, so that no name
/// of a folder becomes a scheme, a query or a fragment.
std::string encodePath(std::string_view path);

/// Points and seconds as a person writes them: at most `decimals` decimals, no trailing zeros, no
/// "-0".
std::string number(double value, int decimals = 2);

/// A share as a percentage that never rounds a difference away: "0%", "<0.1%", "31%", "99.9%".
std::string percent(double share);

/// "build failed" for "build_failed".
std::string spaced(std::string_view name);

/// Columns that valid UTF-8 takes on a terminal: 2 for East Asian wide characters, 0 for combining
/// ones.
std::size_t displayWidth(std::string_view text);

} // namespace ggrade::report
