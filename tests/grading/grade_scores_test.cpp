// What the ends of the scale are worth: everything, nothing, and pictures that only look right.

#include "tool.hpp"

#include "image/png.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

/// A program whose loop draws with `draw`, after `make`.
Submission drawing(const std::string& make, const std::string& draw) {
  return Submission::program("#include <gg/gg.hpp>\n"
                             "#include <gg/platform.hpp>\n"
                             "#include <gg/text_file.hpp>\n"
                             "#include <random>\n"
                             "void app(const gg::Scene& scene) {\n"
                             "  gg::Window window(\"floor\", scene.size);\n" +
                             make + "  while (window) {\n" + draw +
                             "    window.swapBuffers();\n"
                             "  }\n"
                             "}\n");
}

/// Shows `pixels` (RGB, `width` x `height`, unsigned char) in the whole window.
const std::string kShowPixels = R"(
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, width, height, 0, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, window.width(), window.height(),
                      GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
)";
const std::string kMakeTexture = "  gg::Texture texture; gg::Framebuffer framebuffer;\n";

/// The public scene's frames as raw RGB, bottom row first, as optional files of a submission.
void addPublicFrames(Submission& submission) {
  const TemporaryFolder rendered;
  const Ended ended = runTool(
      {"render", "mirror", "--solution", "--times", "0.21,0.9", "--out", rendered.path() / "out"});
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  for (int frame = 0; frame < 2; ++frame) {
    const ggrade::Image image =
        ggrade::readPng(rendered.path() / "out" / ("frame-" + std::to_string(frame) + ".png"));
    std::string bytes;
    for (int y = image.height() - 1; y >= 0; --y)
      for (int x = 0; x < image.width(); ++x)
        for (int c = 0; c < 3; ++c)
          bytes += static_cast<char>(static_cast<int>(image.at(x, y, c) * 255 + 0.5f));
    submission.write("copy" + std::to_string(frame) + ".frag", bytes);
  }
}

const std::string kLoadFrames = kMakeTexture + R"(
  const int width = 640, height = 480;
  const std::string copies[] = {gg::readFile(gg::programFolder() / "copy0.frag"),
                                gg::readFile(gg::programFolder() / "copy1.frag")};
)";
const std::string kPickFrame =
    "    const std::string& pixels = copies[glfwGetTime() < 0.5 ? 0 : 1];\n";

TEST(Score, TheReferenceHasEverything) {
  const Graded graded = gradeByTool(kSource / "solutions/floor", {"--solution"});
  EXPECT_EQ(graded.ended.exitCode, 0);
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.score(), 100);
  EXPECT_EQ(graded.bonus(), 10);
  EXPECT_EQ(graded.results.at("score"), 110);
  EXPECT_THAT(graded.lost(), IsEmpty());
  EXPECT_THAT(graded.results.at("extra_data").at("unused_files"), IsEmpty());
  // Upload or trusted folder: the same treatment.
  const Graded uploaded = grade(Submission::solution());
  EXPECT_EQ(uploaded.score(), 100);
  EXPECT_EQ(uploaded.bonus(), 10);
}

TEST(Score, TheStubHasNothing) {
  const Graded graded = gradeByTool(kSource / "assignments/floor");
  EXPECT_EQ(graded.ended.exitCode, 0);
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.results.at("score"), 0);
  EXPECT_EQ(graded.bonus(), 0);
  // Nothing of the picture is spoiled, either.
  EXPECT_EQ(graded.earned("mirror.keep_picture"), 0);
  EXPECT_EQ(graded.earned("mirror.keep_state"), 0);
}

struct Color {
  const char* name;
  const char* code;
};
void PrintTo(const Color& color, std::ostream* out) {
  *out << color.code;
}

class ConstantImage : public testing::TestWithParam<Color> {};

TEST_P(ConstantImage, HasNothing) {
  const Graded graded = grade(drawing(std::string("  const glm::vec3 color = ") + GetParam().code +
                                          ";\n  glClearColor(color.r, color.g, color.b, 1);\n",
                                      "    glClear(GL_COLOR_BUFFER_BIT);\n"));
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.results.at("score"), 0);
}

INSTANTIATE_TEST_SUITE_P(Score, ConstantImage,
                         testing::Values(Color{"Black", "glm::vec3(0)"},
                                         Color{"White", "glm::vec3(1)"},
                                         Color{"Grey", "glm::vec3(0.35)"},
                                         Color{"Background", "scene.background"}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Score, NoiseHasNothing) {
  const Graded graded =
      grade(drawing(kMakeTexture + "  std::mt19937 random(7);\n"
                                   "  const int width = window.width(), height = "
                                   "window.height();\n"
                                   "  std::vector<unsigned char> pixels(width * height * "
                                   "3);\n",
                    "    for (auto& value : pixels) value = random() & 255;\n" + kShowPixels));
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.results.at("score"), 0);
}

TEST(Score, ACopyOfThePublicPictureHasLessThanHalf) {
  Submission copy = drawing(kLoadFrames, kPickFrame + kShowPixels);
  addPublicFrames(copy);
  const Graded graded = grade(copy, {.pictures = true});
  EXPECT_EQ(graded.outcome(), "graded");
  // The copy is exact where it was taken.
  const auto& frames = graded.results.at("extra_data").at("scenes").at(0).at("frames");
  ASSERT_EQ(frames.size(), 2u);
  for (const auto& frame : frames) EXPECT_EQ(frame.at("wrong_share"), 0);
  EXPECT_LT(graded.results.at("score"), 50);
}

TEST(Score, ACopyWithTheStubForHiddenScenesHasLessThanHalf) {
  Submission copy = Submission::stub();
  addPublicFrames(copy);
  copy.replace("floor.cpp", "#include <gg/gg.hpp>\n",
               "#include <gg/gg.hpp>\n#include <gg/platform.hpp>\n#include <gg/text_file.hpp>\n");
  copy.replace("floor.cpp", "  while (window) {\n", kLoadFrames + "  while (window) {\n");
  copy.replace("floor.cpp", "    window.swapBuffers();\n",
               "    if (scene.camera.position == glm::vec3(0, 3.4, 7) && "
               "scene.real(\"mirror.blur\") == 0) {\n" +
                   kPickFrame + kShowPixels + "    }\n    window.swapBuffers();\n");
  const Graded graded = grade(copy, {.pictures = true});
  EXPECT_EQ(graded.outcome(), "graded");
  for (const auto& frame : graded.results.at("extra_data").at("scenes").at(0).at("frames"))
    EXPECT_EQ(frame.at("wrong_share"), 0);
  EXPECT_LT(graded.results.at("score"), 50);
}

} // namespace
