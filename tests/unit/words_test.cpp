// The table of translations against the texts in the sources: none missing, none left over, and
// values where they belong.

#include "in_japanese.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <vector>

namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

const fs::path kSource = GGRADE_SOURCE_DIR;
const fs::path kTable = kSource / "framework" / "words" / "ja.json";

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// In the order of the file.
using Table = std::vector<std::pair<std::string, std::string>>;

Table table() {
  Table entries;
  const auto all = nlohmann::ordered_json::parse(textOf(kTable));
  for (const auto& [english, text] : all.items())
    entries.emplace_back(english, text.get<std::string>());
  return entries;
}

bool isWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Reads the literals that stand side by side at `at`, joined; empty: there is none.
std::string literalsAt(const std::string& code, std::size_t at) {
  std::string joined;
  const auto skipSpace = [&] {
    while (at < code.size() && std::isspace(static_cast<unsigned char>(code[at]))) ++at;
  };
  for (skipSpace(); at < code.size() && code[at] == '"'; skipSpace()) {
    for (++at; at < code.size() && code[at] != '"'; ++at) {
      if (code[at] == '\\') {
        ++at;
        joined += code[at] == 'n' ? '\n' : code[at];
      } else {
        joined += code[at];
      }
    }
    ++at;
  }
  return joined;
}

/// The texts that `code` asks the table for.
std::set<std::string> askedIn(const std::string& code) {
  std::set<std::string> asked;
  for (const std::string function : {"say", "words", "tag"})
    for (std::size_t at = code.find(function + "("); at != code.npos;
         at = code.find(function + "(", at + 1)) {
      if (at > 0 && isWord(code[at - 1])) continue;
      if (const std::string text = literalsAt(code, at + function.size() + 1); !text.empty())
        asked.insert(text);
    }
  return asked;
}

std::set<std::string> askedInTemplate(const std::string& page) {
  const std::string open = "{{#say}}", close = "{{/say}}";
  std::set<std::string> asked;
  for (std::size_t at = page.find(open); at != page.npos; at = page.find(open, at)) {
    at += open.size();
    asked.insert(page.substr(at, page.find(close, at) - at));
  }
  return asked;
}

std::set<std::string> asked() {
  std::set<std::string> all;
  for (const char* folder : {"framework", "grader"})
    for (const auto& entry : fs::recursive_directory_iterator(kSource / folder)) {
      const fs::path& file = entry.path();
      // What stands in for OpenGL and GLFW has a `say` of its own, for the run's messages.
      if (file.lexically_relative(kSource / "grader").begin()->string() == "capture") continue;
      const std::string kind = file.extension().string();
      if (kind == ".cpp" || kind == ".hpp") all.merge(askedIn(textOf(file)));
      if (kind == ".mustache") all.merge(askedInTemplate(textOf(file)));
    }
  return all;
}

/// Each value's place and format, each name of a template: "0:.1f", "{{part}}". In any order.
std::multiset<std::string> values(const std::string& text) {
  std::multiset<std::string> all;
  int next = 0;
  for (std::size_t at = text.find('{'); at != text.npos; at = text.find('{', at)) {
    const bool twice = text.compare(at, 2, "{{") == 0;
    const std::size_t end = text.find(twice ? "}}" : "}", at) + (twice ? 2 : 1);
    std::string value = text.substr(at, end - at);
    if (!twice) {
      value = value.substr(1, value.size() - 2);
      if (value.empty() || value[0] == ':') value = std::to_string(next++) + value;
    }
    all.insert(value);
    at = end;
  }
  for (const char* place : {"%1", "%2"})
    if (text.find(place) != text.npos) all.insert(place);
  return all;
}

TEST(Words, NothingThatAStudentReadsLacksATranslation) {
  std::set<std::string> lacking = asked();
  ASSERT_GT(lacking.size(), 200u) << "the sources were not found";
  for (const auto& [english, text] : table()) lacking.erase(english);
  EXPECT_THAT(lacking, IsEmpty());
}

TEST(Words, NoTranslationIsLeftOver) {
  const std::set<std::string> known = asked();
  std::vector<std::string> unused;
  for (const auto& [english, text] : table())
    if (!known.contains(english)) unused.push_back(english);
  EXPECT_THAT(unused, IsEmpty());
}

TEST(Words, TranslationsHaveTheSameValues) {
  for (const auto& [english, text] : table()) EXPECT_EQ(values(text), values(english)) << english;
}

TEST(Words, ValuesAreNumberedInAllPlacesOrInNone) {
  for (const auto& [english, text] : table()) {
    int numbered = 0, all = 0;
    for (std::size_t at = text.find('{'); at != text.npos; at = text.find('{', at + 1)) {
      if (text.compare(at, 2, "{{") == 0) break; // a page's: values with names
      numbered += std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0;
      ++all;
    }
    EXPECT_THAT(numbered, testing::AnyOf(0, all)) << text;
  }
}

TEST(Words, TranslationsBeginAndEndAsTheirTextsDo) {
  for (const auto& [english, text] : table()) {
    ASSERT_FALSE(text.empty()) << english;
    EXPECT_EQ(text.ends_with('\n'), english.ends_with('\n')) << english;
  }
}

TEST(Words, TheTableIsSortedAndHasOneLineAnEntry) {
  const Table entries = table();
  EXPECT_TRUE(std::ranges::is_sorted(entries, {}, &Table::value_type::first));
  const std::string text = textOf(kTable);
  EXPECT_EQ(std::size_t(std::ranges::count(text, '\n')), entries.size() + 2);
}

TEST(Words, OrderOfValuesIsTheLanguagesOwn) {
  gg::setLanguage(gg::Language::english);
  EXPECT_EQ(gg::say("{} of {} done", 2, 5), "2 of 5 done");
  const InJapanese japanese;
  EXPECT_EQ(gg::say("{} of {} done", 2, 5), "5個中2個完了");
  EXPECT_EQ(gg::words("no such text"), "no such text");
}

TEST(Words, LanguagesHaveNames) {
  for (const gg::Language language : {gg::Language::english, gg::Language::japanese})
    EXPECT_EQ(gg::parseLanguage(gg::name(language)), language);
  EXPECT_EQ(gg::parseLanguage("de"), std::nullopt);
  EXPECT_EQ(gg::parseLanguage(""), std::nullopt);
}

} // namespace
