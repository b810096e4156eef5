#include "gradebook/look_alike.hpp"

#include "gradebook/cells.hpp"
#include "report/text.hpp"

#include <fmt/format.h>
#include <utf8proc.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

namespace ggrade::gradebook {
namespace {

/// Letters in small (case is folded before), and the Latin letter that they look like in some font.
/// Where capitals alone look alike (В and B, Η and H) the small letters stand for them.
constexpr std::pair<char32_t, char> kLatinLike[] = {
    // Cyrillic
    {U'а', 'a'},
    {U'в', 'b'},
    {U'с', 'c'},
    {U'ԁ', 'd'},
    {U'е', 'e'},
    {U'һ', 'h'},
    {U'н', 'h'},
    {U'і', 'i'},
    {U'ј', 'j'},
    {U'к', 'k'},
    {U'ӏ', 'l'},
    {U'м', 'm'},
    {U'о', 'o'},
    {U'р', 'p'},
    {U'ԛ', 'q'},
    {U'ѕ', 's'},
    {U'т', 't'},
    {U'ѵ', 'v'},
    {U'ԝ', 'w'},
    {U'х', 'x'},
    {U'у', 'y'},
    // Greek
    {U'α', 'a'},
    {U'β', 'b'},
    {U'ε', 'e'},
    {U'γ', 'y'},
    {U'η', 'h'},
    {U'ι', 'i'},
    {U'κ', 'k'},
    {U'μ', 'm'},
    {U'ν', 'v'},
    {U'ο', 'o'},
    {U'ρ', 'p'},
    {U'τ', 't'},
    {U'υ', 'u'},
    {U'χ', 'x'},
    {U'ζ', 'z'},
    // Latin that is no ASCII
    {U'ɑ', 'a'},
    {U'ɡ', 'g'},
    {U'ı', 'i'},
};

char latinLike(char32_t c) {
  const auto found = std::ranges::find(kLatinLike, c, &std::pair<char32_t, char>::first);
  return found == std::end(kLatinLike) ? '\0' : found->second;
}

/// Calls `visit(code point, its bytes)` for each. `text` is UTF-8.
template <class Visit> void eachCodePoint(std::string_view text, Visit&& visit) {
  while (!text.empty()) {
    utf8proc_int32_t c = 0;
    const utf8proc_ssize_t bytes =
        utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                         static_cast<utf8proc_ssize_t>(text.size()), &c);
    if (bytes <= 0) return;
    visit(static_cast<char32_t>(c), text.substr(0, static_cast<std::size_t>(bytes)));
    text.remove_prefix(static_cast<std::size_t>(bytes));
  }
}

std::string asUtf8(std::string_view text) {
  return report::validUtf8(text) == text.size() ? std::string(text) : report::sanitize(text);
}

/// Form KC without case, control characters and those that Unicode calls default ignorable.
std::string folded(const std::string& text) {
  utf8proc_uint8_t* result = nullptr;
  const utf8proc_ssize_t length = utf8proc_map(
      reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
      static_cast<utf8proc_ssize_t>(text.size()), &result,
      static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPAT | UTF8PROC_COMPOSE |
                                     UTF8PROC_CASEFOLD | UTF8PROC_IGNORE | UTF8PROC_STRIPCC));
  const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> owner(result, std::free);
  if (length < 0) throw std::runtime_error(utf8proc_errmsg(length));
  return {reinterpret_cast<const char*>(result), static_cast<std::size_t>(length)};
}

bool isSpace(char32_t c) {
  const auto category = utf8proc_category(static_cast<utf8proc_int32_t>(c));
  return category == UTF8PROC_CATEGORY_ZS || category == UTF8PROC_CATEGORY_ZL ||
         category == UTF8PROC_CATEGORY_ZP || c == 0x2800; // a Braille letter without dots
}

bool showsNothing(char32_t c) {
  switch (utf8proc_category(static_cast<utf8proc_int32_t>(c))) {
  case UTF8PROC_CATEGORY_CC:
  case UTF8PROC_CATEGORY_CF:
  case UTF8PROC_CATEGORY_CN:
  case UTF8PROC_CATEGORY_CO:
  case UTF8PROC_CATEGORY_CS:
    return true;
  default:
    return utf8proc_get_property(static_cast<utf8proc_int32_t>(c))->ignorable;
  }
}

} // namespace

std::string skeleton(std::string_view identifier) {
  std::string all;
  bool space = false;
  eachCodePoint(plainIdentifier(folded(asUtf8(identifier))),
                [&](char32_t c, std::string_view bytes) {
                  if (isSpace(c)) {
                    space = !all.empty();
                    return;
                  }
                  if (space) all += ' ';
                  space = false;
                  if (const char latin = latinLike(c))
                    all += latin;
                  else
                    all += bytes;
                });
  return all;
}

std::vector<std::vector<std::size_t>> lookAlikes(const std::vector<std::string>& identifiers) {
  std::map<std::string, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < identifiers.size(); ++i)
    places[skeleton(identifiers[i])].push_back(i);
  std::vector<std::vector<std::size_t>> others(identifiers.size());
  for (const auto& [same, alike] : places)
    for (const std::size_t i : alike) {
      others[i] = alike;
      std::erase(others[i], i);
    }
  return others;
}

std::string visible(std::string_view identifier) {
  const std::string text = asUtf8(identifier);
  std::string shown = "\"";
  bool mayHide = true; // a space here could not be seen
  eachCodePoint(text, [&](char32_t c, std::string_view bytes) {
    const std::size_t end = std::size_t(bytes.data() - text.data()) + bytes.size();
    if (c == ' ' && (mayHide || end == text.size() || text[end] == ' '))
      shown += "␣";
    else if (c != ' ' && (isSpace(c) || showsNothing(c) || latinLike(c) != '\0' ||
                          latinLike(static_cast<char32_t>(
                              utf8proc_tolower(static_cast<utf8proc_int32_t>(c)))) != '\0'))
      shown += fmt::format("\\u{{{:X}}}", static_cast<std::uint32_t>(c));
    else if (c == '"' || c == '\\')
      (shown += '\\') += bytes;
    else
      shown += bytes;
    mayHide = c == ' ';
  });
  return shown + '"';
}

} // namespace ggrade::gradebook
