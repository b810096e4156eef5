// Errors are not counted twice: what builds on a pass that failed keeps what it is worth by itself,
// and nothing that is no work of the submission's own earns anything by that.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

namespace {

/// What was replaced by the reference's for an item.
std::vector<std::string> carried(const Graded& graded, const std::string& id) {
  for (const auto& item : graded.results.at("extra_data").at("items"))
    if (item.at("id") == id) return item.at("carried_forward").get<std::vector<std::string>>();
  ADD_FAILURE() << "no item " << id;
  return {};
}

/// Was there a second run?
bool ranAgain(const Graded& graded) {
  return graded.results.at("extra_data").at("timings").contains("carry forward");
}

std::string output(const Graded& graded, const std::string& id) {
  for (const auto& test : graded.results.at("tests"))
    if (test.at("extra_data").at("id") == id) return test.at("output");
  return {};
}

Submission changed(const std::string& file, const std::string& from, const std::string& to) {
  Submission submission = Submission::solution();
  submission.replace(file, from, to);
  return submission;
}

TEST(CarriedForward, AWrongTextureLeavesTheSamplingItsPoints) {
  const Graded graded = grade(Submission::example("scale_on_the_left"), {.pictures = true});
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_LT(graded.earned("mirror.texture"), 8);
  EXPECT_EQ(graded.earned("mirror.where"), 20);
  EXPECT_EQ(graded.earned("mirror.position"), 15);
  EXPECT_THAT(carried(graded, "mirror.where"), ElementsAre("reflection"));
  EXPECT_THAT(carried(graded, "mirror.texture"), IsEmpty());
  EXPECT_THAT(output(graded, "mirror.where"),
              HasSubstr("Judged with the reference's reflection in place of yours.\n"));
  // What the window shows is the submission's own.
  EXPECT_EQ(graded.earned("mirror.shading"), 0);
  const auto& frames = graded.results.at("extra_data").at("scenes").at(0).at("frames");
  ASSERT_THAT(frames, SizeIs(2));
  EXPECT_GT(frames.at(0).at("wrong_share"), 0.02);
}

TEST(CarriedForward, RunsThatSeeHiddenScenesAreAnnounced) {
  using ggrade::grading::Runs;
  const ggrade::Target target = ggrade::findTarget(kSource / "assignments", "mirror");
  const fs::path solutions = kSource / "solutions/floor";
  std::vector<std::pair<Runs, std::size_t>> said; // and how many scenes were drawn before
  std::size_t drawn = 0;
  ggrade::grading::GraderOptions options;
  options.diagnosis = options.pictures = false;
  options.threads = 1;
  options.progress = [&](const std::string& what, std::size_t done, std::size_t) {
    if (what == "rendering") drawn = done - 1;
  };
  options.begins = [&](Runs kind) { said.emplace_back(kind, drawn); };
  const auto plan = ggrade::grading::drawScenes(target, solutions);
  ggrade::grading::Grader grader(target, solutions, plan, options);
  grader.prepare();
  drawn = 0;
  const Submission submission = Submission::example("scale_on_the_left");
  const auto result = grader.gradeTrusted(submission.path());
  const std::size_t all = plan.scenes.size();
  // Build and public scene, then the hidden ones, then those with the reference's pixels.
  EXPECT_THAT(said, ElementsAre(std::pair(Runs::told, 0), std::pair(Runs::hidden, 1),
                                std::pair(Runs::none, all), std::pair(Runs::hidden, all),
                                std::pair(Runs::none, all)))
      << result.score;
}

TEST(CarriedForward, SamplingThatIsWrongTooEarnsNothing) {
  Submission both = Submission::example("scale_on_the_left");
  both.replace("tile.frag", "vec2 at = gl_FragCoord.xy / uViewport;",
               "vec2 at = 1.0 - gl_FragCoord.xy / uViewport;");
  const Graded graded = grade(both);
  EXPECT_TRUE(ranAgain(graded));
  EXPECT_LT(graded.earned("mirror.where"), 4);
  EXPECT_LT(graded.earned("mirror.position"), 3);
}

TEST(CarriedForward, ATextureOfAnotherSizeOrFormatIsNotReplaced) {
  for (const auto& [from, to] :
       {std::pair("scene.integer(\"quality.mirror_size\")", "700"),
        std::pair("lightFormat(scene) : GL_RGBA8", "GL_RGBA8 : GL_RGB8")}) {
    Submission other = Submission::example("scale_on_the_left");
    other.replace("floor.cpp", from, to);
    const Graded graded = grade(other);
    EXPECT_FALSE(ranAgain(graded)) << to;
    EXPECT_LT(graded.earned("mirror.position"), 3) << to;
  }
}

TEST(CarriedForward, AMapThatWasNeverClearedLeavesTheLookupItsPoints) {
  const Graded graded = gradePart("shadow", Submission::example("shadow_not_cleared"));
  EXPECT_EQ(graded.earned("shadow.map"), 0);
  EXPECT_EQ(graded.earned("shadow.depth_only"), 0) << "by the first run only";
  EXPECT_EQ(graded.earned("shadow.floor"), 25);
  EXPECT_EQ(graded.earned("shadow.objects"), 20);
  EXPECT_EQ(graded.earned("shadow.ambient"), 15);
  EXPECT_EQ(graded.earned("shadow.outside"), 10);
  EXPECT_THAT(carried(graded, "shadow.outside"), ElementsAre("shadow map"));
}

TEST(CarriedForward, ALookupThroughAnotherMatrixGetsNoMap) {
  // The map is drawn and read with the same matrix, but of a light elsewhere.
  const Graded graded = gradePart(
      "shadow", changed("floor.cpp", "lightCamera(glm::vec3(scene.light.position),",
                        "lightCamera(glm::vec3(scene.light.position) + glm::vec3(2, 0, 0),"));
  EXPECT_FALSE(ranAgain(graded));
  EXPECT_LT(graded.earned("shadow.floor"), 15);
}

TEST(CarriedForward, AComparisonThatIsWrongTooEarnsNothing) {
  Submission both = Submission::example("shadow_not_cleared");
  both.replace("shadow.glsl", "  return comparison(at);\n", "  return 1.0;\n");
  const Graded graded = gradePart("shadow", both);
  EXPECT_EQ(graded.results.at("score"), 0);
}

TEST(CarriedForward, ABlackBrightPassLeavesLevelsAndSumTheirPoints) {
  const Graded graded = gradePart(
      "bloom", changed("bright.frag", "bright = color * ratio * uWeight;", "bright = vec3(0);"));
  EXPECT_EQ(graded.earned("bloom.scene"), 6);
  EXPECT_EQ(graded.earned("bloom.bright"), 0);
  EXPECT_EQ(graded.earned("bloom.levels"), 20);
  EXPECT_EQ(graded.earned("bloom.sum"), 15);
  EXPECT_THAT(carried(graded, "bloom.levels"), ElementsAre("bright pass"));
  EXPECT_LT(graded.earned("bloom.picture"), 2);
}

TEST(CarriedForward, AWrongSceneOfTheSameFormatLeavesTheBrightPassItsPoints) {
  const Graded graded =
      gradePart("bloom", changed("object.frag", " + uGlow, 1);", " + 0.3 * uGlow, 1);"));
  EXPECT_LT(graded.earned("bloom.scene"), 2);
  EXPECT_EQ(graded.earned("bloom.bright"), 18);
  EXPECT_EQ(graded.earned("bloom.levels"), 20);
  EXPECT_EQ(graded.earned("bloom.sum"), 15);
  EXPECT_THAT(carried(graded, "bloom.bright"), ElementsAre("scene"));
}

TEST(CarriedForward, EightBitsAreAnotherKindOfScene) {
  const Graded graded = gradePart("bloom", Submission::example("eight_bits"));
  EXPECT_LT(graded.earned("bloom.bright"), 3);
  EXPECT_THAT(carried(graded, "bloom.bright"), IsEmpty());
}

TEST(CarriedForward, OnePassAfterAnotherIsReplaced) {
  Submission two = changed("bright.frag", "bright = color * ratio * uWeight;", "bright = vec3(0);");
  two.replace("down.frag", "oColor = vec4(downsample(uSource, uSize, uFilter), 1);",
              "oColor = vec4(0);");
  const Graded graded = gradePart("bloom", two);
  EXPECT_EQ(graded.earned("bloom.bright"), 0);
  EXPECT_EQ(graded.earned("bloom.levels"), 0);
  EXPECT_EQ(graded.earned("bloom.sum"), 15);
  EXPECT_THAT(carried(graded, "bloom.sum"), ElementsAre("bright pass", "levels"));
  EXPECT_THAT(output(graded, "bloom.sum"),
              HasSubstr("Judged with the reference's bright pass and levels in place of yours."));
}

TEST(CarriedForward, RightPassesAreNeverRunAgain) {
  EXPECT_FALSE(ranAgain(grade(Submission::solution())));
  EXPECT_FALSE(ranAgain(gradePart("shadow", Submission::example("comparison_inverted"))));
  EXPECT_FALSE(ranAgain(gradePart("bloom", Submission::example("blending_off"))));
}

/// The mirrored objects are drawn, but nowhere to be seen.
Submission nothingReflected() {
  return changed("mirror.vert", "gl_Position = uProjection * position;",
                 "gl_Position = uProjection * position + vec4(1e6, 0, 0, 0);");
}

/// Looks, once the reflection's pass is over, whether there is anything in it after all.
const std::string kLook = R"(
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    std::vector<unsigned> pixels(std::size_t(reflection.size) * std::size_t(reflection.size));
    if (mirror) {
      glBindTexture(GL_TEXTURE_2D, reflection.color);
      glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    }
    bool replaced = false;
    for (unsigned pixel : pixels) replaced = replaced || pixel != pixels[0];
)";
const std::string kObjects = "    // Pass \"objects\".\n"
                             "    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n";

