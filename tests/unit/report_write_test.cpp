#include "report/reports.hpp"
#include "report/write_file.hpp"
#include "report_samples.hpp"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <unistd.h>

namespace ggrade::report {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class WriteFile : public testing::Test {
protected:
  WriteFile() { fs::create_directories(folder_); }
  ~WriteFile() override { fs::remove_all(folder_); }

  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  static std::string messageOf(const std::function<void()>& action) {
    try {
      action();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "(nothing thrown)";
  }

  const fs::path folder_ = fs::temp_directory_path() / ("ggrade-write-" + std::to_string(getpid()));
};

TEST_F(WriteFile, ReplacesTheWholeFileAndLeavesNothingElse) {
  writeFile(folder_ / "a.txt", "a longer first text");
  writeFile(folder_ / "a.txt", "short");
  EXPECT_EQ(read(folder_ / "a.txt"), "short");
  EXPECT_EQ(files(), 1u);
}

TEST_F(WriteFile, SaysPathCauseAndRemedy) {
  writeFile(folder_ / "file", "kept");
  const std::string message = messageOf([&] { writeFile(folder_ / "file" / "results.json", "x"); });
  EXPECT_THAT(message, HasSubstr((folder_ / "file" / "results.json").string()));
  EXPECT_THAT(message, HasSubstr("choose a folder that you may write to and that has room"));
  EXPECT_EQ(read(folder_ / "file"), "kept");
  EXPECT_EQ(files(), 1u);
}

TEST_F(WriteFile, FolderThatRefusesNewFilesIsAnError) {
  // /proc refuses new files even to root.
  const std::string message = messageOf([] { writeFile("/proc/results.json", "x"); });
  EXPECT_THAT(message, HasSubstr("cannot write '/proc/results.json'"));
  EXPECT_THAT(message, HasSubstr("choose a folder"));
}

TEST_F(WriteFile, FolderInAFilesPlaceIsNamed) {
  writeFile(folder_ / "file", "kept");
  const std::string message = messageOf([&] { makeFolder(folder_ / "file" / "out"); });
  EXPECT_THAT(message,
              HasSubstr("cannot make the folder '" + (folder_ / "file" / "out").string() + "'"));
  EXPECT_THAT(message, HasSubstr("choose a folder"));
  EXPECT_THAT(messageOf([&] { makeFolder(folder_ / "file"); }),
              HasSubstr("cannot make the folder"));
}

TEST_F(WriteFile, WriteReportsMakesTheFourFiles) {
  writeReports(folder_ / "new" / "out", samples::partial(64, 48));
  for (const char* name : {"results.json", "junit.xml", "index.html", "student.html"})
    EXPECT_GT(fs::file_size(folder_ / "new" / "out" / name), 1000u) << name;
  EXPECT_THAT(read(folder_ / "new" / "out" / "index.html"), HasSubstr("Hand back student.html"));
}

} // namespace
} // namespace ggrade::report
