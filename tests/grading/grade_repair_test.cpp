// Each fault once: what was wrong is proved by drawing it again, costs the points of its own step,
// and is told.

#include "tool.hpp"

#include "grading/catalogue.hpp"

#include <gmock/gmock.h>

using namespace tool;
using ggrade::results::Result;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

Result repaired(const Submission& submission) {
  return grade(submission, {.diagnosis = true, .repair = true}).result;
}

Result repaired(const std::string& file, const std::string& from, const std::string& to) {
  return repaired(Submission::solution().replace(file, from, to));
}

double lost(const Result& result, const std::string& id) {
  for (const auto& item : result.items)
    if (item.id == id)
      return item.kind == ggrade::results::ItemKind::keep ? -item.earned
                                                          : item.points - item.earned;
  ADD_FAILURE() << "no item " << id;
  return 0;
}

double lostInAll(const Result& result) {
  double all = 0;
  for (const auto& item : result.items)
    if (item.kind != ggrade::results::ItemKind::bonus) all += lost(result, item.id);
  return all;
}

TEST(LongRepair, AStateThatIsLeftCostsOnceAndNoMoreThanTen) {
  const Result result = repaired("mirror.hpp", "glViewport(0, 0, window.x, window.y);",
                                 "glViewport(0, 0, window.y, window.y);");
  ASSERT_EQ(result.causes.size(), 1U) << result.causesSought;
  EXPECT_THAT(result.causes[0].passes, ElementsAre(1U));
  EXPECT_EQ(result.causes[0].unit, "viewport");
  EXPECT_THAT(result.causes[0].todos, IsEmpty());
  EXPECT_NEAR(lostInAll(result), 10, 0.01);
  ASSERT_EQ(result.diagnoses.size(), 1U);
  EXPECT_THAT(result.diagnoses[0].text,
              HasSubstr("all is right: the viewport (yours: 0, 0, 480, 480)."));
}

TEST(Repair, ALineOfAShaderCostsTheStepThatWritesIt) {
  const Result result = repaired("mirror.vert", "uClip ? world.y : 1", "uClip ? -world.y : 1");
  ASSERT_EQ(result.causes.size(), 1U) << result.causesSought;
  EXPECT_EQ(result.causes[0].unit, "lines mirror.6 of main in vertex");
  EXPECT_THAT(result.causes[0].todos, ElementsAre("mirror.6"));
  EXPECT_NEAR(lost(result, "mirror.clip"), 15, 0.01);
  const auto& shading =
      *std::ranges::find(result.items, "mirror.shading", &ggrade::results::Item::id);
  EXPECT_THAT(shading.repaired,
              ElementsAre("what stands below TODO(mirror.6) in main() of the vertex shader"));
  EXPECT_THAT(shading.message, HasSubstr("reflection's colours: 0.0%"));
  EXPECT_NEAR(lostInAll(result), 15, 0.01);
}

TEST(LongRepair, WhatIsNotDrawnGivesBackWhatWasDoneBesides) {
  const Result result = repaired(Submission::firstSteps(3));
  ASSERT_EQ(result.causes.size(), 2U) << result.causesSought;
  EXPECT_EQ(result.causes[0].unit, "draws");
  EXPECT_TRUE(result.causes[0].isUnseen);
  EXPECT_THAT(result.causes[0].todos, ElementsAre("mirror.4"));
  EXPECT_EQ(result.causes[1].unit, "shader vertex") << "the submission's own, without its lines";
  EXPECT_THAT(result.causes[1].todos, ElementsAre("mirror.5", "mirror.6"));
  EXPECT_NEAR(lostInAll(result), 65, 0.01) << "what belongs to steps 4 to 6";
}

TEST(LongRepair, NothingDoneEarnsNothing) {
  EXPECT_NEAR(lostInAll(repaired(Submission::firstSteps(0))), 100, 0.01);
}

/// The solution without one step, and what that is worth: all others' points, but of those of whose
/// work nothing can be seen then.
struct Gap {
  std::string todo;
  double score;
};

/// A part's score where these of its TODOs are done, all other parts', and these patches applied.
double scoreOf(const ggrade::Target& target, std::set<std::string> done,
               const std::vector<fs::path>& patches = {}) {
  for (const ggrade::Part& part : target.assignment.parts)
    for (const ggrade::Todo& todo : part.todos)
      if (part.id != target.id) done.insert(todo.id);
  const TemporaryFolder files;
  const fs::path solutions = kSource / "solutions" / target.assignment.id;
  ggrade::grading::writeFiles(target.assignment, {solutions, patches, done}, files.path());
  return gradePart(target.id, files.path(), {.repair = true}).score();
}

