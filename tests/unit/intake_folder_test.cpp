#include "few_descriptors.hpp"
#include "intake/unpack.hpp"
#include "intake_samples.hpp"

#include "assignment/usage_error.hpp"

#include <gmock/gmock.h>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace ggrade::intake {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class FolderUpload : public testing::Test {
protected:
  Unpacked unpackUpload(const std::string& name = "student1") const {
    return unpack(uploadOf(folder.path() / name), kWanted, into, sandbox::Isolation::none);
  }

  TemporaryFolder folder;
  const fs::path into = folder.path() / "into";
  const fs::path upload = folder.path() / "student1";
};

TEST_F(FolderUpload, BecomesPlainFiles) {
  const fs::path file = folder.write("student1/hw/floor.cpp", "\xEF\xBB\xBFint a;\r\n");
  fs::permissions(file, fs::perms(0700));
  folder.write("student1/hw/textures/tile.png", std::string("\0\xFF", 2));
  const Unpacked result = unpackUpload();
  EXPECT_EQ(result.problem, "");
  EXPECT_THAT(result.refused, IsEmpty());
  EXPECT_THAT(result.remarks, IsEmpty());
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "textures/tile.png"));
  EXPECT_EQ(textOf(into / "floor.cpp"), "\xEF\xBB\xBFint a;\r\n") << "BOM and CRLF stay";
  EXPECT_EQ(textOf(into / "textures/tile.png"), std::string("\0\xFF", 2));
  EXPECT_EQ(fs::status(into / "floor.cpp").permissions(), fs::perms(0644));
}

// Else they would count as not handed in, or the upload as empty.
TEST_F(FolderUpload, WhatCantBeOpenedForWantOfDescriptorsIsNoFaultOfTheUpload) {
  folder.write("student1/floor.cpp", "a");
  folder.write("student1/hw/mirror.vert", "b");
  std::size_t refused = 0;
  for (rlim_t left = 0; left < 6; ++left) {
    fs::remove_all(into);
    Unpacked result;
    std::string error;
    {
      const FewDescriptors few(left);
      try {
        result = unpackUpload();
      } catch (const std::system_error& problem) {
        error = problem.what();
      } catch (const UsageError& problem) {
        error = problem.what();
      }
    }
    EXPECT_EQ(result.problem, "") << left;
    if (error.empty()) {
      EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "hw/mirror.vert")) << left;
      EXPECT_THAT(result.refused, IsEmpty()) << left;
    } else {
      ++refused;
      EXPECT_THAT(error, HasSubstr("Too many open files")) << left;
    }
  }
  EXPECT_GE(refused, 1U);
  EXPECT_LE(refused, 5U);
}

TEST_F(FolderUpload, LinksAndDevicesAreRefusedByName) {
  folder.write("student1/floor.cpp", "");
  fs::create_symlink("/etc/passwd", upload / "mirror.vert");
  fs::create_directory_symlink("/etc", upload / "etc");
  fs::create_symlink("floor.cpp", upload / "tile.vert");
  ASSERT_EQ(mkfifo((upload / "pipe.vert").c_str(), 0600), 0);
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  const std::string path = (upload / "socket").string();
  ASSERT_LT(path.size(), sizeof address.sun_path);
  path.copy(address.sun_path, path.size());
  const int socketFile = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(socketFile, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  close(socketFile);
  const Unpacked result = unpackUpload();
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp"));
  EXPECT_THAT(result.refused, ElementsAre("etc: is a symbolic link",
                                          "mirror.vert: is a symbolic link", "pipe.vert: is a FIFO",
                                          "socket: is a socket", "tile.vert: is a symbolic link"));
}

TEST_F(FolderUpload, ClutterIsCounted) {
  folder.write("student1/floor.cpp", "");
  folder.write("student1/.vs/a/b", "");
  folder.write("student1/.git/config", "");
  folder.write("student1/.DS_Store", "");
  folder.write("student1/._floor.cpp", "");
  folder.write("student1/Thumbs.db", "");
  folder.write("student1/__MACOSX/._floor.cpp", "");
  const Unpacked result = unpackUpload();
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp"));
  EXPECT_THAT(result.refused, IsEmpty());
  EXPECT_THAT(result.remarks, ElementsAre("passed over 6 entries: .DS_Store, ._*, .git, .vs, "
                                          "Thumbs.db, __MACOSX"));
}

TEST_F(FolderUpload, NamesOfOtherCaseAndEncodingAreTaken) {
  folder.write("student1/Floor.CPP", "");
  folder.write("student1/\x89\x65.frag", "");
  folder.write("student1/か\u3099.frag", "");
  const Unpacked result = unpackUpload();
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "\u304C.frag", "影.frag"));
  EXPECT_THAT(result.remarks, ElementsAre("Floor.CPP counts as floor.cpp"));
}

TEST_F(FolderUpload, SourcesInShiftJisBecomeUtf8) {
  folder.write("student1/floor.cpp", "// \x89\x65\x95\x5C\nint a;\n");
  folder.write("student1/mirror.vert", "// Jos\xE9.\n");
  folder.write("student1/photo.jpg", "\x89\x65");
  const Unpacked result = unpackUpload();
  EXPECT_EQ(textOf(into / "floor.cpp"), "// 影表\nint a;\n");
  EXPECT_EQ(textOf(into / "mirror.vert"), "// Jos\xE9.\n");
  EXPECT_EQ(textOf(into / "photo.jpg"), "\x89\x65");
  EXPECT_THAT(result.remarks,
              ElementsAre("floor.cpp was Shift_JIS (CP932)",
                          "mirror.vert is neither UTF-8 nor Shift_JIS (CP932): save it as UTF-8"));
}

