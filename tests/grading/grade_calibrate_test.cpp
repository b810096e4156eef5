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
  Ended calibrate(const fs::path& catalogue, Arguments more) {
    Arguments arguments = {"calibrate",   "mirror",  "--seeds", "1",
                           "--catalogue", catalogue, "--out",   files_.path() / "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runTool(arguments, {}, kSeconds);
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
  const Graded graded = grade(Submission::example("light_not_mirrored"));
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
}

} // namespace
