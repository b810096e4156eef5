// The likeliest cause, in words: right where it is known, honest where it isn't.

#include "tool.hpp"

#include <gmock/gmock.h>

using namespace tool;
using testing::AnyOf;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::StrEq;

namespace {

nlohmann::json onlyDiagnosis(const Graded& graded) {
  const nlohmann::json none = {{"id", ""}, {"text", ""}};
  const auto& all = graded.results.at("extra_data").at("diagnoses");
  EXPECT_EQ(all.size(), 1u);
  return all.empty() ? none : all[0];
}

TEST(Diagnosis, LightNotMirroredIsNamedWithItsStep) {
  const Graded graded =
      grade(Submission::example("light_not_mirrored"), {.pictures = true, .diagnosis = true});
  const auto diagnosis = onlyDiagnosis(graded);
  EXPECT_EQ(diagnosis.at("id"), "mirror_light_not_mirrored");
  EXPECT_EQ(diagnosis.at("step"), "Step 4: draw the mirrored scene");
  EXPECT_GT(diagnosis.at("confidence"), 0.9);
  EXPECT_EQ(diagnosis.at("picture"), "the texture that objects are drawn into");
  EXPECT_EQ(diagnosis.at("scene"), "public");
  EXPECT_THAT(diagnosis.at("place").get<std::string>(), HasSubstr(" of 1024x1024"));
  // The student reads it, with the place in the public scene; the instructor alone its name.
  const std::string output = graded.results.at("output");
  EXPECT_THAT(output, HasSubstr("Diagnosis: " + diagnosis.at("text").get<std::string>()));
  EXPECT_THAT(output, HasSubstr("Read again: Step 4"));
  EXPECT_THAT(output, HasSubstr(diagnosis.at("place").get<std::string>()));
  EXPECT_THAT(output, Not(HasSubstr("mirror_light_not_mirrored")));
}

TEST(Diagnosis, AFaultThatNobodyListedIsUnknownOrMeasured) {
  // A hole in the reflection, of no known mistake's shape.
  const Graded graded =
      grade(std::move(Submission::solution().replace(
                "tile.frag", "    reflected = texture(uReflection, at).rgb;\n",
                "    reflected = texture(uReflection, at).rgb;\n"
                "    if (fract(at.x * 3) < 0.5 && at.y > 0.4) reflected = vec3(0, 1, 0.3);\n")),
            {.pictures = true, .diagnosis = true});
  const auto diagnosis = onlyDiagnosis(graded);
  EXPECT_EQ(diagnosis.at("id"), "");
  EXPECT_EQ(diagnosis.at("confidence"), 0);
  EXPECT_THAT(diagnosis.at("text").get<std::string>(), HasSubstr("matches no known mistake"));
  // What is seen is said all the same.
  EXPECT_THAT(diagnosis.at("picture").get<std::string>(), HasSubstr("the window, frame"));
}

TEST(Diagnosis, AnUnfinishedProgramIsToldItsNextStep) {
  const auto diagnosis =
      onlyDiagnosis(grade(Submission::firstSteps(4), {.pictures = true, .diagnosis = true}));
  EXPECT_THAT(diagnosis.at("id").get<std::string>(), StrEq("step.4"));
  EXPECT_EQ(diagnosis.at("step"), "Step 5: turn culling and normals");
}

TEST(Diagnosis, FramebufferLeftBound) {
  const auto& diagnosis = onlyDiagnosis(
      grade(Submission::example("framebuffer_left_bound"), {.pictures = true, .diagnosis = true}));
  EXPECT_EQ(diagnosis.at("id"), "framebuffer_left_bound");
  EXPECT_THAT(diagnosis.at("text").get<std::string>(), HasSubstr("still bound"));
}

TEST(Diagnosis, NeverSwapsWithTheCompilersWarningBesideIt) {
  const Graded graded =
      grade(Submission::example("never_swaps"), {.pictures = true, .diagnosis = true});
  EXPECT_EQ(onlyDiagnosis(graded).at("id"), "no_frame");
  const std::string output = graded.results.at("output");
  EXPECT_THAT(output, HasSubstr("window.swapBuffers() is not reached"));
  EXPECT_THAT(output, HasSubstr("[-Wcomment]: a comment that ends in a backslash"));
}

TEST(Diagnosis, NoneWhereNothingWasLost) {
  const Graded graded = grade(Submission::solution(), {.pictures = true, .diagnosis = true});
  EXPECT_TRUE(graded.results.at("extra_data").at("diagnoses").empty());
}

} // namespace
