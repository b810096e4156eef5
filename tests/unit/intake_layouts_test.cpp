#include "intake/bundle.hpp"
#include "intake/layouts.hpp"

#include <gmock/gmock.h>

namespace ggrade::intake {
namespace {

TEST(MoodleName, IsReadWithAndWithoutTheLastBar) {
  for (const char* entry :
       {"Hanako Yamada_101_assignsubmission_file_", "Hanako Yamada_101_assignsubmission_file"}) {
    const auto name = parseMoodle(entry);
    ASSERT_TRUE(name) << entry;
    EXPECT_EQ(name->name, "Hanako Yamada");
    EXPECT_EQ(name->identifier, "101");
    EXPECT_EQ(name->file, "");
    EXPECT_FALSE(name->onlineText);
  }
}

TEST(MoodleName, HoldsTheFileWhereThereAreNoFolders) {
  const auto name = parseMoodle("山田_花子_102_assignsubmission_file_home_work.zip");
  ASSERT_TRUE(name);
  EXPECT_EQ(name->name, "山田_花子");
  EXPECT_EQ(name->identifier, "102");
  EXPECT_EQ(name->file, "home_work.zip");
}

TEST(MoodleName, SaysOnlineText) {
  EXPECT_TRUE(parseMoodle("A B_103_assignsubmission_onlinetext_")->onlineText);
  EXPECT_TRUE(parseMoodle("A B_103_assignsubmission_onlinetext_onlinetext.html")->onlineText);
}

TEST(MoodleName, CannotBeForgedByAFileName) {
  const auto name = parseMoodle("Eve_666_assignsubmission_file_Ada_101_assignsubmission_file_.zip");
  ASSERT_TRUE(name);
  EXPECT_EQ(name->identifier, "666");
  EXPECT_EQ(name->file, "Ada_101_assignsubmission_file_.zip");
}

TEST(MoodleName, IsNothingElse) {
  for (const char* entry : {"Ada", "Ada_assignsubmission_file_", "Ada_x1_assignsubmission_file_",
                            "Ada__assignsubmission_file_", "Ada_1_assignsubmission_fileX",
                            "Ada_1_assignsubmission_comments_", "_assignsubmission_file_"})
    EXPECT_FALSE(parseMoodle(entry)) << entry;
}

TEST(CanvasName, IsReadWithAndWithoutLate) {
  const auto name = parseCanvas("yamadahanako_5012_80311_floor.cpp");
  ASSERT_TRUE(name);
  EXPECT_EQ(name->name, "yamadahanako");
  EXPECT_EQ(name->user, "5012");
  EXPECT_EQ(name->file, "floor.cpp");
  EXPECT_FALSE(name->late);
  const auto late = parseCanvas("山田花子_LATE_5013_80312_my_homework-1.zip");
  ASSERT_TRUE(late);
  EXPECT_EQ(late->name, "山田花子");
  EXPECT_EQ(late->user, "5013");
  EXPECT_EQ(late->file, "my_homework-1.zip");
  EXPECT_TRUE(late->late);
}

TEST(CanvasName, CannotBeForgedByAFileName) {
  EXPECT_EQ(parseCanvas("eve_666_1_ada_5012_2_floor.cpp")->user, "666");
  EXPECT_EQ(parseCanvas("eve_666_1_LATE_5012_2_floor.cpp")->late, false);
}

TEST(CanvasName, IsNothingElse) {
  for (const char* entry : {"floor.cpp", "ada_1_floor.cpp", "_1_2_floor.cpp", "ada_1_2_",
                            "ada_x_2_floor.cpp", "ada_LATE_floor.cpp", ""})
    EXPECT_FALSE(parseCanvas(entry)) << entry;
}

TEST(SplitNumber, KnowsCanvasAndBrowsers) {
  const auto expect = [](const char* file, const char* name, unsigned number) {
    EXPECT_EQ(splitNumber(file).name, name) << file;
    EXPECT_EQ(splitNumber(file).number, number) << file;
  };
  expect("floor-1.cpp", "floor.cpp", 1);
  expect("floor-12.cpp", "floor.cpp", 12);
  expect("floor (3).cpp", "floor.cpp", 3);
  expect("floor(3).cpp", "floor.cpp", 3);
  expect("homework-2.tar.gz", "homework.tar.gz", 2);
  expect("README-4", "README", 4);
  expect("floor.cpp", "floor.cpp", 0);
  expect("floor2.cpp", "floor2.cpp", 0);
  expect("-1.cpp", "-1.cpp", 0);
  expect("7.cpp", "7.cpp", 0);
  expect("a-99999.cpp", "a-99999.cpp", 0);
  expect("a-1).cpp", "a-1).cpp", 0);
  expect("", "", 0);
}

TEST(ArchiveSuffix, IsFoundWhateverItsCase) {
  EXPECT_EQ(archiveSuffix("a.ZIP"), ".zip");
  EXPECT_EQ(archiveSuffix("a.b.Tar.Gz"), ".tar.gz");
  EXPECT_EQ(archiveSuffix("a.tzst"), ".tzst");
  EXPECT_EQ(archiveSuffix(".zip"), "") << "nothing before it";
  EXPECT_EQ(archiveSuffix("a.7z"), "");
  EXPECT_TRUE(isOtherArchive("a.7z"));
  EXPECT_TRUE(isOtherArchive("floor.cpp.gz"));
  EXPECT_FALSE(isOtherArchive("a.tar.gz"));
  EXPECT_FALSE(isOtherArchive("floor.cpp"));
}

TEST(Clutter, IsFoundAnywhereInAPath) {
  EXPECT_EQ(clutterIn("__MACOSX/hw/._floor.cpp"), "__MACOSX");
  EXPECT_EQ(clutterIn("hw/.DS_Store"), ".DS_Store");
  EXPECT_EQ(clutterIn("hw\\.vs\\x\\y.db"), ".vs");
  EXPECT_EQ(clutterIn("hw/.git/config"), ".git");
  EXPECT_EQ(clutterIn("Thumbs.db"), "Thumbs.db");
  EXPECT_EQ(clutterIn("hw/._floor.cpp"), "._*");
  EXPECT_EQ(clutterIn("hw/.gitignore"), "");
  EXPECT_EQ(clutterIn("hw/a.vs"), "");
  EXPECT_EQ(clutterIn(""), "");
}

} // namespace
} // namespace ggrade::intake
