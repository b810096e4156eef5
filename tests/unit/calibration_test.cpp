// What the gradings of known answers say of the grader, on scores made up for it.

#include "calibration/adopt.hpp"
#include "calibration/diagnosis.hpp"
#include "calibration/page.hpp"
#include "calibration/programs.hpp"
#include "calibration/subject.hpp"
#include "calibration/tolerances.hpp"
#include "calibration/verdicts.hpp"
#include "grading/recipe.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
using namespace ggrade::calibration;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

ItemDeclaration item(const std::string& id, results::ItemKind kind, double points,
                     bool beyond = false) {
  ItemDeclaration declared;
  declared.id = id;
  declared.kind = kind;
  declared.points = points;
  declared.beyondLecture = beyond;
  return declared;
}

const std::vector<ItemDeclaration> kItems = {
    item("p.shape", results::ItemKind::gain, 50), item("p.colour", results::ItemKind::gain, 30),
    item("p.clip", results::ItemKind::gain, 20, true), item("p.keep", results::ItemKind::keep, 40),
    item("p.soft", results::ItemKind::bonus, 10)};

/// A grading in which items lost so many points.
Score score(std::uint64_t seed, const std::map<std::string, double>& lost) {
  Score made;
  made.seed = seed;
  made.score = 100;
  made.bonus = 10;
  for (const ItemDeclaration& one : kItems) {
    const double full = one.kind == results::ItemKind::keep ? 0 : one.points;
    const double gone = lost.count(one.id) ? lost.at(one.id) : 0;
    made.earned[one.id] = full - gone;
    if (gone > 0) made.messages[one.id] = "31% differ";
    (one.kind == results::ItemKind::bonus ? made.bonus : made.score) -= gone;
  }
  made.score = std::max(0.0, made.score);
  return made;
}

Measured measured(Kind kind, const std::string& name, std::vector<Score> scores,
                  const std::string& fails = {}) {
  Measured made;
  made.program.kind = kind;
  made.program.name = name;
  made.program.fails = fails;
  made.scores = std::move(scores);
  return made;
}

std::vector<std::string> failures(const std::vector<Measured>& all) {
  return judge("p", kItems, all).failures();
}

TEST(Verdicts, RightAnswersThatKeepTheirPointsAndMistakesThatLoseTheirsSeparate) {
  const Verdicts verdicts = judge(
      "p", kItems,
      {measured(Kind::reference, "reference", {score(1, {}), score(2, {})}),
       measured(Kind::variant, "p_v", {score(1, {{"p.shape", 2}}), score(2, {{"p.shape", 1.2}})}),
       measured(Kind::mistake, "p_m", {score(1, {{"p.shape", 30}}), score(2, {{"p.shape", 50}})},
                "p.shape"),
       measured(Kind::stub, "stub",
                {score(1, {{"p.shape", 50}, {"p.colour", 30}, {"p.clip", 20}})})});
  EXPECT_THAT(verdicts.failures(), IsEmpty());
  EXPECT_THAT(verdicts.seeds, ElementsAre(1, 2));
  EXPECT_EQ(verdicts.lowestRight, 98);
  EXPECT_EQ(verdicts.highestWrong, 70);
  EXPECT_EQ(verdicts.confusion[0][0], 4u); // right, accepted
  EXPECT_EQ(verdicts.confusion[0][1], 0u);
  EXPECT_EQ(verdicts.confusion[1][0], 0u);
  EXPECT_EQ(verdicts.confusion[1][1], 3u); // wrong, not accepted
  const Row& variant = verdicts.rows[1];
  EXPECT_EQ(variant.lowest, 98);
  EXPECT_NEAR(variant.mean, 98.4, 1e-9);
  EXPECT_NEAR(variant.highest, 98.8, 1e-9);
  EXPECT_NEAR(variant.margin, 0, 1e-9);
  const Row& mistake = verdicts.rows[2];
  EXPECT_NEAR(mistake.itemLoss, 0.6, 1e-9);
  EXPECT_NEAR(mistake.margin, 15, 1e-9); // of the item: 30 of 50 lost, 15 must be
}

TEST(Verdicts, ARightAnswerBelow98IsNamedWithItsSeedAndWhatItLost) {
  const auto all = failures({measured(
      Kind::variant, "p_v", {score(1, {{"p.shape", 1.9}}), score(7, {{"p.shape", 2.1}})})});
  EXPECT_THAT(all, ElementsAre("p_v: on seed 7 it scores 97.9; a right answer has at least 98; "
                               "p.shape loses 2.1 (31% differ)"));
}

