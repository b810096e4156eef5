// Archives of students who mean well, on Windows, Macs and Linux, in Japan and elsewhere.
#include "intake_fixture.hpp"

namespace ggrade::intake {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

ARCHIVE_SUITE(HonestArchive);

TEST_P(HonestArchive, ZipIsUnpacked) {
  const Unpacked result = unpackBytes(
      "student1.zip", zipOf({{"hw/", "", 0, 3, 040755},
                             {"hw/floor.cpp", "int a;\r\n"},
                             {.name = "hw/sub/x.png", .bytes = "pixels", .deflated = true}}));
  EXPECT_EQ(result.problem, "");
  EXPECT_THAT(result.refused, IsEmpty());
  EXPECT_THAT(result.remarks, IsEmpty());
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "sub/x.png"));
  EXPECT_EQ(textOf(into / "floor.cpp"), "int a;\r\n");
  EXPECT_EQ(textOf(into / "sub/x.png"), "pixels");
}

TEST_P(HonestArchive, TarIsUnpackedWithEveryCompression) {
  const std::string tar = tarOf({{"hw/", "", '5'}, {"hw/floor.cpp", "int a;"}});
  const std::pair<const char*, Compression> kinds[] = {
      {".tar", Compression::none},  {".tar.gz", Compression::gzip},
      {".tgz", Compression::gzip},  {".tar.bz2", Compression::bzip2},
      {".tar.xz", Compression::xz}, {".tar.zst", Compression::zstd}};
  for (const auto& [suffix, kind] : kinds) {
    const Unpacked result = unpackBytes(std::string("student1") + suffix, compressed(tar, kind));
    EXPECT_EQ(result.problem, "") << suffix;
    EXPECT_EQ(textOf(into / "floor.cpp"), "int a;") << suffix;
    EXPECT_EQ(fs::status(into / "floor.cpp").permissions(), fs::perms(0644)) << "was 06777";
  }
}

TEST_P(HonestArchive, NamesOfJapaneseWindowsAreDecoded) {
  const Unpacked result = unpackBytes(
      "student1.zip",
      zipOf({{"\x95\x5C\\floor.cpp", "a", 0, 0}, {"\x95\x5C\\\x89\x65.frag", "b", 0, 0}}));
  EXPECT_EQ(result.problem, "");
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "影.frag")) << "表 ends in a backslash";
}

TEST_P(HonestArchive, BackslashesOfWindowsDivideFolders) {
  const Unpacked result = unpackBytes(
      "student1.zip", zipOf({{"hw\\floor.cpp", "a", 0, 0}, {"hw\\sub\\x.frag", "b", 0, 0}}));
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "sub/x.frag"));
  EXPECT_THAT(result.refused, IsEmpty());
}

TEST_P(HonestArchive, NamesMarkedAsUtf8AreTakenAsSuch) {
  // As CP932, too, these bytes mean something.
  unpackBytes("student1.zip", zipOf({{"floor.cpp", "", 0x800}, {"影.frag", "", 0x800}}));
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "影.frag"));
}

TEST_P(HonestArchive, MacsLeaveNfdAndMacosx) {
  const Unpacked result = unpackBytes("student1.zip", zipOf({{"課題/floor.cpp", "a"},
                                                             {"課題/か\u3099.frag", "b"},
                                                             {"課題/.DS_Store", "x"},
                                                             {"__MACOSX/課題/._floor.cpp", "x"},
                                                             {"__MACOSX/._課題", "x"}}));
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "\u304C.frag"));
  EXPECT_THAT(result.remarks, ElementsAre("passed over 3 entries: .DS_Store, __MACOSX"));
  EXPECT_THAT(result.refused, IsEmpty());
}

TEST_P(HonestArchive, VisualStudiosFoldersCostNothing) {
  // Of these bytes none is read; otherwise they would be more than 32 MiB.
  std::vector<ZipEntry> entries = {{"hw/floor.cpp", "a"}};
  for (int n = 0; n < 11; ++n)
    entries.push_back({.name = "hw/.vs/hw/v17/" + std::to_string(n) + ".ipch",
                       .bytes = std::string(4 << 20, 'x'),
                       .deflated = true});
  const Unpacked result = unpackBytes("student1.zip", zipOf(entries));
  EXPECT_EQ(result.problem, "");
  EXPECT_THAT(result.remarks, ElementsAre("passed over 11 entries: .vs"));
}

TEST_P(HonestArchive, SourcesKeepMarksAndLineEndsButBecomeUtf8) {
  const Unpacked result =
      unpackBytes("student1.zip", zipOf({{"floor.cpp", "\xEF\xBB\xBFint a;\r\n"},
                                         {"mirror.vert", "// \x95\x5C\r\n#version 410 core\r\n"}}));
  EXPECT_EQ(textOf(into / "floor.cpp"), "\xEF\xBB\xBFint a;\r\n");
  EXPECT_EQ(textOf(into / "mirror.vert"), "// 表\r\n#version 410 core\r\n");
  EXPECT_THAT(result.remarks, ElementsAre("mirror.vert was Shift_JIS (CP932)"));
}

TEST_P(HonestArchive, MayStandInAFolderBesideOtherFiles) {
  folder.write("student1/homework.zip", zipOf({{"floor.cpp", "zip"}}));
  folder.write("student1/mirror.vert", "file");
  const Unpacked result = unpack(uploadOf(folder.path() / "student1"), kWanted, into, GetParam());
  EXPECT_EQ(result.problem, "");
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "mirror.vert"));
}

} // namespace
} // namespace ggrade::intake
