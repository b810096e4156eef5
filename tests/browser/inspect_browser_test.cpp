// The filmstrip page in a real browser, opened from file:// without a network.
#include "../unit/report_inspect_samples.hpp"
#include "browser.hpp"
#include "report/inspect.hpp"

#include <gmock/gmock.h>

namespace ggrade::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// What the scripts of these tests are written with.
constexpr const char kHelpers[] = R"js(
  const say = document.documentElement.dataset, viewer = document.querySelector(".viewer");
  const shown = () => [...document.querySelectorAll(".pass")].filter((p) => !p.hidden).map((p) => p.id).join();
  const press = (key, target = document.body) =>
    target.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
  const until = async (good) => { while (!good()) await new Promise((done) => setTimeout(done, 5)); };
  const valuesOf = (id) => until(() => viewer.dataset.shown === id);
  const probe = viewer.querySelector(".probe"), canvas = viewer.querySelector("canvas");
  const point = (x, y) => {
    const box = canvas.getBoundingClientRect(), scale = box.width / canvas.width;
    canvas.dispatchEvent(new PointerEvent("pointermove",
      { clientX: box.left + (x + 0.5) * scale, clientY: box.top + (y + 0.5) * scale, bubbles: true }));
  };
  const pixel = (x, y) => [...canvas.getContext("2d").getImageData(x, y, 1, 1).data].join();
)js";

class InspectInBrowser : public Browser {
protected:
  // What the script said is in the first tag; the rest of the page is left out.
  Visit drive(const InspectedFrame& frame, const std::string& script) {
    Visit seen = visit(driven(inspectPage(frame),
                              "(async () => {" + (kHelpers + script) + "say.done = true; })();"),
                       "--window-size=1280,900 --virtual-time-budget=5000");
    seen.dom.resize(std::min(seen.dom.size(), seen.dom.find("<head>")));
    return seen;
  }
};

TEST_F(InspectInBrowser, OpensOnTheFirstPassWithoutAWordOnTheConsole) {
  const Visit seen = visit(inspectPage(samples::frame()));
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, HasSubstr("data-ready=\"true\""));
  EXPECT_THAT(seen.dom, HasSubstr("id=\"pass-2\" data-number=\"2\" tabindex=\"-1\" hidden"));
  EXPECT_THAT(seen.dom, Not(HasSubstr("id=\"pass-1\" data-number=\"1\" tabindex=\"-1\" hidden")));
}

TEST_F(InspectInBrowser, AHostileProgramsTextRunsNothing) {
  InspectedFrame frame = samples::frame();
  std::strcpy(frame.trace.samples[0].uniform, "<script>document.title=1</script>");
  frame.messages = {{"<img src=x onerror=alert(1)>", 1, 0}};
  const Visit seen = visit(inspectPage(frame));
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, HasSubstr("<title>homework: a frame, pass by pass</title>"));
}

TEST_F(InspectInBrowser, CardsLinksAndArrowKeysGoFromPassToPass) {
  const Visit seen = drive(samples::frame(), R"js(
    say.first = shown();
    document.getElementById("card-2").click();
    say.clicked = `${shown()} ${document.querySelector("#pass-2 h2").innerText}`;
    say.current = document.querySelector(".pass-card[aria-current]").id;
    press("ArrowRight"); say.right = shown();
    press("ArrowRight"); say.last = shown();
    press("ArrowLeft"); press("ArrowLeft"); press("ArrowLeft"); say.left = shown();
    document.querySelector("#pass-1 dd a[data-to='3']").click(); say.link = shown();
    say.related = [...document.querySelectorAll(".pass-card.related")].map((c) => c.id);
    say.arcs = document.querySelectorAll(".arc.related").length;
    location.hash = "#pass-2"; await until(() => shown() === "pass-2"); say.hash = shown();
  )js");
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, HasSubstr("data-first=\"pass-1\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-clicked=\"pass-2 Pass 2 clears a texture, 4 x 4 RGBA8\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-current=\"card-2\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-right=\"pass-3\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-last=\"pass-3\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-left=\"pass-1\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-link=\"pass-3\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-related=\"card-1\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-arcs=\"1\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-hash=\"pass-2\""));
}

TEST_F(InspectInBrowser, ThePointerReadsTheValuesAsStored) {
  const Visit seen = drive(samples::frame(), R"js(
    await valuesOf("values-0");
    point(2, 1); say.half = probe.value;
    document.querySelectorAll("#pass-1 .pictures button")[1].click();
    await valuesOf("values-1");
    point(2, 0); say.depth = probe.value;
    point(0, 0); say.far = probe.value;
    document.getElementById("card-3").click();
    await valuesOf("values-2");
    point(5, 2); say.bytes = probe.value;
    press("ArrowLeft", viewer.querySelector(".pane"));
    say.moved = `${shown()} ${probe.value}`;
  )js");
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, HasSubstr("data-half=\"x 2, y 1 from the top (gl_FragCoord 2.5, 1.5)\n"
                                  "R 2.5   G -0.5   B 1   A 1\""));
  EXPECT_THAT(seen.dom, HasSubstr("(gl_FragCoord 2.5, 2.5)\ndepth 0.9873\""));
  EXPECT_THAT(seen.dom, HasSubstr("(gl_FragCoord 0.5, 2.5)\ndepth 1\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-bytes=\"x 5, y 2 from the top (gl_FragCoord 5.5, 3.5)\n"
                                  "R 255 (1.000)   G 128 (0.502)   B 255 (1.000)   A 255"));
  EXPECT_THAT(seen.dom, AllOf(HasSubstr("data-moved=\"pass-3 x 4, y 2"),
                              HasSubstr("G 255 (1.000)   B 255 (1.000)   A 255 (1.000)\"")))
      << "an arrow key on the picture moves the pixel, not the pass";
}

