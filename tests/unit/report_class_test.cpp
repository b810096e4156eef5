#include "report/class_page.hpp"
#include "report_class_samples.hpp"
#include "report_samples.hpp"

#include <gmock/gmock.h>
#include <limits>

namespace ggrade::report {
namespace {

using samples::count;
using testing::HasSubstr;
using testing::Not;

ClassPage pageOf(std::vector<ClassRow> rows) {
  ClassPage page;
  page.title = "Mirror";
  page.rows = std::move(rows);
  return page;
}

// The page from one heading to the next section.
std::string section(const std::string& page, const std::string& id) {
  const auto from = page.find("<section id=\"" + id + "\"");
  if (from == std::string::npos) return "";
  return page.substr(from, page.find("</section>", from) - from);
}

// Without the style and the script.
std::string body(const std::string& page) {
  const auto from = page.find("<body");
  return page.substr(from, page.find("<script>") - from);
}

TEST(ClassPage, NeedsNothingFromOutsideAndStaysSmall) {
  ClassPage data = samples::wholeClass(200);
  std::string page = classPage(data);
  EXPECT_LT(page.size(), 400'000u);
  EXPECT_EQ(count(page, "<img"), 0u);
  samples::addThumbnails(data);
  page = classPage(data);
  EXPECT_THAT(page, HasSubstr("default-src 'none'; img-src data:"));
  for (const char* outside : {"http:", "https:", "src=\"/", "url(", "@import", "<iframe", "module"})
    EXPECT_THAT(page, Not(HasSubstr(outside))) << outside;
  EXPECT_GT(count(page, "<img"), 100u);
  EXPECT_EQ(count(page, "<img src=\"data:image/png;base64,iVBOR"), count(page, "<img"));
  EXPECT_EQ(count(page, "loading=\"lazy\""), count(page, "<img"));
  EXPECT_EQ(count(page, "alt=\"What "), count(page, "<img"));
}

TEST(ClassPage, HasARowWithScoreReasonAndBothLinks) {
  ClassRow row = samples::student("学生1", 61.5);
  row.student = "1234", row.folder = "a b";
  row.reason = "Look at glFrontFace.";
  row.submitted = "2026-11-20T23:59+09:00";
  row.remarks = {"3 attempts: attempt 3 counts"};
  const std::string table = section(classPage(pageOf({row})), "students");
  EXPECT_THAT(table, HasSubstr("<a href=\"a%20b/index.html\"><bdi class=\"key\">学生1</bdi></a>"));
  EXPECT_THAT(table, HasSubstr("<span class=\"student\">1234</span>"));
  EXPECT_THAT(table, HasSubstr("href=\"a%20b/student.html\" aria-label=\"Student's page of"));
  EXPECT_THAT(table,
              HasSubstr("<tr id=\"row-1\" class=\"part\" data-outcome=\"graded\" data-bin=\"6\">"));
  EXPECT_THAT(table, HasSubstr("data-value=\"61.5\"><span class=\"points\"><b>61.5</b>"));
  EXPECT_THAT(table, HasSubstr("1 of 3 items lost points."));
  EXPECT_THAT(table, HasSubstr("Look at glFrontFace."));
  EXPECT_THAT(table, HasSubstr("<span>2026-11-20</span> <span>23:59+09:00</span>"));
  EXPECT_THAT(table, HasSubstr("<li>3 attempts: attempt 3 counts</li>"));
  EXPECT_THAT(table, HasSubstr("<td class=\"seconds number\" data-value=\"2.5\">2.5</td>"));
  EXPECT_THAT(table, HasSubstr("<option value=\"graded\">graded (1)</option>"));
}

TEST(ClassPage, TheKeyIsNotRepeatedWhereItIsTheName) {
  EXPECT_THAT(classPage(pageOf({samples::student("student1")})),
              Not(HasSubstr("class=\"student\"")));
}

TEST(ClassPage, ColumnsStandOnlyWhereAStudentHasThem) {
  const std::string plain = classPage(pageOf({samples::student("student1")}));
  for (const char* column : {">Picture<", ">Adjustments<", ">Late<", ">Final<", ">Submitted<"})
    EXPECT_THAT(plain, Not(HasSubstr(column))) << column;
  ClassRow late = samples::student("student1", 50), changed = samples::student("student2", 80);
  late.penalty = 10;
  changed.adjustments = {{"mirror.shading", 20, 40, "another pivot", "tutor1"},
                         {"", 80, 70, "", ""}};
  const std::string page = classPage(pageOf({late, changed}));
  EXPECT_THAT(page, HasSubstr("data-value=\"10\">−10</td>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"final number\" data-value=\"50\"><b>50</b></td>"));
  EXPECT_THAT(page,
              HasSubstr("<td class=\"adjustments\" data-value=\"10\"><ul><li>The reflection is "
                        "lit: 40 instead of 20: another pivot (tutor1)</li><li>Total: 70 "));
}

TEST(ClassPage, SaysTheFiguresAndWhoIsLeftOut) {
  ClassRow ours = samples::student("student4");
  ours.outcome = results::Outcome::notGradable;
  const std::string page =
      classPage(pageOf({samples::student("student1", 20), samples::student("student2", 60),
                        samples::student("student3", 70), ours}));
  EXPECT_THAT(page,
              HasSubstr("Final scores of 3 students, out of 100: mean 50, median 60, quartiles 40 "
                        "and 65. 1 submission is not gradable and has no score: left out of these "
                        "figures."));
  EXPECT_THAT(page, HasSubstr("3 lost points</li>"));
  EXPECT_THAT(page, HasSubstr("1 not gradable</li>"));
  EXPECT_THAT(page,
              HasSubstr("<tr id=\"row-4\" class=\"unjudged\" data-outcome=\"not_gradable\">"));
  EXPECT_THAT(page, HasSubstr("<td class=\"score number\">no score</td>"));
}

TEST(ClassPage, TheHistogramSaysInWordsWhatItDraws) {
  const std::string page =
      section(classPage(pageOf({samples::student("student1", 5), samples::student("student2", 9),
                                samples::student("student3", 100)})),
              "scores");
  EXPECT_THAT(page, HasSubstr("role=\"img\" aria-label=\"How many students have which final "
                              "score: 2 from 0 to 10, 1 from 90 to 100.\""));
  EXPECT_EQ(count(page, "<rect"), 2u);
  EXPECT_EQ(count(page, "data-bin="), 10u);
  EXPECT_THAT(page, HasSubstr("<tr><th scope=\"row\">90 to 100</th><td class=\"figure\">1</td>"));
}

TEST(ClassPage, ABonusMayGoAboveTheHistogramsEnd) {
  const std::string page =
      section(classPage(pageOf({samples::student("student1", 105)})), "scores");
  EXPECT_EQ(count(page, "data-bin="), 11u);
  EXPECT_THAT(page, HasSubstr("1 from above 100."));
  EXPECT_THAT(page, HasSubstr("&gt;100</text>"));
}

TEST(ClassPage, DropsStandBeforeRises) {
  ClassPage page = pageOf({samples::student("student1")});
  page.changes = {{"student2", "student2", 40, 60.5},
                  {"student1", "student1", 60, 40},
                  {"student3", "", 50, std::numeric_limits<double>::quiet_NaN()}};
  page.remarks = {"__MACOSX: passed over"};
  const std::string html = classPage(page), changes = section(html, "changes");
  EXPECT_LT(changes.find("2 scores dropped"), changes.find("1 score rose"));
  EXPECT_LT(changes.find("student1/index.html"), changes.find("student2/index.html"));
  EXPECT_THAT(changes, HasSubstr("<b>−20</b>"));
  EXPECT_THAT(changes, HasSubstr("<b>+20.5</b>"));
  EXPECT_THAT(changes, HasSubstr("<td class=\"figure\">50</td><td class=\"figure\">no score</td>"));
  EXPECT_EQ(count(changes, "<details class=\"quiet\" open>"), 2u);
  EXPECT_THAT(section(html, "remarks"), HasSubstr("<li>__MACOSX: passed over</li>"));
}

TEST(ClassPage, ManyRisesAreFoldedAwayDropsNever) {
  ClassPage page = pageOf({samples::student("student1")});
  for (int i = 0; i < 40; ++i)
    page.changes.push_back({"student1", "student1", 50, i % 2 ? 60.0 : 40.0});
  const std::string changes = section(classPage(page), "changes");
  EXPECT_THAT(changes, HasSubstr("<details class=\"quiet\" open>\n<summary>20 scores dropped"));
  EXPECT_THAT(changes, HasSubstr("<details class=\"quiet\">\n<summary>20 scores rose"));
}

TEST(ClassPage, BeginsWithWhoNeedsAPersonAndWhy) {
  ClassRow ours = samples::student("student1"), alike = samples::student("ada");
  ours.outcome = results::Outcome::notGradable;
  ours.reason = "the sandbox could not start";
  alike.lookAlikes = {"\"ada\\u{200B}\""};
  alike.quoted = "\"␣ada\"";
  ClassRow given = samples::student("student3", 160);
  given.adjustments = {{"mirror.keep", 0, 50, "kept", "kim",
                        "50 points are more than the 0 that "
                        "mirror.keep can give"}};
  const std::string page =
      body(classPage(pageOf({ours, samples::student("student2"), alike, given})));
  const std::string first = page.substr(0, page.find("<main>"));
  EXPECT_THAT(first, HasSubstr("<h2>3 of 4 students need a person</h2>"));
  EXPECT_THAT(first,
              HasSubstr("<li><a href=\"#row-1\"><bdi>student1</bdi></a><div><p>Not gradable, "
                        "our fault: the sandbox could not start</p></div></li>"));
  EXPECT_THAT(
      first,
      HasSubstr("<a href=\"#row-3\"><bdi>&quot;␣ada&quot;</bdi></a><div><p>Looks like "
                "&quot;ada\\u{200B}&quot;: which one counts? No gradebook has a grade of theirs."));
  EXPECT_THAT(first, HasSubstr("<a href=\"#row-4\"><bdi>student3</bdi></a><div><p>Is this override "
                               "meant? 50 points are more than the 0 that mirror.keep can give "
                               "(kim); they count.</p>"));
  EXPECT_THAT(first, Not(HasSubstr("#row-2")));
  EXPECT_THAT(first, HasSubstr("look alike leave one, remove the folders of all of them here"));
  const std::string table = section(page, "students");
  EXPECT_THAT(table, HasSubstr("<tr id=\"row-3\""));
  EXPECT_THAT(table, HasSubstr("<span class=\"chip none\">looks like another</span><span "
                               "class=\"student\">found as &quot;␣ada&quot;</span>"));
  EXPECT_EQ(count(table, "class=\"chip none\">looks like"), 1u);
  EXPECT_THAT(table, HasSubstr("<span class=\"beyond\">50 points are more than the 0 that "
                               "mirror.keep can give</span>"));
  EXPECT_THAT(body(classPage(pageOf({samples::student("student1")}))),
              HasSubstr("<h2>Nobody needs a person</h2>"));
}

TEST(ClassPage, ATotalThatAPersonGaveNeedsNoOtherPerson) {
  ClassRow ours = samples::student("student1", 50);
  ours.outcome = results::Outcome::notGradable;
  ours.adjustments = {{"", 0, 50, "shown in the exercise", "kim"}};
  EXPECT_THAT(classPage(pageOf({ours})), HasSubstr("Nobody needs a person"));
}

TEST(ClassPage, SaysWhatWasRefused) {
  ClassPage page = pageOf({samples::student("student1")});
  page.refused = {"link: a symbolic link is not followed"};
  page.rows[0].refused = {"../x.cpp: leads out of its folder"};
  const std::string html = classPage(page);
  EXPECT_THAT(html, HasSubstr("<h2>2 files or uploads refused</h2>"));
  EXPECT_THAT(html, HasSubstr("<details open><summary>which, and why</summary><ul><li>link: a "
                              "symbolic link is not followed</li><li>student1: ../x.cpp: leads out "
                              "of its folder</li></ul>"));
  page.refused.assign(13, "link: a symbolic link is not followed");
  EXPECT_THAT(classPage(page), HasSubstr("<details><summary>which, and why"));
  EXPECT_THAT(classPage(pageOf({samples::student("student1")})),
              HasSubstr("<h2>Nothing was refused</h2>"));
}

TEST(ClassPage, SaysWhichSandboxOrThatThereWasNone) {
  ClassPage page = pageOf({samples::student("student1"), samples::student("student2")});
  page.protections = {{"sandbox", "bubblewrap 0.8.0"}, {"self-test", "15 escapes refused"}};
  const std::string html = body(classPage(page));
  EXPECT_THAT(html, HasSubstr("<h2>Programs ran in a sandbox: bubblewrap 0.8.0</h2>"));
  EXPECT_THAT(html, HasSubstr("<dt>self-test</dt><dd class=\"number\">15 escapes refused</dd>"));
  EXPECT_THAT(html, HasSubstr("limits; no self-test in this run</summary>"));
  EXPECT_THAT(html, Not(HasSubstr("No sandbox")));
  page.selfTested = true;
  EXPECT_THAT(body(classPage(page)), HasSubstr("limits; self-test passed</summary>"));
  page.unprotected = 1;
  EXPECT_THAT(body(classPage(page)),
              HasSubstr("<div class=\"card danger\">\n    <h2>No sandbox: the programs of 1 of 2 "
                        "students ran as the user who graded"));
  page.unprotected = 2;
  page.protections.clear();
  const std::string without = body(classPage(page));
  EXPECT_THAT(without,
              HasSubstr("<h2>No sandbox: every program ran as the user who graded, with "));
  EXPECT_THAT(without, Not(HasSubstr("in a sandbox")));
}

TEST(ClassPage, WithoutChangesOrRemarksThereAreNoSuchSections) {
  const std::string page = classPage(pageOf({samples::student("student1")}));
  for (const char* absent :
       {"Since the last run", "Remarks on this run", "How this was graded", "Most common mistakes"})
    EXPECT_THAT(page, Not(HasSubstr(absent))) << absent;
}

TEST(ClassPage, MistakesAreGroupedWithTheirStudentsAndUnknownOnesCounted) {
  ClassRow first = samples::student("student1"), second = samples::student("student2"),
           third = samples::student("student3");
  first.diagnoses = second.diagnoses = {{"mirror_cull", "Look at glFrontFace."}};
  third.diagnoses = {{"", "whatever"}};
  const std::string html = classPage(pageOf({first, second, third}));
  const std::string mistakes = section(html, "mistakes");
  EXPECT_THAT(mistakes, HasSubstr("Look at glFrontFace. <span class=\"soft small\">mirror_cull"));
  EXPECT_THAT(mistakes, HasSubstr("2 students <span class=\"soft\">(66.7%)</span>"));
  EXPECT_THAT(mistakes, HasSubstr("<li><a href=\"student2/index.html\"><bdi>student2</bdi></a>"));
  EXPECT_THAT(mistakes, HasSubstr("Unknown: no known mistake explains what is wrong."));
  EXPECT_THAT(mistakes, HasSubstr("1 student <span class=\"soft\">(33.3%)</span>"));
  EXPECT_THAT(section(html, "outcomes"), HasSubstr("3 students <span class=\"soft\">(100%)"));
}

TEST(ClassPage, ItemsHardestFirstBonusApart) {
  ClassRow row = samples::student("student1");
  row.items[2].earned = -15;
  const std::string items = section(classPage(pageOf({row})), "items");
  const auto shading = items.find("mirror.shading"), keep = items.find("mirror.keep"),
             where = items.find("mirror.where"), bonus = items.find("Mean share of bonus");
  EXPECT_LT(shading, keep);
  EXPECT_LT(keep, where);
  EXPECT_LT(where, bonus);
  EXPECT_LT(bonus, items.find("mirror.blur"));
  EXPECT_THAT(items, HasSubstr("50% kept<span class=\"bar tint\""));
  EXPECT_THAT(items, HasSubstr("<td class=\"figure\">1 of 1</td>"));
}

TEST(ClassPage, ManyRemarksOnOneUploadAreCut) {
  ClassRow row = samples::student("student1");
  row.remarks.assign(2000, "refused.exe: not a file of this assignment");
  const std::string page = classPage(pageOf({row}));
  EXPECT_EQ(count(page, "refused.exe"), 5u);
  EXPECT_THAT(page, HasSubstr("<li>and 1995 more</li>"));
}

TEST(ClassPage, AnEmptyClassIsStillAPage) {
  const std::string page = classPage(ClassPage());
  EXPECT_THAT(page, HasSubstr("There are no submissions."));
  EXPECT_THAT(page, Not(HasSubstr("<table")));
  EXPECT_THAT(body(page), Not(HasSubstr("?"))) << "no figure of nothing";
}

TEST(ClassPage, AllNotGradableHasNoFiguresOfNothing) {
  ClassRow row = samples::student("student1");
  row.outcome = results::Outcome::notGradable;
  const std::string page = classPage(pageOf({row, row}));
  EXPECT_THAT(page, HasSubstr("2 submissions are not gradable and have no score"));
  EXPECT_THAT(page, Not(HasSubstr("mean ")));
  EXPECT_EQ(section(page, "scores"), "");
}

TEST(ClassPage, WhatIsNoNumberIsNeverShownAsOne) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  ClassRow row = samples::student("student1", kNaN);
  row.bonus = row.penalty = row.seconds = row.maxScore = kNaN;
  for (ClassItem& item : row.items) item.earned = item.points = kNaN;
  row.adjustments = {{"mirror.where", kNaN, kNaN, "r", "w"}};
  const std::string page = classPage(pageOf({row, samples::student("student2")}));
  for (const char* bad : {"nan", "NaN%", "width:?", "data-value=\"?\""})
    EXPECT_THAT(body(page), Not(HasSubstr(bad))) << bad;
  EXPECT_THAT(page, HasSubstr("Final scores of 1 student, out of 100: mean 60"));
}

TEST(ClassPage, HostileTextStaysText) {
  const std::string evil = "<script>alert('x')</script>\"'&amp; \x1B[31mred \xE2\x80\xAE"
                           "gnp.exe \xFF {{title}} =HYPERLINK(\"a\") <!--adjustments-->";
  std::string longName;
  while (longName.size() < 10'000) longName += evil;
  ClassPage page = samples::wholeClass(12);
  for (ClassRow& row : page.rows) {
    for (std::string* text : {&row.name, &row.student, &row.headline, &row.reason, &row.submitted})
      *text = longName;
    row.remarks = {longName};
    row.adjustments = {{longName, 1, 2, longName, longName}};
    row.diagnoses = {{longName, longName}};
    for (ClassItem& item : row.items) item.id = item.title = longName;
  }
  page.rows[0].folder = "javascript:alert(1)//";
  page.changes = {{longName, longName, 1, 2}};
  page.title = page.intro = longName;
  page.remarks = {longName};
  page.facts = {{longName, longName}};
  const std::string html = classPage(page);
  EXPECT_EQ(count(html, "<script"), 1u);
  for (const char* forbidden : {"\x1B", "\u202E", "\xFF", "javascript:", "<!--"})
    EXPECT_THAT(html, Not(HasSubstr(forbidden))) << forbidden;
  EXPECT_THAT(html, HasSubstr("{{title}}")) << "text is no template";
  EXPECT_THAT(html, HasSubstr("=HYPERLINK"));
  EXPECT_LT(section(html, "students").size(), 12 * 12'000u) << "long texts are cut";
}

} // namespace
} // namespace ggrade::report