TEST(Verdicts, ARightAnswerLosesWhatItMayAndNoMore) {
  Measured lecture = measured(Kind::variant, "p_lecture", {score(1, {{"p.clip", 20}})});
  EXPECT_THAT(failures({lecture}), ElementsAre(HasSubstr("p_lecture: on seed 1 it scores 80")));
  lecture.program.loses = {"p.clip"};
  EXPECT_THAT(failures({lecture}), IsEmpty());
  lecture.scores = {score(1, {{"p.clip", 20}, {"p.colour", 3}})};
  EXPECT_THAT(failures({lecture}),
              ElementsAre(AllOf(HasSubstr("p.colour loses 3"), Not(HasSubstr("p.clip loses")))));
}

TEST(Verdicts, ARightAnswerMovesByAtMostOnePoint) {
  EXPECT_THAT(
      failures({measured(Kind::variant, "p_v", {score(1, {}), score(2, {{"p.shape", 1}})})}),
      IsEmpty());
  EXPECT_THAT(
      failures({measured(Kind::variant, "p_v", {score(1, {}), score(2, {{"p.shape", 1.1}})})}),
      ElementsAre("p_v: its score moves by 1.1 points from seed to seed, 98.9 to 100; at most 1 is "
                  "allowed"));
}

TEST(Verdicts, AMistakeThatLosesTooLittleOfItsItemIsNamed) {
  const auto all = failures({measured(
      Kind::mistake, "p_m",
      {score(1, {{"p.shape", 14.9}}), score(2, {{"p.shape", 50}}), score(3, {{"p.shape", 14}})},
      "p.shape")});
  EXPECT_THAT(all, ElementsAre("p_m: on seed 3 p.shape loses 14 of 50 points; 30% of them must "
                               "go: 31% differ (fails on 2 of 3 seeds: 1, 3)"));
}

TEST(Verdicts, AMistakeInARequiredItemCostsSevenAndAHalfInAll) {
  const auto lost = [](const char* id, double points) {
    return failures({measured(Kind::mistake, "p_m", {score(1, {{id, points}})}, id)});
  };
  EXPECT_THAT(lost("p.colour", 9), IsEmpty());
  EXPECT_THAT(lost("p.keep", 24), IsEmpty());
  EXPECT_THAT(lost("p.keep", 23.9), ElementsAre(HasSubstr("p.keep loses 23.9 of 40")));
  EXPECT_THAT(lost("p.clip", 6), IsEmpty()); // beyond the lecture: may cost less
  EXPECT_THAT(lost("p.clip", 5.9), ElementsAre(HasSubstr("p.clip loses 5.9 of 20")));
  EXPECT_THAT(lost("p.soft", 6), IsEmpty()); // a bonus costs nothing of the 100
  std::vector<ItemDeclaration> small = kItems;
  small.push_back(item("p.small", results::ItemKind::gain, 5));
  Score cheap = score(1, {});
  cheap.earned["p.small"] = 0;
  EXPECT_THAT(
      judge("p", small, {measured(Kind::mistake, "p_m", {cheap}, "p.small")}).failures(),
      ElementsAre(HasSubstr("it costs 5 points in all; a mistake in a required item costs at "
                            "least 7.5")));
}

TEST(Verdicts, AnotherEndThanTheOneDeclaredFails) {
  Measured mistake = measured(Kind::mistake, "p_m", {score(1, {{"p.shape", 50}})}, "p.shape");
  mistake.scores[0].outcome = results::Outcome::crash;
  mistake.scores[0].detail = "signal 11";
  EXPECT_THAT(failures({mistake}),
              ElementsAre("p_m: on seed 1 it ends as crash instead of graded: signal 11"));
  mistake.program.outcome = results::Outcome::crash;
  EXPECT_THAT(failures({mistake}), IsEmpty());
}

TEST(Verdicts, TwoMistakesMustNotOffsetEachOther) {
  Measured pair = measured(Kind::pair, "p_a + b", {score(1, {{"p.shape", 40}})});
  pair.program.of = {"p_a", "p_b"};
  const Measured a = measured(Kind::mistake, "p_a", {score(1, {{"p.shape", 40}})}, "p.shape");
  Measured b = measured(Kind::mistake, "p_b", {score(1, {{"p.colour", 30}})}, "p.colour");
  EXPECT_THAT(failures({a, b, pair}), IsEmpty());
  b.scores = {score(1, {{"p.colour", 30}, {"p.clip", 20}})};
  const Verdicts verdicts = judge("p", kItems, {a, b, pair});
  EXPECT_THAT(verdicts.failures(),
              ElementsAre("p_a + b: on seed 1 it scores 70, more than p_b alone with 60"));
  EXPECT_EQ(verdicts.pairs, 1u);
  EXPECT_EQ(verdicts.confusion[1][0], 1u);
}

