// The class page in a real browser, opened from file:// without a network.
#include "../unit/report_class_samples.hpp"
#include "browser.hpp"
#include "report/class_page.hpp"

#include <gmock/gmock.h>

#include <sstream>

namespace ggrade::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// What the scripts of these tests are written with.
constexpr const char kHelpers[] = R"js(
  const say = document.documentElement.dataset, section = document.getElementById("students");
  const rows = () => [...section.querySelectorAll("tbody tr")].filter((row) => !row.hidden);
  const names = () => rows().map((row) => row.querySelector("bdi").textContent).join();
  const heading = (word) => [...section.querySelectorAll("thead th")].find((th) => th.textContent.startsWith(word));
  const sort = (word) => heading(word).querySelector("button").click();
  const sorted = () => [...section.querySelectorAll("[aria-sort]")].map((th) => `${th.textContent} ${th.ariaSort}`).join();
  const status = () => section.querySelector("[role=status]").textContent;
  const { find, outcome } = section.querySelector("form").elements;
  const type = (text) => { find.value = text; find.dispatchEvent(new Event("input")); };
  const choose = (value) => { outcome.value = value; outcome.dispatchEvent(new Event("change")); };
  const bin = (i) => document.querySelector(`.bins [data-bin="${i}"]`);
  const clear = section.querySelector("form button");
)js";

// The smallest contrast (WCAG 2, against the nearest opaque background) of all text that can be
// seen.
constexpr const char kContrast[] = R"js(
  const context = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  const rgba = (colour) => {
    context.clearRect(0, 0, 1, 1);
    context.fillStyle = colour;
    context.fillRect(0, 0, 1, 1);
    return [...context.getImageData(0, 0, 1, 1).data];
  };
  const luminance = ([r, g, b]) => [r, g, b].map((v) => v / 255)
    .map((v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const background = (element) => {
    for (; element; element = element.parentElement) {
      const colour = rgba(getComputedStyle(element).backgroundColor);
      if (colour[3] === 255) return colour;
    }
    return [255, 255, 255];
  };
  let worst = 99, where = "", count = 0;
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement, style = getComputedStyle(element);
    if (!walker.currentNode.data.trim() || element.closest("script, .hidden-text, [hidden]") || !element.checkVisibility()) continue;
    const [a, b] = [rgba(element.closest("svg") ? style.fill : style.color), background(element)].map(luminance);
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    ++count;
    if (contrast < worst) [worst, where] = [contrast, `${element.className} ${walker.currentNode.data.trim()}`];
  }
  say.contrast = worst.toFixed(2) + " " + where;
  say.enough = worst >= 4.5 && count > 300;
)js";

class ClassInBrowser : public Browser {
protected:
  // What the script said is in the first tag; the rest of the page is left out.
  Visit drive(const ClassPage& page, const std::string& script,
              const std::string& flags = "--window-size=1280,900") {
    Visit seen =
        visit(driven(classPage(page), "{" + (kHelpers + script) + "say.done = true; }"), flags);
    seen.dom.resize(std::min(seen.dom.size(), seen.dom.find("<head>")));
    EXPECT_EQ(seen.console, "");
    EXPECT_THAT(seen.dom, HasSubstr("data-done=\"true\"")) << "the test's script came to its end";
    return seen;
  }

  static ClassPage five() {
    ClassPage page;
    page.title = "Mirror";
    for (const auto& [name, score] : {std::pair("Émile", 100.0), std::pair("student10", 60.0),
                                      std::pair("student2", 7.5), std::pair("Zoë", 60.0)})
      page.rows.push_back(samples::student(name, score));
    page.rows[2].outcome = results::Outcome::crash;
    page.rows[2].reason = "Signal 11 (SIGSEGV) in the first frame.";
    page.rows.push_back(samples::student("学生1"));
    page.rows[4].outcome = results::Outcome::notGradable;
    return page;
  }
};

