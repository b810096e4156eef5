#include "report/class_page.hpp"
#include "report/reports.hpp"
#include "report_class_samples.hpp"
#include "report_samples.hpp"

#include <gmock/gmock.h>

namespace ggrade::report {
namespace {

using samples::count;
using testing::HasSubstr;
using testing::Not;

constexpr const char kRule[] = "10% per day, at most 50%";
constexpr const char kPage[] = "<p>a</p><!--adjustments--><!--/adjustments--><p>b</p>";

ClassRow adjusted() {
  ClassRow row = samples::student("student1", 80);
  row.adjustments = {{"mirror.shading", 20, 40, "drawn with another pivot", "tutor1"}};
  return row;
}

TEST(Adjustments, AreToldInWords) {
  const std::string page = withAdjustments(kPage, adjusted(), kRule);
  EXPECT_THAT(page, HasSubstr("<li>The reflection is lit: the grader gave 20 of 60, your "
                              "instructor gave 40: drawn with another pivot (tutor1)</li>"));
  EXPECT_THAT(page, HasSubstr("<p>Final score: 80 of 100</p>"));
  EXPECT_THAT(page, Not(HasSubstr("late")));
  EXPECT_THAT(page, HasSubstr("<p>a</p><!--adjustments-->\n<section"));
  EXPECT_THAT(page, HasSubstr("</section>\n<!--/adjustments--><p>b</p>"));
}

TEST(Adjustments, LatenessNamesPointsAndRule) {
  ClassRow row = samples::student("student1", 50);
  row.penalty = 10;
  EXPECT_THAT(withAdjustments(kPage, row, kRule),
              HasSubstr("<li>Handed in late: 10 points off (10% per day, at most 50%)</li>"));
  row.penalty = 1;
  EXPECT_THAT(withAdjustments(kPage, row, ""), HasSubstr("<li>Handed in late: 1 point off</li>"));
}

TEST(Adjustments, OfKeptItemsSayWhatIsTakenOff) {
  ClassRow row = adjusted();
  row.adjustments = {{"mirror.keep", -12, -2, "", ""}};
  EXPECT_THAT(withAdjustments(kPage, row, ""),
              HasSubstr("<li>Everything else stays: the grader took off 12 of 30, your instructor "
                        "took off 2</li>"));
}

TEST(Adjustments, OfTheTotalAndOfUnknownItems) {
  ClassRow row = adjusted();
  row.adjustments = {{"", 60, 75.5, "shown in the exercise", "tutor1"},
                     {"mirror.gone", 1, 2, "old", "tutor2"}};
  const std::string page = withAdjustments(kPage, row, "");
  EXPECT_THAT(page, HasSubstr("<li>Total: the grader gave 60 of 100, your instructor gave 75.5: "
                              "shown in the exercise (tutor1)</li>"));
  EXPECT_THAT(page, HasSubstr("<li>mirror.gone: the grader gave 1, your instructor gave 2: old "
                              "(tutor2)</li>"));
}

TEST(Adjustments, OfWhatWasNotGradable) {
  ClassRow row = adjusted();
  row.outcome = results::Outcome::notGradable;
  EXPECT_THAT(withAdjustments(kPage, row, ""),
              HasSubstr("<p>No final score: the submission could not be graded</p>"));
  row.adjustments = {{"", 0, 70, "shown", "tutor1"}};
  row.finalScore = 70;
  const std::string page = withAdjustments(kPage, row, "");
  EXPECT_THAT(page, HasSubstr("Total: the grader gave no score, your instructor gave 70: shown"));
  EXPECT_THAT(page, HasSubstr("<p>Final score: 70 of 100</p>"));
}

TEST(Adjustments, ReplaceWhatStoodThere) {
  const std::string once = withAdjustments(kPage, adjusted(), kRule);
  EXPECT_EQ(withAdjustments(once, adjusted(), kRule), once);
  EXPECT_EQ(withAdjustments(once, samples::student("student1"), kRule), kPage)
      << "nothing to say: nothing stays";
}

TEST(Adjustments, APageWithoutThePlaceStaysAsItIs) {
  EXPECT_EQ(withAdjustments("<p>a</p>", adjusted(), kRule), "<p>a</p>");
  EXPECT_EQ(withAdjustments("<p>a</p><!--adjustments-->", adjusted(), kRule),
            "<p>a</p><!--adjustments-->");
}

TEST(Adjustments, BothPagesOfAResultHaveThePlaceOnceNearTheScore) {
  const Pages pages = resultPages(samples::partial(64, 48), Reveal::names);
  for (const std::string& page : {pages.index, pages.student}) {
    const std::string changed = withAdjustments(page, adjusted(), kRule);
    EXPECT_EQ(count(page, "<!--adjustments--><!--/adjustments-->"), 1u);
    EXPECT_EQ(count(changed, "Final score: 80 of 100"), 1u);
    EXPECT_LT(changed.find("Final score"), changed.find("<h2")) << "in the verdict";
    EXPECT_EQ(withAdjustments(changed, samples::student("student1"), ""), page);
  }
}

TEST(Adjustments, NoStudentsTextIsTakenForThePlace) {
  const std::string evil = "<!--adjustments-->evil<!--/adjustments-->";
  results::Result result = samples::partial(64, 48);
  result.outcome = results::Outcome::buildFailed;
  for (std::string* text :
       {&result.submission, &result.title, &result.part, &result.detail, &result.compilerOutput,
        &result.scenes[0].output, &result.scenes[0].name, &result.items[1].message})
    *text = evil + " error";
  result.unusedFiles = {evil};
  result.diagnoses = {{"", evil, evil, .5, evil, evil, evil, evil, {evil}, evil}};
  const Pages pages = resultPages(result, Reveal::details);
  for (const std::string& page : {pages.index, pages.student}) {
    EXPECT_EQ(count(page, "<!--adjustments-->"), 1u);
    EXPECT_EQ(count(page, "<!--/adjustments-->"), 1u);
    EXPECT_GT(count(page, "&lt;!--adjustments--&gt;evil"), 5u);
  }
}

TEST(Adjustments, HostileTextStaysText) {
  const std::string evil = "<script>\"'&<!--/adjustments-->\u202E\x1B[31m";
  ClassRow row = adjusted();
  row.adjustments = {{evil, 1, 2, evil, evil}};
  row.penalty = 5;
  const std::string page = withAdjustments(kPage, row, evil);
  EXPECT_EQ(count(page, "<!--/adjustments-->"), 1u);
  for (const char* forbidden : {"<script", "\u202E", "\x1B"})
    EXPECT_THAT(page, Not(HasSubstr(forbidden)));
  EXPECT_EQ(withAdjustments(page, row, evil), page);
}

} // namespace
} // namespace ggrade::report
