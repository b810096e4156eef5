// ggrade calibrate: the real tool on a catalogue of its own.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <chrono>

using namespace tool;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

/// Pictures of every scene may have to be drawn first, on a machine with much else to do.
constexpr double kSeconds = 250;

/// A folder with mistakes/ and variants/.
class Calibrate : public testing::Test {
protected:
  void SetUp() override {
    const std::string light = diffOf("light_not_mirrored");
    files_.write("mistakes/mirror_light.patch",
                 "Title: The light is not mirrored\nGrades: mirror\nSymptom: Wrong light.\n"
                 "Hint: Look at the light.\nFails: mirror.shading\nStep: mirror.4\n"
                 "Shows: mirror\n\n" +
                     light);
    files_.write("variants/mirror_comment.patch",
                 "Title: A comment more\nGrades: mirror\n\n"
                 "diff --git a/solutions/floor/mine.glsl b/solutions/floor/mine.glsl\n"
                 "new file mode 100644\n--- /dev/null\n+++ b/solutions/floor/mine.glsl\n"
                 "@@ -0,0 +1 @@\n+// nothing\n");
    files_.write("doctored/variants/mirror_light.patch",
                 "Title: No right answer\nGrades: mirror\n\n" + light);
    files_.write("doctored/variants/mirror_gone.patch",
                 "Title: Gone\nGrades: mirror\n\n"
                 "diff --git a/solutions/floor/tile.frag b/solutions/floor/tile.frag\n"
                 "--- a/solutions/floor/tile.frag\n+++ b/solutions/floor/tile.frag\n"
                 "@@ -1,1 +1,1 @@\n-never there\n+something\n");
  }
  static std::string diffOf(const std::string& example) {
    const std::string text = read(kSource / "solutions/floor/examples" / (example + ".patch"));
    return text.substr(text.find("diff --git"));
  }
  Ended calibrate(const fs::path& catalogue, Arguments more, double seconds = kSeconds) {
    Arguments arguments = {"calibrate",   "mirror",  "--seeds", "1",
                           "--catalogue", catalogue, "--out",   files_.path() / "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runTool(arguments, {}, seconds);
  }

  TemporaryFolder files_;
};

TEST_F(Calibrate, RightAndWrongAnswersSeparate) {
  const Ended ended = calibrate(files_.path(), {"--only", "comment", "light", "noise", "--json"});
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  const auto json = nlohmann::json::parse(ended.out).at("parts").at(0);
  EXPECT_EQ(json.at("part"), "mirror");
  EXPECT_EQ(json.at("programs").size(), 3u);
  const auto scoreOf = [&](const std::string& name) -> double {
    for (const auto& one : json.at("programs"))
      if (one.at("name") == name) return one.at("lowest");
    throw std::runtime_error(name);
  };
  EXPECT_EQ(scoreOf("mirror_comment"), 100);
  EXPECT_LE(scoreOf("mirror_light"), 85);
  EXPECT_EQ(scoreOf("noise"), 0);
  const std::string page = read(files_.path() / "out/index.html");
  EXPECT_THAT(page, AllOf(HasSubstr("None of 3 gradings was wrong."), HasSubstr("<svg"),
                          HasSubstr("mirror_light, seed 1301"), Not(HasSubstr("{{"))));

  // The same score as anybody's: the judge that stays judges as the one for one grading does.
  const Graded graded = gradeByTool(Submission::example("light_not_mirrored"));
  EXPECT_EQ(graded.score(), scoreOf("mirror_light"));

  // What was graded is kept.
  const auto start = std::chrono::steady_clock::now();
  const Ended again = calibrate(files_.path(), {"--only", "comment", "light", "noise"});
  EXPECT_EQ(again.exitCode, 0) << again.errors;
  EXPECT_THAT(again.out, HasSubstr("Wrong ones taken for right: 0 of 2"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(Calibrate, AMistakeThatIsFiledAsARightAnswerFailsAndSoDoesAPatchThatNoLongerApplies) {
  const Ended ended = calibrate(files_.path() / "doctored", {"--only", "variant"});
  EXPECT_EQ(ended.exitCode, 1);
  EXPECT_THAT(ended.errors, AllOf(HasSubstr("right and wrong answers don't separate:"),
                                  HasSubstr("mirror_light: on seed 1301 it scores "),
                                  HasSubstr("a right answer has at least 98; "),
                                  HasSubstr("; mirror.shading loses "),
                                  HasSubstr("mirror_gone.patch no longer applies")));
  EXPECT_THAT(ended.out, HasSubstr("Right answers taken for wrong: 1 of 1."));
}

/// One that shows in the window that is wider than all others, of a scene that `fast` leaves out.
void addAMistakeOfWideWindows(const TemporaryFolder& files) {
  files.write("wide/mistakes/mirror_wide.patch",
              "Title: Wide windows show the reflection shifted\nGrades: mirror\n"
              "Symptom: Shifted.\nHint: Look at wide windows.\nFails: mirror.keep_following\n"
              "Step: mirror.3\nShows: mirror_resized\n\n"
              "diff --git a/solutions/floor/tile.frag b/solutions/floor/tile.frag\n"
              "--- a/solutions/floor/tile.frag\n+++ b/solutions/floor/tile.frag\n"
              "@@ -53,3 +53,4 @@\n     vec2 at = gl_FragCoord.xy / uViewport;\n"
              "+    if (uViewport.x > 1.7 * uViewport.y) at.x = fract(at.x + 0.3);\n"
              "     reflected = texture(uReflection, at).rgb;\n"
              "     // END SOLUTION(mirror.3)\n");
}

TEST_F(Calibrate, OtherTolerancesAreTriedInTheScenesOfTheQualityThatWasAskedFor) {
  addAMistakeOfWideWindows(files_);
  const Ended ended =
      calibrate(files_.path() / "wide", {"--skip-diagnosis", "--quality", "fast", "--json"});
  EXPECT_EQ(ended.exitCode, 1) << ended.errors;
  const auto part = nlohmann::json::parse(ended.out).at("parts").at(0);
  EXPECT_EQ(part.at("confusion").at("wrong_accepted"), 1) << "fast has no such window";
  const auto& crossed = part.at("cross_validation");
  EXPECT_EQ(crossed.at("published_holds"), false);
  for (const auto& trial : crossed.at("trials"))
    EXPECT_EQ(int(trial.at("errors").at(0)) + int(trial.at("errors").at(1)), 1) << trial;
}

/// A dozen looks at each program.
class LongCalibrate : public Calibrate {};

TEST_F(LongCalibrate, LookingLessCloselyIsQuickerAndSeesLess) {
  addAMistakeOfWideWindows(files_);
  const fs::path catalogue = files_.path() / "wide";
  files_.write("wide/variants/mirror_comment.patch",
               read(files_.path() / "variants/mirror_comment.patch"));
  files_.write("wide/mistakes/mirror_light.patch",
               read(files_.path() / "mistakes/mirror_light.patch"));
  const Ended ended = calibrate(
      catalogue, {"--trade", "--only", "comment", "light", "wide", "--json"}, 2 * kSeconds);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(ended.errors,
              AllOf(HasSubstr("calibrating mirror: seed 1301, balanced\n"),
                    HasSubstr("calibrating mirror: seed 1301, balanced, windows x 0.25\n"),
                    HasSubstr("calibrating mirror: seed 1301, balanced, 1 hidden scene\n")));
  const auto part = nlohmann::json::parse(ended.out).at("parts").at(0);
  EXPECT_EQ(part.at("hidden_scenes").size(), 5u);
  const auto row = [&](const std::string& sweep, const std::string& setting) {
    for (const auto& one : part.at("rows"))
      if (one.at("sweep") == sweep && one.at("setting") == setting) return one;
    throw std::runtime_error(setting);
  };
  // What fails in the last scene alone is seen there, and nowhere before.
  const auto seen = [&](const std::string& sweep, const std::string& setting) {
    const auto one = row(sweep, setting);
    EXPECT_EQ(one.at("right"), 1);
    EXPECT_EQ(one.at("right_taken_for_wrong"), 0) << setting << one.dump();
    EXPECT_EQ(one.at("wrong"), 2);
    EXPECT_GT(one.at("seconds").at("median"), 0);
    return one.at("wrong_taken_for_right") == 0;
  };
  EXPECT_TRUE(seen("quality", "balanced"));
  EXPECT_TRUE(seen("quality", "thorough"));
  EXPECT_FALSE(seen("quality", "fast"));
  EXPECT_FALSE(seen("hidden scenes", "0 of 5"));
  EXPECT_FALSE(seen("hidden scenes", "4 of 5"));
  EXPECT_TRUE(seen("hidden scenes", "all 5"));
  EXPECT_TRUE(seen("window size", "whole"));
  EXPECT_TRUE(seen("window size", "3/4"));
  EXPECT_LT(row("hidden scenes", "0 of 5").at("seconds").at("median"),
            row("quality", "thorough").at("seconds").at("median"));
  EXPECT_EQ(row("quality", "balanced").at("highest_wrong"), 85);
  EXPECT_EQ(row("quality", "balanced").at("lowest_right"), 100);

  const auto& measures = part.at("measures");
  EXPECT_EQ(measures.at(0).at("measure"), "RMSE");
  EXPECT_EQ(measures.at(0).at("roc_area"), 1); // the right answer draws the reference's picture
  EXPECT_GT(measures.at(0).at("ms"), 0);
  EXPECT_EQ(measures.back().at("measure"), "rubric: the limits above");
  EXPECT_EQ(measures.back().at("wrong_taken_for_right"), 0);
  EXPECT_EQ(names(files_.path() / "out"),
            (std::vector<std::string>{"index.html", "trade.csv", "trade.json"}));
  EXPECT_THAT(read(files_.path() / "out/trade.csv"), HasSubstr("\nmirror,quality,fast,1,0,2,1,"));
  EXPECT_THAT(read(files_.path() / "out/index.html"),
              AllOf(HasSubstr("Would fewer hidden scenes do?"), HasSubstr("<svg class=\"plot\""),
                    Not(HasSubstr("{{"))));

  // All of it was kept.
  const Ended again = calibrate(catalogue, {"--trade", "--only", "comment", "light", "wide"});
  EXPECT_EQ(again.exitCode, 0) << again.errors;
  EXPECT_EQ(nlohmann::json::parse(read(files_.path() / "out/trade.json")).at("parts").at(0), part);
  EXPECT_THAT(again.out, AllOf(HasSubstr("mirror, seeds 1301\n"), HasSubstr("1 of 2 (90.5%)")));
}

TEST_F(Calibrate, ADisputedSubmissionBecomesAnAnonymousMistake) {
  const Submission submission = Submission::example("no_depth");
  const Ended ended = runTool({"calibrate", "mirror", "--catalogue", files_.path(), "--adopt",
                               submission.path(), "--as", "mistake"},
                              {}, kSeconds);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(ended.out,
              AllOf(HasSubstr("mistakes/mirror_disputed_1.patch"), HasSubstr("may name a person")));
  const std::string patch = read(files_.path() / "mistakes/mirror_disputed_1.patch");
  EXPECT_THAT(patch, AllOf(HasSubstr("Fails: mirror.hidden"), HasSubstr("\n+"),
                           Not(HasSubstr(submission.path().string()))));
}

TEST(CalibrateUsage, SaysWhatItNeeds) {
  EXPECT_THAT(runTool({"calibrate", "nothing"}).errors,
              HasSubstr("there is no assignment or part \"nothing\""));
  EXPECT_THAT(runTool({"calibrate", "mirror", "--adopt", "x"}).errors, HasSubstr("needs --as"));
  EXPECT_THAT(runTool({"calibrate", "floor", "--adopt", "x", "--as", "variant"}).errors,
              HasSubstr("has several parts"));
  EXPECT_THAT(runTool({"calibrate", "mirror", "--only", "nobody"}).errors,
              HasSubstr("--only nobody: mirror has no program of this name or kind"));
  EXPECT_EQ(runTool({"calibrate", "mirror", "--seeds", "0"}).exitCode, 2);
  EXPECT_THAT(runTool({"calibrate", "mirror", "--trade", "--only", "pictures"}).errors,
              HasSubstr("--trade is about mistakes, variants, the reference and the stub: --only "
                        "names none of them"));
  EXPECT_THAT(runTool({"calibrate", "mirror", "--trade", "--quality", "fast"}).errors,
              HasSubstr("--quality excludes --trade"));
}

} // namespace
