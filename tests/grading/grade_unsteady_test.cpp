// Programs that draw something else each time they run, and programs that leave something behind
// for their next run.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace {

/// The solution with `statements` before each swap.
Submission beforeSwap(const std::string& statements) {
  Submission submission = Submission::solution();
  submission.replace("floor.cpp", "    window.swapBuffers();\n",
                     statements + "    window.swapBuffers();\n");
  submission.replace("floor.cpp", "#include <gg/gg.hpp>\n",
                     "#include <gg/gg.hpp>\n#include <cstdlib>\n#include <filesystem>\n"
                     "#include <fstream>\n#include <random>\n");
  return submission;
}

std::vector<double> unsteadyShares(const Graded& graded) {
  std::vector<double> shares;
  for (const auto& frame : graded.results.at("extra_data").at("scenes").at(0).at("frames"))
    shares.push_back(frame.at("unsteady_share"));
  return shares;
}

TEST(Unsteady, ARandomSquareIsNamedMeasuredAndShown) {
  const Submission random = beforeSwap(
      "    std::random_device device;\n"
      "    glEnable(GL_SCISSOR_TEST);\n"
      "    glScissor(20, 20, 64, 48);\n"
      "    const float colour[] = {(device() % 256) / 255.0f, (device() % 256) / 255.0f, 0, 1};\n"
      "    glClearBufferfv(GL_COLOR, 0, colour);\n"
      "    glDisable(GL_SCISSOR_TEST);\n");
  const TemporaryFolder out;
  const fs::path report = out.path() / "report";
  ASSERT_EQ(runTool({"grade", "mirror", random.path(), "--no-diagnosis", "--out", report}).exitCode,
            0);
  const Graded graded{{}, nlohmann::json::parse(read(report / "results.json"))};
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_THAT(graded.detail(),
              AllOf(StartsWith("public: not deterministic: a second run of the same program draws "
                               "something else (1% of frame 1, 1% of frame 2)"),
                    HasSubstr("Random numbers")));
  EXPECT_THAT(unsteadyShares(graded), Each(64.0 * 48 / (640 * 480)));
  for (const char* page : {"index.html", "student.html"}) {
    const std::string text = read(report / page);
    for (const char* shown : {"1% unsteady", "not deterministic"})
      EXPECT_NE(text.find(shown), text.npos) << page << ": " << shown;
  }
}

TEST(Unsteady, AProgramThatDrawsTheSameIsNotNamed) {
  const Graded graded = grade(Submission::solution(), {.pictures = true});
  EXPECT_THAT(unsteadyShares(graded), Each(0.0));
  EXPECT_THAT(graded.detail(), Not(HasSubstr("deterministic")));
}

/// Fills every file of the shader cache, which the program's next runs are given.
Submission spoilsCache(const std::string& bytes) {
  return beforeSwap("    for (const auto& entry : std::filesystem::recursive_directory_iterator("
                    "std::getenv(\"MESA_SHADER_CACHE_DIR\")))\n"
                    "      if (entry.is_regular_file())\n"
                    "        std::ofstream(entry.path(), std::ios::binary) << std::string(" +
                    bytes + ");\n");
}

TEST(ShaderCache, WhateverARunLeavesInItCostsNothing) {
  for (const std::string bytes : {"20 << 20, 'x'", "4096, 'x'", "0, 'x'"}) {
    const Graded graded = grade(spoilsCache(bytes));
    EXPECT_EQ(graded.outcome(), "graded") << bytes;
    EXPECT_EQ(graded.score(), 100) << bytes;
  }
}

} // namespace
