#include "intake/names.hpp"

#include "report/text.hpp"

#include <fmt/format.h>
#include <iconv.h>
#include <utf8proc.h>

#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace ggrade::intake {
namespace {

std::string mapped(std::string_view text, int options) {
  utf8proc_uint8_t* result = nullptr;
  const utf8proc_ssize_t length = utf8proc_map(
      reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
      static_cast<utf8proc_ssize_t>(text.size()), &result, static_cast<utf8proc_option_t>(options));
  const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> owner(result, std::free);
  if (length < 0) throw std::runtime_error(utf8proc_errmsg(length));
  return {reinterpret_cast<const char*>(result), static_cast<std::size_t>(length)};
}

/// Calls `visit(code point, its bytes)` for each; false where `text` is not UTF-8.
template <class Visit> bool eachCodePoint(std::string_view text, Visit&& visit) {
  while (!text.empty()) {
    utf8proc_int32_t c = 0;
    const utf8proc_ssize_t bytes =
        utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                         static_cast<utf8proc_ssize_t>(text.size()), &c);
    if (bytes <= 0) return false;
    visit(c, text.substr(0, static_cast<std::size_t>(bytes)));
    text.remove_prefix(static_cast<std::size_t>(bytes));
  }
  return true;
}

bool belongsInFolderName(utf8proc_int32_t c) {
  switch (utf8proc_category(c)) {
  case UTF8PROC_CATEGORY_LU:
  case UTF8PROC_CATEGORY_LL:
  case UTF8PROC_CATEGORY_LT:
  case UTF8PROC_CATEGORY_LM:
  case UTF8PROC_CATEGORY_LO:
  case UTF8PROC_CATEGORY_MN:
  case UTF8PROC_CATEGORY_MC:
  case UTF8PROC_CATEGORY_ND:
    return true;
  default:
    return c == '-';
  }
}

/// Folder name without an end of its own.
std::string plainWord(std::string_view name) {
  std::string word;
  eachCodePoint(name, [&](utf8proc_int32_t c, std::string_view bytes) {
    if (belongsInFolderName(c))
      word += bytes;
    else if (!word.empty() && word.back() != '_')
      word += '_';
  });
  word.erase(0, word.find_first_not_of("-_"));
  return word;
}

} // namespace

bool isUtf8(std::string_view bytes) {
  return eachCodePoint(bytes, [](utf8proc_int32_t, std::string_view) {});
}

std::optional<std::string> fromCp932(std::string_view bytes) {
  const iconv_t converter = iconv_open("UTF-8", "CP932");
  if (converter == iconv_t(-1))
    throw std::runtime_error("iconv can't read CP932: is /usr/lib/*/gconv of package libc6 there?");
  std::string text(3 * bytes.size(), '\0'); // one byte of CP932 becomes at most three
  char* in = const_cast<char*>(bytes.data());
  char* out = text.data();
  std::size_t inLeft = bytes.size();
  std::size_t outLeft = text.size();
  const std::size_t result = iconv(converter, &in, &inLeft, &out, &outLeft);
  iconv_close(converter);
  if (result == std::size_t(-1)) return std::nullopt;
  text.resize(text.size() - outLeft);
  return text;
}

std::optional<std::string> decodeName(std::string_view bytes) {
  if (isUtf8(bytes)) return mapped(bytes, UTF8PROC_STABLE | UTF8PROC_COMPOSE);
  const std::optional<std::string> japanese = fromCp932(bytes);
  if (!japanese) return std::nullopt;
  return mapped(*japanese, UTF8PROC_STABLE | UTF8PROC_COMPOSE);
}

std::string decodeOrEscape(std::string_view bytes) {
  if (std::optional<std::string> name = decodeName(bytes)) return *name;
  std::string escaped;
  for (const char c : bytes) {
    if (static_cast<unsigned char>(c) < 0x80)
      escaped += c;
    else
      escaped += fmt::format("\\x{:02X}", static_cast<unsigned char>(c));
  }
  return escaped;
}

std::string displayName(std::string_view name) {
  // What `sanitize` replaces is taken out.
  constexpr std::string_view kReplacement = "\uFFFD";
  std::string clean = report::sanitize(name);
  for (std::size_t at = 0; (at = clean.find(kReplacement, at)) != clean.npos;)
    clean.erase(at, kReplacement.size());
  const std::string line = report::sanitizeLine(clean, 99); // and an ellipsis
  return line.empty() ? "(no name)" : line;
}

bool hasControl(std::string_view name) {
  bool found = false;
  eachCodePoint(name, [&](utf8proc_int32_t c, std::string_view) {
    found |= utf8proc_category(c) == UTF8PROC_CATEGORY_CC;
  });
  return found;
}

std::string caseFolded(std::string_view name) {
  return mapped(name, UTF8PROC_STABLE | UTF8PROC_COMPOSE | UTF8PROC_CASEFOLD);
}

std::string_view cut(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && (text[bytes] & 0xC0) == 0x80) --bytes;
  return text.substr(0, bytes);
}

std::string folderName(std::string_view name, std::string_view id) {
  const std::string end(cut(plainWord(id), kLongestFolderName / 2));
  const std::size_t room = kLongestFolderName - (end.empty() ? 0 : end.size() + 1);
  const std::string word = plainWord(name);
  std::string start(cut(word, room));
  while (start.ends_with('_') || start.ends_with('-')) start.pop_back();
  if (start.empty()) start = end.empty() ? "student" : "";
  return start.empty() ? end : end.empty() ? start : start + '_' + end;
}

} // namespace ggrade::intake
