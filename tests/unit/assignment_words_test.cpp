// What students read of the assignments, in Japanese: nothing lacks a translation, and no
// translation lacks its text.

#include "grading/catalogue.hpp"
#include "grading/scenes.hpp"
#include "tradeoff/adopted.hpp"
#include "tradeoff/analysis.hpp"

#include "in_japanese.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

using namespace ggrade;
using nlohmann::json;
namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

using Table = std::map<std::string, std::string>;
using Texts = std::set<std::string>;

const fs::path kRoot = GGRADE_SOURCE_DIR;

/// Those that have a translation. An assignment may be English only, but none of these.
std::vector<Assignment> translated() {
  std::vector<Assignment> all = loadAssignments(kRoot / "assignments");
  std::erase_if(all, [](const Assignment& assignment) {
    return !fs::exists(assignment.folder / "words.ja.json");
  });
  std::vector<std::string> ids;
  for (const Assignment& assignment : all) ids.push_back(assignment.id);
  EXPECT_THAT(ids, testing::IsSupersetOf({"deferred", "floor", "shadow_volume", "ssao", "post"}));
  return all;
}

/// Has the text a letter of Japanese in it? Of one that has nothing but names and values there is
/// nothing to translate.
bool isJapanese(const std::string& text) {
  return std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) >= 0xE3; });
}

Texts ofAssignment(const fs::path& folder) {
  const json from = readJson(folder / "assignment.json");
  Texts texts = {from.at("title")};
  for (const json& part : from.at("parts")) {
    texts.insert(part.at("title"));
    for (const json& todo : part.at("todos")) texts.insert(todo.at("title"));
    for (const json& item : part.at("items")) {
      for (const char* key : {"title", "looks_at", "cause"}) texts.insert(item.at(key));
      if (item.contains("output")) texts.insert(item.at("output"));
    }
  }
  return texts;
}

/// The texts in `say("...")` and `words("...")`, lines that continue each other joined.
Texts literalsIn(const std::string& code) {
  static const std::regex kCall("\\b(?:say|words)\\(\\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)");
  static const std::regex kPiece("\"((?:[^\"\\\\]|\\\\.)*)\"");
  Texts texts;
  for (std::sregex_iterator call(code.begin(), code.end(), kCall), none; call != none; ++call) {
    const std::string pieces = (*call)[1];
    std::string text;
    for (std::sregex_iterator piece(pieces.begin(), pieces.end(), kPiece); piece != none; ++piece)
      text += (*piece)[1];
    texts.insert(std::regex_replace(text, std::regex("\\\\(.)"), "$1"));
  }
  return texts;
}

Texts ofRubrics(const fs::path& folder) {
  Texts texts;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".cpp" &&
        entry.path().filename().string().starts_with("rubric"))
      texts.merge(literalsIn(readFile(entry.path())));
  return texts;
}

Texts ofScenes(const fs::path& folder) {
  Texts texts;
  const json from = readJson(folder / "scenes.json");
  for (const json& scene : from.at("scenes")) texts.insert(scene.at("name"));
  return texts;
}

Texts ofCatalogue(const Assignment& assignment, const fs::path& folder) {
  Texts texts;
  for (const Part& part : assignment.parts)
    for (const grading::Mistake& mistake :
         grading::loadCatalogue(assignment, part, folder, folder).mistakes) {
      texts.insert({mistake.title, mistake.hint});
      if (!mistake.experiment.empty()) texts.insert(mistake.experiment);
    }
  return texts;
}

/// A name that is the same in every language, such as "SMAA low".
bool isProper(const std::string& name) {
  return std::ranges::any_of(name, [](char c) { return c >= 'A' && c <= 'Z'; });
}

/// What is measured, and what was.
Texts ofTradeoff(const fs::path& folder) {
  Texts texts;
  const json quality = readJson(folder / "quality.json");
  for (const json& part : quality.at("parts"))
    for (const json& scene : part.at("scenes")) {
      texts.insert(scene.at("about"));
      for (const json& note : scene.value("notes", json::object())) texts.insert(note);
    }
  for (const char* kind : {"growth", "saved"})
    for (const json& one : quality.at(kind)) texts.insert(one.at("name"));
  if (!fs::exists(folder / "tradeoff")) return texts; // nothing is measured yet
  const json figures = readJson(folder / "tradeoff" / "figures.json");
  for (const json& sweep : figures.at("sweeps")) {
    texts.insert(sweep.at("error"));
    for (const json& row : sweep.value("compared", json::array())) {
      if (const std::string name = row.at("name"); !isProper(name)) texts.insert(name);
      for (const json& error : row.at("errors")) texts.insert(error.at("name"));
    }
  }
  return texts;
}

