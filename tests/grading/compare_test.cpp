#include "image/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <sys/wait.h>

using namespace ggrade;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

namespace {

struct Ended {
  int exitCode;
  std::string out, errors;
};

/// A folder with pairs of small images, and the program run in it.
class CompareCommand : public testing::Test {
protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "/compare_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    const Image grey(40, 20, 3, 0.4f); // 102/255: exact in 8 bits
    Image dot = grey;
    for (int y = 10; y < 12; ++y)
      for (int x = 30; x < 34; ++x) dot.at(x, y, 1) = 0.8f;
    write("grey.png", grey);
    write("dot.png", dot);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const Image& image) { writeImageFile(folder_ / name, image); }

  Ended run(const std::string& arguments) {
    const auto out = folder_ / ".out", errors = folder_ / ".errors";
    const std::string command = "cd '" + folder_.string() + "' && '" GGRADE_COMPARE "' " +
                                arguments + " >'" + out.string() + "' 2>'" + errors.string() + "'";
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status)) << command;
    return {WEXITSTATUS(status), read(out), read(errors)};
  }
  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// A file error: exit code 4, nothing on stdout, one line on stderr.
  void expectError(const std::string& arguments, const std::string& text) {
    const Ended result = run(arguments);
    EXPECT_EQ(result.exitCode, 4) << arguments;
    EXPECT_THAT(result.out, IsEmpty()) << arguments;
    EXPECT_THAT(result.errors, AllOf(StartsWith("ggrade compare: "), HasSubstr(text))) << arguments;
    EXPECT_LE(std::ranges::count(result.errors, '\n'), 2) << result.errors;
  }

  fs::path folder_;
};

TEST_F(CompareCommand, SameImagesPass) {
  fs::copy(folder_ / "grey.png", folder_ / "copy.png");
  const Ended result = run("grey.png copy.png");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.errors, "");
  EXPECT_THAT(result.out, AllOf(StartsWith("Comparing \"grey.png\" and \"copy.png\"\n"),
                                HasSubstr("Mean error = 0\n"), HasSubstr("Peak SNR = inf\n"),
                                HasSubstr("0% of 800 pixels differ\n"), HasSubstr("SSIM 1.00000"),
                                EndsWith("PASS\n")));
}

TEST_F(CompareCommand, PrintsTheNumbersOfADifference) {
  const Ended result = run("grey.png dot.png");
  EXPECT_EQ(result.exitCode, 2);
  // 8 of 2400 values are off by 0.4: mean 8 * 0.4 / 2400, root mean square 0.4 * sqrt(8 / 2400),
  // 20 log10(1 / 0.023094) dB.
  EXPECT_THAT(
      result.out,
      AllOf(HasSubstr("  Mean error = 0.00133333\n"), HasSubstr("  RMS error = 0.023094\n"),
            HasSubstr("  Peak SNR = 32.73\n"),
            HasSubstr("  Max error  = 0.4 @ (30, 10, G)  values are 0.40000001, 0.40000001, "
                      "0.40000001 vs 0.40000001, 0.80000001, 0.40000001\n"),
            HasSubstr("  8 pixels (1%) over 1e-06\n")));
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("tolerance 0.01373, radius 1, 3 of 3 channels"),
                    HasSubstr("1% of 800 pixels differ, densest at (31,10): 1% of 32x20, "
                              "worst at (30,10): G is 0.4, expected 0.8\n"),
                    HasSubstr("mean difference -0.001333"), EndsWith("FAILURE\n")));
}

TEST_F(CompareCommand, SpeaksJapaneseWithTheSameNumbers) {
  setenv("GG_LANG", "ja", 1);
  const Ended result = run("grey.png dot.png"), missing = run("grey.png none.png"),
              help = run("--help");
  setenv("GG_LANG", "en", 1);
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(
      result.out,
      AllOf(HasSubstr("  平均誤差 = 0.00133333\n"), HasSubstr("  1e-06を超える画素：8個 (1%)\n"),
            HasSubstr("  採点での比較（許容差0.01373、半径1、3成分中3成分）：\n"),
            HasSubstr("800画素の1%が異なる、最も集中しているのは(31,10)：32x20の1%、最大の差は"
                      "(30,10)：Gが0.4、正しくは0.8\n"),
            EndsWith("FAILURE\n")));
  EXPECT_THAT(missing.errors, HasSubstr("'none.png'を読めません：そのようなファイルはありません"));
  EXPECT_THAT(help.out, AllOf(HasSubstr("使い方: ggrade compare"), HasSubstr("採点での比較"),
                              Not(HasSubstr("Exit codes"))));
}

