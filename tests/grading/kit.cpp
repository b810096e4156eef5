#include "kit.hpp"

#include "authoring/quiz.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

namespace tool {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

std::vector<std::string> statesOf(const std::string& part, const fs::path& expected,
                                  const fs::path& folder, std::string* said) {
  const TemporaryFolder out;
  const Ended ended = Running({kBuild / "bin/ggrade-check", part, "--expected", expected,
                               "--folder", folder, "--out", out.path() / "a.html", "--json"})
                          .wait(100);
  EXPECT_THAT(ended.exitCode, testing::AnyOf(0, 1)) << ended.errors;
  if (said) *said = ended.out;
  std::vector<std::string> states;
  EXPECT_NE(ended.out, "") << ended.errors;
  const json all = json::parse(ended.out);
  for (const json& todo : all.at(0).at("todos")) states.push_back(todo.at("state"));
  return states;
}

fs::path expectedOf(const std::string& part) {
  static const TemporaryFolder folder;
  const fs::path expected = folder.path() / part;
  if (fs::exists(expected)) return expected;
  const Ended ended = runTool({"expect", part, "--out", expected}, {}, 1700);
  if (ended.exitCode != 0) throw std::runtime_error(ended.errors);
  return expected;
}

void takeOutComments(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::istringstream lines(read(entry.path()));
    std::string text;
    for (std::string line; std::getline(lines, line);)
      if (const std::size_t first = line.find_first_not_of(' ');
          first == line.npos || line.compare(first, 2, "//") != 0)
        text += line + '\n';
    std::ofstream(entry.path()) << text;
  }
}

namespace {

/// Each step's program: exactly the first k TODOs are done, nothing else is begun.
void expectEveryStepKnown(const ggrade::Part& part, const fs::path& expected) {
  for (std::size_t k = 0; k <= part.todos.size(); ++k) {
    const TemporaryFolder step;
    const Ended ended =
        runTool({"derive", part.id, "--done", std::to_string(k), "--out", step.path()});
    ASSERT_EQ(ended.exitCode, 0) << ended.errors;
    std::vector<std::string> wanted(part.todos.size(), "not_begun");
    std::fill_n(wanted.begin(), k, "done");
    std::string said;
    EXPECT_EQ(statesOf(part.id, expected, step.path(), &said), wanted)
        << part.id << " after step " << k << '\n'
        << said;
  }
}

/// No answer of a quiz is in the kit; beside it are all of them, in both languages.
void expectQuizzes(const fs::path& kit, const Ended& released,
                   const std::vector<ggrade::Assignment>& assignments) {
  std::vector<std::string> wanted, reasons;
  for (const ggrade::Assignment& assignment : assignments)
    for (const ggrade::Part& part : assignment.parts) {
      const fs::path source = kSource / "solutions" / assignment.id / (part.id + ".quiz.json");
      for (const char* ending : {".md", ".gift.txt", ".ja.md", ".ja.gift.txt"})
        wanted.push_back(part.id + ending);
      for (const auto& question : ggrade::authoring::readQuiz(source).questions)
        for (const auto& answer : question.answers) reasons.push_back(answer.reason);
      EXPECT_TRUE(fs::exists(kit / "assignments" / assignment.id / (part.id + ".quiz.md")));
    }
  ASSERT_GE(reasons.size(), 6u * 3);
  for (const auto& entry : fs::recursive_directory_iterator(kit)) {
    const std::string name = entry.path().filename().string();
    EXPECT_FALSE(name.ends_with(".quiz.json") || name.ends_with(".gift.txt")) << entry.path();
    if (!name.ends_with(".md")) continue;
    const std::string text = read(entry.path());
    for (const std::string& reason : reasons)
      EXPECT_EQ(text.find(reason), text.npos) << entry.path() << ": " << reason;
  }
  const fs::path answers = kit.string() + "-quiz";
  EXPECT_THAT(names(answers), testing::IsSupersetOf(wanted));
  EXPECT_THAT(released.out, HasSubstr(answers.filename().string() + "\n"));
  std::string all;
  for (const std::string& name : wanted) all += read(answers / name);
  for (const std::string& reason : reasons) EXPECT_THAT(all, HasSubstr(reason));
}

} // namespace

void expectKit(const fs::path& kit, const Ended& released,
               const std::vector<ggrade::Assignment>& assignments) {
  EXPECT_THAT(names(kit),
              IsSupersetOf({"CMakeLists.txt", "README.md", "README.ja.md", "assignments", "cmake",
                            "expected", "framework", "ggrade", "grader"}));
  EXPECT_TRUE(fs::exists(kit / ".vscode/tasks.json"));
  EXPECT_THAT(names(kit), Not(Contains("solutions")));
  EXPECT_THAT(names(kit), Not(Contains("tests")));
  EXPECT_TRUE(fs::exists(kit.string() + ".zip"));
  EXPECT_THAT(released.out, HasSubstr(kit.filename().string() + ".zip"));
  expectQuizzes(kit, released, assignments);
  for (const auto& any : ggrade::loadAssignments(kSource / "assignments"))
    for (const char* name : {"framework", "grader", "cmake"})
      expectNoSolutionIn(any, kit / name, true);
  for (const ggrade::Assignment& assignment : assignments) {
    SCOPED_TRACE(assignment.id);
    // No line of it where the assignment's own files are, and no block of several lines anywhere.
    EXPECT_GE(expectNoSolutionIn(assignment, kit / "assignments" / assignment.id), 1);
    for (const ggrade::Part& part : assignment.parts)
      expectNoSolutionIn(assignment, kit / "expected" / part.id);
    for (const auto& entry : fs::directory_iterator(kSource / "assignments" / assignment.id))
      if (entry.is_regular_file()) {
        EXPECT_EQ(read(kit / "assignments" / assignment.id / entry.path().filename()),
                  read(entry.path()));
      }
    for (const ggrade::Part& part : assignment.parts) {
      expectEveryStepKnown(part, kit / "expected");
      // The finished program's passes as numbers, for whoever wants to compare.
      EXPECT_FALSE(names(kit / "expected" / part.id / "reference").empty()) << part.id;
    }
  }
}

void expectThatItChecks(const fs::path& kit, Environment environment) {
  environment.emplace_back("GGRADE_PRESET", "release");
  const Ended ended = Running({kit / "ggrade", "check", "--json"}, environment, kit).wait(900);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  const json part = json::parse(ended.out).at(0);
  EXPECT_EQ(part.at("part"), "ssao");
  EXPECT_EQ(part.at("outcome"), "graded");
  for (const json& todo : part.at("todos")) EXPECT_EQ(todo.at("state"), "not_begun");
  EXPECT_THAT(read(kit / "out/check-ssao.html"), HasSubstr("data:image/png"));
}

} // namespace tool