TEST_F(FolderUpload, ASingleFileGetsTheWantedName) {
  folder.write("student1.cpp", "int a;");
  const Unpacked result = unpackUpload("student1.cpp");
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp"));
  EXPECT_THAT(result.remarks, ElementsAre("student1.cpp counts as floor.cpp"));
}

TEST_F(FolderUpload, ASingleFileThatCouldBeTwoDoesNot) {
  folder.write("student1.vert", "");
  EXPECT_EQ(unpackUpload("student1.vert").problem,
            "the upload holds none of floor.cpp, mirror.vert, tile.vert");
  EXPECT_THAT(filesIn(into), IsEmpty());
}

TEST_F(FolderUpload, NumbersOfBrowsersAreTakenOff) {
  folder.write("student1/floor (1).cpp", "");
  folder.write("student1/tile-2.vert", "two");
  folder.write("student1/tile.vert", "plain");
  const Unpacked result = unpackUpload();
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "tile-2.vert", "tile.vert"));
  EXPECT_EQ(textOf(into / "tile.vert"), "plain");
  EXPECT_THAT(result.remarks, ElementsAre("floor (1).cpp counts as floor.cpp"));
}

TEST_F(FolderUpload, SeveralSourcesAreOneUpload) {
  Upload several;
  several.sources = {{folder.write("ada_1_2_floor.cpp", "a"), "floor.cpp"},
                     {folder.write("ada_1_3_tile.vert", "b"), "tile.vert"}};
  EXPECT_EQ(unpack(several, kWanted, into, sandbox::Isolation::none).problem, "");
  EXPECT_THAT(filesIn(into), ElementsAre("floor.cpp", "tile.vert"));
}

TEST_F(FolderUpload, ASourceThatIsALinkIsNotFollowed) {
  folder.write("elsewhere/floor.cpp", "");
  fs::create_directory_symlink(folder.path() / "elsewhere", upload);
  const Unpacked result = unpackUpload();
  EXPECT_THAT(result.problem, HasSubstr("holds none of"));
  EXPECT_THAT(result.refused, ElementsAre("student1: is a symbolic link"));
}

TEST_F(FolderUpload, ArchivesInFoldersOfItAndOtherArchivesAreRefused) {
  folder.write("student1/floor.cpp", "");
  folder.write("student1/old/hw.zip", "PK");
  folder.write("student1/hw.rar", "Rar!");
  const Unpacked result = unpackUpload();
  EXPECT_THAT(result.refused,
              ElementsAre("hw.rar: only zip and tar files (gz, bz2, xz, zst) are unpacked",
                          "old/hw.zip: an archive in a folder is not unpacked"));
  folder.write("student2.7z", "7z");
  const Unpacked other = unpack(uploadOf(folder.path() / "student2.7z"), kWanted,
                                folder.path() / "other", sandbox::Isolation::none);
  EXPECT_THAT(other.problem, HasSubstr("holds none of"));
  EXPECT_THAT(other.refused, ElementsAre(HasSubstr("student2.7z: only zip and tar")));
}

TEST_F(FolderUpload, LimitsHold) {
  folder.write("student1/floor.cpp", "");
  folder.write("student1/huge.png", std::string((4 << 20) + 1, 'x'));
  const Unpacked one = unpackUpload();
  EXPECT_EQ(one.problem, "");
  EXPECT_THAT(one.refused, ElementsAre("huge.png: 4194305 bytes or more, a file may have 4 MiB"));

  for (int n = 0; n < 2000; ++n) folder.write("many/" + std::to_string(n), "");
  folder.write("many/floor.cpp", "");
  const Unpacked many = unpack(uploadOf(folder.path() / "many"), kWanted, folder.path() / "out",
                               sandbox::Isolation::none);
  EXPECT_EQ(many.problem, "holds more than 2000 files and folders");
  EXPECT_THAT(filesIn(folder.path() / "out"), IsEmpty());

  for (int n = 0; n < 9; ++n) folder.write("large/" + std::to_string(n), std::string(4 << 20, 'x'));
  folder.write("large/floor.cpp", "");
  const Unpacked large = unpack(uploadOf(folder.path() / "large"), kWanted, folder.path() / "out",
                                sandbox::Isolation::none);
  EXPECT_EQ(large.problem, "holds more than 32 MiB of files");
}

TEST_F(FolderUpload, DepthIsLimited) {
  folder.write("student1/floor.cpp", "");
  std::string deep = "student1/";
  for (int n = 0; n < 20; ++n) deep += "d/";
  folder.write(deep + "x", "");
  const Unpacked result = unpackUpload();
  EXPECT_EQ(result.problem, "");
  EXPECT_THAT(result.refused, ElementsAre(HasSubstr("d: more than 16 folders deep")));
}

TEST_F(FolderUpload, NeedsAFreshFolder) {
  folder.write("student1/floor.cpp", "");
  folder.write("into/old", "");
  EXPECT_THAT([&] { unpackUpload(); }, testing::ThrowsMessage<UsageError>(
                                           into.string() + " is not empty: name a new folder"));
}

} // namespace
} // namespace ggrade::intake
