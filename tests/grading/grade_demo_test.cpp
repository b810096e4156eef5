// `ggrade demo`: every bundled example, graded and told of as it must be. Those of one assignment
// here; all of them with --long.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

namespace {

/// \param of an assignment's id; empty: of all
///   \return how many examples, and how many of them show a mistake of the catalogue
std::pair<std::size_t, std::size_t> expectExamples(const std::string& of) {
  const TemporaryFolder folder;
  Arguments command = {"demo", "--out", folder.path() / "demo"};
  if (!of.empty()) command.push_back(of);
  const Ended ended = runTool(command, {}, 1700);
  EXPECT_EQ(ended.exitCode, 0) << ended.errors;
  const std::string page = read(folder.path() / "demo/index.html");
  std::vector<std::pair<std::string, std::string>> expected;
  std::map<std::string, std::string> mistakes;
  for (const std::string& id : names(kSource / "solutions")) {
    const fs::path examples = kSource / "solutions" / id / "examples";
    if (!fs::exists(examples) || (!of.empty() && id != of)) continue;
    std::vector<std::string> targets;
    const json declared = json::parse(read(kSource / "assignments" / id / "assignment.json"));
    for (const json& part : declared.at("parts")) targets.push_back(part.at("id"));
    if (targets.size() > 1) targets.push_back(id);
    for (const std::string& target : targets) {
      expected.emplace_back(target + "-reference", "graded");
      expected.emplace_back(target + "-stub", "graded");
    }
    for (const std::string& name : names(examples)) {
      auto header = ggrade::grading::patchHeader(examples / name);
      const std::string example = name.substr(0, name.find('.'));
      expected.emplace_back(example, header.at("Outcome"));
      if (header.contains("Mistake")) mistakes[example] = header["Mistake"];
    }
  }
  for (const auto& [name, outcome] : expected) {
    EXPECT_THAT(ended.out, ContainsRegex(name + " .*" + outcome)) << name;
    EXPECT_NE(page.find(name + "/index.html"), page.npos) << name;
    const auto results =
        json::parse(read(folder.path() / "demo" / name / "results.json")).at("extra_data");
    EXPECT_EQ(results.at("outcome"), outcome) << name;
    if (name.ends_with("-reference"))
      EXPECT_EQ(results.at("score_without_bonus"), 100) << name;
    else if (name.ends_with("-stub"))
      EXPECT_EQ(results.at("score_without_bonus"), 0) << name;
    else
      EXPECT_LE(results.at("score_without_bonus"), 97) << name; // as calibration wants it
    if (mistakes.contains(name)) {
      EXPECT_EQ(results.at("diagnoses").at(0).at("id"), mistakes[name]) << name;
    }
  }
  EXPECT_THAT(ended.out, HasSubstr((folder.path() / "demo/index.html").string()));
  EXPECT_EQ(std::ranges::count(ended.out, '\n'), long(expected.size()) + 3) << ended.out;
  return {expected.size(), mistakes.size()};
}

TEST(Demo, ShowsEveryExampleOfAnAssignmentAsItMustEnd) {
  const auto [examples, mistakes] = expectExamples("ssao");
  EXPECT_GE(examples, 5u);
  EXPECT_GE(mistakes, 3u);
}

TEST(LongDemo, ShowsEveryExampleAsItMustEnd) {
  const auto [examples, mistakes] = expectExamples("");
  EXPECT_GE(examples, 40u);
  EXPECT_GE(mistakes, 16u);
}

TEST(Demo, OfAnotherIsAnErrorThatNamesThem) {
  const Ended ended = runTool({"demo", "mirorr"});
  EXPECT_EQ(ended.exitCode, 2);
  EXPECT_THAT(ended.errors, AllOf(HasSubstr("mirorr"), HasSubstr("mirror")));
}

} // namespace
