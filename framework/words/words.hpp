#pragma once
/// \file
/// Everything that a student reads, in the student's language. The English text is the tag by which
/// its translation is found in the table, `ja.json` (one line a text).

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace gg {

/// Of texts. Chosen by `setLanguage`, else by the first of GG_LANG, LC_ALL, LC_MESSAGES and LANG
/// that is set: Japanese if it begins with "ja".
enum class Language { english, japanese };

Language language();
void setLanguage(Language language);
/// "en" or "ja".
std::string_view name(Language language);
/// The other way; nothing for any other word.
std::optional<Language> parseLanguage(std::string_view name);

/// Adds a table of further texts, such as an assignment's own; does nothing in English, or if there
/// is no such file. A text that is known already stays as it is, so that what `words` has returned
/// remains valid. Throws std::runtime_error, naming the file, if it isn't an object of texts.
void addWords(const std::filesystem::path& table);

/// The text in the chosen language; the English one where there is no other.
std::string_view words(std::string_view english);

/// Marks a text of a constant table, for which `words` is asked where it is read.
constexpr std::string_view tag(std::string_view english) {
  return english;
}

/// The same with values in its places, as fmt::format.
template <class... Values>
std::string say(fmt::format_string<Values...> english, Values&&... values) {
  const fmt::string_view text = english;
  return fmt::vformat(words({text.data(), text.size()}), fmt::make_format_args(values...));
}

} // namespace gg
