#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

namespace ggrade::report {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD"; // U+FFFD

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t bytes = 0; // 0: not UTF-8
};

// The shortest form only, no surrogates, at most U+10FFFF (Unicode 15, table 3-7).
CodePoint decode(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + bytes > text.size()) return {};
  std::uint32_t value = first & (0xFFu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    value = value << 6 | (byte(i) & 0x3F);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < kSmallest[bytes] || surrogate || value > 0x10FFFF) return {};
  return {value, bytes};
}

bool isBidiControl(std::uint32_t c) {
  return c == 0x061C || c == 0x200E || c == 0x200F || (c >= 0x202A && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069);
}

bool isPlain(char c) {
  return (c >= 0x20 && c < 0x7F) || c == '\t' || c == '\n';
}

bool isPrintable(std::uint32_t c) {
  if (c == '\t' || c == '\n') return true;
  if (c < 0x20 || (c >= 0x7F && c < 0xA0)) return false;
  if (c == 0x2028 || c == 0x2029 || c == 0xFEFF || isBidiControl(c)) return false;
  const bool tag = c >= 0xE0000 && c <= 0xE007F; // invisible copies of ASCII
  const bool noncharacter = (c & 0xFFFE) == 0xFFFE || (c >= 0xFDD0 && c <= 0xFDEF);
  return !tag && !noncharacter;
}

// The end of the escape sequence that starts at `at` (ECMA-48). One that is never ended stops at
// the end of its line, so that it cannot hide what follows.
std::size_t skipEscape(std::string_view text, std::size_t at) {
  std::size_t i = at + 1;
  if (i == text.size()) return i;
  const char kind = text[i++];
  if (kind == '[') {
    while (i < text.size() && text[i] >= 0x20 && text[i] < 0x40) ++i;
    return i < text.size() && text[i] >= 0x40 && text[i] < 0x7F ? i + 1 : i;
  }
  if (kind == ']' || kind == 'P' || kind == 'X' || kind == '^' || kind == '_') {
    for (; i < text.size() && text[i] != '\n'; ++i) {
      if (text[i] == '\a') return i + 1;
      if (text[i] == '\x1B' && i + 1 < text.size() && text[i + 1] == '\\') return i + 2;
    }
    return i;
  }
  return kind >= 0x20 && kind < 0x7F ? i : at + 1;
}

// Where text may be cut near `at`: after a line end within `slack` bytes, or between code points.
std::size_t cutBefore(const std::string& text, std::size_t at, std::size_t slack) {
  const std::size_t line = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  if (line != std::string::npos && at - line <= slack) return line + 1;
  while (at > 0 && (text[at] & 0xC0) == 0x80) --at;
  return at;
}

} // namespace

std::size_t validUtf8(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const std::size_t bytes = decode(text, i).bytes;
    if (bytes == 0) break;
    i += bytes;
  }
  return i;
}

std::string sanitize(std::string_view text) {
  // Most text, and every picture in a page, is fine as it is.
  if (std::ranges::all_of(text, isPlain)) return std::string(text);
  std::string clean;
  clean.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '\x1B') {
      i = skipEscape(text, i);
      continue;
    }
    if (text[i] == '\r') {
      if (i + 1 == text.size() || text[i + 1] != '\n') clean += '\n';
      ++i;
      continue;
    }
    const CodePoint c = decode(text, i);
    if (c.bytes > 0 && isPrintable(c.value)) {
      clean += text.substr(i, c.bytes);
    } else {
      clean += kReplacement;
    }
    i += std::max<std::size_t>(c.bytes, 1);
  }
  return clean;
}

std::string sanitizeLine(std::string_view text, std::size_t limit) {
  const std::string clean = sanitize(text);
  std::string line;
  std::size_t count = 0;
  bool space = false;
  for (std::size_t i = 0; i < clean.size();) {
    const std::size_t bytes = decode(clean, i).bytes;
    if (clean[i] == ' ' || clean[i] == '\n' || clean[i] == '\t') {
      space = !line.empty();
    } else {
      if (count + (space ? 1 : 0) >= limit) return line + "…";
      if (space) line += ' ', ++count;
      line.append(clean, i, bytes), ++count;
      space = false;
    }
    i += bytes;
  }
  return line;
}

std::string capped(std::string text, std::size_t limit) {
  if (text.size() <= limit) return text;
  const std::size_t head = cutBefore(text, limit / 4 * 3, 400);
  const std::size_t tail = std::max(head, cutBefore(text, text.size() - limit / 4, 400));
  const std::size_t left = tail - head;
  return text.substr(0, head) +
         fmt::format("\n[... {} of {} bytes are left out here ...]\n", left, text.size()) +
         text.substr(tail);
}

std::string escapeXml(std::string_view text) {
  std::string out;
  for (const char c : sanitize(text)) {
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    case '\'':
      out += "&#39;";
      break;
    default:
      out += c;
    }
  }
  return out;
}

std::string encodePath(std::string_view path) {
  std::string url;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-_.~/").find(c) != std::string_view::npos;
    if (plain) {
      url += c;
    } else {
      url += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return url;
}

std::string number(double value, int decimals) {
  if (!std::isfinite(value)) return "?";
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string percent(double share) {
  if (!std::isfinite(share)) return "?%";
  const double value = std::clamp(share, 0.0, 1.0) * 100;
  if (value == 0 || value == 100) return number(value, 0) + "%";
  if (value < 0.1) return "<0.1%";
  if (value > 99.9) return ">99.9%";
  return number(value, 1) + "%";
}

std::string spaced(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::size_t displayWidth(std::string_view text) {
  struct Range {
    std::uint32_t first, last;
  };
  // East Asian Width W and F, and emoji presentation, in the blocks that names and messages use.
  constexpr Range kWide[] = {
      {0x1100, 0x115F},   {0x2E80, 0x303E},   {0x3041, 0x33FF},   {0x3400, 0x4DBF},
      {0x4E00, 0x9FFF},   {0xA000, 0xA4CF},   {0xA960, 0xA97F},   {0xAC00, 0xD7A3},
      {0xF900, 0xFAFF},   {0xFE30, 0xFE6F},   {0xFF00, 0xFF60},   {0xFFE0, 0xFFE6},
      {0x1F300, 0x1F64F}, {0x1F680, 0x1F6FF}, {0x1F900, 0x1FAFF}, {0x20000, 0x3FFFD}};
  constexpr Range kZero[] = {{0x0300, 0x036F}, {0x1AB0, 0x1AFF}, {0x1DC0, 0x1DFF},
                             {0x200B, 0x200D}, {0x20D0, 0x20FF}, {0x3099, 0x309A},
                             {0xFE00, 0xFE0F}, {0xFE20, 0xFE2F}};
  const auto within = [](const auto& ranges, std::uint32_t c) {
    return std::any_of(std::begin(ranges), std::end(ranges),
                       [c](const Range& r) { return c >= r.first && c <= r.last; });
  };
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = decode(text, i);
    i += std::max<std::size_t>(c.bytes, 1);
    width += within(kZero, c.value) ? 0 : within(kWide, c.value) ? 2 : 1;
  }
  return width;
}

} // namespace ggrade::report
