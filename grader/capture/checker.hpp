#pragma once
/// \file
/// Checks of what the captured process claims.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>

namespace ggrade::channel {

/// `text` as valid UTF-8 that is safe to print: every byte that is no part of a character (overlong
/// forms, surrogates and numbers above U+10FFFF included) and every control character but line feed
/// and tab becomes U+FFFD.
std::string sanitizedUtf8(std::string_view text);

/// Checks claims one after another; the first one that fails is the result.
class Checker {
public:
  bool atMost(const std::string& field, std::uint64_t value, std::uint64_t limit) {
    return value <= limit ||
           fail(field, std::to_string(value) + " is above " + std::to_string(limit));
  }
  bool atLeast(const std::string& field, std::uint64_t value, std::uint64_t limit) {
    return value >= limit ||
           fail(field, std::to_string(value) + " is below " + std::to_string(limit));
  }
  bool equal(const std::string& field, std::uint64_t value, std::uint64_t expected) {
    return value == expected ||
           fail(field, std::to_string(value) + " is not " + std::to_string(expected));
  }
  bool oneOf(const std::string& field, std::uint32_t value,
             std::initializer_list<std::uint32_t> allowed) {
    return std::find(allowed.begin(), allowed.end(), value) != allowed.end() ||
           fail(field, std::to_string(value) + " is none of the values that are possible");
  }
  /// `first` and `count` name rows of a table of `rows`.
  bool range(const std::string& field, std::uint64_t first, std::uint64_t count,
             std::uint64_t rows) {
    return first + count <= rows ||
           fail(field, std::to_string(first) + " + " + std::to_string(count) + " is above " +
                           std::to_string(rows));
  }
  bool seconds(const std::string& field, double value) {
    constexpr double kLongest = 1e6; // longer than any run
    return (std::isfinite(value) && value >= 0 && value <= kLongest) ||
           fail(field, std::to_string(value) + " is not a time from 0 to 1000000 seconds");
  }
  /// `to` becomes valid UTF-8 without control characters.
  template <std::size_t size>
  bool text(const std::string& field, const char (&from)[size], std::string& to) {
    const auto* const end = std::find(from, from + size, '\0');
    if (end == from + size) return fail(field, "the text does not end");
    to = sanitizedUtf8(std::string_view(from, static_cast<std::size_t>(end - from)));
    return true;
  }
  /// The same where it stands, cut between two characters if it has become too long.
  template <std::size_t size> bool text(const std::string& field, char (&inPlace)[size]) {
    std::string text;
    if (!this->text(field, inPlace, text)) return false;
    std::size_t length = std::min(text.size(), size - 1);
    const auto continues = [&](std::size_t at) {
      return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80;
    };
    while (continues(length)) --length;
    std::memset(inPlace, 0, size);
    std::memcpy(inPlace, text.data(), length);
    return true;
  }
  std::string error;

private:
  bool fail(const std::string& field, const std::string& reason) {
    error = field + ": " + reason;
    return false;
  }
};

/// "frames[3]."
inline std::string element(const char* list, std::uint32_t index) {
  return std::string(list) + "[" + std::to_string(index) + "].";
}

} // namespace ggrade::channel
