// Programs that nobody has written: what is drawn, and what is said of what becomes of it.

#include "authoring/solution_blocks.hpp"
#include "generated/figures.hpp"
#include "generated/mutants.hpp"
#include "generated/operators.hpp"
#include "generated/rewrites.hpp"

#include "framework_throws.hpp"

#include <gmock/gmock.h>

#include <set>

using namespace ggrade;
using namespace ggrade::generated;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

namespace {

std::vector<std::string> changed(const std::string& change, const std::string& line) {
  for (const Operator& one : operators())
    if (one.name == change) return one.apply(line);
  ADD_FAILURE() << "there is no " << change;
  return {};
}

TEST(Generated, EachKindOfMistake) {
  const auto expect = [](const char* change, const char* line, std::vector<std::string> wanted) {
    EXPECT_THAT(changed(change, line), testing::UnorderedElementsAreArray(wanted))
        << change << ": " << line;
  };
  expect("flips a comparison", "  if (depth <= bias) {", {"  if (depth > bias) {"});
  expect("moves a bound by one", "  for (int i = 0; i < 5; ++i)",
         {"  for (int i = 0; i <= 5; ++i)"});
  expect("and for or", "a && b", {"a || b"});
  expect("negates a condition", "  if (isOn()) draw();", {"  if (!(isOn())) draw();"});
  expect("plus for minus", "x = a + b - c;", {"x = a - b - c;", "x = a + b + c;"});
  expect("times for over", "x = a * b;", {"x = a / b;"});
  expect("another number", "glViewport(0, x);", {"glViewport(1, x);"});
  expect("another number", "float b = 0.5;",
         {"float b = 1.0;", "float b = 0.25;", "float b = 0.0;"});
  expect("another number", "vec3 v; GL_TEXTURE0", {});
  expect("swaps two arguments", "lookAt(eye, target, up);",
         {"lookAt(target, eye, up);", "lookAt(eye, up, target);"});
  expect("another constant of OpenGL", "glCullFace(GL_BACK);",
         {"glCullFace(GL_FRONT);", "glCullFace(GL_FRONT_AND_BACK);"});
  expect("another constant of OpenGL", "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);",
         {"glClear(GL_DEPTH_BUFFER_BIT);", "glClear(GL_COLOR_BUFFER_BIT);"});
  expect("another function", "n = glm::normalize(n);", {"n = (n);"});
  expect("another function", "x = std::min(a, b);", {"x = std::max(a, b);"});
  expect("other components", "p.xy", {"p.yx", "p.yx"});
  expect("other factors", "m = view * mirror;", {"m = mirror * view;", "m = view;", "m = mirror;"});
  expect("drops a sign", "vec3(1, -1, -x)", {"vec3(1, 1, -x)", "vec3(1, -1, x)"});
  expect("adds a sign", "f(light);", {"f(-light);"});
  expect("true for false", "set(true);", {"set(false);"});
  expect("leaves out a statement", "  program.use();", {"  ;"});
  expect("leaves out a statement", "  light = up;", {"  ;"});
}

TEST(Generated, StringsCommentsAndDeclarationsStay) {
  for (const Operator& one : operators()) {
    EXPECT_THAT(one.apply("  // a < b, -1, GL_BACK, sin(x.xy) * y; glEnable(GL_BLEND);"), IsEmpty())
        << one.name;
    EXPECT_THAT(one.apply("  say(\"a < b, 1.5, GL_BACK, true\");"),
                Each(testing::AnyOf("  ;", HasSubstr("\"a < b, 1.5, GL_BACK, true\""))))
        << one.name;
  }
  for (const char* line : {"  const float a = 1;", "  glm::vec3 up = f(x);", "  return f(x);",
                           "  GLuint name;", "  if (x) f();", "  gg::Program program(a, b);"})
    EXPECT_FALSE(authoring::isPlainStatement(line)) << line;
  for (const char* line : {"  glClear(A | B);", "  x = 1;", "  x.y += f(1);", "  a.set(\"b\", c);",
                           "  ++i;  // comment"})
    EXPECT_EQ(authoring::isPlainStatement(line), std::string(line).find("++i") == std::string::npos)
        << line;
}

const char* const kProgram = "void before() { x = 1; } // stays\n"
                             "// BEGIN SOLUTION(m.1)\n"
                             "struct Kept {\n"
                             "  int member;\n"
                             "};\n"
                             "void draw() {\n"
                             "  glViewport(0, 0, width, height); // of the window\n"
                             "  call(first,\n"
                             "       second);\n"
                             "  value = other;\n"
                             "}\n"
                             "// END SOLUTION(m.1)\n"
                             "void after() { x = 2; }\n";

TEST(Generated, RightOnesAreRewrittenInsideOfBlocksAlone) {
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Chance chance(seed, "test");
    const Rewritten done = rewrite(kProgram, "m.cpp", 1 + seed % 5, chance);
    EXPECT_FALSE(done.changes.empty());
    for (const char* kept : {"void before() { x = 1; } // stays\n// BEGIN SOLUTION(m.1)\nstruct "
                             "Kept {\n  int member;\n",
                             "call(first,\n       second);",
                             "// END SOLUTION(m.1)\nvoid after() { x = 2; }\n", "value = other;"})
      EXPECT_THAT(done.text, HasSubstr(kept)) << seed;
    EXPECT_THAT(done.text, testing::AnyOf(HasSubstr("glViewport(0, 0, width, height);"))) << seed;
    texts.insert(done.text);
    Chance again(seed, "test");
    EXPECT_EQ(rewrite(kProgram, "m.cpp", 1 + seed % 5, again).text, done.text);
  }
  EXPECT_GT(texts.size(), 60u);
  const auto all = [&](const std::string& part) {
    return std::ranges::any_of(texts,
                               [&](const auto& text) { return text.find(part) != text.npos; });
  };
  for (const char* part : {"for (int other0 = 0; other0 < 1; ++other0) value = other;",
                           "if (1 < 2) {", "if (1 > 2) value = other;\n", "float other0 = 0.25;",
                           "[&] { value = other; }();", "glViewport(0, 0, width, height);\n"})
    EXPECT_TRUE(all(part)) << part;
}

