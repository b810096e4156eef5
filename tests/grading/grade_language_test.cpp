// What students read, in their language; what is measured, the same in each.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace {

struct Reading {
  std::string page, terminal;
  nlohmann::json results;
};

Reading reading(const std::string& language) {
  const Submission submission = Submission::example("light_not_mirrored");
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  const Ended ended =
      runTool({"--lang=" + language, "grade", "mirror", submission.path(), "--out", out});
  EXPECT_EQ(ended.signal, 0) << ended.errors;
  return {read(out / "student.html"), ended.out, nlohmann::json::parse(read(out / "results.json"))};
}

TEST(Language, AStudentsPageIsJapaneseWithTheSameScores) {
  const Reading english = reading("en"), japanese = reading("ja");
  EXPECT_THAT(english.page, HasSubstr("<html lang=\"en\">"));
  EXPECT_THAT(japanese.page, HasSubstr("<html lang=\"ja\">"));
  for (const char* text : {">評価項目</h2>", ">シーン</h2>", ">採点の条件</h2>", "診断：",
                           "最初に異なるもの：", "読み直すところ：", "考えられる原因："})
    EXPECT_THAT(japanese.page, HasSubstr(text)) << text;
  const std::string body = japanese.page.substr(japanese.page.find("<body>"));
  for (const char* text :
       {"items lost points", "Diagnosis", "First wrong", "Read again", "Likely cause",
        "the texture that objects are drawn into", "of it differs", "of the pixels differ",
        "What was seen, and what to do", "full points", "pixels differ", "Reference",
        "bright where the pictures differ", "What lost points here", "How this was graded",
        "Drag on the picture", "Positions count pixels"}) {
    EXPECT_THAT(english.page, HasSubstr(text)) << "the page has changed: choose another sentence";
    EXPECT_THAT(body, Not(HasSubstr(text)));
  }
  EXPECT_THAT(english.terminal, AllOf(HasSubstr("first wrong: "), Not(HasSubstr("診断"))));
  EXPECT_THAT(japanese.terminal, AllOf(HasSubstr("最初に異なるもの："), HasSubstr("診断")));

  const auto& tests = english.results.at("tests");
  const auto& others = japanese.results.at("tests");
  ASSERT_EQ(tests.size(), others.size());
  for (std::size_t i = 0; i < tests.size(); ++i)
    EXPECT_EQ(tests[i].at("score"), others[i].at("score")) << tests[i].at("name");
  EXPECT_EQ(english.results.at("score"), japanese.results.at("score"));
  const auto diagnosis = [](const Reading& of) {
    return of.results.at("extra_data").at("diagnoses").at(0);
  };
  EXPECT_EQ(diagnosis(english).at("id"), diagnosis(japanese).at("id"));
  EXPECT_EQ(diagnosis(english).at("confidence"), diagnosis(japanese).at("confidence"));
}

/// Of programs with the first five TODOs, whose comments are in one language or the other.
TEST(Language, OfCommentsIsWorthNothing) {
  std::vector<nlohmann::json> scores;
  for (const std::string language : {"en", "ja"}) {
    const TemporaryFolder step;
    ASSERT_EQ(runTool({"derive", "mirror", "--done", "5", "--lang", language, "--out", step.path()})
                  .exitCode,
              0);
    EXPECT_EQ(read(step.path() / "mirror.hpp").find("Given:") == std::string::npos,
              language == "ja");
    const Graded graded = gradeByTool(step.path());
    EXPECT_EQ(graded.outcome(), "graded");
    nlohmann::json& items = scores.emplace_back();
    for (const auto& test : graded.results.at("tests")) items.push_back(test.at("score"));
  }
  EXPECT_EQ(scores.at(0), scores.at(1));
}

TEST(Language, AnotherOneIsAUsageError) {
  const Ended other = runTool({"list", "--lang", "de"});
  EXPECT_EQ(other.exitCode, 2);
  EXPECT_THAT(other.errors, HasSubstr("--lang de: there are en and ja"));
  const Ended none = runTool({"list", "--lang"});
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_THAT(none.errors, HasSubstr("--lang needs a value: en or ja"));
}

/// What CLI11 says, sentence by sentence.
TEST(Language, ARefusedCommandLineIsToldInJapanese) {
  const auto refusal = [](Arguments arguments) {
    arguments.insert(arguments.end(), {"--lang", "ja"});
    const Ended ended = runTool(arguments);
    EXPECT_EQ(ended.exitCode, 2);
    return ended.errors.substr(0, ended.errors.find('\n'));
  };
  EXPECT_EQ(refusal({"list", "-x"}), "使い方の誤り：次の引数は使えません：-x");
  // In the order in which CLI11 gives them.
  EXPECT_EQ(refusal({"list", "-x", "-y"}), "使い方の誤り：次の引数は使えません：-y -x");
  EXPECT_EQ(refusal({}), "使い方の誤り：コマンドの指定が必要です");
  EXPECT_EQ(refusal({"inspect"}), "使い方の誤り：IDの指定が必要です");
  EXPECT_EQ(refusal({"inspect", "mirror", "--time", "soon"}),
            "使い方の誤り：--timeの値を読み取れません：soon");
  EXPECT_EQ(refusal({"inspect", "mirror", "--out"}),
            "使い方の誤り：--out：1個必要な値 (TEXT) が足りません");
  EXPECT_EQ(refusal({"render", "mirror", "--out", "x", "--raw"}),
            "使い方の誤り：--rawには--passesも必要です");
  EXPECT_EQ(refusal({"grade", "mirror", "x", "--quality", "best"}),
            "使い方の誤り：--quality：bestは{fast,balanced,thorough}の中にありません");
}

TEST(Language, FollowsTheEnvironmentToo) {
  // Before anything is drawn: the program doesn't compile.
  const Submission submission = Submission::program("int main() { return x; }\n");
  const Graded graded = gradeByTool(submission, {}, {{"GG_LANG", "ja"}});
  EXPECT_EQ(graded.outcome(), "build_failed");
  EXPECT_THAT(graded.detail(), HasSubstr("コンパイラのメッセージ："));
}

} // namespace
