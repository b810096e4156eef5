// What archives may hold and nobody gets: each entry is refused by name, the rest is taken.
#include "intake_fixture.hpp"

namespace ggrade::intake {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class RefusedEntry : public ArchiveUpload {
protected:
  std::vector<std::string> refusedOf(const std::string& name, const std::string& bytes) {
    const Unpacked result = unpackBytes(name, bytes);
    EXPECT_EQ(result.problem, "");
    EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp"));
    return result.refused;
  }
  std::vector<std::string> refusedInZip(std::vector<ZipEntry> entries) {
    entries.insert(entries.begin(), {"floor.cpp", "int a;"});
    return refusedOf("student1.zip", zipOf(entries));
  }
  std::vector<std::string> refusedInTar(std::vector<TarEntry> entries) {
    entries.insert(entries.begin(), {"floor.cpp", "int a;"});
    return refusedOf("student1.tar", tarOf(entries));
  }
};
INSTANTIATE_TEST_SUITE_P(With, RefusedEntry,
                         testing::Values(sandbox::Isolation::bwrap, sandbox::Isolation::none),
                         [](const auto& parameter) {
                           return parameter.param == sandbox::Isolation::bwrap ? "bwrap" : "none";
                         });

TEST_P(RefusedEntry, PathsThatLeadAway) {
  const fs::path outside = folder.path() / "outside";
  EXPECT_THAT(
      refusedInZip({{outside.string(), "x"},
                    {"../outside", "x"},
                    {"hw/../../outside", "x"},
                    {"..\\outside", "x", 0, 0},
                    {"C:\\outside", "x", 0, 0},
                    {"\\\\server\\outside", "x", 0, 0}}),
      ElementsAre(outside.string() + ": is an absolute path", "../outside: leads out of its folder",
                  "hw/../../outside: leads out of its folder",
                  HasSubstr("outside: leads out of its folder"),
                  HasSubstr("outside: names a drive"), HasSubstr("outside: is an absolute path")));
  EXPECT_THAT(refusedInTar({{outside.string(), "x"}, {"../outside", "x"}}),
              ElementsAre(outside.string() + ": is an absolute path",
                          "../outside: leads out of its folder"));
  EXPECT_FALSE(fs::exists(outside));
}

TEST_P(RefusedEntry, LinksAndDevices) {
  EXPECT_THAT(refusedInTar({{"mirror.vert", "", '2', -1, "/etc/passwd"},
                            {"tile.vert", "", '1', -1, "floor.cpp"},
                            {"terminal", "", '3'},
                            {"disk", "", '4'},
                            {"pipe", "", '6'}}),
              ElementsAre("mirror.vert: is a symbolic link", "tile.vert: is a hard link",
                          "terminal: is a device", "disk: is a device", "pipe: is a FIFO"));
  EXPECT_THAT(refusedInZip({{"mirror.vert", "/etc/passwd", 0, 3, 0120777}}),
              ElementsAre("mirror.vert: is a symbolic link"));
}

TEST_P(RefusedEntry, NothingIsWrittenThroughALink) {
  const fs::path outside = folder.path() / "outside";
  fs::create_directory(outside);
  const Unpacked result = unpackBytes("a.tar", tarOf({{"floor.cpp", ""},
                                                      {"link", "", '2', -1, outside.string()},
                                                      {"link/x", "through it"}}));
  EXPECT_THAT(result.refused, ElementsAre("link: is a symbolic link"));
  EXPECT_TRUE(fs::is_empty(outside));
  EXPECT_EQ(textOf(into / "link/x"), "through it") << "in a folder of its own";
}

TEST_P(RefusedEntry, EqualNames) {
  EXPECT_THAT(refusedInZip({{"floor.cpp", "second"}, {"FLOOR.cpp", "third"}}),
              ElementsAre("floor.cpp: is there twice: the first counts",
                          "FLOOR.cpp: differs from floor.cpp in case only: the first counts"));
  EXPECT_EQ(textOf(into / "floor.cpp"), "int a;");
}

TEST_P(RefusedEntry, NamesWithControlCharacters) {
  EXPECT_THAT(refusedInZip({{"mirror\n.vert", "x"}, {"\x1B[2Jx.vert", "x"}}),
              ElementsAre("mirror .vert: its name holds a control character",
                          "x.vert: its name holds a control character"));
}

TEST_P(RefusedEntry, NamesInNoEncoding) {
  EXPECT_THAT(refusedInZip({{"Jos\xE9.vert", "x"}}),
              ElementsAre("Jos\\xE9.vert: its name is neither UTF-8 nor Shift_JIS (CP932)"));
}

TEST_P(RefusedEntry, NamesEndAtNul) {
  // libarchive's names do; what comes behind can make nothing else of the file.
  EXPECT_THAT(refusedInZip({{std::string("floor.cpp\0.exe", 14), "x"}}),
              ElementsAre("floor.cpp: is there twice: the first counts"));
}

TEST_P(RefusedEntry, LongAndDeepNames) {
  std::string deep;
  for (int n = 0; n < 16; ++n) deep += "d/";
  EXPECT_THAT(
      refusedInZip(
          {{std::string(256, 'a'), "x"}, {deep + "x", "x"}, {std::string(60000, 'b'), "x"}}),
      ElementsAre(HasSubstr("a name of 256 bytes, 255 are allowed"),
                  deep + "x: more than 16 folders deep", HasSubstr("bytes, 255 are")));
}

TEST_P(RefusedEntry, EncryptedOnes) {
  EXPECT_THAT(refusedInZip({{"mirror.vert", "0123456789abcdef", 1}}),
              ElementsAre("mirror.vert: is encrypted: ask for an upload without a password"));
}

TEST_P(RefusedEntry, DamagedOnes) {
  EXPECT_THAT(refusedInZip({{.name = "mirror.vert", .bytes = "text", .crcError = 1}}),
              ElementsAre("mirror.vert: is damaged, or compressed in a way that is not read"));
}

TEST_P(RefusedEntry, ArchivesInArchives) {
  EXPECT_THAT(refusedInZip({{"old.zip", zipOf({{"mirror.vert", "x"}})}, {"old.rar", "Rar!"}}),
              ElementsAre("old.zip: an archive in an archive is not unpacked",
                          "old.rar: an archive in an archive is not unpacked"));
}

TEST_P(RefusedEntry, LargeFiles) {
  EXPECT_THAT(
      refusedInZip({{.name = "a.exe", .bytes = std::string((4 << 20) + 1, 'x'), .deflated = true}}),
      ElementsAre("a.exe: 4194305 bytes or more, a file may have 4 MiB"));
}

} // namespace
} // namespace ggrade::intake
