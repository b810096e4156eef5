#include "report/picture.hpp"
#include "report/reports.hpp"
#include "report/results_json.hpp"
#include "report_samples.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace ggrade::report {
namespace {

using testing::HasSubstr;
using testing::Not;

// What a student reads: the page, and of results.json all but extra_data.
std::string studentText(const results::Result& result, Reveal reveal) {
  nlohmann::json json = nlohmann::json::parse(resultsJson(result, reveal));
  json.erase("extra_data");
  return resultPages(result, reveal).student + json.dump();
}

TEST(Reveal, ParsesItsThreeWords) {
  EXPECT_EQ(parseReveal("none"), Reveal::none);
  EXPECT_EQ(parseReveal("names"), Reveal::names);
  EXPECT_EQ(parseReveal("details"), Reveal::details);
  EXPECT_EQ(parseReveal("all"), std::nullopt);
}

TEST(Reveal, NoneLeavesTitlesAndPoints) {
  const std::string text = studentText(samples::partial(64, 48), Reveal::none);
  for (const char* secret :
       {"hidden-low", "hidden-many", "31.4%", "212", "lit as if they stood above", "Step 5",
        "camera at", "texture unit 1", "8131"})
    EXPECT_THAT(text, Not(HasSubstr(secret))) << secret;
  EXPECT_THAT(text, HasSubstr("The reflection is lit from the right side"));
  EXPECT_THAT(text, HasSubstr("3 / 30"));
  EXPECT_THAT(text, HasSubstr("was also drawn in scenes that are not shown here"));
}

TEST(Reveal, NamesAddsNamesMessagesCauseAndStepButNoPosition) {
  const std::string text = studentText(samples::partial(64, 48), Reveal::names);
  for (const char* shown : {"hidden-low", "31.4%", "lit as if they stood above",
                            "Step 5: turn culling and normals", "densest at (position withheld)"})
    EXPECT_THAT(text, HasSubstr(shown)) << shown;
  for (const char* secret : {"212", "camera at", "texture unit 1", "8131"})
    EXPECT_THAT(text, Not(HasSubstr(secret))) << secret;
}

TEST(Reveal, DetailsAddsPositionsAndEvidenceButNeverOutputOrSeed) {
  const std::string text = studentText(samples::partial(64, 48), Reveal::details);
  EXPECT_THAT(text, HasSubstr("densest at (212, 340)"));
  EXPECT_THAT(text, HasSubstr("texture unit 1"));
  EXPECT_THAT(text, Not(HasSubstr("debug: camera"))) << "printed in a hidden run";
  EXPECT_THAT(text, Not(HasSubstr("8131")));
}

TEST(Reveal, HiddenPicturesNeedDetails) {
  const results::Result result = samples::partial(64, 48);
  for (std::size_t s = 1; s < 3; ++s)
    for (const results::Frame& frame : result.scenes[s].frames)
      for (const Image* image :
           {&frame.student, &frame.reference, &frame.difference, &frame.flipPicture}) {
        const std::string uri = pngDataUri(*image);
        EXPECT_THAT(studentText(result, Reveal::none), Not(HasSubstr(uri)));
        EXPECT_THAT(studentText(result, Reveal::names), Not(HasSubstr(uri)));
        EXPECT_THAT(studentText(result, Reveal::details), HasSubstr(uri));
      }
  for (const results::Frame& frame : result.scenes[0].frames)
    EXPECT_THAT(studentText(result, Reveal::none), HasSubstr(pngDataUri(frame.student)));
}

TEST(Reveal, HiddenSceneWithThePublicOnesNameGetsNoPicture) {
  results::Result result = samples::partial(64, 48);
  std::swap(result.scenes[0], result.scenes[1]);
  result.scenes[0].name = "public";
  EXPECT_THAT(studentText(result, Reveal::names),
              Not(HasSubstr(pngDataUri(result.scenes[0].frames[0].student))));
}

TEST(Reveal, PublicOutputIsTheStudents) {
  EXPECT_THAT(studentText(samples::partial(64, 48), Reveal::none), HasSubstr("glossiness 0.0"));
}

TEST(Reveal, PositionsOfThePublicSceneStay) {
  results::Result result = samples::partial(64, 48);
  results::Item& item = result.items[1];
  item.credits = {{"public", 0.1, true}, {"hidden-low", 1}, {"hidden-many", 1}};
  EXPECT_THAT(studentText(result, Reveal::names), HasSubstr("densest at (212, 340)"));
}

TEST(Reveal, AMessageAboutThePublicSceneKeepsItsPositionsWhateverHappensElsewhere) {
  results::Result result = samples::partial(64, 48);
  results::Item& item = result.items[1];
  item.message = "public: densest at (212, 340)";
  item.credits = {{"public", 0.1, true}, {"hidden-low", 0.5}};
  EXPECT_THAT(studentText(result, Reveal::names), HasSubstr("densest at (212, 340)"));
  item.message = "hidden-low: densest at (212, 340)";
  EXPECT_THAT(studentText(result, Reveal::names), Not(HasSubstr("212")));
  item.message = "public: densest at (212, 340)";
  item.credits = {{"public", 1, true}, {"hidden-low", 0.5}};
  EXPECT_THAT(studentText(result, Reveal::names), Not(HasSubstr("212")));
}

TEST(Reveal, DiagnosisHasNoPositionOfAHiddenSceneAndNeverItsName) {
  results::Result result = samples::partial(64, 48);
  results::Diagnosis diagnosis;
  diagnosis.part = "mirror";
  diagnosis.text = "Your reflection matches what happens when the light is not mirrored.";
  diagnosis.step = "Step 4: draw the mirrored scene";
  diagnosis.confidence = 0.97;
  diagnosis.picture = "the texture that objects are drawn into";
  diagnosis.amount = "31% of it differs";
  diagnosis.scene = "hidden-low";
  diagnosis.place = "around (777, 333) of 1024x1024";
  diagnosis.beside = {"floor.cpp:280:5: warning: multi-line comment"};
  diagnosis.id = "mirror_light_not_mirrored";
  result.diagnoses = {diagnosis};
  for (const Reveal reveal : {Reveal::none, Reveal::names, Reveal::details})
    EXPECT_THAT(studentText(result, reveal), Not(HasSubstr("mirror_light_not_mirrored")));
  EXPECT_THAT(studentText(result, Reveal::none), Not(HasSubstr("when the light is not mirrored")));
  const std::string names = studentText(result, Reveal::names);
  for (const char* shown : {"when the light is not mirrored", "97%", "Step 4: draw the mirrored",
                            "31% of it differs", "hidden-low", "multi-line comment"})
    EXPECT_THAT(names, HasSubstr(shown)) << shown;
  EXPECT_THAT(names, Not(HasSubstr("(777")));
  EXPECT_THAT(studentText(result, Reveal::details), HasSubstr("around (777, 333) of 1024x1024"));
  EXPECT_THAT(resultPages(result, Reveal::none).index, HasSubstr("mirror_light_not_mirrored"));
  result.diagnoses[0].scene = "public";
  EXPECT_THAT(studentText(result, Reveal::names), HasSubstr("around (777, 333) of 1024x1024"));
  result.diagnoses[0].scene.clear(); // an outcome, which everybody may know
  EXPECT_THAT(studentText(result, Reveal::none), HasSubstr("when the light is not mirrored"));
}

TEST(Reveal, EvidenceOfAHiddenCrashMayQuoteTheProgram) {
  results::Result result = samples::crashed();
  result.detail = "hidden-low: what(): camera at 1.25";
  result.scenes[0].outcome = "graded";
  result.scenes.push_back({"hidden-low", false, "crash", "what(): camera at 1.25", {}, {}, "", 1});
  EXPECT_THAT(studentText(result, Reveal::names), Not(HasSubstr("1.25")));
  EXPECT_THAT(studentText(result, Reveal::names), HasSubstr("This happened in a hidden scene."));
  EXPECT_THAT(resultPages(result, Reveal::names).index, HasSubstr("camera at 1.25"));
  result.scenes[0].outcome = "crash"; // the public scene crashed too, with other evidence
  EXPECT_THAT(studentText(result, Reveal::names), Not(HasSubstr("1.25")));
}

TEST(Reveal, EvidenceOfAPublicCrashIsShown) {
  EXPECT_THAT(studentText(samples::crashed(), Reveal::none), HasSubstr("Signal 11 (SIGSEGV)"));
}

TEST(WithholdPositions, TakesOutTuplesAndNothingElse) {
  EXPECT_EQ(withholdPositions("at (212, 340), [1.5,-2e3] and (x=3, y=4)"),
            "at (position withheld), (position withheld) and (position withheld)");
  EXPECT_EQ(withholdPositions("31% (of 640 pixels), glUniform1f(light, 2) (3) ("),
            "31% (of 640 pixels), glUniform1f(light, 2) (3) (");
}

} // namespace
} // namespace ggrade::report