TEST(Generated, ShadersAreRewrittenInTheirLanguage) {
  const std::string shader = "void main() {\n"
                             "  // BEGIN SOLUTION(m.1)\n"
                             "  vec3 light = normalize(l);\n"
                             "  colour = vec4(light, 1);\n"
                             "  // END SOLUTION(m.1)\n"
                             "}\n";
  std::string all;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Chance chance(seed, "test");
    all += rewrite(shader, "m.frag", 1, chance).text;
  }
  for (const char* part : {"vec4 other0 = vec4(normalize(l), 0.0);\n  vec3 light = other0.xyz;",
                           "vec3 light = (normalize(l)) * 1.0;", "vec3 light = other0;"})
    EXPECT_THAT(all, HasSubstr(part));
  EXPECT_THAT(all, AllOf(Not(HasSubstr("[&]")), Not(HasSubstr("1.0f"))));
}

class Drawn : public testing::Test {
protected:
  const Target target_ = findTarget(fs::path(GGRADE_SOURCE_DIR) / "assignments", "mirror");
  const fs::path solution_ = fs::path(GGRADE_SOURCE_DIR) / "solutions/floor";

  std::vector<Mutant> draw(std::size_t count, std::uint64_t seed) const {
    return drawMutants(target_.assignment, target_.parts[0], solution_, count, seed);
  }
};

TEST_F(Drawn, AreOfAllStepsDifferentAndTheSameForASeed) {
  const std::vector<Mutant> all = draw(150, 7);
  ASSERT_EQ(all.size(), 150u);
  EXPECT_EQ(all, draw(150, 7));
  EXPECT_NE(all, draw(150, 8));
  std::set<std::string> todos, kinds, texts;
  for (const Mutant& mutant : all) {
    todos.insert(mutant.todo);
    kinds.insert(mutant.change);
    texts.insert(describe(mutant));
  }
  EXPECT_EQ(texts.size(), 150u) << "none twice";
  EXPECT_EQ(todos.size(), target_.parts[0].todos.size());
  EXPECT_GT(kinds.size(), 14u);
}

