#include "in_japanese.hpp"
#include "report/chart.hpp"
#include "report/page.hpp"
#include "report/text.hpp"

#include <gmock/gmock.h>

namespace ggrade::report {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

std::string rendered(const char* body, const json& data) {
  return renderPage({body, "", "", ""}, data, "Title");
}

TEST(Page, AsksWhetherThereIsAnyText) {
  const char* body = "{{#a}}some{{/a}}{{^a}}none{{/a}}";
  EXPECT_EQ(rendered(body, {{"a", "text"}}), "some");
  EXPECT_EQ(rendered(body, {{"a", ""}}), "none");
  EXPECT_EQ(rendered(body, {{"a", nullptr}}), "none");
  EXPECT_EQ(rendered(body, {{"a", false}}), "none");
  EXPECT_EQ(rendered(body, {{"a", json::array()}}), "none");
  EXPECT_EQ(rendered(body, {{"a", 0}}), "some") << "a number is text";
}

TEST(Page, NumbersAreWrittenAsPeopleDo) {
  EXPECT_EQ(rendered("{{a}} {{b}} {{c}} {{d}}", {{"a", 61.50}, {"b", 3.0}, {"c", 7u}, {"d", -2}}),
            "61.5 3 7 -2");
}

TEST(Page, TextIsEscapedAndSanitized) {
  EXPECT_EQ(rendered("{{a}}|{{{a}}}", {{"a", "<b>\x1B[31m\xE2\x80\xAE"
                                             "&"}}),
            "&lt;b&gt;\xEF\xBF\xBD&amp;|<b>\xEF\xBF\xBD&");
  EXPECT_EQ(rendered("{{a}}", {{"a", "{{b}}"}, {"b", "text"}}), "{{b}}") << "no template";
}

TEST(Page, AListHoldsObjectsOrText) {
  EXPECT_EQ(rendered("{{#rows}}{{id}}{{#words}} {{.}}{{/words}};{{/rows}}",
                     {{"rows",
                       {{{"id", 1}, {"words", linesOf({"a\nb", "c"})}},
                        {{"id", 2}, {"words", json::array()}}}}}),
            "1 a b c;2;");
}

TEST(Page, SaysItsTextsInTheReadersLanguage) {
  const InJapanese japanese;
  const PageKind kind{"{{lang}} {{#say}}Items{{/say}}", "", "", "", true};
  EXPECT_EQ(renderPage(kind, json::object(), ""), "ja 評価項目");
}

TEST(Page, ABrokenTemplateIsNoPage) {
  EXPECT_THROW(rendered("{{#a}}", json::object()), std::logic_error);
}

TEST(ChartAxis, IsLinearInStepsOfOneTwoOrFive) {
  const Axis axis = Axis::linear(0, 7.3, 100, 200);
  EXPECT_THAT(axis.ticks(), ElementsAre(0, 2, 4, 6, 8));
  EXPECT_DOUBLE_EQ(axis.at(2), 125);
  EXPECT_THAT(Axis::linear(-3, 11, 0, 1).ticks(), ElementsAre(-5, 0, 5, 10, 15));
  EXPECT_THAT(Axis::linear(0, 0, 0, 1).ticks().size(), testing::Ge(2u)) << "of nothing, too";
}

TEST(ChartAxis, IsLogarithmicBetweenRoundValues) {
  const Axis axis = Axis::logarithmic({0.3, 4}, 0, 100);
  ASSERT_EQ(axis.ticks().size(), 5u); // 0.2, 0.5, 1, 2, 5
  EXPECT_NEAR(axis.ticks().front(), 0.2, 1e-12);
  EXPECT_NEAR(axis.ticks().back(), 5, 1e-12);
  EXPECT_NEAR(axis.at(1), 50, 1e-9);
  EXPECT_EQ(axis.at(0), 0) << "no logarithm: at the beginning";
  EXPECT_EQ(Axis::logarithmic({1, 10'000}, 0, 1).ticks().size(), 5u) << "the powers alone";
}

TEST(Chart, EscapesItsTextsAndRoundsToATenth) {
  Chart chart({0, 10, 0, 10});
  chart.dot("best", 1.26, 2, 3.5, "a < b");
  chart.path("front", {{0, 0.04}, {10, 9.96}});
  chart.text("tick", 1, 2, "end", "<5");
  EXPECT_EQ(chart.svg("plot", 20, 10, "\"x\""),
            "<svg class=\"plot\" viewBox=\"0 0 20 10\" role=\"img\" aria-label=\"&quot;x&quot;\">"
            "<circle class=\"best\" cx=\"1.3\" cy=\"2\" r=\"3.5\"><title>a &lt; b</title></circle>"
            "<polyline class=\"front\" points=\"0,0 10,10\"/>"
            "<text class=\"tick\" x=\"1\" y=\"2\" text-anchor=\"end\">&lt;5</text></svg>");
  EXPECT_THAT(chart.svg("plot", 20, 10, "id", "Title", "Words"),
              HasSubstr("aria-labelledby=\"id-title id-desc\"><title id=\"id-title\">Title</title>"
                        "<desc id=\"id-desc\">Words</desc>"));
}

} // namespace
} // namespace ggrade::report
