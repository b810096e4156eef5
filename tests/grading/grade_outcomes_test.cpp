// Every way in which a submission can end, provoked, told apart, and explained.

#include "tool.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>

#include <csignal>
#include <fstream>

using namespace tool;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace {

/// What a submission's author must learn: the outcome, why, and that this is a grade (exit code 0).
void expectEnd(const Graded& graded, const std::string& outcome,
               const testing::Matcher<std::string>& detail) {
  EXPECT_EQ(graded.ended.exitCode, 0) << graded.ended.errors;
  EXPECT_EQ(graded.outcome(), outcome);
  EXPECT_THAT(graded.detail(), detail);
  EXPECT_THAT(graded.ended.out, HasSubstr(outcome));
}

/// The solution with a statement before each swap, or after it.
Submission beforeSwap(const std::string& statement) {
  return std::move(Submission::solution().replace("floor.cpp", "    window.swapBuffers();\n",
                                                  statement + "    window.swapBuffers();\n"));
}
Submission afterSwap(const std::string& statement) {
  return std::move(Submission::solution().replace("floor.cpp", "    window.swapBuffers();\n",
                                                  "    window.swapBuffers();\n" + statement));
}

/// "floor.cpp:12:" for the line of the submission's file that holds `text`.
std::string lineWith(const Submission& submission, const std::string& file,
                     const std::string& text) {
  const std::string all = read(submission.path() / file);
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(all.find(text));
  return file + ":" + std::to_string(1 + std::count(all.begin(), end, '\n')) + ":";
}

TEST(Outcome, BuildFailedNamesTheStudentsLine) {
  const Submission wrong = Submission::example("build_error");
  const Graded graded = gradeByTool(wrong);
  expectEnd(graded, "build_failed",
            AllOf(HasSubstr(lineWith(wrong, "mirror.hpp", "fboWidth")),
                  ContainsRegex(":[0-9]+: error"), HasSubstr("fboWidth"),
                  Not(HasSubstr("/submission"))));
  EXPECT_EQ(graded.results.at("score"), 0);
  EXPECT_THAT(graded.results.at("output").get<std::string>(),
              HasSubstr("glViewport(0, 0, fboWidth"));
}

TEST(Outcome, ShaderErrorNamesFileLineAndColumn) {
  const Submission wrong = Submission::example("shader_error");
  const Graded graded = gradeByTool(wrong);
  expectEnd(graded, "shader_error",
            AllOf(HasSubstr(lineWith(wrong, "tile.frag", "uWindow")),
                  ContainsRegex(":[0-9]+: error"), HasSubstr("uWindow")));
  EXPECT_EQ(graded.results.at("score"), 0);
}

TEST(Outcome, GlErrorNamesTheCallAndKeepsTheScore) {
  const Graded graded = gradeByTool(beforeSwap("    glEnable(GL_TEXTURE_2D);\n"));
  expectEnd(graded, "gl_error", AllOf(HasSubstr("GL_INVALID_ENUM"), HasSubstr("glEnable")));
  EXPECT_EQ(graded.score(), 100);
}

TEST(Outcome, NoFrameWhenACommentSwallowsTheSwap) {
  const Graded graded = gradeByTool(Submission::example("never_swaps"));
  expectEnd(graded, "no_frame", HasSubstr("glfwSwapBuffers"));
  EXPECT_EQ(graded.results.at("score"), 0);
  // The compiler saw it coming.
  EXPECT_THAT(graded.results.at("output").get<std::string>(), HasSubstr("multi-line comment"));
}

TEST(Outcome, NoFrameWhenTheProgramEndsAtOnce) {
  const Graded graded = gradeByTool(Submission::program("#include <gg/gg.hpp>\n"
                                                        "void app(const gg::Scene&) {}\n"));
  expectEnd(graded, "no_frame", HasSubstr("0 of 2 frames came"));
  EXPECT_EQ(graded.results.at("score"), 0);
}

TEST(Outcome, Timeout) {
  const Graded graded = gradeByTool(afterSwap("    for (volatile int i = 0; i >= 0; i = 0) {}\n"));
  expectEnd(graded, "timeout", AllOf(HasSubstr("1 of 2 frames came"), ContainsRegex("[0-9]+ s")));
  EXPECT_EQ(graded.results.at("score"), 0);
}

TEST(Outcome, CrashNamesTheSignal) {
  const Graded graded = gradeByTool(Submission::example("crash"));
  expectEnd(graded, "crash", AllOf(HasSubstr("SIGSEGV"), HasSubstr("0 of 2 frames came")));
  EXPECT_EQ(graded.results.at("score"), 0);
}

TEST(Outcome, CrashByAnUncaughtExceptionQuotesIt) {
  const Graded graded = gradeByTool(afterSwap("    std::vector<int>(3).at(7) = 1;\n"));
  expectEnd(graded, "crash",
            AllOf(HasSubstr("vector::_M_range_check"), HasSubstr("1 of 2 frames")));
}

TEST(Outcome, CrashByAbort) {
  const Graded graded = gradeByTool(afterSwap("    std::abort();\n"));
  expectEnd(graded, "crash", AllOf(HasSubstr("SIGABRT"), HasSubstr("1 of 2 frames came")));
}

TEST(Outcome, OutOfMemory) {
  const Graded graded = gradeByTool(
      afterSwap("    static std::vector<std::vector<char>> held;\n"
                "    for (;;) held.emplace_back(32 << 20, static_cast<char>(held.size()));\n"));
  expectEnd(graded, "out_of_memory", AllOf(HasSubstr("memory"), HasSubstr("of 2 frames came")));
  EXPECT_EQ(graded.results.at("score"), 0);
}

TEST(Outcome, BadOutputWhenTheSharedMemoryHoldsGarbage) {
  // Before any library's constructor runs, the descriptor is still open.
  Submission garbage =
      afterSwap("    std::fill_n(channel + 1024, 8192, '\\xff');\n    _exit(0);\n");
  garbage.replace("floor.cpp", "#include <gg/gg.hpp>\n", R"(#include <gg/gg.hpp>
#include <cstdio>
#include <sys/mman.h>
#include <unistd.h>
char* channel = nullptr;
void mapChannel(int, char**, char** variable) {
  int file = -1;
  for (; *variable; ++variable) std::sscanf(*variable, "GG_CAPTURE_FD=%d", &file);
  channel = static_cast<char*>(
      mmap(nullptr, 16384, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0));
}
[[gnu::section(".preinit_array"), gnu::used]] void (*const mapHook)(int, char**, char**) =
    mapChannel;
)");
  const Graded graded = gradeByTool(garbage);
  expectEnd(graded, "bad_output", HasSubstr("makes no sense"));
  EXPECT_EQ(graded.results.at("score"), 0);
}

/// The process of `name` whose parent is `parent`; 0 if there is none.
pid_t childNamed(pid_t parent, const std::string& name) {
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string number = entry.path().filename();
    if (number.find_first_not_of("0123456789") != number.npos) continue;
    std::ifstream status(entry.path() / "stat"), line(entry.path() / "cmdline");
    std::string text, words;
    std::getline(status, text);
    std::getline(line, words);
    int of = 0;
    const std::size_t close = text.rfind(')');
    if (close == text.npos || std::sscanf(text.c_str() + close, ") %*c %d", &of) != 1) continue;
    if (of == parent && words.find(name) != words.npos) return std::stoi(number);
  }
  return 0;
}