TEST_F(CompareCommand, RefusesInJapanese) {
  setenv("GG_LANG", "ja", 1);
  expectError("grey.png", "ggrade compare: Bの指定が必要です\n");
  expectError("grey.png dot.png -radius 65", "--radius：65は0から64までの範囲にありません");
  expectError("grey.png dot.png -fail -1", "--fail: '-1'は0以上の数ではありません");
  setenv("GG_LANG", "en", 1);
}

TEST_F(CompareCommand, FollowsTheLimitsOfIdiff) {
  const auto exitCode = [&](const std::string& limits) {
    return run("grey.png dot.png -q " + limits).exitCode;
  };
  EXPECT_EQ(exitCode("-fail 0.5 -warn 0.5"), 0);
  EXPECT_EQ(exitCode("--fail 0.5"), 0);
  EXPECT_EQ(exitCode("--fail 0.5 --warn 0.3"), 1);
  EXPECT_EQ(exitCode("--fail 0.5 -hardwarn 0.3"), 1);
  EXPECT_EQ(exitCode("--fail 0.5 -hardfail 0.3"), 2);
  EXPECT_EQ(exitCode("-failpercent 1"), 1); // within the limit, but over the default warning
  EXPECT_EQ(exitCode("-fail=0.5 -warn=0.5"), 0);
  EXPECT_EQ(exitCode("-fail 0.3"), 2);
  EXPECT_EQ(exitCode("-failpercent 1 -warnpercent 1"), 0); // exactly 1% of the pixels
  EXPECT_EQ(exitCode("-failpercent 0.9 -warnpercent 1"), 2);
  EXPECT_EQ(exitCode("-failpercent 1 -warnpercent 0.9"), 1);
  EXPECT_EQ(exitCode("-fail 0.5 -warn 0.5 -hardfail 0.3"), 2);
  EXPECT_EQ(exitCode("-fail 0.5 -warn 0.5 -hardwarn 0.3"), 1);
  EXPECT_EQ(exitCode("-fail 0.5 -warn 0.5 -hardfail 0.5 -hardwarn 0.5"), 0);
}

TEST_F(CompareCommand, QuietSaysOnlyWhatIsWrong) {
  EXPECT_EQ(run("-q grey.png dot.png").out, "FAILURE\n");
  EXPECT_EQ(run("-q grey.png dot.png -fail 1 -warn 0.1").out, "WARNING\n");
  const Ended same = run("-q grey.png grey.png");
  EXPECT_EQ(same.out, "");
  EXPECT_EQ(same.errors, "");
  EXPECT_EQ(run("grey.png grey.png").errors,
            "ggrade compare: note: both names are the same file\n");
}

TEST_F(CompareCommand, ToleranceAndRadiusAreOurs) {
  Image line(40, 20, 3, 0.4f), moved = line;
  for (int y = 0; y < 20; ++y) {
    line.at(10, y, 0) = 0.8f;
    moved.at(11, y, 0) = 0.8f;
  }
  write("line.png", line);
  write("moved.png", moved);
  EXPECT_THAT(run("line.png moved.png").out, HasSubstr("    0% of 800 pixels differ\n"));
  EXPECT_THAT(run("line.png moved.png --radius 0").out, HasSubstr("    5% of 800 pixels differ"));
  EXPECT_THAT(run("line.png moved.png -radius 0 -tolerance 0.5").out,
              HasSubstr("    0% of 800 pixels differ\n"));
}

TEST_F(CompareCommand, OtherSizesAndChannelsAreNamed) {
  write("small.png", Image(20, 10, 3));
  write("rgba.png", Image(40, 20, 4, 0.4f));
  const Ended size = run("small.png grey.png");
  EXPECT_EQ(size.exitCode, 3);
  EXPECT_THAT(size.out,
              HasSubstr("'small.png' is 20x10 with 3 channels, 'grey.png' is 40x20 with 3 "
                        "channels; both must have the same size and channels\n"));
  const Ended channels = run("grey.png rgba.png");
  EXPECT_EQ(channels.exitCode, 3);
  EXPECT_THAT(channels.out, HasSubstr("'rgba.png' is 40x20 with 4 channels"));
}

TEST_F(CompareCommand, AlphaCountsForIdiffButNotForGrades) {
  Image a(40, 20, 4, 0.4f), b = a;
  b.at(5, 5, 3) = 1.0f;
  write("a.png", a);
  write("b.png", b);
  const Ended result = run("a.png b.png");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.out, AllOf(HasSubstr("@ (5, 5, A)"), HasSubstr("3 of 4 channels"),
                                HasSubstr("    0% of 800 pixels differ\n")));
  EXPECT_THAT(run("a.png b.png --channels 4").out, HasSubstr("    0.125% of 800 pixels differ"));
  expectError("grey.png grey.png -q --channels 4", "--channels 4: the images have 3");
}

