// A student's way through the handout: every program with the first k TODOs filled in compiles
// without a warning, is graded, earns what it shows, and shows what the handout's picture does.

#include "handout.hpp"

#include "authoring/pass_picture.hpp"
#include "authoring/solution_blocks.hpp"
#include "image/compare.hpp"

#include <gmock/gmock.h>

#include <regex>
#include <sstream>

using namespace tool;
using ggrade::Image;
using nlohmann::json;
using testing::Contains;

namespace {

/// What is known of a way besides that it never goes back.
struct Way {
  std::vector<double> scores; ///< after 0, 1, 2, ... steps; empty: only the last is known
  std::vector<int> unseen;    ///< steps that change nothing in the window
};

const std::map<std::string, Way> kWays = {
    // Each step's points come with it, if its work can be seen then: a framebuffer object into
    // which nothing is drawn can't, nor can a matrix with which nothing is.
    {"mirror", {{0, 0, 15, 35, 65, 85, 100, 100}, {1, 2}}},
    {"shadow", {{0, 0, 0, 30, 100, 100, 100}, {1, 2, 3}}},
    {"bloom", {{0, 0, 10, 27, 45, 65, 80, 100}, {1, 3, 4, 5, 6}}}};

double pointsOf(const ggrade::Part& part, ggrade::results::ItemKind kind) {
  double sum = 0;
  for (const ggrade::ItemDeclaration& item : part.items)
    if (item.kind == kind) sum += item.points;
  return sum;
}

/// What a program shows in the first frame of a picture of the handout.
ggrade::channel::Capture draw(const std::string& id, const fs::path& program, const json& scene,
                              const ggrade::grading::Moments& times,
                              const ggrade::grading::ShaderCache& shaders) {
  auto rendering =
      ggrade::grading::renderScene(id, program, scene, times, shaders, ggrade::grading::isolation(),
                                   ggrade::grading::gradingRequest());
  EXPECT_EQ(rendering.happened.outcome, ggrade::results::Outcome::graded)
      << rendering.happened.detail;
  return std::move(rendering.capture);
}

Image windowOf(const ggrade::channel::Capture& capture) {
  return ggrade::rubric::toImage(ggrade::grading::rawFrames(capture).at(0));
}

class Step : public testing::TestWithParam<std::string> {
protected:
  const ggrade::Assignment& assignment() const { return grader_.target().assignment; }
  const ggrade::Part& part() const { return grader_.target().parts.at(0); }
  Way way() const {
    const auto found = kWays.find(GetParam());
    return found == kWays.end() ? Way() : found->second;
  }

  /// Are the pictures of step `k` in the handout those that its program draws?
  void expectPictures(std::size_t k, const fs::path& program) const {
    const json settings = readHandout(assignment());
    const auto times = ggrade::grading::handoutTimes(part(), settings, k);
    const auto& shaders = grader_.references().shaders;
    const auto capture =
        draw(assignment().id, program,
             ggrade::grading::handoutScene(assignment(), part(), settings, k), times, shaders);
    const std::string name = part().id + "-" + std::to_string(k);
    expectHandedOut(assignment(), name + ".png", windowOf(capture));
    if (k == 0) return;
    const std::string todo = part().todos[k - 1].id;
    if (const json passes = settings.value("passes", json::object()); passes.contains(todo))
      expectHandedOut(assignment(), name + "-pass.png",
                      ggrade::authoring::passPicture(capture.trace, passes.at(todo), todo));
    const json pictures = settings.value("pictures", json::object());
    for (const auto& [other, picture] : pictures.items())
      if (picture.at("done") == json({todo}))
        expectHandedOut(
            assignment(), other + ".png",
            windowOf(draw(assignment().id, program, pictureScene(assignment(), settings, picture),
                          ggrade::grading::handoutTimes(settings, picture, other), shaders)));
  }

