#include "intake/contents.hpp"
#include "intake/packed.hpp"

#include <gmock/gmock.h>

namespace ggrade::intake {
namespace {

using testing::ElementsAre;

std::string refusedAs(std::string_view name) {
  return safePath(name).refused;
}

TEST(SafePath, IsRelativeWithSlashes) {
  EXPECT_EQ(safePath("hw\\mirror\\floor.cpp").path, "hw/mirror/floor.cpp");
  EXPECT_EQ(safePath("./hw//floor.cpp").path, "hw/floor.cpp");
  EXPECT_EQ(safePath("hw/..floor.cpp").path, "hw/..floor.cpp");
}

TEST(SafePath, DecodesBeforeItTurnsBackslashes) {
  EXPECT_EQ(safePath("\x95\x5C\\floor.cpp").path, "表/floor.cpp");
  EXPECT_EQ(safePath("\u304B\u3099.vert").path, "\u304C.vert") << "NFD becomes NFC";
}

TEST(SafePath, RefusesWhatLeadsAway) {
  EXPECT_EQ(refusedAs("/etc/passwd"), "is an absolute path");
  EXPECT_EQ(refusedAs("\\\\server\\share\\x"), "is an absolute path");
  EXPECT_EQ(refusedAs("C:\\floor.cpp"), "names a drive");
  EXPECT_EQ(refusedAs("c:floor.cpp"), "names a drive");
  EXPECT_EQ(refusedAs("../floor.cpp"), "leads out of its folder");
  EXPECT_EQ(refusedAs("hw\\..\\..\\floor.cpp"), "leads out of its folder");
  EXPECT_EQ(refusedAs("hw/.."), "leads out of its folder");
}

TEST(SafePath, RefusesNamesThatNobodyShouldRead) {
  EXPECT_EQ(refusedAs(std::string_view("floor\0.cpp", 10)), "its name holds a control character");
  EXPECT_EQ(refusedAs("floor\n.cpp"), "its name holds a control character");
  EXPECT_EQ(refusedAs("floor\u0085.cpp"), "its name holds a control character");
  EXPECT_EQ(refusedAs("\xFF.cpp"), "its name is neither UTF-8 nor Shift_JIS (CP932)");
  EXPECT_EQ(safePath("\xFF.cpp").shown, "\\xFF.cpp");
  EXPECT_EQ(refusedAs(""), "has no name");
  EXPECT_EQ(refusedAs("./."), "has no name");
}

TEST(SafePath, HasLimits) {
  EXPECT_EQ(refusedAs(std::string(255, 'a')), "");
  EXPECT_EQ(refusedAs(std::string(256, 'a')), "a name of 256 bytes, 255 are allowed");
  std::string deep;
  for (int n = 0; n < 15; ++n) deep += "d/";
  EXPECT_EQ(refusedAs(deep + "x"), "");
  EXPECT_EQ(refusedAs(deep + "d/x"), "more than 16 folders deep");
}

Contents contentsOf(const std::vector<Entry>& entries) {
  Contents contents(kUploadLimits);
  for (const Entry& entry : entries) contents.add(entry);
  return contents;
}

TEST(Contents, TheFirstOfEqualNamesCounts) {
  const Contents contents = contentsOf({{.name = "floor.cpp", .size = 5, .bytes = "first"},
                                        {.name = "./floor.cpp", .size = 6, .bytes = "second"},
                                        {.name = "Floor.CPP", .size = 5, .bytes = "third"}});
  ASSERT_EQ(contents.files().size(), 1u);
  EXPECT_EQ(contents.files()[0].bytes, "first");
  EXPECT_THAT(contents.refused(),
              ElementsAre("./floor.cpp: is there twice: the first counts",
                          "Floor.CPP: differs from floor.cpp in case only: the first counts"));
}

TEST(Contents, AFileIsNoFolder) {
  const Contents contents =
      contentsOf({{.name = "a/b"}, {.name = "A"}, {.name = "c"}, {.name = "c/d"}});
  EXPECT_EQ(contents.files().size(), 2u);
  EXPECT_THAT(contents.refused(), ElementsAre("A: is a folder, too: that counts",
                                              "c/d: c is a file, too: that counts"));
}

TEST(Contents, RefusesEveryOtherKindByName) {
  const Contents contents = contentsOf({{.name = "a", .kind = Kind::symbolicLink},
                                        {.name = "b", .kind = Kind::hardLink},
                                        {.name = "c", .kind = Kind::device},
                                        {.name = "d", .kind = Kind::fifo},
                                        {.name = "e", .kind = Kind::socket},
                                        {.name = "f", .kind = Kind::encrypted},
                                        {.name = "g", .kind = Kind::damaged},
                                        {.name = "h", .kind = Kind::tooLarge, .size = 5000000},
                                        {.name = "i", .kind = Kind::folder}});
  EXPECT_TRUE(contents.files().empty());
  EXPECT_THAT(contents.refused(),
              ElementsAre("a: is a symbolic link", "b: is a hard link", "c: is a device",
                          "d: is a FIFO", "e: is a socket",
                          "f: is encrypted: ask for an upload without a password",
                          "g: is damaged, or compressed in a way that is not read",
                          "h: 5000000 bytes or more, a file may have 4 MiB"));
}

TEST(Contents, CountsClutter) {
  EXPECT_EQ(contentsOf({}).clutterRemark(), "");
  EXPECT_EQ(contentsOf({{.name = ".DS_Store", .kind = Kind::clutter}}).clutterRemark(),
            "passed over 1 entry: .DS_Store");
  EXPECT_EQ(contentsOf({{.name = "._*", .kind = Kind::clutter},
                        {.name = "._*", .kind = Kind::clutter},
                        {.name = ".DS_Store", .kind = Kind::clutter}})
                .clutterRemark(),
            "passed over 3 entries: .DS_Store, ._*");
}

TEST(Contents, HasLimits) {
  Limits limits;
  limits.entries = 2;
  limits.bytes = 1 << 20;
  Contents contents(limits);
  const std::string mebibyte(1 << 20, 'x');
  contents.add({.name = "a", .size = mebibyte.size(), .bytes = mebibyte});
  EXPECT_THAT([&] { contents.add({.name = "b", .size = 1, .bytes = "x"}); },
              testing::ThrowsMessage<UploadProblem>("holds more than 1 MiB of files"));
  EXPECT_THAT([&] { contents.add({.name = "c", .kind = Kind::folder}); },
              testing::ThrowsMessage<UploadProblem>("holds more than 2 files and folders"));
}

} // namespace
} // namespace ggrade::intake