TEST(Verdicts, PicturesWithoutAProgramAndTheStubEarnNothing) {
  const auto lost = [](double left) { return score(1, {{"p.shape", 100 - left}}); };
  EXPECT_THAT(failures({measured(Kind::pictures, "noise", {lost(0)})}), IsEmpty());
  EXPECT_THAT(failures({measured(Kind::pictures, "noise", {lost(0.1)}),
                        measured(Kind::stub, "stub", {lost(3)})}),
              ElementsAre("noise: on seed 1 it scores 0.1 instead of 0",
                          "stub: on seed 1 it scores 3 instead of 0"));
}

TEST(Verdicts, AProgramThatCouldNotBeGradedFailsByName) {
  Measured gone = measured(Kind::variant, "p_v", {});
  gone.problem = "p_v.patch no longer applies";
  const Verdicts verdicts = judge("p", kItems, {gone});
  EXPECT_THAT(verdicts.failures(), ElementsAre("p_v: p_v.patch no longer applies"));
  EXPECT_THAT(tableOf(verdicts), HasSubstr("not graded"));
}

TEST(Verdicts, TheTableAndTheJsonSayTheSame) {
  const std::vector<Measured> all = {
      measured(Kind::reference, "reference", {score(1, {})}),
      measured(Kind::mistake, "p_m", {score(1, {{"p.shape", 10}})}, "p.shape")};
  const Verdicts verdicts = judge("p", kItems, all);
  const std::string table = tableOf(verdicts);
  EXPECT_THAT(table, AllOf(HasSubstr("p: 2 programs, seeds 1, 2 gradings"), HasSubstr("20%"),
                           HasSubstr("FAILS"), HasSubstr("score 100 or more"),
                           HasSubstr("Wrong ones taken for right: 1 of 1")));
  const nlohmann::json json = toJson(verdicts, all);
  EXPECT_EQ(json.at("programs").at(1).at("item_loss"), 0.2);
  EXPECT_EQ(json.at("programs").at(1).at("scores").at(0).at("score"), 90);
  EXPECT_EQ(json.at("confusion").at("wrong_accepted"), 1);
}

TEST(CrossValidation, ChoosesOnOneHalfAndCountsErrorsOnTheOther) {
  // Two names in each half.
  std::vector<std::string> halves[2];
  for (char c = 'a'; halves[0].size() < 2 || halves[1].size() < 2; ++c) {
    const std::string name = std::string("p_") + c;
    if (auto& half = halves[halfOf(name)]; half.size() < 2) half.push_back(name);
  }
  const auto right = [](const std::string& name, double lost) {
    return measured(Kind::variant, name, {score(1, {{"p.shape", lost}})});
  };
  const auto trial = [&](Setting setting, double first, double second) {
    return Trial{setting,
                 {right(halves[0][0], first), right(halves[0][1], 0), right(halves[1][0], second),
                  right(halves[1][1], 0)}};
  };
  const Setting strict{0.5, 0}, wide{7.5, 2};
  const CrossValidation result = crossValidate(
      "p", kItems, {trial(strict, 0.5, 4), trial(publishedSetting(), 1, 1.5), trial(wide, 5, 0.2)});
  EXPECT_EQ(publishedSetting(), (Setting{3.5, 1}));
  EXPECT_EQ(result.programs[0], 2u);
  EXPECT_EQ(result.programs[1], 2u);
  EXPECT_EQ(result.chosen[0], strict); // no error there, and the widest margin
  EXPECT_EQ(result.errorsOnOther[0], 1u);
  EXPECT_EQ(result.chosen[1], wide);
  EXPECT_EQ(result.errorsOnOther[1], 1u);
  EXPECT_TRUE(result.publishedHolds);
  EXPECT_EQ(toJson(result).at("trials").at(0).at("errors"), nlohmann::json({0, 1}));
  const Section section = sectionOf(result);
  EXPECT_THAT(section.text, HasSubstr("they get 1 of the second half wrong"));
  EXPECT_THAT(section.text, HasSubstr("The published ones get 0 of 4 wrong"));
  EXPECT_EQ(section.rows.size(), 3u);
  EXPECT_EQ(section.rows[1][1], "0 + 0 (published)");
}

TEST(CrossValidation, TriesThePublishedToleranceAmongOthers) {
  const std::vector<Setting> all = settings();
  EXPECT_EQ(all.size(), 18u);
  EXPECT_EQ(std::count(all.begin(), all.end(), publishedSetting()), 1);
}

