#include "words/words.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

#include <nlohmann/json.hpp>

namespace gg {

extern const char* const kJapaneseLines[]; // ja.json, made by embed.cmake
extern const std::size_t kJapaneseLineCount;

namespace {

using Table = std::map<std::string, std::string, std::less<>>;

Language fromEnvironment() {
  for (const char* name : {"GG_LANG", "LC_ALL", "LC_MESSAGES", "LANG"})
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0')
      return std::string_view(value).starts_with("ja") ? Language::japanese : Language::english;
  return Language::english;
}

std::optional<Language>& chosen() {
  static std::optional<Language> language;
  return language;
}

Table& table() {
  static Table japanese = [] {
    std::string text;
    for (std::size_t i = 0; i < kJapaneseLineCount; ++i)
      text += std::string(kJapaneseLines[i]) + '\n';
    return nlohmann::json::parse(text).get<Table>();
  }();
  return japanese;
}

} // namespace

Language language() {
  static const Language usual = fromEnvironment();
  return chosen().value_or(usual);
}

void setLanguage(Language language) {
  chosen() = language;
}

std::string_view name(Language language) {
  return language == Language::japanese ? "ja" : "en";
}

std::optional<Language> parseLanguage(std::string_view word) {
  for (const Language language : {Language::english, Language::japanese})
    if (word == name(language)) return language;
  return std::nullopt;
}

void addWords(const std::filesystem::path& file) {
  if (language() == Language::english) return;
  std::ifstream in(file, std::ios::binary);
  if (!in) return;
  try {
    for (auto& [english, text] :
         nlohmann::json::parse(std::string(std::istreambuf_iterator<char>(in), {})).get<Table>())
      table().emplace(english, text);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

std::string_view words(std::string_view english) {
  if (language() == Language::english) return english;
  const auto found = table().find(english);
  return found == table().end() ? english : std::string_view(found->second);
}

} // namespace gg
