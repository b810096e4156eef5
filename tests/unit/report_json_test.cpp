#include "report/results_json.hpp"
#include "report_samples.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace ggrade::report {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

Json parsed(const results::Result& result, Reveal reveal = Reveal::names) {
  return Json::parse(resultsJson(result, reveal)); // throws on invalid JSON or UTF-8
}

std::vector<std::string> keysOf(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST(ResultsJson, HasExactlyGradescopesKeys) {
  const Json json = parsed(samples::partial(16, 12));
  EXPECT_THAT(keysOf(json), testing::UnorderedElementsAre(
                                "score", "execution_time", "output", "output_format",
                                "test_output_format", "test_name_format", "visibility",
                                "stdout_visibility", "extra_data", "tests", "leaderboard"));
  for (const Json& test : json["tests"])
    EXPECT_THAT(keysOf(test), testing::UnorderedElementsAre(
                                  "score", "max_score", "status", "name", "name_format", "number",
                                  "output", "output_format", "tags", "visibility", "extra_data"));
  EXPECT_EQ(json["visibility"], "visible");
  EXPECT_EQ(json["stdout_visibility"], "hidden");
  EXPECT_EQ(json["output_format"], "text");
  EXPECT_EQ(json["leaderboard"], Json::array());
}

TEST(ResultsJson, ScoreIncludesTheBonusAndTimesAddUp) {
  const Json json = parsed(samples::perfect(16, 12));
  EXPECT_DOUBLE_EQ(json["score"], 110);
  EXPECT_DOUBLE_EQ(json["extra_data"]["max_score"], 100);
  EXPECT_DOUBLE_EQ(json["extra_data"]["bonus"], 10);
  EXPECT_NEAR(json["execution_time"], 1.502, 1e-9);
}

TEST(ResultsJson, WhatWasCarriedForwardIsSaid) {
  results::Result result = samples::partial(16, 12);
  result.items[1].carried = {"scene", "bright pass"};
  const Json json = parsed(result);
  EXPECT_EQ(json["extra_data"]["items"][1]["carried_forward"], Json({"scene", "bright pass"}));
  EXPECT_EQ(json["extra_data"]["items"][0]["carried_forward"], Json::array());
  EXPECT_THAT(
      json["tests"][1]["output"].get<std::string>(),
      HasSubstr("\nJudged with the reference's scene and bright pass in place of yours.\n"));
  EXPECT_THAT(json["tests"][0]["output"].get<std::string>(), Not(HasSubstr("in place of")));
}

TEST(ResultsJson, GainItem) {
  const Json test = parsed(samples::partial(16, 12))["tests"][1];
  EXPECT_DOUBLE_EQ(test["score"], 3);
  EXPECT_DOUBLE_EQ(test["max_score"], 30);
  EXPECT_EQ(test["status"], "failed");
  EXPECT_EQ(test["name"], "The reflection is lit from the right side");
  EXPECT_EQ(test["number"], "2");
  EXPECT_EQ(test["tags"], Json({"gain"}));
  EXPECT_EQ(test["visibility"], "visible");
  EXPECT_THAT(test["output"].get<std::string>(),
              HasSubstr("Read again: Step 5: turn culling and normals\n"));
  EXPECT_EQ(test["extra_data"]["id"], "mirror.shading");
}

TEST(ResultsJson, KeepItemHasNoMaximumAndNeverAddsPoints) {
  const Json test = parsed(samples::partial(16, 12))["tests"][4];
  EXPECT_DOUBLE_EQ(test["max_score"], 0);
  EXPECT_DOUBLE_EQ(test["score"], -4);
  EXPECT_EQ(test["status"], "failed");
  EXPECT_EQ(test["name"], "Everything else stays (takes away up to 30)");
  const Json kept = parsed(samples::perfect(16, 12))["tests"][4];
  EXPECT_DOUBLE_EQ(kept["score"], 0);
  EXPECT_EQ(kept["status"], "passed");
}

TEST(ResultsJson, BonusAndBeyondTheLectureAreNoted) {
  const Json tests = parsed(samples::perfect(16, 12))["tests"];
  EXPECT_EQ(tests[5]["name"], "Bonus: The reflection is blurred");
  EXPECT_EQ(tests[5]["tags"], Json({"bonus"}));
  EXPECT_EQ(tests[3]["tags"], Json({"gain", "beyond_lecture"}));
}

TEST(ResultsJson, ExtraDataMakesARegradeExact) {
  const Json extra = parsed(samples::partial(16, 12))["extra_data"];
  EXPECT_EQ(extra["outcome"], "graded");
  EXPECT_EQ(extra["seed"], 8131u);
  EXPECT_EQ(extra["sandbox"], "bwrap");
  EXPECT_EQ(extra["fingerprint"]["renderer"], "llvmpipe (LLVM 15.0.6, 256 bits)");
  EXPECT_DOUBLE_EQ(extra["thresholds"]["radius"], 1);
  EXPECT_DOUBLE_EQ(extra["timings"]["build"], 0.412);
  EXPECT_DOUBLE_EQ(extra["items"][1]["credits"]["hidden-low"], 0.1);
  EXPECT_DOUBLE_EQ(extra["scenes"][1]["frames"][1]["wrong_share"], 0.131);
  EXPECT_EQ(extra["unused_files"].size(), 2u);
}

TEST(ResultsJson, WhatNeverReachedTheCompilerIsNotSaidToHaveFailedThere) {
  results::Result result = samples::buildFailed();
  result.compilerOutput.clear();
  result.detail = "the archive is damaged";
  const std::string output = parsed(result)["output"];
  EXPECT_THAT(output, testing::StartsWith("There is no program to run, so nothing was drawn."));
  EXPECT_THAT(output, HasSubstr("the archive is damaged"));
}

TEST(ResultsJson, BuildFailureShowsTheCompilerAndScoresZero) {
  const Json json = parsed(samples::buildFailed());
  EXPECT_DOUBLE_EQ(json["score"], 0);
  EXPECT_EQ(json["extra_data"]["outcome"], "build_failed");
  EXPECT_THAT(json["output"].get<std::string>(),
              testing::StartsWith("The program did not compile"));
  EXPECT_THAT(json["output"].get<std::string>(),
              HasSubstr("floor.cpp:42:5: error: 'mirrorFramebuffer'"));
  EXPECT_EQ(json["tests"][0]["output"], "Not judged.\n");
}

TEST(ResultsJson, OurFailureIsNoZero) {
  results::Result result = samples::noFrame();
  result.outcome = results::Outcome::notGradable;
  EXPECT_TRUE(parsed(result)["score"].is_null());
}

TEST(ResultsJson, HostileTextsParseBackAndStaySmall) {
  const std::string text = resultsJson(samples::hostile(), Reveal::details);
  const Json json = Json::parse(text);
  EXPECT_LT(text.size(), 64u << 10);
  EXPECT_THAT(json["tests"][0]["name"].get<std::string>(),
              HasSubstr("<script>alert('x')</script>"));
  for (const char* forbidden : {"\x1B", "\\u001b", "\u202E", "\xFF"})
    EXPECT_THAT(text, Not(HasSubstr(forbidden)));
}

TEST(ResultsJson, NotANumberBecomesNull) {
  results::Result result = samples::perfect(16, 12);
  result.items[0].earned = std::nan("");
  EXPECT_TRUE(parsed(result)["tests"][0]["score"].is_null());
}

} // namespace
} // namespace ggrade::report
