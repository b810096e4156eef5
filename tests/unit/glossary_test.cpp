// docs/glossary.md: one word for one thing, in everything that a student reads in Japanese.

#include "assignment/assignment.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

using namespace ggrade;
namespace fs = std::filesystem;

namespace {

struct Term {
  std::string japanese;          ///< the first of its words
  std::vector<std::string> nots; ///< what it isn't called
};

std::vector<Term> terms() {
  static const std::regex kRow(R"(\| ([^|]+) \| ([^|]+) \| ([^|]+) \|([^|]*)\|)");
  static const std::regex kWord("`([^`]+)`");
  std::istringstream in(readFile(fs::path(GGRADE_SOURCE_DIR) / "docs/glossary.md"));
  std::vector<Term> all;
  std::smatch row;
  for (std::string line; std::getline(in, line);) {
    if (!std::regex_match(line, row, kRow) || row[1] == "English" || row[1] == "---") continue;
    const std::string japanese = row[2], nots = row[4];
    Term term{japanese.substr(0, japanese.find("、")), {}};
    for (std::sregex_iterator i(nots.begin(), nots.end(), kWord), end; i != end; ++i)
      term.nots.push_back((*i)[1]);
    all.push_back(std::move(term));
  }
  return all;
}

bool isReadInJapanese(const std::string& name) {
  return name == "ggrade" ||
         std::ranges::any_of(std::array{".ja.md", ".ja.json", ".quiz.json", ".ja.txt"},
                             [&](const char* ending) { return name.ends_with(ending); });
}

/// By path. What stands in 「」 is quoted, and may be anything.
std::map<std::string, std::string> textsInJapanese() {
  static const std::regex kQuoted("「[^\n]*?」");
  const fs::path root = GGRADE_SOURCE_DIR;
  std::vector<fs::path> files = {root / "README.ja.md", root / "framework/words/ja.json",
                                 root / "ggrade"};
  for (const char* folder : {"assignments", "cmake/help", "docs", "grader", "solutions"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (isReadInJapanese(entry.path().filename().string())) files.push_back(entry.path());
  std::map<std::string, std::string> texts;
  for (const fs::path& file : files)
    texts[file.lexically_relative(root).string()] = std::regex_replace(readFile(file), kQuoted, "");
  return texts;
}

TEST(Glossary, OneThingHasOneWord) {
  const auto texts = textsInJapanese();
  EXPECT_GE(texts.size(), 40u);
  std::size_t banned = 0;
  for (const Term& term : terms())
    for (const std::string& word : term.nots) {
      ++banned;
      for (const auto& [file, text] : texts) {
        const std::size_t at = text.find(word);
        if (at != text.npos)
          ADD_FAILURE() << file << ':' << 1 + std::ranges::count(text.substr(0, at), '\n') << ": "
                        << word << " is called " << term.japanese << " in docs/glossary.md";
      }
    }
  EXPECT_GE(banned, 30u);
}

TEST(Glossary, EveryWordIsUsed) {
  const auto texts = textsInJapanese();
  EXPECT_GE(terms().size(), 60u);
  for (const Term& term : terms())
    EXPECT_TRUE(std::ranges::any_of(texts, [&](const auto& one) {
      return one.second.find(term.japanese) != std::string::npos;
    })) << term.japanese;
}

} // namespace
