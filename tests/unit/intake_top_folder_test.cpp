#include "intake/contents.hpp"

#include "intake/packed.hpp"

#include <gmock/gmock.h>

namespace ggrade::intake {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<std::string> kWanted = {"floor.cpp", "mirror.vert", "tile.vert"};

TopFolder take(const std::vector<std::string>& paths) {
  std::vector<File> files;
  for (const std::string& path : paths) files.push_back({path, path});
  return takeTopFolder(std::move(files), kWanted);
}

std::vector<std::string> pathsOf(const TopFolder& top) {
  std::vector<std::string> paths;
  for (const File& file : top.files) paths.push_back(file.path);
  return paths;
}

TEST(TopFolder, IsTheShallowestWithAWantedFile) {
  const TopFolder top = take({"a/b/floor.cpp", "a/b/mirror.vert", "a/floor.cpp", "a/c/x.png"});
  EXPECT_THAT(pathsOf(top), ElementsAre("b/floor.cpp", "b/mirror.vert", "floor.cpp", "c/x.png"));
  EXPECT_THAT(top.outside, IsEmpty());
}

TEST(TopFolder, IsTheOneWithMoreOfThem) {
  const TopFolder top = take({"a/floor.cpp", "b/floor.cpp", "b/tile.vert", "notes.txt"});
  EXPECT_THAT(pathsOf(top), ElementsAre("floor.cpp", "tile.vert"));
  EXPECT_EQ(top.files[0].bytes, "b/floor.cpp");
  EXPECT_THAT(top.outside, ElementsAre("a/floor.cpp", "notes.txt"));
  EXPECT_EQ(top.reason, "is outside b/, where the assignment's files are");
}

TEST(TopFolder, IsNamedWhereTwoDoEqually) {
  EXPECT_THAT(
      [] {
        take({"b/floor.cpp", "a/floor.cpp"});
      },
      testing::ThrowsMessage<UploadProblem>(
          "a/ and b/ both hold the assignment's files: which one counts?"));
}

TEST(TopFolder, IsMissingWhereNothingIsWanted) {
  EXPECT_THAT(
      [] {
        take({"main.cpp", "floor.cpp.txt"});
      },
      testing::ThrowsMessage<UploadProblem>(
          "the upload holds none of floor.cpp, mirror.vert, tile.vert"));
  EXPECT_THAT([] { take({}); }, testing::Throws<UploadProblem>());
}

TEST(TopFolder, GivesFilesTheWantedCase) {
  const TopFolder top = take({"hw/Floor.CPP", "hw/sub/TILE.vert"});
  EXPECT_THAT(pathsOf(top), ElementsAre("floor.cpp", "sub/TILE.vert"));
  EXPECT_THAT(top.remarks, ElementsAre("Floor.CPP counts as floor.cpp"));
}

} // namespace
} // namespace ggrade::intake