TEST_F(Drawn, ChangeTheirLinesAndNothingElse) {
  for (const Mutant& mutant : draw(150, 9)) {
    const std::string text = readFile(solution_ / mutant.file), after = withChange(text, mutant);
    EXPECT_NE(after, text);
    EXPECT_EQ(std::ranges::count(after, '\n') - std::ranges::count(text, '\n'),
              std::ptrdiff_t(mutant.after.size()) - std::ptrdiff_t(mutant.before.size()));
    for (const std::string& line : mutant.after) EXPECT_THAT(after, HasSubstr(line + '\n'));
  }
}

TEST_F(Drawn, OfAnotherTextIsRefused) {
  const Mutant mutant = draw(1, 7)[0];
  EXPECT_THROW(withChange("another\n", mutant), std::invalid_argument);
  EXPECT_THROW(withChange("", mutant), std::invalid_argument);
}

Case wrong(double score, const char* shownIn, const char* answer = "", const char* step = "") {
  Case found;
  found.name = "wrong-000";
  found.todo = "m.2";
  found.score.outcome = results::Outcome::graded;
  found.score.score = score;
  found.allowed = 30;
  found.shownIn = shownIn;
  found.answer = answer;
  found.step = step;
  settle(found, 100, "Step 2: light it");
  return found;
}

TEST(Generated, AFaultCostsItsStep) {
  EXPECT_EQ(wrong(70, "public").fate, Fate::fair);
  EXPECT_EQ(wrong(69, "public").fate, Fate::tooLow);
  EXPECT_EQ(wrong(98, "public").fate, Fate::survived);
  EXPECT_EQ(wrong(98, "").fate, Fate::equivalent);
  EXPECT_EQ(wrong(97, "").fate, Fate::unseen);
  Case crashed = wrong(0, "public");
  crashed.score.outcome = results::Outcome::crash;
  settle(crashed, 100, "");
  EXPECT_EQ(crashed.fate, Fate::notDrawn);
  crashed.isRight = true;
  settle(crashed, 100, "");
  EXPECT_EQ(crashed.fate, Fate::tooLow) << "a right one has to draw";
  Case right = wrong(98, "");
  right.isRight = true;
  settle(right, 100, "");
  EXPECT_EQ(right.fate, Fate::fair);
  right.score.score = 97;
  settle(right, 100, "");
  EXPECT_EQ(right.fate, Fate::tooLow);
}

TEST(Generated, ADiagnosisIsRightWhereItNamesTheStep) {
  EXPECT_EQ(wrong(70, "public").told, Told::silent);
  EXPECT_EQ(wrong(70, "public", "brighter").told, Told::generic);
  EXPECT_EQ(wrong(70, "public", "m_dark", "Step 2: light it").told, Told::right);
  EXPECT_EQ(wrong(70, "public", "m_dark", "Step 1: draw").told, Told::wrong);
}

TEST(Generated, WhatDoesNotHoldIsSaid) {
  Figures figures;
  figures.part = "m";
  for (int i = 0; i < 18; ++i)
    figures.cases.push_back(wrong(80, "public", "m_dark", "Step 2: light it"));
  EXPECT_EQ(failuresOf(figures), "");
  figures.cases.push_back(wrong(100, "public"));
  EXPECT_EQ(failuresOf(figures), "m: only 94.7% of the wrong programs are found\n");
  figures.cases.back() = wrong(20, "public", "m_dark", "Step 1: draw");
  EXPECT_EQ(failuresOf(figures),
            "m: 5.3% of the wrong programs lose more than their step's points and 10\n"
            "m: the first diagnosis names a wrong step in 5.3%\n");
  Case right = wrong(90, "");
  right.isRight = true;
  settle(right, 100, "");
  figures.cases.assign(1, right);
  EXPECT_EQ(failuresOf(figures), "m: 1 right programs lose more than 2 points\n");
}

} // namespace