TEST_F(InspectInBrowser, ExposureChannelAndDepthRangeChangeThePicture) {
  const Visit seen = drive(samples::frame(), R"js(
    const input = (selector, value) => {
      const element = viewer.querySelector(selector);
      if (element.type === "radio") element.checked = true; else element.value = value;
      element.dispatchEvent(new Event("input"));
    };
    await valuesOf("values-0");
    say.fitted = pixel(2, 1) + " " + pixel(0, 0);
    input(".exposure input", "0"); say.plain = pixel(0, 0);
    input("[name=channel][value='1']"); say.green = pixel(2, 1);
    viewer.querySelector(".reset").click(); say.reset = pixel(2, 1);
    document.querySelectorAll("#pass-1 .pictures button")[1].click();
    await valuesOf("values-1");
    input(".between input:nth-of-type(1)", "0.9"); input(".between input:nth-of-type(2)", "1");
    say.depth = pixel(2, 0) + " " + pixel(0, 0);
    say.hidden = [".exposure", ".channels"].map((s) => viewer.querySelector(s).hidden);
  )js");
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, HasSubstr("data-fitted=\"255,0,102,255 102,102,102,255\""))
      << "2.5 is white";
  EXPECT_THAT(seen.dom, HasSubstr("data-plain=\"255,255,255,255\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-green=\"0,0,0,255\"")) << "-0.5";
  EXPECT_THAT(seen.dom, HasSubstr("data-reset=\"255,0,102,255\""));
  // Of the way from 1 - 0.9 down to 2^-12, 1 - 0.9873 has 34%: evenDepth().
  EXPECT_THAT(seen.dom, HasSubstr("data-depth=\"87,87,87,255 255,255,255,255\""));
  EXPECT_THAT(seen.dom, HasSubstr("data-hidden=\"true,true\""));
}

TEST_F(InspectInBrowser, TheWheelZoomsOnlyAfterAClickOnThePicture) {
  const Visit seen = drive(samples::frame(), R"js(
    await valuesOf("values-0");
    const pane = viewer.querySelector(".pane");
    const wheel = () => pane.dispatchEvent(new WheelEvent("wheel", { deltaY: -1, cancelable: true }));
    say.fit = canvas.style.width; say.scrolls = wheel(); say.same = canvas.style.width;
    pane.focus(); say.zooms = !wheel(); say.larger = canvas.style.width;
    viewer.querySelector("[data-zoom='1']").click(); say.whole = canvas.style.width;
  )js");
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, HasSubstr("data-fit=\"64px\" data-scrolls=\"true\" data-same=\"64px\" "
                                  "data-zooms=\"true\" data-larger=\"80px\" data-whole=\"4px\""));
}

TEST_F(InspectInBrowser, NotANumberIsMagentaAndInfinityCyan) {
  InspectedFrame frame = samples::frame();
  const std::uint16_t special[] = {0x7E00, 0x7C00};
  std::memcpy(&frame.trace.pixels[0], &special[0], 2); // red of (0, 0)
  std::memcpy(&frame.trace.pixels[8], &special[1], 2); // red of (1, 0)
  const Visit seen = drive(frame, R"js(
    await valuesOf("values-0");
    point(0, 0); say.nan = `${pixel(0, 0)} ${probe.value}`;
    point(1, 0); say.inf = `${pixel(1, 0)} ${probe.value}`;
  )js");
  EXPECT_THAT(seen.dom, HasSubstr("data-nan=\"255,0,255,255 "));
  EXPECT_THAT(seen.dom, HasSubstr("\nR NaN   G 1"));
  EXPECT_THAT(seen.dom, HasSubstr("data-inf=\"0,255,255,255 "));
  EXPECT_THAT(seen.dom, HasSubstr("\nR +Inf   G 1"));
}

TEST_F(InspectInBrowser, WithoutAScriptEveryPassIsShown) {
  std::string page = inspectPage(samples::frame());
  page.erase(page.rfind("<script>"), page.rfind("</script>") - page.rfind("<script>"));
  const Visit seen = visit(page);
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, Not(HasSubstr("tabindex=\"-1\" hidden")));
  EXPECT_THAT(seen.dom, HasSubstr("<div class=\"viewer\" hidden"));
}

TEST_F(InspectInBrowser, WithoutValuesThePictureIsStillShown) {
  InspectLimits limits;
  limits.bytes = 0;
  const Visit seen = visit(inspectPage(samples::frame(), limits));
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, HasSubstr("The values of this picture are not in the page."));
}

TEST_F(InspectInBrowser, IsDarkWhereTheReaderIsAndFitsANarrowWindow) {
  const std::string page = inspectPage(samples::frame());
  const Image dark =
      screenshot(page, "--window-size=1280,900 --blink-settings=preferredColorScheme=0");
  EXPECT_LT(dark.at(2, 2, 0), 0.2f);
  const Visit narrow = visit(driven(page, "document.documentElement.dataset.overflow = "
                                          "document.documentElement.scrollWidth - innerWidth"),
                             "--window-size=500,900");
  EXPECT_THAT(narrow.dom, HasSubstr("data-overflow=\"0\""));
}

} // namespace
} // namespace ggrade::report