/// `{}`, `{:.1f}` and `{0}` of a text, as "0:.1f", in the order of the values.
std::multiset<std::string> placesOf(const std::string& text) {
  static const std::regex kPlace("\\{([0-9]*)(:[^}]*)?\\}");
  std::multiset<std::string> places;
  int next = 0;
  for (std::sregex_iterator place(text.begin(), text.end(), kPlace), none; place != none; ++place) {
    const std::string number = (*place)[1];
    places.insert((number.empty() ? std::to_string(next++) : number) + (*place)[2].str());
  }
  return places;
}

Texts without(const Texts& texts, const Table& table) {
  Texts rest;
  for (const std::string& text : texts)
    if (!table.contains(text)) rest.insert(text);
  return rest;
}

/// A table is all that is asked for and nothing else, in order, a line an entry.
void expectToTranslate(const fs::path& file, const Texts& needed, const Table& framework) {
  SCOPED_TRACE(file.string());
  const std::string text = readFile(file);
  const Table table = readJson(file).get<Table>();
  std::vector<std::string> lacking, unused, different;
  for (const std::string& one : without(without(needed, table), framework)) lacking.push_back(one);
  std::string sorted = "{\n";
  for (const auto& [english, japanese] : table) {
    if (!needed.contains(english)) unused.push_back(english);
    if (placesOf(english) != placesOf(japanese) || !isJapanese(japanese))
      different.push_back(english + " -> " + japanese);
    sorted +=
        (sorted.size() > 2 ? ",\n" : "") + json(english).dump() + ": " + json(japanese).dump();
  }
  EXPECT_THAT(lacking, IsEmpty());
  EXPECT_THAT(unused, IsEmpty());
  EXPECT_THAT(different, IsEmpty());
  EXPECT_EQ(text, sorted + "\n}\n") << "not sorted, or not a line an entry";
}

TEST(AssignmentWords, NothingThatAStudentReadsLacksATranslation) {
  const Table framework = readJson(kRoot / "framework/words/ja.json").get<Table>();
  for (const Assignment& assignment : translated()) {
    const fs::path solution = kRoot / "solutions" / assignment.id;
    expectToTranslate(assignment.folder / "words.ja.json", ofAssignment(assignment.folder),
                      framework);
    Texts needed = ofRubrics(solution);
    needed.merge(ofScenes(solution));
    needed.merge(ofCatalogue(assignment, solution));
    needed.merge(ofTradeoff(solution));
    expectToTranslate(solution / "words.ja.json", needed, framework);
  }
}

/// All tables end up in one: which assignment was read first must not matter.
TEST(AssignmentWords, OneTextHasOneTranslation) {
  Table all;
  for (const Assignment& assignment : translated())
    for (const fs::path& folder : {assignment.folder, kRoot / "solutions" / assignment.id})
      for (const auto& [english, japanese] : readJson(folder / "words.ja.json").get<Table>()) {
        const auto [known, fresh] = all.emplace(english, japanese);
        EXPECT_EQ(known->second, japanese) << folder << ": " << english;
      }
}

TEST(AssignmentWords, StandWhereTheAssignmentIsRead) {
  const InJapanese japanese;
  const Target target = findTarget(kRoot / "assignments", "mirror");
  EXPECT_EQ(target.assignment.title, "市松模様の床の映り込み、影、ブルーム");
  EXPECT_EQ(target.parts.at(0).title, "フレームバッファオブジェクトによる鏡の映り込み");
  EXPECT_EQ(target.parts.at(0).todos.at(0).title, "フレームバッファオブジェクトを作る");
  const ItemDeclaration& item = target.parts.at(0).items.at(1);
  EXPECT_EQ(item.id, "mirror.texture");
  EXPECT_EQ(item.title, "映り込みがフレームバッファオブジェクトに描画されている");
  EXPECT_EQ(item.output, "映り込み");
  EXPECT_TRUE(isJapanese(item.looksAt)) << item.looksAt;
  EXPECT_TRUE(isJapanese(item.cause)) << item.cause;
}

TEST(AssignmentWords, StandInTheCatalogue) {
  const InJapanese japanese;
  const fs::path solution = kRoot / "solutions/floor";
  const Target target = findTarget(kRoot / "assignments", "mirror");
  const grading::Catalogue catalogue =
      grading::loadCatalogue(target.assignment, target.parts.at(0), solution, solution);
  const grading::Mistake* mistake = catalogue.mistake("mirror_upside_down");
  ASSERT_TRUE(mistake);
  EXPECT_EQ(mistake->title, "床が映り込みを上下逆にサンプリングしている");
  EXPECT_THAT(mistake->hint, HasSubstr("何も反転する必要はありません。"));
  EXPECT_THAT(mistake->symptom, Not(IsEmpty()));
  EXPECT_FALSE(isJapanese(mistake->symptom)) << "for the instructor";
}