TEST_F(CompareCommand, NaNInEitherFileIsAFailureByName) {
  Image good(8, 8, 3, 0.5f), bad = good;
  bad.at(6, 2, 1) = std::numeric_limits<float>::quiet_NaN();
  bad.at(7, 7, 0) = std::numeric_limits<float>::infinity();
  write("good.exr", good);
  write("bad.exr", bad);
  for (const char* names : {"bad.exr good.exr", "good.exr bad.exr"}) {
    const Ended result = run(std::string(names) + " -fail 1000 -failpercent 100");
    EXPECT_EQ(result.exitCode, 2) << names;
    EXPECT_THAT(result.out,
                HasSubstr("'bad.exr': 2 pixels hold NaN or Inf, the first NaN at (6,2), "
                          "channel G; such pixels compare with nothing"));
  }
}

TEST_F(CompareCommand, FloatFilesKeepTheirRange) {
  write("a.exr", Image(4, 4, 1, 100.0f));
  write("b.exr", Image(4, 4, 1, 100.5f));
  const Ended result = run("a.exr b.exr");
  EXPECT_THAT(result.out, AllOf(HasSubstr("Max error  = 0.5 @ (0, 0, Y)  values are 100 vs 100.5"),
                                HasSubstr("Peak SNR = 46.0639\n"))); // 20 log10(100.5 / 0.5)
}

TEST_F(CompareCommand, WritesAnOpaqueDifference) {
  Image a(4, 4, 4, 0.4f), b(4, 4, 4, 0.8f);
  write("a.exr", a);
  write("b.exr", b);
  EXPECT_EQ(run("a.exr b.exr -o signed.exr").exitCode, 2);
  EXPECT_NEAR(readImageFile(folder_ / "signed.exr").image.at(1, 1, 0), -0.4f, 1e-6f);
  EXPECT_EQ(run("a.exr b.exr --out abs.exr -abs -scale 2").exitCode, 2);
  const Image difference = readImageFile(folder_ / "abs.exr").image;
  EXPECT_NEAR(difference.at(1, 1, 2), 0.8f, 1e-6f);
  EXPECT_EQ(difference.at(1, 1, 3), 1.0f);
}

TEST_F(CompareCommand, JsonHoldsTheSameNumbers) {
  const Ended result = run("--json grey.png dot.png");
  EXPECT_EQ(result.exitCode, 2);
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["verdict"], "FAILURE");
  EXPECT_EQ(json["exitCode"], 2);
  EXPECT_EQ(json["failPixels"], 8);
  EXPECT_EQ(json["maxError"]["x"], 30);
  EXPECT_NEAR(json["maxError"]["value"].get<double>(), 0.4, 1e-6);
  EXPECT_EQ(json["tolerant"]["wrongPixels"], 8);
  EXPECT_EQ(json["tolerant"]["wrongShare"], 0.01);
  EXPECT_EQ(json["tolerant"]["densestWindow"]["share"], 8.0 / 640);
  EXPECT_TRUE(nlohmann::json::parse(run("--json grey.png grey.png").out)["peakSnr"].is_null());

  const Ended missing = run("--json grey.png no.png");
  EXPECT_EQ(missing.exitCode, 4);
  const auto error = nlohmann::json::parse(missing.out);
  EXPECT_EQ(error["verdict"], "ERROR");
  EXPECT_EQ(error["reason"], "cannot read 'no.png': there is no such file; check the name");
}

// Black against white: L differs by 100 of at most 203.3; HDR-FLIP shows white at 0.85.
TEST_F(CompareCommand, FlipOfDisplayValues) {
  write("black.png", Image(8, 6, 3, 0.0f));
  write("white.png", Image(8, 6, 3, 1.0f));
  const Ended result = run("--flip black.png white.png");
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.out, HasSubstr("\n  FLIP 0.967380 (LDR, 67.02 pixels per degree)\n"));
  EXPECT_THAT(run("--flip white.png white.png").out, HasSubstr("FLIP 0.000000 (LDR"));
  EXPECT_THAT(run("white.png black.png").out, Not(HasSubstr("FLIP")));
  const auto json = nlohmann::json::parse(run("-json -flip -ppd 40 black.png white.png").out);
  EXPECT_NEAR(json["flip"]["mean"].get<double>(), 0.9673798, 1e-6);
  EXPECT_EQ(json["flip"]["range"], "LDR");
  EXPECT_EQ(json["flip"]["pixelsPerDegree"], 40.0);
  EXPECT_FALSE(json["flip"].contains("exposures"));
}