TEST(CarriedForward, AProgramThatDrawsOtherPassesInTheSecondRunHasTheScoreOfTheFirst) {
  // Knowing that it is looked at is no way out, either.
  Submission honest = nothingReflected();
  honest.replace("floor.cpp", kObjects, kLook);
  EXPECT_EQ(grade(honest).earned("mirror.where"), 20);
  Submission other = nothingReflected();
  other.replace("floor.cpp", kObjects,
                kLook + "    if (replaced) {\n"
                        "      glBindFramebuffer(GL_FRAMEBUFFER, reflection.framebuffer);\n"
                        "      glClear(GL_DEPTH_BUFFER_BIT);\n"
                        "      glBindFramebuffer(GL_FRAMEBUFFER, 0);\n"
                        "    }\n");
  const Graded graded = grade(other);
  EXPECT_TRUE(ranAgain(graded));
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.earned("mirror.where"), 0);
  EXPECT_THAT(carried(graded, "mirror.where"), IsEmpty());
}

TEST(CarriedForward, AProgramThatFailsInTheSecondRunHasTheScoreOfTheFirst) {
  Submission other = nothingReflected();
  other.replace("floor.cpp", kObjects, kLook + "    if (replaced) std::abort();\n");
  other.replace("floor.cpp", "#include <gg/gg.hpp>\n",
                "#include <gg/gg.hpp>\n#include <cstdlib>\n");
  const Graded graded = grade(other);
  EXPECT_EQ(graded.outcome(), "graded") << "what the first run was";
  EXPECT_EQ(graded.earned("mirror.where"), 0);
}

