#include "report/picture.hpp"
#include "tradeoff/adopted.hpp"
#include "tradeoff/page.hpp"
#include "words/words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace ggrade;
using namespace ggrade::tradeoff;
using testing::HasSubstr;
using testing::Not;

namespace {

/// Two numbers, each setting with an error that the larger size halves.
Measured sample() {
  Measured measured;
  measured.sweep.part = "mirror";
  measured.sweep.name = "sharp";
  measured.sweep.about = "A scene.";
  measured.sweep.scene = {{"size", {480, 360}}, {"quality", {{"size", 64}, {"clip", 1}}}};
  measured.sweep.numbers = {{"clip", {0, 1}, "What sinks shows.", false},
                            {"size", {64, 128, 256}, "", true}};
  measured.sweep.together = {{"size", "clip"}};
  for (const json& setting : allSettings(measured.sweep)) {
    const double size = setting["size"];
    const double clip = setting["clip"];
    const double ms = size * size / 4096 + clip / 10;
    measured.points.push_back(
        {setting,
         {ms, 0.9 * ms, 1.1 * ms, ms + 3, true},
         {{"RMSE, edges left out", 1 / size + (clip == 0 ? 0.1 : 0)}, {"edge \"RMSE\"", 2 / size}},
         {},
         {}});
  }
  measured.offMs = 3;
  return measured;
}

TEST(TradeoffSweep, HasEverySettingOnce) {
  const Measured measured = sample();
  EXPECT_EQ(measured.points.size(), 6u);
  EXPECT_EQ(measured.points[0].setting, json({{"clip", 1}, {"size", 64}})) << "the scene's own";
}

TEST(TradeoffFiles, HoldANumberAlone) {
  const Measured measured = sample();
  const Findings findings = findingsOf(measured, {});
  ASSERT_EQ(findings.tables.size(), 3u);
  EXPECT_EQ(findings.tables[1].name(), "size");
  EXPECT_EQ(csvOf(measured, findings.tables[1]),
            "size,ms,low,high,frame_ms,\"RMSE, edges left out\",\"edge \"\"RMSE\"\"\"\n"
            "64,1.1,0.99,1.21,4.1,0.015625,0.03125\n"
            "128,4.1,3.69,4.51,7.1,0.0078125,0.015625\n"
            "256,16.1,14.49,17.71,19.1,0.00390625,0.0078125\n");
  const json all = jsonOf(measured, findings, findings.tables[1]);
  EXPECT_EQ(all["rows"].size(), 3u);
  EXPECT_EQ(all["rows"][2]["setting"], json({{"clip", 1}, {"size", 256}}));
  EXPECT_DOUBLE_EQ(all["rows"][2]["errors"]["RMSE, edges left out"], 0.00390625);
  EXPECT_NEAR(all["cost_exponent"], 1.94, 0.01);
  EXPECT_EQ(all["error_falls"], "The error falls with size: from 1.6% at 64 to 0.39% at 256.");
}

TEST(TradeoffFiles, HoldNumbersTogether) {
  const Measured measured = sample();
  const Findings findings = findingsOf(measured, {});
  EXPECT_EQ(findings.tables[2].name(), "size-clip");
  EXPECT_EQ(findings.tables[2].points.size(), 6u);
  EXPECT_THAT(csvOf(measured, findings.tables[2]),
              HasSubstr("\n64,0,1,0.9,1.1,4,0.115625,0.03125\n64,1,1.1,"));
}

TEST(TradeoffFindings, AnswerWishes) {
  const Measured measured = sample();
  const Findings findings = findingsOf(measured, {4.6, 0.001});
  ASSERT_EQ(findings.advice.size(), 2u);
  EXPECT_EQ(findings.advice[0].wish, "at most 4.60 ms");
  ASSERT_TRUE(findings.advice[0].point);
  EXPECT_EQ(measured.points[*findings.advice[0].point].setting, json({{"clip", 1}, {"size", 128}}));
  EXPECT_EQ(findings.advice[1].wish, "an error of at most 0.10%");
  EXPECT_FALSE(findings.advice[1].point);
  const std::string text = textOf(measured, findings);
  EXPECT_THAT(text, HasSubstr("{\"quality\":{\"clip\":1,\"size\":128}}"));
  EXPECT_THAT(text, HasSubstr("no setting that was measured"));
  EXPECT_THAT(text, HasSubstr("mirror, scene \"sharp\": 6 settings"));
  EXPECT_THAT(text, HasSubstr("accurate, reference"));
  EXPECT_THAT(text, HasSubstr("16.1 ms of  19.1 ms     0.39%  clip 1, size 256"));
}

TEST(TradeoffFindings, PresetsOfSeveralScenesStandTogether) {
  Measured blurred = sample();
  blurred.sweep.name = "blurred";
  blurred.sweep.scene["quality"]["samples"] = 1;
  blurred.sweep.numbers = {{"samples", {1, 2}, "", true}};
  blurred.sweep.together.clear();
  blurred.points.resize(2);
  blurred.points[0].setting = {{"samples", 1}};
  blurred.points[1].setting = {{"samples", 2}};
  const std::vector<Measured> all = {sample(), blurred};
  const json presets = presetsJson(all, {findingsOf(all[0], {}), findingsOf(all[1], {})});
  EXPECT_EQ(presets["mirror"]["reference"]["quality"],
            json({{"clip", 1}, {"size", 256}, {"samples", 2}}));
  EXPECT_EQ(presets["mirror"]["fast"]["quality"]["size"], 64);
}

TEST(TradeoffFindings, SayWhereTheRoundsWereNotEnough) {
  Measured measured = sample();
  EXPECT_EQ(roundsText(measured.points, {24, 3}), "");
  measured.points[2].cost.narrow = measured.points[4].cost.narrow = false;
  EXPECT_EQ(roundsText(measured.points, {24, 3}),
            "Of 2 of 6 settings the cost is known less well: after 24 rounds the interval is still "
            "wider than 10% of the whole frame or 10% of the cost.");
  gg::setLanguage(gg::Language::japanese);
  EXPECT_EQ(roundsText(measured.points, {24, 3}),
            "6通りのうち2通りの設定では、コストの精度が不足："
            "24回測っても、区間の幅がフレーム全体の10%以上、またはコストの10%以上。");
  gg::setLanguage(gg::Language::english);
}

TEST(TradeoffWishes, HaveUnits) {
  EXPECT_DOUBLE_EQ(parseMs("5ms"), 5);
  EXPECT_DOUBLE_EQ(parseMs("0.005s"), 5);
  EXPECT_DOUBLE_EQ(parseMs("5"), 5);
  EXPECT_DOUBLE_EQ(parseError("1%"), 0.01);
  EXPECT_DOUBLE_EQ(parseError("0.01"), 0.01);
  for (const char* text : {"", "ms", "5 ms", "-1ms", "5min", "nan", "inf", "1%"}) {
    try {
      parseMs(text);
      ADD_FAILURE() << text;
    } catch (const UsageError& error) {
      EXPECT_EQ(error.what(), std::string("--budget ") + text + ": must be a time such as 5ms");
    }
  }
  EXPECT_THROW(parseError("1ms"), UsageError);
}

TEST(TradeoffChart, CanBeReadAloud) {
  const Measured measured = sample();
  const Findings findings = findingsOf(measured, {});
  const std::string svg = frontChart(measured, findings, Labels::places);
  EXPECT_THAT(svg, HasSubstr("role=\"img\" aria-labelledby=\"chart-mirror-sharp-title "
                             "chart-mirror-sharp-desc\"><title id=\"chart-mirror-sharp-title\">"
                             "mirror, sharp: time against RMSE, edges left out</title>"));
  EXPECT_THAT(
      svg,
      HasSubstr("1: clip 1, size 64: 1.10 ms of a frame of 4.10 ms, RMSE, edges left out 1.6%."));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(curveChart(measured, findings.curves[1], false), HasSubstr("64: 1.6%. 128: 0.78%."));
  EXPECT_THAT(curveChart(measured, findings.curves[1], true), HasSubstr("64: 1.10 ms."));
}

TEST(TradeoffChart, BearsNoTimeAndNoError) {
  Measured measured = sample();
  for (Point& point : measured.points) {
    point.cost = {};
    point.errors[0].value = 0;
  }
  const std::string svg = frontChart(measured, findingsOf(measured, {}), Labels::places);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

/// What `tradeoff --adopt` keeps of two sweeps.
json adoptedSample() {
  const Measured measured = sample();
  json sharp = jsonOf(measured, findingsOf(measured, {})), blurred = sharp;
  blurred["scene_name"] = "blurred";
  for (json& preset : blurred["presets"]) preset["setting"] = {{"samples", 16}, {"size", 8}};
  const json need = {{"passes", 2}, {"image_bytes", 1 << 20}, {"ms", 3}},
             against = {{"passes", 3}, {"image_bytes", 2 << 20}, {"ms", 4}};
  return {{"format", kFormat},
          {"sweeps", {sharp, blurred}},
          {"growth",
           {{{"part", "mirror"},
             {"series", "pixels"},
             {"values", {1, 2}},
             {"costs", {jsonOf(Cost{1, 0.9, 1.1, 4, true}), jsonOf(Cost{2.5, 2, 3, 5, true})}},
             {"exponent", 1.32}}}},
          {"saved",
           {{{"scene", "no mirror"},
             {"needed", need},
             {"against", against},
             {"saved", jsonOf(Cost{1, 0.9, 1.1, 4, true})}}}}};
}

/// What it kept before costs had intervals.
json oldSample() {
  const Measured measured = sample();
  json sharp = jsonOf(measured, findingsOf(measured, {}));
  for (json& preset : sharp["presets"])
    for (const char* key : {"low", "high", "frame_ms", "narrow"}) preset.erase(key);
  json blurred = sharp;
  blurred["scene_name"] = "blurred";
  for (json& preset : blurred["presets"]) preset["setting"] = {{"samples", 16}, {"size", 8}};
  json need = {{"passes", 2}, {"image_bytes", 1 << 20}, {"ms", 3}};
  return {{"sweeps", {sharp, blurred}},
          {"growth",
           {{{"part", "mirror"},
             {"series", "pixels"},
             {"values", {1, 2}},
             {"ms", {1, 2.5}},
             {"exponent", 1.32}}}},
          {"saved", {{{"scene", "no mirror"}, {"needed", need}, {"against", need}}}}};
}

TEST(TradeoffAdopted, APresetHasTheNumbersOfAllSweeps) {
  const json presets = adoptedPresets(adoptedSample());
  EXPECT_EQ(presets["fast"], json({{"clip", 1}, {"samples", 16}, {"size", 64}}));
  EXPECT_EQ(presets["reference"], json({{"clip", 1}, {"samples", 16}, {"size", 256}}));
}

TEST(TradeoffAdopted, OfTwoPartsTheLaterOneDecides) {
  const auto sweep = [](const char* part, int format) {
    return json{{"part", part}, {"presets", {{"fast", {{"setting", {{"format", format}}}}}}}};
  };
  const json figures = {{"sweeps", {sweep("targets", 0), sweep("figure", 1), sweep("figure", 2)}}};
  EXPECT_EQ(adoptedPresets(figures)["fast"], json({{"format", 1}}));
}

/// Else its table and presets.json seem to contradict each other.
TEST(TradeoffAdopted, SaysWhatAnotherPartDecides) {
  json figures = adoptedSample(), later = figures["sweeps"][0];
  EXPECT_THAT(handoutText(figures, "mirror"), Not(HasSubstr("presets.json")));
  later["part"] = "water";
  later["presets"] = {{"fast", {{"setting", {{"size", 32}}}}},
                      {"accurate", {{"setting", {{"size", 128}}}}}};
  figures["sweeps"].push_back(later);
  EXPECT_THAT(handoutText(figures, "mirror"),
              testing::EndsWith("\n- `presets.json` has `size` as part water asks, which has it, "
                                "too: fast 32, accurate 128.\n"));
}

TEST(TradeoffAdopted, IsATableInTheHandout) {
  const std::string text = handoutText(adoptedSample(), "mirror");
  EXPECT_THAT(text, testing::StartsWith(
                        "A scene. 480 x 360 pixels; without this part a frame takes 3.00 ms.\n\n"
                        "Between fast (1.10 ms, error 1.6%) and reference (16.1 ms, error 0.39%), "
                        "a frame takes 19.1 ms instead of 4.10 ms, and the error falls to 25.0% of "
                        "it.\n\n"
                        "| preset | time of this part | whole frame | RMSE, edges left out | "
                        "setting |\n| --- | ---: | ---: | ---: | --- |\n"));
  EXPECT_THAT(
      text,
      HasSubstr("| accurate, reference | 16.1 ms | 19.1 ms | 0.39% | `clip` 1, `size` 256 |\n"));
  json hidden = adoptedSample();
  hidden["growth"][0]["costs"][0] = jsonOf(costOf({{9, 9, 11, 11, 9, 11}, {8, 9, 10, 9, 10, 12}}));
  EXPECT_THAT(handoutText(hidden, ""),
              HasSubstr("| mirror | pixels | 1: below 2 ms, 2: 2.50 ms | – |\n"));
  EXPECT_EQ(handoutText(adoptedSample(), ""),
            "| part | against | its cost in a frame | grows with the power |\n"
            "| --- | --- | --- | ---: |\n"
            "| mirror | pixels | 1: 1.00 ms, 2: 2.50 ms | 1.32 |\n\n"
            "| scene | passes | memory | a frame's time |\n| --- | ---: | ---: | ---: |\n"
            "| no mirror | 2 of 3 | 1.0 of 2.0 MiB | 3.00 ms of 4.00 ms |\n");
  hidden["saved"][0]["saved"]["low"] = 0;
  EXPECT_THAT(handoutText(hidden, ""), HasSubstr("| no less (3.00 ms and 4.00 ms) |\n"));
  gg::setLanguage(gg::Language::japanese);
  EXPECT_THAT(handoutText(hidden, ""), HasSubstr("1: 2 ms未満, 2: 2.50 ms"));
  EXPECT_THAT(handoutText(adoptedSample(), "mirror"),
              HasSubstr("fast（1.10 ms、誤差1.6%）からreference（16.1 ms、誤差0.39%）へ："
                        "1フレームの時間は4.10 msから19.1 msへ、誤差はその25.0%へ。\n\n"
                        "| プリセット | このパートの時間 | フレーム全体 | "));
  gg::setLanguage(gg::Language::english);
}

TEST(TradeoffAdopted, OfTheFirstFormatIsTheTableThatItWas) {
  const std::string text = handoutText(oldSample(), "mirror");
  EXPECT_THAT(text, testing::StartsWith(
                        "A scene. 480 x 360 pixels; without this part a frame takes 3.00 ms.\n\n"
                        "| preset | time of this part | RMSE, edges left out | setting |\n"
                        "| --- | ---: | ---: | --- |\n"));
  EXPECT_THAT(text,
              HasSubstr("| accurate, reference | 16.1 ms | 0.39% | `clip` 1, `size` 256 |\n"));
  EXPECT_THAT(text, HasSubstr("(handout/tradeoff-mirror-sharp.svg)\n"));
  EXPECT_THAT(text, HasSubstr("(handout/tradeoff-mirror-blurred.svg)\n"));
  EXPECT_THAT(text, HasSubstr("- The error falls with size: from 1.6% at 64 to 0.39% at 256. Its "
                              "cost grows with the power 1.94 of it.\n"));
  json noisy = oldSample();
  noisy["growth"][0]["ms"][0] = -1;
  EXPECT_THAT(handoutText(noisy, ""), HasSubstr("| mirror | pixels | 1: –, 2: 2.50 ms | – |\n"));
  noisy = oldSample();
  noisy["growth"][0]["deviation"] = 0.5;
  EXPECT_THAT(handoutText(noisy, ""), HasSubstr("| 1: 1.00 ms, 2: 2.50 ms | – |\n"));
  json falling = oldSample();
  falling["growth"][0]["exponent"] = -0.02;
  EXPECT_THAT(handoutText(falling, ""), HasSubstr("| 1: 1.00 ms, 2: 2.50 ms | < 0.1 |\n"));
  json saving = oldSample();
  saving["saved"][0]["needed"]["ms"] = 1.5;
  EXPECT_THAT(handoutText(saving, ""), HasSubstr("| 1.50 ms of 3.00 ms |\n"));
  EXPECT_EQ(handoutText(oldSample(), "shadow"), "");
  EXPECT_EQ(handoutText(oldSample(), ""),
            "| part | against | its cost in a frame | grows with the power |\n"
            "| --- | --- | --- | ---: |\n"
            "| mirror | pixels | 1: 1.00 ms, 2: 2.50 ms | 1.32 |\n\n"
            "| scene | passes | memory | a frame's time |\n| --- | ---: | ---: | ---: |\n"
            "| no mirror | 2 of 2 | 1.0 of 1.0 MiB | no less (3.00 ms and 3.00 ms) |\n");
}

TEST(TradeoffAdopted, AChartStandsAlone) {
  const Measured measured = sample();
  const std::string svg = chartSvg(measured, findingsOf(measured, {}));
  EXPECT_THAT(svg,
              testing::StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\""));
  EXPECT_THAT(svg, HasSubstr(">fast</text>"));
  EXPECT_THAT(svg, HasSubstr(">accurate, reference</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("var(--")));
}

TEST(TradeoffCompare, NamedSettingsStandSideBySide) {
  Measured measured = sample();
  // The second isn't on the front; what the first doesn't say doesn't matter to it.
  measured.sweep.compare = {{"large", {{"size", 256}}}, {"unclipped", {{"clip", 0}, {"size", 64}}}};
  const Findings findings = findingsOf(measured, {});
  ASSERT_EQ(findings.compared.size(), 2u);
  EXPECT_EQ(measured.points[findings.compared[0].point].setting["size"], 256);
  EXPECT_EQ(measured.points[findings.compared[1].point].setting, json({{"clip", 0}, {"size", 64}}));
  const json figures = {{"format", kFormat}, {"sweeps", {jsonOf(measured, findings)}}};
  EXPECT_THAT(handoutText(figures, "mirror"),
              HasSubstr("| setting | time of this part | RMSE, edges left out | edge \"RMSE\" |\n"
                        "| --- | ---: | ---: | ---: |\n"
                        "| large | 16.1 ms | 0.39% | 0.78% |\n"
                        "| unclipped | 1.00 ms | 11.6% | 3.1% |\n"));
  PageAssignment page{"floor", "The floor", {measured}, {findings}, {}, {}, {}, {}, false};
  const std::string html = tradeoffPage({page});
  EXPECT_THAT(html, HasSubstr("Side by side"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">unclipped</th>"));
  page.findings[0].compared.clear();
  EXPECT_THAT(tradeoffPage({page}), Not(HasSubstr("Side by side")));
}

TEST(TradeoffPage, ShowsFrontPresetsAndCurves) {
  PageAssignment page{"floor", "The floor",           {sample()}, {},   {},
                      {},      {{"compiler", "c++"}}, {},         false};
  page.findings = {findingsOf(page.measured[0], {4.6, {}})};
  page.growth = {{"mirror",
                  "pixels",
                  {1, 2, 4},
                  {{1, 1, 1, 3, true}, {2, 2, 2, 3, true}, {4, 0, 4, 3, true}},
                  growthOf({1, 2, 4}, {1, 2, 4})}};
  page.saved = {{"nothing <glows>", {2, 1 << 20, 3}, {13, 4 << 20, 30}, {27, 26, 28, 30, true}}};
  Image& first = page.measured[0].points[page.findings[0].front[0]].rendered = Image(30, 20, 3);
  for (std::size_t i = 0; i < 1800; ++i) first.values()[i] = float(i * i * 7919 % 256) / 255;
  const std::string html = tradeoffPage({page});
  const std::string picture = report::pngDataUri(first);
  EXPECT_GT(picture.size(), 400u) << "longer than a line of text may be";
  EXPECT_THAT(html, HasSubstr("<img src=\"" + picture + "\""));
  EXPECT_THAT(html, HasSubstr("The error falls with size: from 1.6% at 64 to 0.39% at 256."));
  EXPECT_THAT(
      html,
      HasSubstr("The error falls with clip: from 11.6% at 0 to 1.6% at 1. What sinks shows."));
  EXPECT_THAT(html, HasSubstr("Not everything has been measured"));
  EXPECT_THAT(html, HasSubstr("at most 4.60 ms"));
  EXPECT_THAT(html, HasSubstr("{&quot;quality&quot;:{&quot;clip&quot;:1,&quot;size&quot;:128}}"));
  EXPECT_THAT(html, HasSubstr("<td>pixels</td><td>1: 1.00 ms, 2: 2.00 ms, 4: below 4 ms</td><td "
                              "class=\"number\">1.00</td>"));
  EXPECT_THAT(html, HasSubstr("nothing &lt;glows&gt;"));
  EXPECT_THAT(html,
              HasSubstr("2 of 13</td><td class=\"number\">1.0 MiB of 4.0 MiB</td><td "
                        "class=\"number\">3.00 ms of 30.0 ms</td><td class=\"number\">27.0 ms<"));
  // What the part's trade is comes first.
  const std::size_t trade =
      html.find("Between fast (1.10 ms, error 1.6%) and reference (16.1 ms, ");
  ASSERT_NE(trade, html.npos);
  EXPECT_LT(trade, html.find("How it was measured"));
  EXPECT_THAT(html, HasSubstr("id=\"trade-mirror-sharp-title\""));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">accurate, reference<span class=\"soft\">the "
                              "fastest within 10% of the least error; every number at its highest "
                              "quality</span></th>"));
  EXPECT_THAT(html, Not(HasSubstr("known less well")));
  page.measured[0].points[0].cost.narrow = false;
  EXPECT_THAT(tradeoffPage({page}), HasSubstr("Of 1 of 6 settings the cost is known less well"));
  EXPECT_THAT(html, Not(HasSubstr("{{")));
  EXPECT_THAT(html, Not(HasSubstr("http://")));
}

} // namespace