TEST_F(CompareCommand, FlipOfFloatsLooksAtSeveralExposures) {
  write("dark.exr", Image(8, 6, 3, 2.0f));
  write("bright.exr", Image(8, 6, 3, 8.0f));
  const Ended result = run("--flip bright.exr dark.exr");
  EXPECT_THAT(result.out,
              HasSubstr("(HDR, 67.02 pixels per degree)\n    the largest of 2 exposures "
                        "from +"));
  const auto json = nlohmann::json::parse(run("--json --flip bright.exr dark.exr").out);
  EXPECT_GT(json["flip"]["mean"].get<double>(), 0.05);
  EXPECT_EQ(json["flip"]["range"], "HDR");
  EXPECT_EQ(json["flip"]["exposures"]["count"], 2);
  write("display.png", Image(8, 6, 3, 0.5f));
  expectError("--flip dark.exr display.png", "--flip: one file holds linear floats, the other");
  write("two.exr", Image(8, 6, 2, 0.5f));
  expectError("--flip two.exr two.exr", "--flip: two channels are no colour");
}

TEST_F(CompareCommand, FlipWritesItsHeatMap) {
  EXPECT_EQ(run("--flip grey.png dot.png -o map.png").exitCode, 2);
  const Image map = readImageFile(folder_ / "map.png").image;
  EXPECT_EQ(map.sizeText(), "40x20");
  EXPECT_THAT(map.pixel(0, 0), testing::ElementsAre(0, 0, testing::FloatEq(4 / 255.0f), 1));
  EXPECT_GT(map.at(31, 10, 0), 0.5f);
}

TEST_F(CompareCommand, NamesTheFileAndTheRemedy) {
  expectError("grey.png no.png", "cannot read 'no.png': there is no such file; check the name");
  expectError(". grey.png", "cannot read '.': it is a folder; name an image file in it");
  std::ofstream(folder_ / "zero.png");
  expectError("grey.png zero.png", "'zero.png': the file is empty (0 bytes); write it again");
  fs::copy(folder_ / "dot.png", folder_ / "cut.png");
  fs::resize_file(folder_ / "cut.png", fs::file_size(folder_ / "cut.png") - 30);
  expectError("cut.png grey.png", "'cut.png': broken PNG: the data ends too early; write the file");
  std::ofstream(folder_ / "text.txt") << "not an image";
  expectError("text.txt grey.png", "cannot read 'text.txt': ");
}

TEST_F(CompareCommand, NeverOverwritesAnInputOrLeavesHalfAnOutput) {
  const std::string before = read(folder_ / "grey.png");
  expectError("grey.png dot.png -o grey.png", "'grey.png' is one of the images");
  expectError("grey.png dot.png -o ./../" + folder_.filename().string() + "/dot.png",
              "is one of the images");
  EXPECT_EQ(read(folder_ / "grey.png"), before);
  expectError("grey.png dot.png -o no/d.png", "there is no folder 'no'; create it first");
  expectError("grey.png dot.png -o d.foo", "no image format is called '.foo'; use .png or .exr");
  expectError("grey.png dot.png -o .", "it is a folder");
  for (const auto& entry : fs::directory_iterator(folder_))
    EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr(".tmp-")));
}

TEST_F(CompareCommand, WrongCommandLinesSayWhatIsWrong) {
  expectError("grey.png", "B is required");
  expectError("", "A is required");
  expectError("grey.png dot.png -nope", "-nope");
  expectError("grey.png dot.png -fail -1", "--fail: '-1' is not a number of 0 or more");
  expectError("grey.png dot.png -fail nan", "--fail: 'nan' is not a number of 0 or more");
  expectError("grey.png dot.png -fail much", "--fail");
  expectError("grey.png dot.png -radius 65", "--radius: Value 65 not in range 0 to 64");
  expectError("grey.png dot.png --ppd 0", "--ppd: Value 0 not in range");
  expectError("grey.png dot.png -flip -ppd nan", "pixels per degree must be 1 to 1000");
  expectError("grey.png dot.png -tolerance inf", "the tolerance must be a finite number");
}

TEST_F(CompareCommand, HelpPublishesTheTolerances) {
  for (const char* flag : {"--help", "-help", "-h"}) {
    const Ended help = run(flag);
    EXPECT_EQ(help.exitCode, 0) << flag;
    EXPECT_THAT(help.out,
                AllOf(HasSubstr("Usage: ggrade compare [OPTIONS] A B"),
                      HasSubstr("R = 1 pixel, T = 3.5/255"), HasSubstr("--hardwarn"),
                      HasSubstr("Points depend on these numbers only"), HasSubstr("--flip"),
                      HasSubstr("ggrade compare mine.png reference.png")));
  }
}

TEST_F(CompareCommand, AFullDiskIsNotASuccess) {
  const int status =
      std::system(("'" GGRADE_COMPARE "' '" + (folder_ / "grey.png").string() + "' '" +
                   (folder_ / "grey.png").string() + "' >/dev/full 2>/dev/null")
                      .c_str());
  EXPECT_EQ(WEXITSTATUS(status), 4);
}

} // namespace
