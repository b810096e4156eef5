// `ggrade tradeoff` on the real reference: a sweep of two values, small.

#include "tool.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

using testing::ElementsAre;
using testing::HasSubstr;
using namespace tool;

namespace {

nlohmann::json readJson(const fs::path& file) {
  return nlohmann::json::parse(read(file));
}

TEST(Tradeoff, MeasuresOneNumber) {
  TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  const Ended ended = runTool({"tradeoff", "mirror", "--only", "mirror_clip", "--rounds", "6",
                               "--frames", "1", "--budget", "10s", "--out", out.string()});
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(ended.errors, HasSubstr("mirror, sharp: against the truth\n"));
  EXPECT_THAT(ended.errors, HasSubstr("mirror, sharp: timing, round 6 of at most 6\n"));
  EXPECT_THAT(ended.out, HasSubstr("mirror, scene \"sharp\": 2 settings"));
  EXPECT_THAT(ended.out, HasSubstr("at most 10000.0 ms\n"));
  EXPECT_THAT(ended.out, HasSubstr("The error falls with mirror_clip: from "))
      << "what is not clipped shows, and the truth sees it";
  EXPECT_THAT(names(out), ElementsAre("floor", "index.html", "tradeoff.json"));
  EXPECT_THAT(names(out / "floor"),
              ElementsAre("mirror_clip.csv", "mirror_clip.json", "presets.json"));

  const auto rows = readJson(out / "floor/mirror_clip.json")["rows"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["setting"], nlohmann::json({{"mirror_clip", 0}}));
  for (const auto& row : rows) {
    EXPECT_GE(row["low"], 0);
    EXPECT_LE(row["low"], row["ms"]);
    EXPECT_LE(row["ms"], row["high"]);
    EXPECT_LT(row["high"], row["frame_ms"]);
  }
  EXPECT_GT(rows[0]["errors"]["reflection RMSE"], rows[1]["errors"]["reflection RMSE"]);
  const std::string csv = read(out / "floor/mirror_clip.csv");
  EXPECT_THAT(csv, HasSubstr("mirror_clip,ms,low,high,frame_ms,reflection RMSE,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_EQ(readJson(out / "floor/presets.json")["mirror"]["reference"]["quality"],
            nlohmann::json({{"mirror_clip", 1}}));
  const std::string page = read(out / "index.html");
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(page, HasSubstr("<svg class=\"chart\""));
  EXPECT_THAT(page, HasSubstr("fast, balanced, accurate, reference are one setting ("));
  EXPECT_THAT(page, HasSubstr("clock processor"));
}

TEST(Tradeoff, SaysWhatItDoesNotKnow) {
  TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const Ended number = runTool({"tradeoff", "mirror", "--only", "fog", "--out", out});
  EXPECT_EQ(number.exitCode, 2);
  EXPECT_THAT(number.errors, HasSubstr("--only fog: no sweep has this number; there are: "));
  const Ended part = runTool({"tradeoff", "fog", "--out", out});
  EXPECT_EQ(part.exitCode, 2);
  EXPECT_THAT(part.errors, HasSubstr("there is no assignment or part \"fog\""));
  const Ended time = runTool({"tradeoff", "mirror", "--budget", "soon", "--out", out});
  EXPECT_EQ(time.exitCode, 2);
  EXPECT_THAT(time.errors, HasSubstr("--budget soon: must be a time such as 5ms"));
  const Ended adopt = runTool({"tradeoff", "mirror", "--adopt", "--out", out});
  EXPECT_EQ(adopt.exitCode, 2);
  EXPECT_THAT(adopt.errors,
              HasSubstr("--adopt needs everything measured: name floor instead of mirror"));
  EXPECT_FALSE(fs::exists(out));
}

TEST(Tradeoff, BrokenOffKeepsWhatWasWritten) {
  TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  Running running(words({"tradeoff", "mirror", "--only", "mirror_clip", "blur_samples", "--rounds",
                         "6", "--frames", "1", "--out", out.string()}));
  ASSERT_TRUE(running.says("mirror, blurred: ", 90));
  running.signalGroup(SIGINT);
  EXPECT_EQ(running.wait(30).exitCode, 130);
  EXPECT_THAT(names(out / "floor"),
              ElementsAre("mirror_clip.csv", "mirror_clip.json", "presets.json"));
  EXPECT_THAT(read(out / "index.html"), HasSubstr("Not everything has been measured"));
  EXPECT_EQ(readJson(out / "tradeoff.json")["assignments"][0]["complete"], false);
}

} // namespace
