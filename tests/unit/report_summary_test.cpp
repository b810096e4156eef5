#include "in_japanese.hpp"
#include "report/summary.hpp"
#include "report/terminal.hpp"
#include "report/text.hpp"
#include "report_samples.hpp"

#include <gmock/gmock.h>
#include <sstream>

namespace ggrade::report {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::string> terminalLines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Outcome, NamesAreTheContracts) {
  const std::pair<results::Outcome, const char*> kNames[] = {
      {results::Outcome::graded, "graded"},
      {results::Outcome::buildFailed, "build_failed"},
      {results::Outcome::shaderError, "shader_error"},
      {results::Outcome::glError, "gl_error"},
      {results::Outcome::noFrame, "no_frame"},
      {results::Outcome::timeout, "timeout"},
      {results::Outcome::crash, "crash"},
      {results::Outcome::outOfMemory, "out_of_memory"},
      {results::Outcome::badOutput, "bad_output"},
      {results::Outcome::notGradable, "not_gradable"}};
  for (const auto& [outcome, expected] : kNames) {
    EXPECT_EQ(name(outcome), expected);
    EXPECT_THAT(std::string(explanation(outcome)), testing::EndsWith(".")) << expected;
  }
}

TEST(Summary, StandingTellsGainKeepAndBonusApart) {
  results::Item item;
  item.points = 10;
  EXPECT_EQ(standing(item), Standing::unjudged);
  item.judged = true;
  item.earned = 10;
  EXPECT_EQ(standing(item), Standing::full);
  item.earned = 4;
  EXPECT_EQ(standing(item), Standing::part);
  EXPECT_EQ(pointsText(item), "4 / 10");
  item.earned = 0;
  EXPECT_EQ(standing(item), Standing::none);
  item.kind = results::ItemKind::keep;
  EXPECT_EQ(standing(item), Standing::full);
  EXPECT_EQ(pointsText(item), "kept");
  item.earned = -10;
  EXPECT_EQ(standing(item), Standing::none);
  EXPECT_EQ(pointsText(item), "−10");
}

TEST(Terminal, BeginsWithTheDiagnosis) {
  results::Result result = samples::partial(16, 12);
  result.diagnoses = {{"mirror",
                       "The light is not mirrored.",
                       "Step 4: draw the mirrored scene",
                       0.968,
                       "the window, frame 1",
                       "31% of it differs",
                       "public",
                       "around (3, 4) of 16x12",
                       {"a.cpp:1:1: warning"},
                       "light"}};
  const std::string table = terminalTable(result, {false, 100});
  EXPECT_THAT(table,
              HasSubstr("Diagnosis (confidence 97%)\n"
                        "  The light is not mirrored.\n"
                        "  first wrong: the window, frame 1: 31% of it differs, around (3, 4) "
                        "of 16x12 (scene public)\n"
                        "  read again: Step 4: draw the mirrored scene\n"
                        "  a.cpp:1:1: warning\n"));
  EXPECT_LT(table.find("Diagnosis"), table.find(result.items[0].title));
  EXPECT_EQ(summarize(result).reason, "The light is not mirrored.");
  result.diagnoses[0].confidence = 0;
  EXPECT_THAT(terminalTable(result, {false, 100}), HasSubstr("Diagnosis\n"));
  EXPECT_NE(summarize(result).reason, "The light is not mirrored.");
}

TEST(Terminal, JapaneseLinesEndBetweenTheirLetters) {
  const InJapanese japanese;
  results::Result result = samples::crashed();
  result.items.clear();
  result.detail =
      "画像は、手順1から4まで終えたプログラムのものです。glfwSwapBuffersに到達しません。"
      "手順5で加わるものがまだ見えません。";
  std::string joined;
  for (const std::string& line : terminalLines(terminalTable(result, {.width = 60}))) {
    EXPECT_LE(displayWidth(line), 60u) << line;
    EXPECT_FALSE(line.starts_with("、") || line.starts_with("。")) << line;
    joined += line;
  }
  EXPECT_THAT(joined, HasSubstr(result.detail)) << "nothing is lost";
}

