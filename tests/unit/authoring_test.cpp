#include "authoring/handout.hpp"
#include "authoring/solution_blocks.hpp"

#include "assignment/assignment.hpp"
#include "framework_throws.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
using authoring::blocks;
using authoring::expandExcerpts;
using authoring::withFilled;
using testing::ElementsAre;

namespace {

const std::string kSolution = "int a;\n"
                              "// BEGIN SOLUTION(mirror.1)\n"
                              "int b;\n"
                              "// END SOLUTION(mirror.1)\n"
                              "int c;\n"
                              "  // BEGIN SOLUTION(mirror.2)\n"
                              "  int d;\n"
                              "  // END SOLUTION(mirror.2)\n"
                              "  // BEGIN SOLUTION(mirror.1)\n"
                              "  int e;\n"
                              "  // END SOLUTION(mirror.1)\n";

TEST(SolutionBlocks, AreTakenOutUnlessFilled) {
  EXPECT_EQ(withFilled(kSolution, "a.cpp", {}), "int a;\nint c;\n");
  EXPECT_EQ(withFilled(kSolution, "a.cpp", {"mirror.1"}), "int a;\nint b;\nint c;\n  int e;\n");
  EXPECT_EQ(withFilled(kSolution, "a.cpp", {"mirror.2"}), "int a;\nint c;\n  int d;\n");
  EXPECT_EQ(withFilled(kSolution, "a.cpp", {"mirror.1", "mirror.2"}),
            "int a;\nint b;\nint c;\n  int d;\n  int e;\n");
  EXPECT_THAT(blocks(kSolution, "a.cpp"), ElementsAre("int b;\n", "  int d;\n", "  int e;\n"));
}

TEST(SolutionBlocks, TextWithoutThemStaysAsItIs) {
  EXPECT_EQ(withFilled("", "a.cpp", {}), "");
  EXPECT_EQ(withFilled("\n\nint a;\n\n\n", "a.cpp", {}), "\n\nint a;\n\n\n");
  // A mark is alone on its line.
  const std::string prose = "int a; // BEGIN SOLUTION(mirror.1)\n// see SOLUTION(mirror.1)\n";
  EXPECT_EQ(withFilled(prose, "a.cpp", {}), prose);
  EXPECT_THAT(blocks(prose, "a.cpp"), ElementsAre());
}

TEST(SolutionBlocks, BlankLinesThatMeetBecomeOne) {
  const std::string text = "int a;\n\n// BEGIN SOLUTION(mirror.1)\nint b;\n"
                           "// END SOLUTION(mirror.1)\n\nint c;\n";
  EXPECT_EQ(withFilled(text, "a.cpp", {}), "int a;\n\nint c;\n");
  EXPECT_EQ(withFilled(text, "a.cpp", {"mirror.1"}), "int a;\n\nint b;\n\nint c;\n");
  // At the start of a file none is left.
  EXPECT_EQ(
      withFilled("// BEGIN SOLUTION(m.1)\nint a;\n// END SOLUTION(m.1)\n\nint b;\n", "a.cpp", {}),
      "int b;\n");
}

std::string problem(const std::string& text) {
  return messageOf<UsageError>([&] { withFilled(text, "floor.cpp", {}); });
}

TEST(SolutionBlocks, MistakesNameFileAndLine) {
  EXPECT_EQ(problem("int a;\n// BEGIN SOLUTION(mirror.1)\nint b;\n"),
            "floor.cpp:2: SOLUTION(mirror.1) is never closed");
  EXPECT_EQ(problem("int a;\n\n// END SOLUTION(mirror.1)\n"),
            "floor.cpp:3: END SOLUTION(mirror.1) has no BEGIN before it");
  EXPECT_EQ(problem("// BEGIN SOLUTION(mirror.1)\n// BEGIN SOLUTION(mirror.2)\n"),
            "floor.cpp:2: SOLUTION(mirror.2) begins inside SOLUTION(mirror.1) of line 1");
  EXPECT_EQ(problem("// BEGIN SOLUTION(mirror.1)\n// END SOLUTION(mirror.2)\n"),
            "floor.cpp:2: END SOLUTION(mirror.2) has no BEGIN before it");
}

TEST(HandoutExcerpt, IsTheCodeFromTheAnchorToItsEnd) {
  const auto stub = [](const std::string& file) {
    EXPECT_EQ(file, "floor.cpp");
    return "int count = 6;\n"
           "// draws {\n"
           "void draw(\n    int i) {\n  if (i) {\n    go();\n  }\n}\n"
           "int last = 7;\n";
  };
  EXPECT_EQ(expandExcerpts("Look:\n{{excerpt floor.cpp \"void draw(\"}}\nDone.\n", "a.md", stub),
            "Look:\n```cpp\nvoid draw(\n    int i) {\n  if (i) {\n    go();\n  }\n}\n```\nDone.\n");
  EXPECT_EQ(expandExcerpts("{{excerpt floor.cpp \"count\"}}\n", "a.md", stub),
            "```cpp\nint count = 6;\n```\n");
}

TEST(HandoutExcerpt, OfAShaderIsMarkedGlsl) {
  EXPECT_EQ(expandExcerpts("{{excerpt tile.frag \"uniform\"}}\n", "a.md",
                           [](const std::string&) { return "uniform bool uMirror;\n"; }),
            "```glsl\nuniform bool uMirror;\n```\n");
}

TEST(HandoutExcerpt, MistakesNameFileAndLine) {
  const auto stub = [](const std::string&) { return "int count;\n"; };
  const auto problem = [&](const std::string& text) {
    return messageOf<UsageError>([&] { expandExcerpts(text, "handout.md", stub); });
  };
  EXPECT_EQ(problem("one\n{{excerpt floor.cpp \"gone\"}}\n"),
            "handout.md:2: floor.cpp has no line with \"gone\"");
  EXPECT_EQ(problem("{{excerpt floor.cpp}}\n"),
            "handout.md:1: {{excerpt floor.cpp}} is not {{excerpt FILE \"ANCHOR\"}}");
}

} // namespace
