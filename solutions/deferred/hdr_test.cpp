// Pictures in Radiance's format: what is read of them, and what is said of those that can't be.

#include "hdr.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <functional>

#include <unistd.h>

namespace {

using testing::HasSubstr;

const std::string kHeader = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n\n";

/// Reads a file with these bytes. (Each test is a process, and several run at a time.)
EnvironmentMap load(const std::string& bytes) {
  const std::string file =
      testing::TempDir() + "ggrade_environment_" + std::to_string(getpid()) + ".hdr";
  struct Removed {
    ~Removed() { unlink(name.c_str()); }
    const std::string& name;
  } removed{file};
  std::ofstream(file, std::ios::binary) << bytes;
  return loadEnvironment(file);
}

std::string bytes(const std::vector<int>& values) {
  std::string text;
  for (const int value : values) text += static_cast<char>(value);
  return text;
}

std::string refusal(const std::string& text) {
  try {
    load(text);
  } catch (const gg::FileError& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

TEST(Hdr, PlainPixels) {
  const EnvironmentMap map = load(kHeader + "-Y 1 +X 2\n" + bytes({128, 64, 0, 129, 255, 3, 7, 0}));
  ASSERT_EQ(map.width, 2);
  ASSERT_EQ(map.height, 1);
  EXPECT_EQ(map.texels.at(0), glm::vec3(128.5f, 64.5f, 0.5f) / 128.0f);
  EXPECT_EQ(map.texels.at(1), glm::vec3(0)) << "exponent 0 is black";
}

TEST(Hdr, PackedRowsAndRowsFromTheTop) {
  std::string text = kHeader + "EXPOSURE=4\nEXPOSURE= 0.5\n\n";
  text.erase(kHeader.size() - 1, 1); // one empty line, after the exposures
  text += "-Y 4 +X 8\n";
  for (int y = 0; y < 4; ++y)
    text += bytes({2, 2, 0, 8, 128 + 8, 10 * y, 3, 1, 2,       3,   128 + 5, 4,  8,
                   9, 9, 9, 9, 9,       9,      9, 9, 128 + 7, 136, 1,       137});
  const EnvironmentMap map = load(text);
  ASSERT_EQ(map.texels.size(), 32u);
  EXPECT_EQ(map.texels[0], glm::vec3(0.5f, 1.5f, 9.5f) / 2.0f);
  EXPECT_EQ(map.texels[2 * 8 + 4], glm::vec3(20.5f, 4.5f, 9.5f) / 2.0f);
  EXPECT_EQ(map.texels[3 * 8 + 7], glm::vec3(30.5f, 4.5f, 9.5f)) << "the last exponent is 137";
}

TEST(Hdr, OldRuns) {
  const EnvironmentMap map =
      load(kHeader + "-Y 2 +X 4\n" + bytes({9, 8, 7, 136, 1, 1, 1, 3, //
                                            1, 2, 3, 136, 4, 5, 6, 136, 1, 1, 1, 2}));
  ASSERT_EQ(map.texels.size(), 8u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(map.texels[i], glm::vec3(9.5f, 8.5f, 7.5f));
  EXPECT_EQ(map.texels[4], glm::vec3(1.5f, 2.5f, 3.5f));
  for (std::size_t i = 5; i < 8; ++i) EXPECT_EQ(map.texels[i], glm::vec3(4.5f, 5.5f, 6.5f));
}

TEST(Hdr, SaysWhatIsWrongAndWhatHelps) {
  EXPECT_THAT(refusal("v/1\1\2"), HasSubstr("is no Radiance picture (.hdr). Make one: oiiotool "));
  EXPECT_THAT(refusal("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n"),
              HasSubstr("has FORMAT=32-bit_rle_xyze; only 32-bit_rle_rgbe"));
  EXPECT_THAT(refusal("#?RADIANCE\n"), HasSubstr("ends in the middle of its header"));
  EXPECT_THAT(refusal(kHeader + "+Y 1 +X 2\n"), HasSubstr("(+Y 1 +X 2) than -Y HEIGHT +X WIDTH"));
  EXPECT_THAT(refusal(kHeader + "-Y 3 +X 4\n"), HasSubstr("is 4 x 3; an environment is twice"));
  EXPECT_THAT(refusal(kHeader + "-Y 0 +X 0\n"), HasSubstr("is 0 x 0"));
  EXPECT_THAT(refusal(kHeader + "-Y 1 +X 2\n" + bytes({1, 2, 3, 4, 5})),
              HasSubstr("ends in the middle of the picture"));
  EXPECT_THAT(refusal(kHeader + "-Y 1 +X 2\n" + bytes({5, 5, 5, 5, 1, 1, 1, 2})),
              HasSubstr("a run of pixels ends outside its row"));
  EXPECT_THAT(refusal(kHeader + "-Y 1 +X 2\n" + bytes({1, 1, 1, 1})),
              HasSubstr("a run of pixels ends outside its row"));
  EXPECT_THAT(refusal(kHeader + "-Y 4 +X 8\n" + bytes({2, 2, 0, 8, 128 + 9, 1})),
              HasSubstr("a run of pixels ends outside its row"));
  EXPECT_THAT(refusal(kHeader + "-Y 4 +X 8\n" + bytes({2, 2, 0, 8, 0, 1})),
              HasSubstr("a run of pixels ends outside its row"));
}

TEST(Hdr, AMissingFileIsNamed) {
  try {
    loadEnvironment("no_such_environment.hdr");
    FAIL() << "nothing was thrown";
  } catch (const gg::FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no_such_environment.hdr: cannot be read"));
  }
}

} // namespace
