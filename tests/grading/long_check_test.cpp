// What `check` says of the whole catalogue: every mistake, finished and at its own step, with and
// without knowing it, and every right answer, also without comments. See kit_check_test.cpp.

#include "kit.hpp"

#include "grading/catalogue.hpp"
#include "grading/recipe.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <iostream>

using namespace tool;
using nlohmann::json;

namespace {

/// A part, and what to expect of it, made once.
struct Known {
  ggrade::Target target;
  fs::path solutions, expected;
  ggrade::grading::Catalogue catalogue;

  const ggrade::Part& part() const { return target.parts.front(); }
  const ggrade::Assignment& assignment() const { return target.assignment; }
};

const Known& known(const std::string& id) {
  static std::map<std::string, Known> all;
  const auto found = all.find(id);
  if (found != all.end()) return found->second;
  const fs::path expected = expectedOf(id);
  ggrade::Target target = ggrade::findTarget(kSource / "assignments", id);
  const fs::path solutions = kSource / "solutions" / target.assignment.id;
  auto catalogue =
      ggrade::grading::loadCatalogue(target.assignment, target.parts.front(), solutions, solutions);
  return all.emplace(id, Known{std::move(target), solutions, expected, std::move(catalogue)})
      .first->second;
}

/// The TODOs of all parts but this one, and the first `count` of this one.
std::set<std::string> firstTodos(const Known& of, std::size_t count) {
  std::set<std::string> todos;
  for (const ggrade::Part& part : of.assignment().parts)
    for (std::size_t i = 0; i < part.todos.size(); ++i)
      if (part.id != of.part().id || i < count) todos.insert(part.todos[i].id);
  return todos;
}

/// All that the compiler reads; empty where the program can't be made.
std::string textOf(const Known& of, const ggrade::grading::Recipe& recipe, const fs::path& into) {
  try {
    ggrade::grading::writeFiles(of.assignment(), recipe, into);
  } catch (const ggrade::UsageError&) {
    return {};
  }
  std::string text;
  for (const std::string& name : names(into)) text += name + '\n' + read(into / name);
  return text;
}

/// What is told of one mistake.
struct Told {
  std::string name, step;
  bool finished = false; ///< in the finished program, else in the one that has come to its step
  std::vector<std::string> states;
  std::string cause;
  bool isDone = false;   ///< nothing is found
  bool isPlaced = false; ///< what isn't right is its step, or that of one with the same passes
  bool isAlone = false;  ///< and no other step may be wrong
  bool isFalse = false;  ///< another step is called wrong, without a doubt
  std::set<std::string> named;     ///< mistakes of the catalogue that it may be
  std::set<std::string> undecided; ///< those of several that have no experiment
};

/// Mistakes of one group show the very same passes.
std::string groupOf(const ggrade::grading::Mistake& mistake) {
  return mistake.same.empty() ? mistake.name : mistake.same;
}

/// A copy of a part's folder of what is expected that doesn't know the mistakes of one group.
void forget(const fs::path& expected, const std::string& group, const fs::path& into) {
  fs::create_directory(into);
  for (const auto& entry : fs::directory_iterator(expected))
    if (entry.path().filename() != "expected.json")
      fs::create_symlink(entry.path(), into / entry.path().filename());
  json all = json::parse(read(expected / "expected.json"));
  for (json& fault : all.at("faults"))
    if (fault.at("group") == group) fault.at("scenes") = json::array();
  std::ofstream(into / "expected.json") << all;
}

///   isLeftOut: it is that nothing of its step was done
Told tell(const Known& of, const fs::path& expected, const ggrade::grading::Mistake& mistake,
          bool finished, bool isLeftOut, const fs::path& files) {
  Told told{mistake.name, mistake.step, finished, {}, {}, true, false, false, false, {}, {}};
  std::set<std::string> steps;
  for (const ggrade::grading::Mistake& other : of.catalogue.mistakes)
    if (groupOf(other) == groupOf(mistake)) steps.insert(other.step);
  const TemporaryFolder folder; // its page, and nobody else's work folder
  std::string said;
  told.states = statesOf(of.part().id, expected, files, &said);
  told.isAlone = std::ranges::find(told.states, "maybe") == told.states.end();
  bool isReached = false; // one of its steps
  for (std::size_t i = 0; i < told.states.size(); ++i) {
    const std::string& state = told.states[i];
    const bool isBlamed =
        state == "wrong" || state == "maybe" || state == "differs" || state == "nearly";
    if (state != "done" && state != "not_begun") told.isDone = false;
    isReached = isReached || steps.count(of.part().todos[i].id);
    if (isReached && state == "nearly") { // "here or in another step"
      told.isPlaced = true;
      told.isAlone = told.isAlone && steps.count(of.part().todos[i].id);
    }
    if (!steps.count(of.part().todos[i].id)) {
      told.isFalse = told.isFalse || state == "wrong";
      continue;
    }
    if (isBlamed || (isLeftOut && state == "not_begun")) told.isPlaced = true;
  }
  told.isDone = told.isDone && !told.isPlaced;
  if (const json all = json::parse(said, nullptr, false); all.is_array() && !all.empty()) {
    told.cause = all.at(0).at("cause");
    const std::string hint = "\n" + all.at(0).at("hint").get<std::string>();
    for (const ggrade::grading::Mistake& other : of.catalogue.mistakes) {
      const bool isOneOfSeveral = hint.find("\n- " + other.title + "\n") != hint.npos;
      if (isOneOfSeveral && other.experiment.empty()) told.undecided.insert(other.name);
      if (isOneOfSeveral || told.cause.ends_with(other.title)) told.named.insert(other.name);
    }
  }
  return told;
}

class LongCheck : public testing::TestWithParam<std::string> {};

/// What is told of each mistake, finished and at its own step.
///   knows: is the mistake itself, with those that show the same, among those that `check` knows?
std::vector<Told> tellAll(const Known& of, bool knows) {
  const auto& todos = of.part().todos;
  std::vector<Told> all;
  for (const ggrade::grading::Mistake& mistake : of.catalogue.mistakes) {
    const auto step = std::ranges::find(todos, mistake.step, &ggrade::Todo::id);
    const bool draws = mistake.outcome == ggrade::results::Outcome::graded ||
                       mistake.outcome == ggrade::results::Outcome::glError;
    if (!draws || step == todos.end()) continue;
    const TemporaryFolder copy;
    fs::path expected = of.expected;
    if (!knows) {
      expected = copy.path();
      forget(of.expected / of.part().id, groupOf(mistake), expected / of.part().id);
    }
    for (const bool finished : {false, true}) {
      const std::size_t count = finished ? todos.size() : std::size_t(step - todos.begin()) + 1;
      if (!finished && count == todos.size()) continue;
      const std::set<std::string> filled = firstTodos(of, count);
      const TemporaryFolder folder;
      const std::string wrong =
          textOf(of, {of.solutions, {mistake.patch}, filled}, folder.path() / "wrong");
      const std::string right = textOf(of, {of.solutions, {}, filled}, folder.path() / "right");
      if (wrong.empty() || wrong == right) continue; // it can't be made yet
      std::set<std::string> others = filled;
      others.erase(mistake.step);
      const bool isLeftOut =
          wrong == textOf(of, {of.solutions, {}, others}, folder.path() / "left_out");
      all.push_back(tell(of, expected, mistake, finished, isLeftOut, folder.path() / "wrong"));
      const Told& told = all.back();
      if (!told.isPlaced || (!knows && !told.named.empty()))
        std::cout << (told.finished ? "finished " : "at step  ") << told.name << " (" << told.step
                  << "): "
                  << (told.isDone     ? "DONE "
                      : told.isPlaced ? ""
                                      : "ELSEWHERE ")
                  << json(told.states).dump() << ' ' << told.cause << std::endl;
    }
  }
  return all;
}

///   share: of the mistakes that show must be at the right row
///   mostFalse: of all may be told as another step's without a doubt
void expectPlaced(const std::vector<Told>& all, double share, double mostFalse) {
  for (const bool finished : {false, true}) {
    const auto count = [&](const auto& is) {
      return std::ranges::count_if(
          all, [&](const Told& one) { return one.finished == finished && is(one); });
    };
    const auto programs = count([](const Told&) { return true; });
    const auto placed = count([](const Told& one) { return one.isPlaced; });
    const auto alone = count([](const Told& one) { return one.isPlaced && one.isAlone; });
    const auto done = count([](const Told& one) { return one.isDone; });
    const auto wrong = count([](const Told& one) { return one.isFalse; });
    const auto named = count([](const Told& one) { return !one.named.empty(); });
    std::cout << (finished ? "finished: " : "at its step: ") << programs << " mistakes, " << placed
              << " at the right row (" << alone << " at that alone), " << done << " called done, "
              << wrong << " told as another step's without a doubt, " << named
              << " told a title of the catalogue\n";
    EXPECT_EQ(finished ? done : 0, 0);
    EXPECT_GE(double(placed), share * double(finished ? programs : programs - done));
    EXPECT_LE(double(wrong), mostFalse * double(programs));
  }
}

TEST_P(LongCheck, PlacesEveryMistake) {
  const std::vector<Told> all = tellAll(known(GetParam()), true);
  std::set<std::string> undecided;
  for (const Told& told : all) undecided.insert(told.undecided.begin(), told.undecided.end());
  EXPECT_THAT(undecided, testing::IsEmpty()) << "what looks alike needs a \"Try:\"";
  expectPlaced(all, 0.95, 0.05);
}

/// Nobody makes the catalogue's mistakes alone: each is looked at as if it weren't in it.
TEST_P(LongCheck, PlacesMistakesThatItDoesNotKnow) {
  expectPlaced(tellAll(known(GetParam()), false), 0.5, 0.1);
}

TEST_P(LongCheck, IsSilentOnEveryRightAnswer) {
  const Known& of = known(GetParam());
  for (const ggrade::grading::Variant& variant : of.catalogue.variants) {
    if (!variant.loses.empty()) continue;
    for (const bool comments : {true, false}) {
      SCOPED_TRACE(variant.name + (comments ? "" : ", without comments"));
      const TemporaryFolder folder;
      const fs::path files = folder.path() / "files";
      ggrade::grading::writeFiles(of.assignment(), {of.solutions, {variant.patch}}, files);
      if (!comments) takeOutComments(files);
      std::string said;
      const std::vector<std::string> states = statesOf(of.part().id, of.expected, files, &said);
      for (const std::string& state : states) EXPECT_EQ(state, "done") << said;
    }
  }
}

/// Each effect alone is right, and all of them aren't.
TEST(LongCheckTogether, TellsOfWhatGoesWrongWhereAllEffectsAreDrawn) {
  const fs::path expected = expectedOf("floor");
  const auto check = [&](const Submission& submission) {
    std::string said;
    statesOf("floor", expected, submission.path(), &said);
    return json::parse(said);
  };
  const auto stateOf = [](const json& part) {
    std::set<std::string> states;
    for (const json& todo : part.at("todos")) states.insert(todo.at("state"));
    return states;
  };
  const std::set<std::string> done{"done"};
  const json right = check(Submission::solution());
  ASSERT_EQ(right.size(), 4u);
  for (const json& part : right) EXPECT_EQ(stateOf(part), done) << part.dump(1);
  EXPECT_EQ(right.at(3).at("part"), "floor");

  Submission alone = Submission::solution();
  alone.replace(
      "floor.cpp", "const bool glows = bloom && showsBloom(scene);",
      "const bool glows = bloom && showsBloom(scene) && !scene.flag(\"effects.shadow\");");
  const json wrong = check(alone);
  ASSERT_EQ(wrong.size(), 4u);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(stateOf(wrong.at(i)), done) << wrong.at(i).dump(1);
  // Who reads what isn't bound there is in doubt.
  const std::set<std::string> doneOrDoubted{"done", "maybe"};
  EXPECT_EQ(stateOf(wrong.at(2)), doneOrDoubted) << wrong.at(2).dump(1);
  EXPECT_EQ(stateOf(wrong.at(3)), std::set<std::string>{"wrong"}) << wrong.at(3).dump(1);

  // The shadow map is where the floor's reflection is bound.
  Submission oneUnit = Submission::solution();
  oneUnit.replace("shadow.hpp", "glActiveTexture(GL_TEXTURE1);", "glActiveTexture(GL_TEXTURE0);");
  oneUnit.replace("shadow.hpp", "program.set(\"uShadowMap\", 1);",
                  "program.set(\"uShadowMap\", 0);");
  const json shadow = check(oneUnit).at(1);
  EXPECT_EQ(shadow.at("todos").at(3).at("state"), "maybe") << shadow.dump(1);
  EXPECT_THAT(shadow.at("problems").at(0).at("text").get<std::string>(),
              testing::StartsWith("shadow.4 may be wrong"));
  EXPECT_THAT(shadow.at("cause").get<std::string>(),
              testing::HasSubstr("uShadowMap reads colours, not depths"));
  EXPECT_EQ(check(Submission::firstSteps(7)).size(), 3u) << "shadow and bloom aren't begun";

  // Alone nothing tells that unit 1 stays active.
  Submission leavesUnitOne = Submission::solution();
  leavesUnitOne.replace("shadow.hpp", "  glActiveTexture(GL_TEXTURE0);\n", "");
  const json left = check(leavesUnitOne);
  EXPECT_EQ(stateOf(left.at(3)), std::set<std::string>{"wrong"}) << left.at(3).dump(1);
  EXPECT_EQ(left.at(1).at("todos").at(3).at("state"), "maybe") << left.at(1).dump(1);
  EXPECT_THAT(left.at(1).at("cause").get<std::string>(),
              testing::HasSubstr("where all effects are drawn it isn't: The sampler uShadowMap"));
}

INSTANTIATE_TEST_SUITE_P(Of, LongCheck,
                         testing::Values("mirror", "shadow", "bloom", "shadow_volume", "figure",
                                         "targets", "ssao", "antialias", "motion_blur",
                                         "afterglow"),
                         [](const auto& info) { return info.param; });

} // namespace