TEST_F(ClassInBrowser, EveryClassRunsItsScriptWithoutAWordOnTheConsole) {
  ClassPage pictures = samples::wholeClass(60), hostile = five();
  samples::addThumbnails(pictures);
  hostile.rows[0].name = hostile.rows[0].reason =
      "<img src=x onerror=\"document.title=1\"><script>document.title=1</script>";
  for (const ClassPage& page : {pictures, hostile, ClassPage()}) {
    const Visit seen = visit(classPage(page));
    EXPECT_THAT(seen.dom, HasSubstr("data-ready=\"true\""));
    EXPECT_THAT(seen.dom, Not(HasSubstr("<title>1</title>")));
    EXPECT_EQ(seen.console, "");
  }
}

TEST_F(ClassInBrowser, SortsNumbersAsNumbersAndWhatIsMissingLast) {
  ClassPage page = five();
  page.rows[0].score = 7.25; // more than 7.5 to whoever compares text
  const Visit seen = drive(page, R"js(
    say.given = names();
    sort("Score"); say.up = `${names()} ${sorted()}`;
    sort("Score"); say.down = `${names()} ${sorted()}`;
  )js");
  EXPECT_THAT(seen.dom, HasSubstr("data-given=\"Émile,student10,student2,Zoë,学生1\""));
  EXPECT_THAT(seen.dom,
              HasSubstr("data-up=\"Émile,student2,student10,Zoë,学生1 Score ascending\""));
  EXPECT_THAT(seen.dom,
              HasSubstr("data-down=\"student10,Zoë,student2,Émile,学生1 Score descending\""))
      << "equal scores keep their order";
}

TEST_F(ClassInBrowser, SortsNamesAsPeopleDoAndKeepsTheOrderOfEqualRows) {
  const Visit seen = drive(five(), R"js(
    sort("Student"); say.name = `${names()} ${sorted()}`;
    sort("Student"); sort("Outcome"); say.outcome = `${names()} ${sorted()}`;
  )js");
  EXPECT_THAT(seen.dom,
              HasSubstr("data-name=\"Émile,student2,student10,Zoë,学生1 Student ascending\""));
  EXPECT_THAT(seen.dom,
              HasSubstr("data-outcome=\"student2,Zoë,student10,Émile,学生1 Outcome ascending\""));
}

TEST_F(ClassInBrowser, SortsTimesAcrossZones) {
  ClassPage page = five();
  page.rows[0].submitted = "2026-11-20T09:00+09:00"; // midnight
  page.rows[1].submitted = "2026-11-20T01:00Z";
  page.rows[2].submitted = "2026-11-19T23:00Z";
  page.rows[3].submitted = "yesterday";
  const Visit seen = drive(page, "sort('Submitted'); say.order = names();");
  EXPECT_THAT(seen.dom, HasSubstr("data-order=\"student2,Émile,student10,Zoë,学生1\""));
}

TEST_F(ClassInBrowser, FiltersByTextAndOutcomeAndSaysHowManyAreLeft) {
  const Visit seen = drive(five(), R"js(
    say.all = `${status()} ${clear.hidden}`;
    type(" ＳＴＵＤＥＮＴ "); say.text = `${names()} ${status()} ${clear.hidden}`;
    choose("graded"); say.both = `${names()} ${status()}`;
    type("sigsegv"); say.none = `${names()} ${status()}`;
    choose(""); say.reason = names();
    sort("Score"); say.stays = names();
    clear.click(); say.cleared = `${status()} ${find.value} ${document.activeElement.name}`;
  )js");
  EXPECT_THAT(seen.dom, HasSubstr("data-all=\"5 students true\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-text=\"student10,student2 2 of 5 students shown false\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-both=\"student10 1 of 5 students shown\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-none=\" 0 of 5 students shown\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-reason=\"student2\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-stays=\"student2\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-cleared=\"5 students  find\""));
}