class LongGaps : public testing::TestWithParam<Gap> {};

TEST_P(LongGaps, EarnWhatIsDoneBesides) {
  const std::string part = GetParam().todo.substr(0, GetParam().todo.find('.'));
  const ggrade::Target target = ggrade::findTarget(kSource / "assignments", part);
  std::set<std::string> done;
  for (const ggrade::Todo& todo : target.parts.front().todos)
    if (todo.id != GetParam().todo) done.insert(todo.id);
  EXPECT_NEAR(scoreOf(target, done), GetParam().score, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Of, LongGaps,
                         testing::Values(Gap{"mirror.1", 90}, Gap{"mirror.2", 95},
                                         Gap{"mirror.4", 70}, Gap{"mirror.5", 80},
                                         Gap{"shadow.1", 95}, Gap{"shadow.2", 95},
                                         Gap{"shadow.3", 80}, Gap{"bloom.2", 94},
                                         Gap{"bloom.3", 83}, Gap{"bloom.4", 82}, Gap{"bloom.5", 80},
                                         Gap{"bloom.6", 85}, Gap{"shadow_volume.4", 75},
                                         Gap{"targets.1", 80}, Gap{"targets.4", 75},
                                         Gap{"ssao.2", 70}, Gap{"ssao.3", 84}),
                         [](const auto& one) {
                           std::string name = one.param.todo;
                           std::ranges::replace(name, '.', '_');
                           return name;
                         });

/// Steps that are still as handed out are given nothing where another one is put right.
class LongUnfinished : public testing::TestWithParam<const char*> {};

TEST_P(LongUnfinished, EarnNoMoreWithAMistake) {
  const std::string part = GetParam();
  const ggrade::Target target = ggrade::findTarget(kSource / "assignments", part);
  const fs::path solutions = kSource / "solutions" / target.assignment.id;
  const ggrade::grading::Catalogue catalogue =
      ggrade::grading::loadCatalogue(target.assignment, target.parts.front(), solutions, solutions);
  std::set<std::string> done;
  int tried = 0;
  for (const ggrade::Todo& todo : target.parts.front().todos) {
    done.insert(todo.id);
    const double right = scoreOf(target, done);
    for (const ggrade::grading::Mistake& mistake : catalogue.mistakes) {
      if (mistake.step != todo.id || mistake.outcome != ggrade::results::Outcome::graded) continue;
      try {
        EXPECT_LE(scoreOf(target, done, {mistake.patch}), right + 0.01)
            << todo.id << ": " << mistake.name;
      } catch (const ggrade::UsageError&) {
        continue; // it needs another step's lines
      }
      ++tried;
      break;
    }
  }
  EXPECT_GE(tried, 3);
}

INSTANTIATE_TEST_SUITE_P(Of, LongUnfinished,
                         testing::Values("mirror", "shadow", "bloom", "shadow_volume", "targets",
                                         "figure", "ssao", "antialias", "motion_blur", "afterglow"),
                         [](const auto& one) { return std::string(one.param); });

/// The occlusion's fragment shader holds the work of four steps.
TEST(Repair, AWholeShaderIsTheWorkOfAllStepsInIt) {
  Submission submission = Submission::firstSteps(1, "ssao");
  submission.replace("gbuffer.glsl", "ndc.y / uProjection", "-ndc.y / uProjection");
  EXPECT_NEAR(gradePart("ssao", submission, {.repair = true}).score(), 0, 0.01);
}

/// The sum and the edges stand in one function: whose lines it are, is told.
TEST(Repair, AStepsLinesCostThatStepWhateverStandsBesideThem) {
  Submission submission = Submission::firstSteps(4, "targets");
  submission.replace("compose.frag", "  if (uHasAmbient)", "  else if (uHasAmbient)");
  // The other step is right, and written in another way.
  submission.replace("compose.frag", "max(5.0 * light -", "max(light + 4.0 * light -");
  const Graded graded = gradePart("targets", submission, {.repair = true});
  EXPECT_NEAR(graded.score(), 87.5, 0.01) << "where something shines and ambient light is there";
}

/// Both step 4's light and step 5 are wrong: what looks like the light of step 5 earns nothing.
TEST(Repair, WhatIsNotBegunEarnsNothingByAnotherFault) {
  Submission submission = Submission::firstSteps(4);
  submission.replace("mirror.hpp", "scene.light.in(mirroredView)",
                     "scene.light.in(view).in(mirroredView)");
  EXPECT_NEAR(gradePart("mirror", submission, {.repair = true}).score(), 65, 0.01);
}

/// No hidden scene's reflection has the size that is typed in.
TEST(Repair, DepthsOfATypedInSizeCostTheStepThatMakesThem) {
  Submission submission = Submission::solution();
  submission.replace("mirror.hpp", "GL_DEPTH_COMPONENT24, size, size",
                     "GL_DEPTH_COMPONENT24, 512, 512");
  const Graded graded = gradePart("mirror", submission, {.repair = true});
  EXPECT_NEAR(graded.score(), 90, 0.01);
  EXPECT_EQ(graded.earned("mirror.hidden"), 0);
}

/// "restored" by another state than the one that was turned.
TEST(Repair, AFaceThatStaysTurnedCostsOnce) {
  Submission submission = Submission::solution();
  submission.replace("mirror.hpp", "glCullFace(GL_FRONT)", "glFrontFace(GL_CW)");
  const Result result = repaired(submission);
  EXPECT_NEAR(lostInAll(result), 10, 0.01);
  ASSERT_EQ(result.causes.size(), 1U) << result.causesSought;
  EXPECT_EQ(result.causes[0].unit, "culling");
}

/// Where a keep item alone lost points, too.
TEST(Repair, WhatIsLeftToTheNextFrameCostsNoMoreThanTen) {
  Submission submission = Submission::firstSteps(6, "shadow_volume");
  submission.replace("counting.hpp", "    glCullFace(GL_BACK);\n", "");
  const Graded graded = gradePart("shadow_volume", submission, {.repair = true});
  EXPECT_NEAR(graded.score(), 90, 0.01);
}

/// The right picture by a stencil and blending, in the window alone.
Submission withoutFramebufferObject() {
  Submission made = Submission::solution();
  const std::string pass =
      "mirrorPass(reflection, size, mirrorProgram, projection, view, light, scene, draw);";
  made.replace("floor.cpp", pass,
               R"(glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
      glEnable(GL_STENCIL_TEST);
      glStencilFunc(GL_ALWAYS, 1, 255);
      glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
      glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
      glDepthMask(GL_FALSE);
      tileProgram.use();
      tileProgram.set("uProjection", projection);
      tileProgram.set("uView", view);
      rectangle.draw();
      glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      glDepthMask(GL_TRUE);
      glStencilFunc(GL_EQUAL, 1, 255);
      glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
      turnCulling();
      beginClipping(mirrorProgram, true);
      drawMirrored(mirrorProgram, projection, view, light, scene, draw);
      endClipping();
      restoreCulling();
      glDisable(GL_STENCIL_TEST);
      glClear(GL_DEPTH_BUFFER_BIT);)");
  made.replace(
      "floor.cpp", "    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n    light.load",
      "    if (!mirror) glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n    light.load");
  made.replace("floor.cpp", "    rectangle.draw();\n\n    if (bloom)",
               R"(    const glm::vec4 share = scene.material("floor").specular;
    glBlendColor(share.r, share.g, share.b, 0);
    glBlendFunc(GL_ONE, GL_CONSTANT_COLOR);
    if (mirror) glEnable(GL_BLEND);
    rectangle.draw();
    glDisable(GL_BLEND);

    if (bloom))");
  made.replace("tile.frag", "color + uMaterial.specular.rgb * reflected", "color");
  return made;
}

TEST(Repair, AReflectionWithoutAFramebufferObjectLacksIt) {
  const Graded graded = gradePart("mirror", withoutFramebufferObject(), {.repair = true});
  EXPECT_EQ(graded.earned("mirror.target"), 0);
  EXPECT_NEAR(graded.score(), 85, 0.01) << "what making it and drawing into it is worth";
}

TEST(LongRepair, AClassIsRepaired) {
  const TemporaryFolder folder;
  Submission submission = Submission::solution();
  submission.replace("mirror.hpp", "glViewport(0, 0, window.x, window.y);",
                     "glViewport(0, 0, window.y, window.y);");
  fs::create_directories(folder.path() / "uploads");
  fs::copy(submission.path(), folder.path() / "uploads/ada");
  const fs::path out = folder.path() / "out";
  const Ended ended =
      runTool({"batch", "mirror", folder.path() / "uploads", "--out", out}, {}, 300);
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  const auto results = nlohmann::json::parse(read(out / "ada/results.json"));
  EXPECT_EQ(results.at("score"), 90);
  EXPECT_EQ(results.at("extra_data").at("proved_causes").at(0).at("unit"), "viewport");
}

} // namespace
