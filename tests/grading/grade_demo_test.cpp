// `ggrade demo`: every bundled example, graded and told of as it must be.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;

namespace {

TEST(Demo, ShowsEveryExampleAsItMustEnd) {
  const TemporaryFolder folder;
  // What every part's mistakes show is drawn first where no test before has done it.
  const Ended ended = runTool({"demo", "--out", folder.path() / "demo"}, {}, 1700);
  EXPECT_EQ(ended.exitCode, 0) << ended.errors;
  const std::string page = read(folder.path() / "demo/index.html");
  std::vector<std::pair<std::string, std::string>> expected;
  for (const std::string& id : names(kSource / "solutions")) {
    const fs::path examples = kSource / "solutions" / id / "examples";
    if (!fs::exists(examples)) continue;
    std::vector<std::string> targets;
    const json declared = json::parse(read(kSource / "assignments" / id / "assignment.json"));
    for (const json& part : declared.at("parts")) targets.push_back(part.at("id"));
    if (targets.size() > 1) targets.push_back(id);
    for (const std::string& target : targets) {
      expected.emplace_back(target + "-reference", "graded");
      expected.emplace_back(target + "-stub", "graded");
    }
    for (const std::string& name : names(examples)) {
      const std::string text = read(examples / name);
      const std::size_t at = text.find("Outcome: ") + 9;
      expected.emplace_back(name.substr(0, name.find('.')),
                            text.substr(at, text.find('\n', at) - at));
    }
  }
  EXPECT_GE(expected.size(), 40u);
  for (const auto& [name, outcome] : expected) {
    EXPECT_THAT(ended.out, ContainsRegex(name + " .*" + outcome)) << name;
    EXPECT_NE(page.find(name + "/index.html"), page.npos) << name;
    const auto results =
        json::parse(read(folder.path() / "demo" / name / "results.json")).at("extra_data");
    EXPECT_EQ(results.at("outcome"), outcome) << name;
    if (name.ends_with("-reference"))
      EXPECT_EQ(results.at("score_without_bonus"), 100) << name;
    else
      EXPECT_LE(results.at("score_without_bonus"), 90) << name;
  }
  EXPECT_THAT(ended.out, HasSubstr((folder.path() / "demo/index.html").string()));
}

} // namespace