  Grader& grader_ = Grader::of(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Every, Step, testing::ValuesIn(partNames()),
                         [](const auto& one) { return one.param; });

TEST_P(Step, IsGradedAndEarnsAndShowsWhatTheHandoutSays) {
  const double points = pointsOf(part(), ggrade::results::ItemKind::gain);
  double score = 0, bonus = 0;
  std::size_t required = 0;
  for (const ggrade::Todo& todo : part().todos) required += !todo.bonus;
  for (std::size_t k = 0; k <= part().todos.size(); ++k) {
    SCOPED_TRACE("step " + std::to_string(k));
    const Submission made = Submission::firstSteps(static_cast<int>(k), part().id);
    const ggrade::grading::Built built = grader_.build(made.path());
    EXPECT_EQ(built.result.compilerOutput, "");
    const std::vector<double> scores = way().scores;
    // Where only the last score is known, the way there is seen in the public scene.
    const bool everywhere = !scores.empty() || k == 0 || k >= required;
    const Graded graded = grader_.grade(built, {.repair = true}, everywhere ? std::size_t(-1) : 1);
    ASSERT_EQ(graded.outcome(), "graded"); // neither gl_error nor no_frame
    if (scores.empty())
      EXPECT_GE(graded.score(), score);
    else
      EXPECT_NEAR(graded.score(), scores.at(k), 0.1);
    score = graded.score();
    if (everywhere) { // elsewhere a bonus is given
      EXPECT_GE(graded.bonus(), bonus);
      bonus = graded.bonus();
    }
    if (k == 0) {
      EXPECT_EQ(graded.results.at("score"), 0);
      for (const ggrade::ItemDeclaration& item : part().items)
        EXPECT_EQ(graded.earned(item.id), 0) << graded.message(item.id);
    }
    if (k == required) {
      EXPECT_EQ(score, points);
    }
    expectPictures(k, built.program->folder());
  }
  EXPECT_EQ(bonus, pointsOf(part(), ggrade::results::ItemKind::bonus));
}

TEST_P(Step, TheReferenceHasEverything) {
  const Graded graded =
      gradePart(GetParam(), kSource / "solutions" / assignment().id, {.solution = true});
  EXPECT_EQ(graded.outcome(), "graded");
  EXPECT_EQ(graded.score(), pointsOf(part(), ggrade::results::ItemKind::gain));
  EXPECT_EQ(graded.bonus(), pointsOf(part(), ggrade::results::ItemKind::bonus));
  EXPECT_THAT(graded.lost(), testing::IsEmpty());
}

/// In the window, or else in a pass.
TEST(Steps, ShowWhatTheHandoutSays) {
  const auto assignment = ggrade::Assignment::load(kSource / "assignments/floor");
  for (const auto& [part, way] : kWays)
    for (std::size_t k = 1; k < way.scores.size(); ++k) {
      const auto picture = [&, part = part](std::size_t step) {
        return readHandedOut(assignment, part + "-" + std::to_string(step) + ".png");
      };
      const ggrade::Comparison comparison = ggrade::compare(picture(k), picture(k - 1));
      ASSERT_TRUE(comparison.compared()) << comparison.message;
      // Making a framebuffer object changes nothing, nor does what nobody reads yet.
      if (testing::Value(static_cast<int>(k), testing::AnyOfArray(way.unseen)))
        EXPECT_EQ(comparison.wrongPixels, 0u) << part << k;
      else
        EXPECT_GT(comparison.wrongShare, 0.005) << part << k;
    }
}

/// Each step's, the passes and further ones that handout.json names, and no others.
TEST(Steps, HandoutsHaveThePicturesThatTheyShould) {
  for (const ggrade::Assignment& assignment : ggrade::loadAssignments(kSource / "assignments")) {
    const json settings = readHandout(assignment);
    std::set<std::string> wanted, there;
    for (const ggrade::Part& part : assignment.parts)
      for (std::size_t k = 0; k <= part.todos.size(); ++k) {
        const std::string name = part.id + "-" + std::to_string(k);
        wanted.insert(name + ".png");
        if (k > 0 && settings.value("passes", json::object()).contains(part.todos[k - 1].id))
          wanted.insert(name + "-pass.png");
      }
    const json pictures = settings.value("pictures", json::object());
    for (const auto& [name, picture] : pictures.items()) wanted.insert(name + ".png");
    for (const std::string& name : names(assignment.folder / "handout"))
      if (name.ends_with(".png")) there.insert(name);
    EXPECT_EQ(there, wanted);
  }
}

/// Of steps of several parts together; those of one part's are drawn with it, above.
TEST(Steps, PicturesOfSeveralPartsAreInStepWithTheSolution) {
  for (const ggrade::Assignment& assignment : ggrade::loadAssignments(kSource / "assignments")) {
    const json settings = readHandout(assignment);
    const json pictures = settings.value("pictures", json::object());
    for (const auto& [name, picture] : pictures.items()) {
      if (picture.at("done").size() == 1) continue; // a step's, see above
      const TemporaryFolder program;
      const fs::path solution = kSource / "solutions" / assignment.id;
      for (const std::string& file : assignment.files)
        program.write(file, ggrade::authoring::withFilled(read(solution / file), file,
                                                          doneFor(assignment, picture)));
      for (const std::string& file : assignment.dataFiles())
        fs::copy_file(assignment.folder / file, program.path() / file);
      using ggrade::sandbox::Isolation;
      ASSERT_TRUE(
          ggrade::grading::buildProgram(assignment.id, program.path(), Isolation::none).ok());
      const auto rendering = ggrade::grading::renderScene(
          assignment.id, program.path(), pictureScene(assignment, settings, picture),
          ggrade::grading::handoutTimes(settings, picture, name), {}, Isolation::none);
      expectHandedOut(assignment, name + ".png", windowOf(rendering.capture));
    }
  }
}

TEST(Steps, StubAndHandoutsAreInStepWithTheSolution) {
  for (const ggrade::Assignment& assignment : ggrade::loadAssignments(kSource / "assignments")) {
    SCOPED_TRACE(assignment.id);
    // The pictures of one assignment; of the others, the tests above draw them.
    const bool pictures = assignment.id == "shadow_volume";
    expectInStep(assignment, pictures);
  }
}

TEST(Steps, EveryStepOfTheFloorHasItsTextAndItsPicture) {
  const fs::path folder = kSource / "assignments/floor";
  for (const char* name : {"mirror.md", "shadow.md", "bloom.md"})
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  const std::vector<std::string> pictures = names(folder / "handout");
  // A step that shows nothing in the window, but draws, shows its pass.
  for (const char* name : {"mirror-2-pass.png", "shadow-3-pass.png", "bloom-3-pass.png",
                           "bloom-4-pass.png", "bloom-5-pass.png", "bloom-6-pass.png"})
    EXPECT_THAT(pictures, Contains(name));
}

/// Lines that aren't blank.
int linesIn(const std::string& text) {
  std::istringstream lines(text);
  int count = 0;
  for (std::string line; std::getline(lines, line);)
    count += line.find_first_not_of(" \t\r") != line.npos;
  return count;
}

/// What a handout shows of the code.
int linesOfCode(const std::string& handout) {
  static const std::regex kCode("```(?:cpp|glsl)\n([^`]*)```");
  int count = 0;
  for (std::sregex_iterator i(handout.begin(), handout.end(), kCode), end; i != end; ++i)
    count += linesIn((*i)[1]);
  return count;
}

TEST(Steps, LittleIsReadBeforeTheFirstTodoOfTheFloor) {
  const fs::path folder = kSource / "assignments/floor";
  for (const std::string part : {"mirror", "shadow", "bloom"}) {
    const std::string handout = read(folder / (part + ".md")),
                      header = read(folder / (part + ".hpp"));
    const std::size_t step = handout.find("\n## Step 2"),
                      todo = header.find("TODO(" + part + ".1)");
    ASSERT_NE(step, handout.npos);
    ASSERT_NE(todo, header.npos);
    const int shown = linesOfCode(handout.substr(0, step));
    EXPECT_GT(shown, 0);
    EXPECT_LE(shown + linesIn(header.substr(0, todo)), 60) << part;
  }
}

TEST(Steps, TodosOfTheFloorStandInTheOrderOfTheirSteps) {
  static const std::regex kTodo(R"(// TODO\(([a-z]+)\.([0-9])\)(?::|, too:))");
  int found = 0;
  const fs::path folder = kSource / "assignments/floor";
  for (const std::string& file : ggrade::Assignment::load(folder).files) {
    const std::string text = read(folder / file);
    std::string last;
    for (std::sregex_iterator i(text.begin(), text.end(), kTodo), end; i != end; ++i, ++found) {
      EXPECT_NE(file, "floor.cpp");
      EXPECT_LE(last, (*i)[2].str()) << file;
      last = (*i)[2];
    }
  }
  EXPECT_GE(found, 7 + 6 + 6);
}

TEST(Steps, NothingOfTheSolutionStandsInTheAssignment) {
  for (const ggrade::Assignment& assignment : ggrade::loadAssignments(kSource / "assignments")) {
    SCOPED_TRACE(assignment.id);
    EXPECT_GE(expectNoSolutionIn(assignment, assignment.folder),
              assignment.id == "floor" ? 7 + 6 + 6 : 1);
  }
}

} // namespace