TEST(CalibrationPage, ShowsEveryProgramAndEscapesWhatPatchesSay) {
  PagePart part;
  part.title = "Part <one>";
  part.measured = {measured(Kind::reference, "reference", {score(1, {})}),
                   measured(Kind::mistake, "p_m", {score(1, {{"p.shape", 10}})}, "p.shape")};
  part.measured[1].program.title = "Uses <b> & co";
  part.verdicts = judge("p", kItems, part.measured);
  EXPECT_THAT(calibrationPage({part}), Not(HasSubstr("Diagnosis")));
  part.sections.push_back({"Diagnosis", "Of 10, 9.", {"a", "b"}, {{"1", "<2>"}}});
  const std::string page = calibrationPage({part});
  EXPECT_THAT(page, AllOf(HasSubstr("1 of 2 gradings were wrong; 1 thing below must hold and does "
                                    "not."),
                          HasSubstr("Part &lt;one&gt;"), HasSubstr("Uses &lt;b&gt; &amp; co"),
                          HasSubstr("<title>p_m, seed 1: 90</title>"), HasSubstr("none fails"),
                          HasSubstr("<h3>Diagnosis</h3>"), HasSubstr("<td>&lt;2&gt;</td>"),
                          Not(HasSubstr("{{"))));
}

TEST(CalibrationPage, ClaimsNothingWhereOnlyTheDiagnosisWasMeasured) {
  PagePart part;
  part.title = "Part one";
  part.sections.push_back({"Diagnosis", "Of 10, 9.", {}, {}});
  part.alone = "the diagnosis";
  EXPECT_THAT(calibrationPage({part}),
              AllOf(HasSubstr("Only the diagnosis was measured this time."),
                    HasSubstr("the diagnosis alone"), HasSubstr("<h3>Diagnosis</h3>"),
                    Not(HasSubstr("gradings was wrong")), Not(HasSubstr("<svg"))));
}

TEST(DiagnosisFigures, SayNothingOfMistakesThatNoRightAnswerCouldBeCombinedWith) {
  DiagnosisFigures figures;
  EXPECT_EQ(figures.rightShare(false), std::nullopt);
  figures.cases = {{"p_m", "", 1, false, "p_m", 1, Answered::right},
                   {"p_m", "", 2, false, "", 0, Answered::unknown},
                   {"p_m", "p_v", 1, true, "", 0, Answered::unknown}};
  EXPECT_EQ(figures.rightShare(false), 0.5);
  EXPECT_EQ(figures.rightShare(true), std::nullopt);
  EXPECT_THAT(sectionOf(figures).text, HasSubstr("elsewhere in none, for none could be made (at"));
  EXPECT_TRUE(toJson(figures).at("right_share_elsewhere").is_null());
  figures.cases.push_back({"p_m", "p_v", 1, false, "", 0, Answered::unknown});
  EXPECT_EQ(figures.rightShare(true), 0);
  EXPECT_THAT(sectionOf(figures).text, HasSubstr("elsewhere in 0.0% (at"));
}

TEST(ScoreFile, KeepsAScoreAndKnowsAHalfWrittenOne) {
  const TemporaryFolder files;
  const fs::path file = files.path() / "score.json";
  Score kept = score(18446744073709551615u, {{"p.shape", 12.3}});
  kept.outcome = results::Outcome::glError;
  kept.detail = "frame 1";
  EXPECT_EQ(loadScore(file), std::nullopt);
  saveScore(file, kept);
  EXPECT_EQ(loadScore(file), kept);
  files.write("score.json", "{\"seed\": 1");
  EXPECT_EQ(loadScore(file), std::nullopt);
}

rubric::RawFrame frame(std::uint32_t width, std::uint32_t height, std::uint8_t value) {
  return {0, width, height, std::vector<std::uint8_t>(std::size_t(width) * height * 4, value)};
}

