// Comments of the assignments in Japanese: none lacks, none is out of date, and whatever reads a
// program sees the same in both.

#include "assignment/assignment.hpp"
#include "authoring/comments.hpp"
#include "authoring/solution_blocks.hpp"
#include "check/begun.hpp"

#include <gmock/gmock.h>

#include <iconv.h>

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>

using namespace ggrade;
using authoring::Translations;
using testing::IsEmpty;
namespace fs = std::filesystem;

namespace {

const fs::path kSolutions = fs::path(GGRADE_SOURCE_DIR) / "solutions";
constexpr std::size_t kColumns = 100; // .clang-format

std::vector<Assignment> withComments() {
  std::vector<Assignment> all = loadAssignments(fs::path(GGRADE_SOURCE_DIR) / "assignments");
  std::erase_if(all, [](const Assignment& assignment) {
    return !fs::exists(kSolutions / assignment.id / "comments.ja.json");
  });
  std::vector<std::string> ids;
  for (const Assignment& assignment : all) ids.push_back(assignment.id);
  EXPECT_THAT(ids, testing::IsSupersetOf({"deferred", "floor", "shadow_volume", "ssao", "post"}));
  return all;
}

/// Calls `visit` with each file's name, and with its text in English and in Japanese.
void forEachFile(
    const std::function<void(const std::string&, const std::string&, const std::string&)>& visit) {
  for (const Assignment& assignment : withComments()) {
    const fs::path folder = kSolutions / assignment.id;
    const Translations translations = authoring::translationsIn(folder);
    for (const std::string& file : assignment.files) {
      const std::string english = readFile(folder / file);
      visit(assignment.id + "/" + file, english, authoring::translated(english, translations));
    }
  }
}

std::string stubOf(const std::string& text) {
  return authoring::withFilled(text, "", {});
}

/// What a compiler reads, token by token.
std::string codeOf(const std::string& text) {
  std::string code;
  char quote = '\0';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (quote == '\0' && c == '/' && next == '/') {
      while (i < text.size() && text[i] != '\n') ++i;
      code += '\n';
    } else {
      if (quote == '\0' && c == '"')
        quote = c;
      else if (quote != '\0' && c == '\\')
        code += text[i++];
      else if (c == quote)
        quote = '\0';
      if (i < text.size()) code += text[i];
    }
  }
  return std::regex_replace(code, std::regex("[ \t]*\n[ \t\n]*"), "\n");
}

/// The TODOs that a line names, a line each.
std::string todosIn(const std::string& text) {
  static const std::regex kTodo(R"((TODO|DONE)\([a-z0-9_]+\.[0-9]+\):?)");
  std::istringstream in(text);
  std::string all;
  for (std::string line; std::getline(in, line);) {
    std::string named;
    for (std::sregex_iterator i(line.begin(), line.end(), kTodo), end; i != end; ++i)
      named += i->str() + ' ';
    if (!named.empty()) all += named + '\n';
  }
  return all;
}

/// Such as uPcfRadius and GL_BACK: `check` tells by them whose place it is.
std::set<std::string> namesOfCodeIn(const std::string& text) {
  static const std::regex kName(R"([A-Za-z0-9_]+)"), kOfCode(R"(.+[A-Z].*|.*_.*)");
  std::set<std::string> names;
  for (std::sregex_iterator i(text.begin(), text.end(), kName), end; i != end; ++i)
    if (std::regex_match(i->str(), kOfCode)) names.insert(i->str());
  return names;
}

/// Full-width characters take two columns.
std::size_t columnsOf(const std::string& line) {
  std::size_t columns = 0;
  for (const char c : line)
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) columns += (c & 0x80) != 0 ? 2 : 1;
  return columns;
}

/// As editors in Japan may save it; empty: it can't be.
std::string inShiftJis(std::string text) {
  const iconv_t converter = iconv_open("CP932", "UTF-8");
  std::string out(2 * text.size() + 1, '\0');
  char *from = text.data(), *to = out.data();
  std::size_t left = text.size(), room = out.size();
  const bool ok = iconv(converter, &from, &left, &to, &room) != std::size_t(-1);
  iconv_close(converter);
  return ok ? out.substr(0, out.size() - room) : "";
}

TEST(AssignmentComments, AreAllInJapanese) {
  for (const Assignment& assignment : withComments())
    EXPECT_THAT(authoring::outOfStep(assignment, kSolutions / assignment.id), IsEmpty());
}

TEST(AssignmentComments, StandInOrderALineEach) {
  for (const Assignment& assignment : withComments()) {
    const fs::path file = kSolutions / assignment.id / "comments.ja.json";
    EXPECT_EQ(readFile(file), readJson(file).dump(1) + "\n") << file;
  }
}

TEST(AssignmentComments, OneHasOneTranslation) {
  std::map<std::string, std::vector<std::string>> all;
  for (const Assignment& assignment : withComments())
    for (const auto& [text, lines] : authoring::translationsIn(kSolutions / assignment.id)) {
      const auto [known, fresh] = all.emplace(text, lines);
      EXPECT_EQ(known->second, lines) << assignment.id << ": " << text;
    }
}

TEST(AssignmentComments, NameTheSameCode) {
  for (const Assignment& assignment : withComments())
    for (const auto& [text, lines] : authoring::translationsIn(kSolutions / assignment.id)) {
      std::string japanese;
      for (const std::string& line : lines) japanese += line + '\n';
      EXPECT_EQ(namesOfCodeIn(japanese), namesOfCodeIn(text)) << assignment.id << ": " << japanese;
    }
}

TEST(AssignmentComments, FitBesideTheCode) {
  forEachFile([](const std::string& name, const std::string&, const std::string& japanese) {
    std::istringstream in(japanese);
    for (std::string line; std::getline(in, line);) {
      if (columnsOf(line) == line.size()) continue; // as it is in English
      EXPECT_LE(columnsOf(line), kColumns) << name << ": " << line;
      // A backslash at a line's end swallows the next one.
      const std::string saved = inShiftJis(line);
      EXPECT_TRUE(line.empty() || (!saved.empty() && saved.back() != '\\')) << name << ": " << line;
    }
  });
}

TEST(AssignmentComments, LeaveTheCodeAsItIs) {
  forEachFile([](const std::string& name, const std::string& english, const std::string& japanese) {
    EXPECT_NE(english, japanese) << name;
    EXPECT_EQ(codeOf(stubOf(japanese)), codeOf(stubOf(english))) << name;
  });
}

/// Whichever of the two somebody began with.
TEST(AssignmentComments, AreNoWorkForCheck) {
  forEachFile([](const std::string& name, const std::string& english, const std::string& japanese) {
    EXPECT_EQ(todosIn(japanese), todosIn(english)) << name;
    for (const bool isKitJapanese : {false, true}) {
      const std::string stub = stubOf(isKitJapanese ? japanese : english);
      const check::Begun other = check::begunIn(stub, stubOf(isKitJapanese ? english : japanese));
      EXPECT_THAT(other.certain, IsEmpty()) << name;
      EXPECT_THAT(other.possible, IsEmpty()) << name;
    }
  });
}

} // namespace