TEST(Summary, PerfectIgnoresTheBonusButNotKeepItems) {
  results::Result result = samples::perfect(16, 12);
  result.items.back().earned = 0;
  EXPECT_TRUE(perfect(result));
  EXPECT_EQ(headline(result), "Complete: every item holds.");
  result.items[4].earned = -1;
  EXPECT_FALSE(perfect(result));
  EXPECT_EQ(headline(result), "1 of 5 items lost points.");
}

TEST(Summary, NamesTheWorstItemsScenesAndFrames) {
  const results::Result result = samples::partial(64, 48);
  const auto worst = worstItems(result, 2);
  ASSERT_EQ(worst.size(), 2u);
  EXPECT_EQ(worst[0]->id, "mirror.shading");
  EXPECT_EQ(worst[1]->id, "mirror.hidden");
  EXPECT_EQ(worstScene(result, *worst[0])->name, "hidden-low");
  const FrameIndex frame = worstFrame(result);
  EXPECT_TRUE(frame.found);
  EXPECT_EQ(frame.scene, 1u);
  EXPECT_EQ(frame.frame, 1u);
}

TEST(Summary, ThumbnailIsSmallAndKeepsItsShape) {
  const Summary summary = summarize(samples::partial(640, 480), "a/index.html");
  EXPECT_EQ(summary.thumbnail.sizeText(), "224x168");
  EXPECT_EQ(summary.reason.substr(0, 6), "−27 "); // the minus sign takes three bytes
}

TEST(TerminalTable, SaysPointsMessageCauseAndStep) {
  const std::string table = terminalTable(samples::partial(16, 12));
  EXPECT_THAT(table, HasSubstr("mirror  tanaka-42  61.5 / 100\n"));
  EXPECT_THAT(table, HasSubstr("✓      35 / 35  The reflection is where it must be\n"));
  EXPECT_THAT(table, HasSubstr("~       3 / 30  The reflection is lit from the right side\n"));
  EXPECT_THAT(table, HasSubstr("~           −4  Everything else stays\n"));
  EXPECT_THAT(table, HasSubstr("likely: What lies below the floor is not clipped.\n"));
  EXPECT_THAT(table, HasSubstr("read again: Step 5: turn culling and normals\n"));
  EXPECT_THAT(table, HasSubstr("not used: notes.txt: not among the files of this assignment\n"));
}

TEST(TerminalTable, HasEscapeSequencesOnlyWhenColourIsAsked) {
  const results::Result result = samples::hostile();
  EXPECT_THAT(terminalTable(result), Not(HasSubstr("\x1B")));
  EXPECT_THAT(terminalTable(samples::perfect(16, 12), {.colour = true}), HasSubstr("\x1B[32m✓"));
  const std::string table = terminalTable(result);
  EXPECT_EQ(sanitize(table), table);
}

TEST(TerminalTable, NoLineIsWiderThanAsked) {
  results::Result result = samples::partial(16, 12);
  result.submission = "田中";
  for (const std::string& line : terminalLines(terminalTable(result, {.width = 70})))
    EXPECT_LE(displayWidth(line), 70u) << line;
}

TEST(TerminalTable, ListAlignsWideNames) {
  results::Result wide = samples::perfect(16, 12), plain = samples::noFrame();
  wide.submission = "田中太郎";
  const std::vector<Summary> all = {summarize(wide), summarize(plain)};
  const auto lines = terminalLines(terminalTable(all, {.width = 90}));
  ASSERT_EQ(lines.size(), 3u);
  const auto column = [](const std::string& line, const char* word) {
    return displayWidth(line.substr(0, line.find(word)));
  };
  EXPECT_EQ(column(lines[0], "outcome"), column(lines[1], "graded"));
  EXPECT_EQ(column(lines[0], "outcome"), column(lines[2], "no_frame"));
  EXPECT_THAT(lines[1], HasSubstr("100 / 100 + 10 bonus  complete"));
  for (const std::string& line : lines) EXPECT_LE(displayWidth(line), 90u) << line;
}

TEST(TerminalTable, NotGradableShowsNoScore) {
  results::Result result = samples::noFrame();
  result.outcome = results::Outcome::notGradable;
  EXPECT_THAT(terminalTable(result), HasSubstr("no score"));
  EXPECT_THAT(terminalTable(result), Not(HasSubstr("0 / 100")));
}

} // namespace
} // namespace ggrade::report
