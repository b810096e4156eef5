// The pages in a real browser, opened from file:// without a network.
#include "../unit/report_samples.hpp"
#include "browser.hpp"
#include "report/reports.hpp"

#include <array>
#include <gmock/gmock.h>

namespace ggrade::report {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(Browser, EveryPageRunsItsScriptWithoutAWordOnTheConsole) {
  const Pages partial = resultPages(samples::partial(64, 48), Reveal::names);
  const Pages hostile = resultPages(samples::hostile(), Reveal::details);
  const std::vector<Summary> all = {summarize(samples::perfect(64, 48), "a/index.html"),
                                    summarize(samples::hostile())};
  const std::pair<const char*, std::string> kPages[] = {
      {"index", partial.index},
      {"student", partial.student},
      {"build failed", resultPages(samples::buildFailed(), Reveal::names).index},
      {"no frame", resultPages(samples::noFrame(), Reveal::names).student},
      {"hostile", hostile.index},
      {"overview", overviewPage("Demo", "", all)}};
  for (const auto& [name, page] : kPages) {
    const Visit seen = visit(page);
    EXPECT_THAT(seen.dom, HasSubstr("data-ready=\"true\"")) << name;
    EXPECT_EQ(seen.console, "") << name;
  }
}

TEST_F(Browser, ForeignScriptsAndRequestsAreRefused) {
  const std::string page = resultPages(samples::partial(64, 48), Reveal::names).index;
  const Visit seen =
      visit(replaced(page, "</body>",
                     "<script>document.documentElement.dataset.foreign = 1</script>"
                     "<img src=\"file:///usr/share/pixmaps/none.png\" "
                     "onerror=\"document.documentElement.dataset.foreign = 2\"></body>"));
  EXPECT_THAT(seen.dom, Not(HasSubstr("data-foreign")));
  EXPECT_THAT(seen.dom, HasSubstr("data-ready=\"true\"")) << "our own script still runs";
  EXPECT_THAT(seen.console, HasSubstr("Content Security Policy"));
}

TEST_F(Browser, SliderStandsBetweenPixelsAndFollowsFrameAndZoom) {
  const std::string page = resultPages(samples::partial(64, 48), Reveal::names).index;
  const Visit seen = visit(driven(page, R"js(
    const scene = document.getElementById("scene-1"), say = document.documentElement.dataset;
    const range = scene.querySelector("input[type=range]"), over = scene.querySelector(".over");
    const frames = [...scene.querySelectorAll(".frame")];
    say.first = frames.map((f) => f.hidden);
    say.borrowed = over.src === frames[1].querySelector(".student").src
      && scene.querySelector(".under").src === frames[1].querySelector(".reference").src;
    range.value = 20; range.dispatchEvent(new Event("input"));
    say.clip = over.style.clipPath; say.spoken = range.getAttribute("aria-valuetext");
    const zoom = scene.querySelector("select");
    zoom.value = "4"; zoom.dispatchEvent(new Event("change"));
    say.zoomed = over.style.clipPath + " " + over.style.width + " " + getComputedStyle(over).imageRendering;
    scene.querySelector("input[type=radio]").click();
    say.second = frames.map((f) => f.hidden);
    say.follows = over.src === frames[0].querySelector(".student").src;
    location.hash = "#scene-2";
    addEventListener("hashchange", () => { say.opened = document.querySelector("#scene-2 > details").open; });
  )js"));
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, HasSubstr("data-first=\"true,false\"")) << "the worst frame first";
  EXPECT_THAT(seen.dom, HasSubstr("data-borrowed=\"true\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-clip=\"inset(0px 44px 0px 0px)\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-spoken=\"20 of 64 columns from submission\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-zoomed=\"inset(0px 176px 0px 0px) 256px pixelated\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-second=\"false,true\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-follows=\"true\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-opened=\"true\""));
}

TEST_F(Browser, PointingAtAPixelReadsBothColours) {
  results::Result result = samples::partial(64, 48);
  result.scenes[0].frames[0].student = Image(64, 48, 4, 1);
  result.scenes[0].frames[0].student.at(10, 5, 1) = 128.0f / 255;
  result.scenes[0].frames[0].reference = Image(64, 48, 4, 0);
  result.scenes[0].frames[0].wrongShare = 1;
  const Visit seen = visit(driven(resultPages(result, Reveal::names).index, R"js(
    addEventListener("load", () => {
      const stack = document.querySelector("#scene-0 .stack"), box = stack.getBoundingClientRect();
      stack.dispatchEvent(new PointerEvent("pointermove", { clientX: box.left + 10.5, clientY: box.top + 5.5 }));
    });
  )js"));
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom,
              HasSubstr(">(10, 5)  submission 255 128 255  reference   0   0   0</output>"));
}

TEST_F(Browser, WithoutAScriptEveryFrameIsShown) {
  std::string page = resultPages(samples::partial(64, 48), Reveal::names).index;
  page.erase(page.rfind("<script>"), page.rfind("</script>") - page.rfind("<script>"));
  EXPECT_THAT(visit(page).dom, Not(HasSubstr("<div class=\"frame\" hidden")));
}

TEST_F(Browser, IsDarkWhereTheReaderIsAndFitsANarrowWindow) {
  const std::string page = resultPages(samples::partial(64, 48), Reveal::names).index;
  const Image light =
      screenshot(page, "--window-size=1280,900 --blink-settings=preferredColorScheme=1");
  const Image dark =
      screenshot(page, "--window-size=1280,900 --blink-settings=preferredColorScheme=0");
  EXPECT_GT(light.at(2, 2, 0), 0.9f);
  EXPECT_LT(dark.at(2, 2, 0), 0.2f);
  const Visit narrow = visit(driven(page, "document.documentElement.dataset.overflow = "
                                          "document.documentElement.scrollWidth - innerWidth"),
                             "--window-size=500,900");
  EXPECT_THAT(narrow.dom, HasSubstr("data-overflow=\"0\""));
}

} // namespace
} // namespace ggrade::report