TEST(Outcome, NotGradableWhenTheJudgeDies) {
  const Submission solution = Submission::solution();
  const TemporaryFolder results;
  Running running(words({"grade", "mirror", solution.path(), "--out", results.path() / "out"}));
  pid_t judge = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!judge && std::chrono::steady_clock::now() < end)
    judge = childNamed(running.pid(), "judge");
  ASSERT_NE(judge, 0) << running.errors();
  kill(judge, SIGKILL);
  const Ended ended = running.wait(60);
  EXPECT_EQ(ended.exitCode, 1);
  const auto json = nlohmann::json::parse(read(results.path() / "out/results.json"));
  EXPECT_EQ(json.at("extra_data").at("outcome"), "not_gradable");
  EXPECT_TRUE(json.at("score").is_null());
  EXPECT_EQ(json.at("extra_data").at("detail"), "the judge died of signal 9");
  EXPECT_THAT(ended.out, HasSubstr("not_gradable"));
}

TEST(Outcome, ForgedResultsAndAnEarlyExitEarnNothing) {
  // Frames come through shared memory alone: what a program prints, what it
  // exits with and what it leaves behind earn nothing.
  const Graded graded = gradeByTool(Submission::program(
      "#include <gg/gg.hpp>\n"
      "#include <fstream>\n"
      "void app(const gg::Scene&) {\n"
      "  std::puts(\"[  PASSED  ] 8 tests.\");\n"
      "  std::puts(\"{\\\"id\\\":\\\"mirror.where\\\",\\\"earned\\\":25,\\\"credit\\\":1,\"\n"
      "            \"\\\"message\\\":\\\"\\\",\\\"credits\\\":[]}\");\n"
      "  for (const char* name : {\"items.jsonl\", \"results.json\", \"/tmp/items.jsonl\",\n"
      "                           \"/submission/items.jsonl\"})\n"
      "    std::ofstream(name) << \"{\\\"id\\\":\\\"mirror.where\\\",\\\"earned\\\":25}\\n\";\n"
      "  std::exit(0);\n"
      "}\n"));
  expectEnd(graded, "no_frame", HasSubstr("0 of 2 frames came"));
  EXPECT_EQ(graded.results.at("score"), 0);
}

} // namespace