/// Results of one language are not taken for those of another by what they are called: names of
/// scenes are words, and the plan is the same.
TEST(AssignmentWords, NameScenesButLeaveThePlanAsItIs) {
  const fs::path solution = kRoot / "solutions/floor";
  const grading::Draw twice{{}, grading::Quality::thorough};
  for (const char* id : {"mirror", "floor"}) {
    const grading::ScenePlan english =
        grading::drawScenes(findTarget(kRoot / "assignments", id), solution, twice);
    const InJapanese inJapanese;
    const grading::ScenePlan japanese =
        grading::drawScenes(findTarget(kRoot / "assignments", id), solution, twice);
    EXPECT_EQ(describe(japanese), describe(english)) << id;
    ASSERT_EQ(japanese.scenes.size(), english.scenes.size());
    bool moved = false, anew = false;
    for (std::size_t i = 0; i < english.scenes.size(); ++i) {
      const std::string& name = japanese.scenes[i].name;
      EXPECT_TRUE(isJapanese(name)) << name;
      moved = moved || name.ends_with("カメラが動いた");
      anew = anew || name.ends_with("別の視点と光源（引き直し）");
      EXPECT_EQ(japanese.scenes[i].like.empty(), english.scenes[i].like.empty());
    }
    EXPECT_TRUE(moved && anew) << id;
  }
}

TEST(TradeoffWords, SayWhatWasMeasured) {
  EXPECT_EQ(tradeoff::fallInWords("The error falls with n: from 3.1% at 0 to 0 at 1. So it is."),
            "The error falls with n: from 3.1% at 0 to 0 at 1. So it is.");
  const InJapanese japanese;
  EXPECT_EQ(tradeoff::fallInWords("The error falls with n: from 3.1% at 0.5 to 0 at 1."),
            "nとともに誤差が減ります。0.5のとき3.1%、1のとき0です。");
  EXPECT_EQ(tradeoff::fallInWords("The error does not fall beyond n 2: from 2.0% at 0 to 1.8% "
                                  "there; it has risen to 2.1% at 6 (+19%). An unknown note."),
            "nが0のときの2.0%から、2のときの1.8%までは誤差が減りますが、その先では減らず、"
            "6では2.1%に増えます (+19%)。An unknown note.");
  // Every sentence that can be said, of the function that says it.
  const auto said = [](const std::vector<std::string>& labels, const std::vector<double>& errors) {
    return tradeoff::fallInWords(tradeoff::fallText("n", labels, errors));
  };
  EXPECT_EQ(said({"1"}, {0.4}), "nの値は1つだけです。1のとき40.0%です。");
  EXPECT_EQ(said({"1", "2"}, {0.01, 0.0101}),
            "ここでは、nを変えても誤差は変わりません。どの値でも1.0%から1.0%です。");
  EXPECT_EQ(said({"1", "2", "3"}, {0.2, 0.3, 0.1}),
            "nとともに誤差が減ります。1のとき20.0%、3のとき10.0%です。"
            "その途中で、1のときの20.0%から、2のときの30.0%に増えます。");
  EXPECT_EQ(said({"1", "2", "4"}, {0.02, 0.01, 0.0101}),
            "nが1のときの2.0%から、2のときの1.0%までは誤差が減りますが、その先では減りません。"
            "4でも1.0% (+1.0%)です。");
  EXPECT_EQ(
      said({"1", "2", "4"}, {0.02, 0.002, 0.00195}),
      "nが1のときの2.0%から、2のときの0.20%までは誤差が減りますが、その先ではほとんど減りません。"
      "4でも0.19% (-2.5%)です。");
  EXPECT_EQ(said({"0", "1", "2"}, {0.03, 0, 0.01}),
            "nが0のときの3.0%から、1のときの0までは誤差が減りますが、その先では減らず、"
            "2では1.0%に増えます。");
  EXPECT_EQ(said({"0", "1"}, {0.010, 0.015}),
            "nを変えても誤差は減りません。0のとき1.0%で、1では1.5%に増えます (+50%)。");
}

TEST(TradeoffWords, LeaveNoEnglishSentenceInAHandout) {
  for (const Assignment& assignment : translated()) {
    const InJapanese japanese;
    addWords(kRoot / "solutions" / assignment.id);
    if (!fs::exists(kRoot / "solutions" / assignment.id / "tradeoff")) continue;
    const json figures = readJson(kRoot / "solutions" / assignment.id / "tradeoff/figures.json");
    std::string text = tradeoff::handoutText(figures, "");
    for (const Part& part : assignment.parts) text += tradeoff::handoutText(figures, part.id);
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
      if (line.empty() || line.starts_with("| ---")) continue;
      EXPECT_THAT(line, Not(ContainsRegex("[a-z,]+ [a-z]+ [a-z]+ [a-z]+"))) << assignment.id;
      // A preset's row, or that of a setting with a proper name.
      const bool names = line.starts_with("| ") && (line.find('`') != line.npos ||
                                                    isProper(line.substr(0, line.find('|', 2))));
      EXPECT_TRUE(names || isJapanese(line)) << assignment.id << ": " << line;
    }
  }
}

} // namespace