TEST(CarriedForward, WhatIsPrintedThenGoesNowhere) {
  Submission other = nothingReflected();
  other.replace("floor.cpp", kObjects,
                kLook + "    if (replaced) throw std::runtime_error(\"caught you\");\n");
  const TemporaryFolder out;
  const fs::path report = out.path() / "report";
  EXPECT_EQ(
      runTool({"grade", "mirror", other.path(), "--no-diagnosis", "--no-repair", "--out", report})
          .exitCode,
      0);
  EXPECT_THAT(read(report / "results.json"), HasSubstr("\"carry forward\""));
  for (const char* file : {"index.html", "student.html", "results.json", "junit.xml"})
    EXPECT_THAT(read(report / file), Not(HasSubstr("caught you"))) << file;
}

TEST(CarriedForward, ACopyOfTheReplacedTextureIsWorthNothing) {
  Submission copy = nothingReflected();
  copy.replace("floor.cpp", "    window.swapBuffers();\n",
               "    if (mirror) {\n"
               "      glBindFramebuffer(GL_READ_FRAMEBUFFER, reflection.framebuffer);\n"
               "      glBlitFramebuffer(0, 0, reflection.size, reflection.size, 0, 0, "
               "window.width(), window.height(), GL_COLOR_BUFFER_BIT, GL_LINEAR);\n"
               "      glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);\n"
               "    }\n"
               "    window.swapBuffers();\n");
  const Graded graded = grade(copy);
  EXPECT_TRUE(ranAgain(graded));
  EXPECT_LT(graded.earned("mirror.where"), 1);
  EXPECT_EQ(graded.results.at("score"), 0);
}

TEST(CarriedForward, PassesThatDrawNothingEarnNothing) {
  Submission hollow =
      changed("bright.frag", "bright = color * ratio * uWeight;", "bright = vec3(0);");
  hollow.replace("down.frag", "oColor = vec4(downsample(uSource, uSize, uFilter), 1);",
                 "oColor = vec4(0);");
  hollow.replace("up.frag", "oColor = vec4(upsample(uSource, uSize, uFilter), 1);",
                 "oColor = vec4(0);");
  const Graded graded = gradePart("bloom", hollow);
  EXPECT_TRUE(ranAgain(graded));
  EXPECT_EQ(graded.earned("bloom.scene"), 6);
  EXPECT_EQ(graded.earned("bloom.bright"), 0);
  EXPECT_EQ(graded.earned("bloom.levels"), 0);
  EXPECT_EQ(graded.earned("bloom.sum"), 0);
}

TEST(CarriedForward, BrightnessWithoutAThresholdEarnsNothingFromTheReferencesScene) {
  Submission both = changed("object.frag", " + uGlow, 1);", " + 0.3 * uGlow, 1);");
  both.replace("bright.frag", "bright = color * ratio * uWeight;", "bright = color * uWeight;");
  const Graded graded = gradePart("bloom", both);
  EXPECT_LT(graded.earned("bloom.bright"), 3);
}

} // namespace