TEST_F(ClassInBrowser, ABarOfTheHistogramShowsItsStudents) {
  const Visit seen = drive(five(), R"js(
    const chip = section.querySelector(".chosen-bin");
    bin(6).click();
    say.six = `${names()} ${status()} ${bin(6).ariaCurrent} ${chip.textContent} ${location.hash}`;
    bin(9).click(); say.nine = `${names()} ${bin(6).ariaCurrent}`;
    bin(9).click(); say.again = `${status()} ${chip.hidden}`;
    say.drawn = document.querySelectorAll(".histogram rect").length;
  )js");
  EXPECT_THAT(seen.dom, HasSubstr("data-six=\"student10,Zoë 2 of 5 students shown true final score "
                                  "60 to 70 #students\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-nine=\"Émile false\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-again=\"5 students true\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-drawn=\"3\""));
}

TEST_F(ClassInBrowser, ThePointerOnABarMeetsItsLink) {
  const Visit seen = drive(five(), R"js(
    const bars = [...document.querySelectorAll(".histogram rect")];
    say.met = bars.map((bar) => {
      bar.scrollIntoView({ block: "center" });
      const box = bar.getBoundingClientRect();
      return document.elementFromPoint((box.left + box.right) / 2, box.bottom - 3).dataset.bin;
    });
  )js");
  EXPECT_THAT(seen.dom, HasSubstr("data-met=\"0,6,9\""));
}

TEST_F(ClassInBrowser, EverythingIsReachedByKeyboardAndHasAName) {
  const Visit seen = drive(samples::wholeClass(40), R"js(
    const used = [...document.querySelectorAll("[data-sort] > *, .bins a, .controls input, .controls select, .skip, summary")];
    say.native = used.every((e) => ["BUTTON", "A", "INPUT", "SELECT", "SUMMARY"].includes(e.tagName) && e.tabIndex === 0);
    const visible = used.filter((e) => e.checkVisibility());
    say.focus = visible.every((e) => { e.focus(); return document.activeElement === e && e.matches(":focus-visible")
      && getComputedStyle(e).outlineStyle === "solid"; }) && visible.length > 30;
    say.headings = document.querySelectorAll("h1").length;
    say.landmarks = ["body > header", "nav[aria-label]", "main", "body > footer", "form[role=search]"]
      .map((s) => document.querySelectorAll(s).length);
    say.captions = [...document.querySelectorAll("table")].every((t) => t.caption?.textContent.trim());
    say.scopes = [...document.querySelectorAll("th")].every((th) => th.scope);
    say.named = [...document.querySelectorAll("a, button:not([hidden])")].every((e) => (e.ariaLabel ?? e.textContent).trim());
    const ids = [...document.querySelectorAll("[id]")].map((e) => e.id);
    say.unique = new Set(ids).size === ids.length;
    say.targets = [...document.querySelectorAll("a[href^='#']")].every((a) => document.querySelector(a.getAttribute("href")));
    say.labels = [...document.querySelectorAll("[aria-labelledby]")].every((e) => document.getElementById(e.getAttribute("aria-labelledby")));
  )js");
  EXPECT_THAT(seen.dom, HasSubstr("data-native=\"true\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-focus=\"true\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-headings=\"1\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-landmarks=\"1,1,1,1,1\""));
  for (const char* good : {"captions", "scopes", "named", "unique", "targets", "labels"})
    EXPECT_THAT(seen.dom, HasSubstr("data-" + std::string(good) + "=\"true\""));
}

TEST_F(ClassInBrowser, TextCanBeReadInBothThemes) {
  ClassPage page = samples::wholeClass(60);
  const std::string script = std::string("bin(9).click();") + kContrast;
  for (const char* theme : {"0", "1"}) {
    const Visit seen =
        drive(page, script,
              std::string("--window-size=1280,900 --blink-settings=preferredColorScheme=") + theme);
    EXPECT_THAT(seen.dom, HasSubstr("data-enough=\"true\"")) << theme;
  }
  const Image dark =
      screenshot(classPage(page), "--window-size=1280,900 --blink-settings=preferredColorScheme=0");
  EXPECT_LT(dark.at(2, 2, 0), 0.2f);
}

