#include "intake/names.hpp"

#include <gmock/gmock.h>

#include <clocale>

namespace ggrade::intake {
namespace {

// か + combining voiced sound mark, as a Mac writes が.
constexpr char kNfd[] = "\u304B\u3099";
constexpr char kNfc[] = "\u304C";
constexpr char kStudentCp932[] = "\x8A\x77\x90\xB6"; // 学生

TEST(DecodeName, MakesNfcOfAMacsNames) {
  EXPECT_EQ(decodeName(kNfd), kNfc);
  EXPECT_EQ(decodeName("e\u0301.zip"), "\u00E9.zip");
}

TEST(DecodeName, TakesUtf8BeforeCp932) {
  EXPECT_EQ(decodeName("学生1"), "学生1");
  EXPECT_EQ(decodeName(kStudentCp932), "学生");
  EXPECT_EQ(decodeName("\xB1\xB2"), "ｱｲ") << "half-width katakana";
}

TEST(DecodeName, KeepsTheBackslashInsideACharacterOfCp932Apart) {
  EXPECT_EQ(decodeName("\x95\x5C\\\x95\x5C.vert"), "表\\表.vert");
}

TEST(DecodeName, IsNothingForOtherBytes) {
  EXPECT_EQ(decodeName("Jos\xE9.zip"), std::nullopt) << "Latin-1";
  EXPECT_EQ(decodeName("\xFF\xFE"), std::nullopt);
  EXPECT_EQ(decodeName("\x80"), std::nullopt);
  EXPECT_EQ(decodeName("\x8A"), std::nullopt) << "half a character";
  EXPECT_EQ(decodeOrEscape("Jos\xE9.zip"), "Jos\\xE9.zip");
}

TEST(FromCp932, NeedsNoLocale) {
  ASSERT_STREQ(std::setlocale(LC_CTYPE, nullptr), "C");
  EXPECT_EQ(fromCp932("\x82\xA0"), "あ");
  EXPECT_EQ(fromCp932(""), "");
}

TEST(DisplayName, TakesOutControlAndDirectionCharacters) {
  EXPECT_EQ(displayName("Ada\u202Egnp\u2066\x01 \n Lovelace\uFEFF"), "Adagnp Lovelace");
  EXPECT_EQ(displayName("\x01\u202E"), "(no name)");
}

TEST(DisplayName, HasAtMostAHundredCodePoints) {
  std::string name;
  for (int n = 0; n < 101; ++n) name += "影";
  EXPECT_EQ(displayName(name).size(), 99 * 3 + std::string("…").size());
  EXPECT_EQ(displayName(name.substr(0, 99 * 3)).size(), 99u * 3);
}

TEST(FolderName, KeepsLettersOfAnyScript) {
  EXPECT_EQ(folderName("Ada Lovelace", "101"), "Ada_Lovelace_101");
  EXPECT_EQ(folderName("学生 花子", "102"), "学生_花子_102");
  EXPECT_EQ(folderName("Ádám O'Neil-Őz"), "Ádám_O_Neil-Őz");
}

TEST(FolderName, IsSafeAnywhere) {
  EXPECT_EQ(folderName("../../etc/passwd"), "etc_passwd");
  EXPECT_EQ(folderName("-rf"), "rf");
  EXPECT_EQ(folderName(".hidden"), "hidden");
  EXPECT_EQ(folderName("index.html"), "index_html");
  EXPECT_EQ(folderName("a\\b:c*d?e\"f<g>h|i"), "a_b_c_d_e_f_g_h_i");
  EXPECT_EQ(folderName("end. "), "end");
  EXPECT_EQ(folderName("🙂"), "student");
  EXPECT_EQ(folderName("🙂", "7"), "7");
  EXPECT_EQ(folderName(""), "student");
}

TEST(FolderName, HasAtMostEightyBytesAndKeepsTheIdentifier) {
  std::string name;
  for (int n = 0; n < 60; ++n) name += "影";
  EXPECT_EQ(folderName(name).size(), 78u) << "26 whole characters";
  const std::string folder = folderName(name, "123456");
  EXPECT_EQ(folder.size(), 72u + 7);
  EXPECT_TRUE(folder.ends_with("影_123456")) << folder;
  EXPECT_LE(folderName(name, name).size(), 80u);
}

TEST(CaseFolded, IsEqualForNamesThatDifferInCaseOnly) {
  EXPECT_EQ(caseFolded("Floor.CPP"), caseFolded("floor.cpp"));
  EXPECT_EQ(caseFolded("ＡÄ"), caseFolded("ａä"));
  EXPECT_NE(caseFolded("a"), caseFolded("b"));
}

} // namespace
} // namespace ggrade::intake
