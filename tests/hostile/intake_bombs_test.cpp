// Archives that are refused as a whole: nothing of them is left, and the message names the limit.
#include "intake/packed.hpp"
#include "intake_fixture.hpp"

namespace ggrade::intake {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

ARCHIVE_SUITE(BadArchive);

/// Why the upload can't be used; nothing of it may be left.
std::string problemOf(const Unpacked& result, const fs::path& into) {
  EXPECT_TRUE(fs::is_empty(into));
  return result.problem;
}

TEST_P(BadArchive, ManyZerosMeetTheLimitOfAllFiles) {
  std::vector<ZipEntry> entries = {{"floor.cpp", "int a;"}};
  for (int n = 0; n < 9; ++n)
    entries.push_back(
        {.name = std::to_string(n), .bytes = std::string(4 << 20, '\0'), .deflated = true});
  const std::string zip = zipOf(entries);
  EXPECT_LT(zip.size(), 50000u);
  EXPECT_EQ(problemOf(unpackBytes("a.zip", zip), into), "a.zip holds more than 32 MiB of files");
}

TEST_P(BadArchive, OverlappingFilesMeetTheLimitOfAllFiles) {
  const std::string zip = overlappingZip(20, 3 << 20);
  EXPECT_LT(zip.size(), 6000u) << "of 60 MiB";
  EXPECT_EQ(problemOf(unpackBytes("a.zip", zip), into), "a.zip holds more than 32 MiB of files");
}

/// A tar file of one file of eight gigabytes of zeros, as gzip files of 16 MiB, one behind the
/// other: 8 MB.
std::string bombOfZeros() {
  const std::string zeros = compressed(std::string(16 << 20, '\0'), Compression::gzip);
  const std::string tar = tarOf({{.name = "floor.cpp", .claimedSize = (8ll << 30) - 1}});
  std::string bomb = compressed(tar.substr(0, 512), Compression::gzip);
  for (int n = 0; n < 512; ++n) bomb += zeros;
  return bomb;
}

TEST_P(BadArchive, EightGigabytesOfZerosAreNotExpanded) {
  EXPECT_EQ(problemOf(unpackBytes("a.tar.gz", bombOfZeros()), into),
            "a.tar.gz expands to more than 1024 MiB");
}

TEST_P(BadArchive, ProcessorTimeIsLimited) {
  Limits limits;
  limits.expandedBytes = 1ull << 40;
  limits.cpuSeconds = 1;
  const fs::path path = folder.write("a.tar.gz", bombOfZeros());
  EXPECT_THAT([&] { bundleOf(path, folder.path(), limits, GetParam(), nullptr); },
              testing::ThrowsMessage<UploadProblem>(HasSubstr("can't be unpacked: ")));
  EXPECT_THAT(filesIn(folder.path()), testing::ElementsAre("a.tar.gz"));
}

TEST_P(BadArchive, AFileThatIsLargerThanItSaysIsNotTaken) {
  const Unpacked result = unpackBytes("a.zip", zipOf({{.name = "floor.cpp",
                                                       .bytes = std::string(8 << 20, '\0'),
                                                       .deflated = true,
                                                       .claimedSize = 100}}));
  EXPECT_THAT(problemOf(result, into), HasSubstr("holds none of floor.cpp"));
  EXPECT_THAT(result.refused, testing::ElementsAre(HasSubstr("floor.cpp: ")));
}

TEST_P(BadArchive, TooManyEntries) {
  std::vector<ZipEntry> entries;
  for (int n = 0; n < 2001; ++n) entries.push_back({std::to_string(n) + ".txt", ""});
  EXPECT_EQ(problemOf(unpackBytes("a.zip", zipOf(entries)), into),
            "a.zip holds more than 2000 files and folders");
  std::vector<ZipEntry> clutter;
  for (int n = 0; n < 20001; ++n) clutter.push_back({".git/" + std::to_string(n), ""});
  EXPECT_EQ(problemOf(unpackBytes("a.zip", zipOf(clutter)), into),
            "a.zip holds more than 20000 files and folders");
}

TEST_P(BadArchive, GzipOfGzipIsNotUnpacked) {
  std::string tar = tarOf({{"floor.cpp", "int a;"}});
  for (int n = 0; n < 2; ++n) tar = compressed(tar, Compression::gzip);
  EXPECT_EQ(problemOf(unpackBytes("a.tar.gz", tar), into), "a.tar.gz is compressed more than once");
  for (int n = 0; n < 40; ++n) tar = compressed(tar, Compression::gzip);
  EXPECT_THAT(problemOf(unpackBytes("a.tar.gz", tar), into), HasSubstr("a.tar.gz can't be read"));
}

TEST_P(BadArchive, WhatIsNoArchiveSaysSo) {
  EXPECT_EQ(problemOf(unpackBytes("a.zip", ""), into), "a.zip is empty");
  EXPECT_THAT(problemOf(unpackBytes("a.zip", "Rar!\x1A\x07 not a zip"), into),
              HasSubstr("a.zip can't be read as a zip or tar file"));
  const std::string zip = zipOf({{"floor.cpp", "int a;"}});
  EXPECT_THAT(problemOf(unpackBytes("a.zip", zip.substr(0, zip.size() - 30)), into),
              HasSubstr("damaged, cut short, or another kind of archive"));
  const std::string tar = tarOf({{"floor.cpp", std::string(4000, 'x')}});
  EXPECT_THAT(problemOf(unpackBytes("a.tar", tar.substr(0, 2000)), into), HasSubstr("is damaged"));
}

TEST_P(BadArchive, TooLargeAsUploaded) {
  EXPECT_EQ(problemOf(unpackBytes("a.zip", std::string((64 << 20) + 1, 'x')), into),
            "a.zip has more than 64 MiB");
}

TEST_P(BadArchive, TooManyArchives) {
  for (int n = 0; n < 5; ++n)
    folder.write("student1/" + std::to_string(n) + ".zip", zipOf({{"floor.cpp", ""}}));
  const Unpacked result = unpack(uploadOf(folder.path() / "student1"), kWanted, into, GetParam());
  EXPECT_EQ(problemOf(result, into), "4.zip is one archive too many: an upload may have 4");
}

TEST_P(BadArchive, TwoFoldersThatDoEquallyAreNamed) {
  EXPECT_EQ(
      problemOf(unpackBytes("a.zip", zipOf({{"old/floor.cpp", ""}, {"new/floor.cpp", ""}})), into),
      "new/ and old/ both hold the assignment's files: which one counts?");
}

} // namespace
} // namespace ggrade::intake
