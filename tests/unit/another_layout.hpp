#pragma once
/// \file
/// What a formatter with other settings makes of a program.

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <sstream>
#include <string>

inline constexpr std::size_t kCommentColumns = 70;

/// Braces stand alone, arguments on lines of their own; long lines of comments are broken.
inline std::string inAnotherLayout(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t lineEnd = std::min(text.size(), text.find('\n', i));
    const bool startsLine = out.empty() || out.back() == '\n';
    if (text.compare(i, 2, "//") == 0) {
      std::istringstream words(text.substr(i + 2, lineEnd - i - 2));
      std::size_t columns = 2;
      out += "//";
      for (std::string word; words >> word; columns += 1 + word.size()) {
        const bool fits = columns + 1 + word.size() <= kCommentColumns;
        out += (fits ? " " : "\n\t// ") + word;
        if (!fits) columns = 2;
      }
      i = lineEnd;
    } else if (text[i] == '#' && startsLine) {
      out += text.substr(i, lineEnd - i);
      i = lineEnd;
    } else if (text[i] == '"') {
      do {
        if (text[i] == '\\') out += text[i++];
        out += text[i++];
      } while (text[i] != '"');
      out += text[i++];
    } else if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      bool ends = false;
      for (; i < text.size() && std::isspace(static_cast<unsigned char>(text[i])) != 0; ++i)
        ends = ends || text[i] == '\n';
      if (!startsLine) out += ends ? '\n' : ' ';
    } else {
      const char c = text[i++];
      if ((c == '{' || c == '}') && !startsLine) out += '\n';
      out += c;
      if (c == '{' || c == '}') out += '\n';
      if (c == ',') out += "\n\t\t";
    }
  }
  return out;
}