TEST_F(ClassInBrowser, LinksLeadToTheStudentsPages) {
  ClassPage page = five();
  page.rows[0].folder = "a b#1";
  page.rows[4].folder = "学生1";
  page.rows[0].diagnoses = {{"mirror_cull", "Look at glFrontFace."}};
  page.changes = {{"Émile", "a b#1", 90, 100}};
  for (const ClassRow& row : page.rows) {
    makeFolder(folder_ / row.folder);
    for (const char* file : {"index.html", "student.html"})
      writeFile(folder_ / row.folder / file, "<p>page</p>");
  }
  const Visit seen = drive(page, R"js(
    const links = [...document.querySelectorAll("a[href$='.html']")];
    say.links = links.map((a) => decodeURIComponent(new URL(a.href).pathname)).join("|");
    say.plain = links.every((a) => new URL(a.href).protocol === "file:" && !new URL(a.href).hash);
    say.requests = performance.getEntriesByType("resource").filter((e) => !e.name.startsWith("data:")).length;
  )js");
  EXPECT_THAT(seen.dom, HasSubstr("data-plain=\"true\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-requests=\"0\""));
  const auto from = seen.dom.find("data-links=\"") + 12;
  std::istringstream links(seen.dom.substr(from, seen.dom.find('"', from) - from));
  int count = 0;
  for (std::string link; std::getline(links, link, '|'); ++count)
    EXPECT_TRUE(std::filesystem::exists(link)) << link;
  EXPECT_EQ(count, 5 * 2 + 5 + 1 + 1) << "table, outcomes, mistakes, changes";
}

TEST_F(ClassInBrowser, WithoutAScriptItIsAPlainTable) {
  std::string page = classPage(five());
  page.erase(page.rfind("<script>"), page.rfind("</script>") - page.rfind("<script>"));
  const Visit seen = visit(page);
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, HasSubstr("<form class=\"controls\" role=\"search\" "
                                  "aria-label=\"Students\" hidden"));
  EXPECT_THAT(seen.dom, HasSubstr("<th scope=\"col\" data-sort=\"number\">Score</th>"));
  EXPECT_THAT(seen.dom, HasSubstr(">5 students</p>"));
}

TEST_F(ClassInBrowser, TwoHundredStudentsFitAnyWindowAndStayQuick) {
  ClassPage page = samples::wholeClass(200);
  samples::addThumbnails(page);
  const std::string script = R"js(
    const over = document.documentElement.scrollWidth - innerWidth;
    const card = section.querySelector(".card");
    say.overflow = `${over} ${card.scrollWidth - card.clientWidth}`;
    const start = performance.now();
    sort("Final"); type("7"); section.offsetHeight;
    say.quick = performance.now() - start < 5000; // 0.4 to 1 s on a machine that is busy with much else
  )js";
  for (const char* width : {"1600", "1280", "1221", "1220", "700", "500"}) {
    const Visit seen = drive(page, script, std::string("--window-size=") + width + ",900");
    EXPECT_THAT(seen.dom,
                AllOf(HasSubstr("data-overflow=\"0 0\""), HasSubstr("data-quick=\"true\"")))
        << width;
  }
}

TEST_F(ClassInBrowser, PrintsOnSeveralPages) {
  const std::filesystem::path pdf = folder_ / "class.pdf";
  ASSERT_TRUE(chromium("--print-to-pdf=" + pdf.string(), classPage(samples::wholeClass(60))));
  const std::string bytes = read(pdf);
  EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
  int pages = 0;
  for (auto at = bytes.find("/Type /Page\n"); at != std::string::npos;
       at = bytes.find("/Type /Page\n", at + 1))
    ++pages;
  EXPECT_GT(pages, 4);
  EXPECT_LT(pages, 20);
}

} // namespace
} // namespace ggrade::report