TEST(Pictures, HaveTheSizesThatAreWantedAndWhatTheirNameSays) {
  const std::vector<std::vector<rubric::RawFrame>> all = {{frame(4, 2, 10), frame(4, 2, 20)},
                                                          {frame(8, 3, 30), frame(8, 3, 40)}};
  for (const PictureKind& kind : pictureKinds()) {
    const auto made = pictures(kind.name, all, {true, false}, 1);
    ASSERT_EQ(made.size(), 2u) << kind.name;
    for (const rubric::RawFrame& one : made) {
      EXPECT_EQ(one.width, 8u);
      EXPECT_EQ(one.pixels.size(), 8u * 3 * 4);
    }
  }
  const auto at = [&](const char* kind, std::size_t scene, std::size_t index) {
    return pictures(kind, all, {true, false}, scene)[index].pixels;
  };
  EXPECT_THAT(at("frozen", 1, 1), Each(30));
  EXPECT_THAT(at("other scene", 0, 1), Each(40));
  EXPECT_THAT(at("public frames", 1, 1), Each(20));
  EXPECT_EQ(at("grey", 0, 0)[2], 128);
  EXPECT_EQ(at("black", 0, 0)[3], 255);
  EXPECT_NE(at("noise", 0, 0), at("noise", 1, 0));
}

/// A disputed submission: the solution with one change and one file more.
class Adopting : public testing::Test {
protected:
  void SetUp() override {
    for (const auto& entry : fs::directory_iterator(GGRADE_SOURCE_DIR "/solutions/floor"))
      if (entry.is_regular_file())
        files_.write("floor/" + entry.path().filename().string(), readFile(entry.path()));
    for (const std::string& name : target_.assignment.files)
      files_.write("ada_lovelace/" + name, readFile(solution_ / name));
    files_.write("ada_lovelace/tile.frag", readFile(solution_ / "tile.frag") + "// mine\n");
    files_.write("ada_lovelace/mine.glsl", "// no line end");
  }
  fs::path adopt(AdoptAs as, const std::string& name, std::vector<results::Item> items = {}) {
    return calibration::adopt(target_, solution_, solution_, files_.path() / "ada_lovelace", as,
                              name, items);
  }

  Target target_ = findTarget(GGRADE_SOURCE_DIR "/assignments", "mirror");
  TemporaryFolder files_;
  fs::path solution_ = files_.path() / "floor";
};

TEST_F(Adopting, AVariantGivesBackTheSubmissionAndNamesNobody) {
  const fs::path patch = adopt(AdoptAs::variant, "");
  EXPECT_EQ(patch, solution_ / "variants/mirror_disputed_1.patch");
  EXPECT_EQ(adopt(AdoptAs::variant, ""), solution_ / "variants/mirror_disputed_2.patch");
  EXPECT_THAT(readFile(patch), Not(HasSubstr("ada")));
  EXPECT_THAT(readFile(patch), Not(HasSubstr(files_.path().string())));
  const auto catalogue =
      grading::loadCatalogue(target_.assignment, target_.parts[0], solution_, solution_);
  ASSERT_EQ(catalogue.variants.size(), 2u);
  grading::writeFiles(target_.assignment, {solution_, {patch}}, files_.path() / "again");
  for (const char* name : {"tile.frag", "mine.glsl", "floor.cpp"})
    EXPECT_EQ(readFile(files_.path() / "again" / name),
              readFile(files_.path() / "ada_lovelace" / name));
}

TEST_F(Adopting, AMistakeNamesTheItemThatLostMost) {
  results::Item texture, shading;
  texture.id = "mirror.texture";
  texture.points = texture.earned = 20;
  shading.id = "mirror.shading";
  shading.points = 20;
  shading.earned = 4;
  adopt(AdoptAs::mistake, "dark", {texture, shading});
  const auto catalogue =
      grading::loadCatalogue(target_.assignment, target_.parts[0], solution_, solution_);
  ASSERT_EQ(catalogue.mistakes.size(), 1u);
  EXPECT_EQ(catalogue.mistakes[0].name, "mirror_dark");
  EXPECT_EQ(catalogue.mistakes[0].fails, "mirror.shading");
  EXPECT_EQ(catalogue.mistakes[0].step, "mirror.5");
}

TEST_F(Adopting, SaysWhatIsWrong) {
  adopt(AdoptAs::variant, "once");
  EXPECT_THAT(messageOf<UsageError>([&] { adopt(AdoptAs::variant, "once"); }),
              HasSubstr("is there already"));
  EXPECT_THAT(messageOf<UsageError>([&] { adopt(AdoptAs::variant, "Ada L."); }),
              HasSubstr("use small letters"));
  fs::remove_all(files_.path() / "ada_lovelace");
  EXPECT_THAT(messageOf<UsageError>([&] { adopt(AdoptAs::variant, ""); }),
              HasSubstr("there is no such folder"));
  for (const std::string& name : target_.assignment.files)
    files_.write("ada_lovelace/" + name, readFile(solution_ / name));
  EXPECT_THAT(messageOf<UsageError>([&] { adopt(AdoptAs::variant, ""); }),
              HasSubstr("is the solution itself"));
}

} // namespace
