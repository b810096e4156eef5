#include "in_japanese.hpp"
#include "report/picture.hpp"
#include "report/reports.hpp"
#include "report_samples.hpp"

#include "image/png.hpp"
#include "report/text.hpp"

#include <gmock/gmock.h>

namespace ggrade::report {
namespace {

using samples::count;
using testing::HasSubstr;
using testing::Not;

std::string index(const results::Result& result) {
  return resultPages(result, Reveal::names).index;
}

TEST(Base64, MatchesTheRfcsExamples) {
  const auto encoded = [](std::string_view text) {
    return base64({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(Thumbnail, AveragesAndNeverEnlarges) {
  Image image(4, 2, 4, 0);
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 2; ++y) image.at(x, y, 0) = float(x);
  const Image small = thumbnail(image, 2, 2);
  EXPECT_EQ(small.sizeText(), "2x1");
  EXPECT_FLOAT_EQ(small.at(0, 0, 0), 0.5f);
  EXPECT_FLOAT_EQ(small.at(1, 0, 0), 0.0f);
  EXPECT_EQ(thumbnail(image, 100, 100).sizeText(), "4x2");
  EXPECT_TRUE(thumbnail(Image(), 10, 10).empty());
}

TEST(ResultPage, NeedsNothingFromOutside) {
  for (const results::Result& result : {samples::partial(64, 48), samples::hostile()})
    for (const std::string& page : {resultPages(result, Reveal::details).index,
                                    resultPages(result, Reveal::details).student}) {
      EXPECT_THAT(
          page,
          HasSubstr(
              "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-"));
      for (const char* outside :
           {"http:", "https:", "src=\"/", "url(", "@import", "<iframe", "<object"})
        EXPECT_THAT(page, Not(HasSubstr(outside))) << outside;
      EXPECT_EQ(count(page, "<img") - count(page, "<img class=\"under\"") -
                    count(page, "<img class=\"over\""),
                count(page, "src=\"data:image/png;base64,"));
    }
}

TEST(ResultPage, SaysTheOutcomeInWordsFirst) {
  const std::string page = index(samples::noFrame());
  const auto words = page.find("The program drew no frame: glfwSwapBuffers was never reached.");
  ASSERT_NE(words, std::string::npos);
  EXPECT_LT(words, page.find("<h2"));
  EXPECT_THAT(page, HasSubstr("data-outcome=\"no_frame\""));
  EXPECT_THAT(page, HasSubstr("no frame came"));
  EXPECT_THAT(page, HasSubstr("6 items were not judged."));
}

TEST(ResultPage, IsJapaneseForWhoReadsJapanese) {
  const std::string english = resultPages(samples::partial(64, 48), Reveal::names).student;
  EXPECT_THAT(english, HasSubstr("<html lang=\"en\">"));
  const InJapanese japanese;
  const std::string page = resultPages(samples::partial(64, 48), Reveal::names).student;
  for (const char* text :
       {"<html lang=\"ja\">", "<h2 id=\"items-heading\">評価項目</h2>", "採点の条件</h2>",
        "評価項目5個のうち3個で失点しました。", "aria-label=\"100点中61.5点\"",
        "data-columns=\"%2列のうち%1列があなたの画像\""})
    EXPECT_THAT(page, HasSubstr(text));
  for (const char* text : {"Items", "Likely cause", "Read again", "Reference",
                           "of the pixels differ", "Zoom", "How this was graded", "{{"}) {
    EXPECT_THAT(page.substr(page.find("<body>")), Not(HasSubstr(text)));
  }
}

TEST(ResultPage, NamesWhatLostMostAndWhereAtTheTop) {
  const std::string page = index(samples::partial(64, 48));
  const std::string top = page.substr(0, page.find("<h2"));
  EXPECT_THAT(top, HasSubstr("aria-label=\"Score 61.5 of 100\""));
  EXPECT_THAT(top, HasSubstr("−27"));
  EXPECT_THAT(top, HasSubstr("<a class=\"chip none\" href=\"#scene-1\">hidden-low</a>"));
  EXPECT_LT(top.find("−27"), top.find("−7.5"));
}

TEST(ResultPage, HasEveryPictureOnceAndASliderAScene) {
  const results::Result result = samples::partial(64, 48);
  const std::string page = index(result);
  for (const results::Scene& scene : result.scenes)
    for (const results::Frame& frame : scene.frames)
      EXPECT_GE(count(page, pngDataUri(frame.student)), 1u);
  EXPECT_EQ(count(page, "<img class=\"student\""), 6u);
  EXPECT_EQ(count(page, "<img class=\"reference\""), 6u);
  EXPECT_EQ(count(page, "<img class=\"difference\""), 6u);
  EXPECT_EQ(count(page, "<img class=\"flip\""), 6u);
  for (const results::Scene& scene : result.scenes)
    for (const results::Frame& frame : scene.frames) {
      EXPECT_THAT(page, HasSubstr(pngDataUri(frame.flipPicture)));
      EXPECT_THAT(page, HasSubstr("<figcaption>FLIP " + number(frame.flip, 4) + "</figcaption>"));
    }
  EXPECT_EQ(count(page, "<input type=\"range\""), 3u);
  EXPECT_EQ(count(page, "<input type=\"radio\""), 6u);
  EXPECT_THAT(page,
              HasSubstr("alt=\"Submission, hidden-low at 2.5 s: 13.1% of the pixels differ.\""));
}

TEST(ResultPage, HasNoSliderWithoutAPair) {
  EXPECT_THAT(index(samples::crashed()), Not(HasSubstr("<input type=\"range\"")));
  results::Result result = samples::partial(64, 48);
  for (results::Scene& scene : result.scenes)
    for (results::Frame& frame : scene.frames) frame.student = Image(32, 48, 4, 1);
  EXPECT_THAT(index(result), Not(HasSubstr("<input type=\"range\""))) << "sizes differ";
}

TEST(ResultPage, HostileTextStaysText) {
  const Pages pages = resultPages(samples::hostile(), Reveal::details);
  for (const std::string& page : {pages.index, pages.student}) {
    EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
    EXPECT_EQ(count(page, "<script"), 1u);
    for (const char* forbidden : {"\x1B", "\u202E", "\xFF", "\x01"})
      EXPECT_THAT(page, Not(HasSubstr(forbidden)));
    EXPECT_THAT(page, HasSubstr("{{submission}}")) << "text is no template";
    EXPECT_LT(page.size(), 1u << 20) << "outputs are capped";
    EXPECT_THAT(page, HasSubstr("bytes are left out here"));
  }
}

TEST(ResultPage, CompilerErrorsAreMarkedAndTheFirstStandsOnTop) {
  const std::string page = index(samples::buildFailed());
  EXPECT_EQ(count(page, "<span class=\"err\">floor.cpp:42:5: error: &#39;mirrorFramebuffer&#39; "
                        "was not declared"),
            1u);
  EXPECT_LT(page.find("floor.cpp:42:5"), page.find("<h2"));
  EXPECT_THAT(page, HasSubstr("<span class=\"warn\">floor.cpp:61:12: warning:"));
}

TEST(ResultPage, PerfectLooksDifferent) {
  EXPECT_THAT(index(samples::perfect(64, 48)), HasSubstr("verdict card full perfect"));
  EXPECT_THAT(index(samples::perfect(64, 48)),
              HasSubstr("6 items in 6 frames of 3 scenes; no pixel differs."));
  EXPECT_THAT(index(samples::partial(64, 48)), Not(HasSubstr("verdict card part perfect")));
}

TEST(ResultPage, SaysWhenThereWasNoSandbox) {
  results::Result result = samples::perfect(16, 12);
  EXPECT_THAT(index(result), Not(HasSubstr("ran without a sandbox")));
  result.sandbox = "none";
  EXPECT_THAT(index(result), HasSubstr("ran without a sandbox"));
}

TEST(ResultPage, AnEmptyResultIsStillAPage) {
  EXPECT_THAT(index(results::Result()), HasSubstr("The grader failed, not the submission"));
}

TEST(OverviewPage, HasARowWithThumbnailScoreAndLink) {
  const std::vector<Summary> all = {summarize(samples::perfect(64, 48), "reference/index.html"),
                                    summarize(samples::crashed(), "a b/index.html"),
                                    summarize(samples::hostile())};
  const std::string page = overviewPage("Demo", "Three programs.", all);
  EXPECT_THAT(page, HasSubstr("<a href=\"reference/index.html\">reference</a>"));
  EXPECT_THAT(page, HasSubstr("<a href=\"a%20b/index.html\">crash</a>"));
  EXPECT_THAT(page, HasSubstr("<tr class=\"full\" data-outcome=\"graded\">"));
  EXPECT_THAT(page, HasSubstr("<tr class=\"none\" data-outcome=\"crash\">"));
  EXPECT_EQ(count(page, "<img src=\"data:image/png"), 2u);
  EXPECT_THAT(page, HasSubstr("1 complete"));
  EXPECT_THAT(page, HasSubstr("1 crash"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
}

} // namespace
} // namespace ggrade::report
