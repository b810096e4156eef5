#include "image/png.hpp"
#include "image/temporary_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace ggrade;
namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

class WholeFile : public testing::Test {
protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "/whole_file_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  static void write(const fs::path& path, const std::string& text) {
    writeWholeFile(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  }
  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::ptrdiff_t filesInFolder() const {
    return std::distance(fs::directory_iterator(folder_), {});
  }

  fs::path folder_;
};

TEST_F(WholeFile, ReplacesAFileAndLeavesNothingElse) {
  const auto path = folder_ / "a.txt";
  write(path, "first");
  write(path, "second");
  EXPECT_EQ(read(path), "second");
  EXPECT_EQ(filesInFolder(), 1);
  struct stat info;
  ASSERT_EQ(stat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0400, 0400u);
}

TEST_F(WholeFile, FollowsALinkInsteadOfReplacingIt) {
  write(folder_ / "real.txt", "old");
  fs::create_symlink("real.txt", folder_ / "link.txt");
  write(folder_ / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(read(folder_ / "real.txt"), "new");
}

TEST_F(WholeFile, UncommittedFileDisappears) {
  const auto path = folder_ / "kept.exr";
  write(path, "old");
  {
    TemporaryFile file(path);
    EXPECT_EQ(file.path().extension(), ".exr");
    EXPECT_EQ(file.path().parent_path(), folder_);
    std::ofstream(file.path()) << "half";
  }
  EXPECT_EQ(read(path), "old");
  EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(WholeFile, NamesWhatStandsInTheWay) {
  EXPECT_THAT([&] { write(folder_ / "no" / "a.png", "x"); },
              ThrowsMessage<std::runtime_error>("cannot write '" + (folder_ / "no/a.png").string() +
                                                "': there is no folder '" +
                                                (folder_ / "no").string() + "'; create it first"));
  EXPECT_THAT([&] { write(folder_, "x"); },
              ThrowsMessage<std::runtime_error>(EndsWith("it is a folder; name a file in it")));
  EXPECT_THAT(
      [] { write("/dev/null", "x"); },
      ThrowsMessage<std::runtime_error>("cannot write '/dev/null': it is not a regular file"));
}

TEST_F(WholeFile, NamesMissingPermission) {
  const bool root = geteuid() == 0;
  chmod(folder_.c_str(), 0555);
  if (root) {
    ASSERT_EQ(seteuid(65534), 0); // root may write anywhere
  }
  EXPECT_THAT([&] { writePng(folder_ / "a.png", Image(1, 1, 3)); },
              ThrowsMessage<std::runtime_error>("cannot write '" + (folder_ / "a.png").string() +
                                                "': Permission denied"));
  if (root) {
    ASSERT_EQ(seteuid(0), 0);
  }
  chmod(folder_.c_str(), 0755);
}

// A limit on the size of files fails a write in the middle, as a full disk does.
TEST_F(WholeFile, KeepsTheOldFileWhenWritingFailsHalfway) {
  const auto path = folder_ / "a.txt";
  write(path, "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THAT([&] { write(path, std::string(1000, 'x')); },
              ThrowsMessage<std::runtime_error>(EndsWith("File too large")));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(read(path), "old");
  EXPECT_EQ(filesInFolder(), 1);
}

} // namespace
