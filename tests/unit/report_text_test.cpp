#include "report/text.hpp"

#include <gmock/gmock.h>

namespace ggrade::report {
namespace {

using testing::HasSubstr;

TEST(Sanitize, KeepsPlainAndJapaneseTextWithTabsAndLineEnds) {
  EXPECT_EQ(sanitize("a\tb\n影 ✓ 🙂"), "a\tb\n影 ✓ 🙂");
}

TEST(Sanitize, ReplacesEveryByteThatIsNotUtf8) {
  EXPECT_EQ(sanitize("a\xFF"
                     "b"),
            "a\uFFFDb");
  EXPECT_EQ(sanitize("\xC0\xAF"), "\uFFFD\uFFFD") << "overlong slash";
  EXPECT_EQ(sanitize("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD") << "surrogate";
  EXPECT_EQ(sanitize("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD") << "above U+10FFFF";
  EXPECT_EQ(sanitize("\xE5\xBD"), "\uFFFD\uFFFD") << "cut in the middle";
  EXPECT_EQ(sanitize("\x8E\x9F"), "\uFFFD\uFFFD") << "Shift_JIS";
}

TEST(Sanitize, TakesOutTerminalSequences) {
  EXPECT_EQ(sanitize("\x1B[1;31merror\x1B[0m"), "error");
  EXPECT_EQ(sanitize("\x1B]0;title\a"
                     "text"),
            "text");
  EXPECT_EQ(sanitize("\x1B]8;;http://x\x1B\\link"), "link");
  EXPECT_EQ(sanitize("\x1B]never ended\nshown"), "\nshown");
  EXPECT_EQ(sanitize("\x1B"), "");
  EXPECT_EQ(sanitize("\x1B["), "");
  EXPECT_EQ(sanitize("\x1B影"), "影");
}

TEST(Sanitize, ReplacesControlAndDirectionCharacters) {
  EXPECT_EQ(sanitize(std::string("a\0b\x07\x7F", 5)), "a\uFFFDb\uFFFD\uFFFD");
  EXPECT_EQ(sanitize("\u202Egnp.exe\u2066\u200F\u061C"), "\uFFFDgnp.exe\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(sanitize("\u0085\u2028\uFEFF\uFFFE\U000E0041"), "\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD");
}

TEST(Sanitize, MakesLineEndsUnix) {
  EXPECT_EQ(sanitize("a\r\nb\rc\r"), "a\nb\nc\n");
}

TEST(SanitizeLine, JoinsWhiteSpaceAndCutsBetweenCodePoints) {
  EXPECT_EQ(sanitizeLine(" a\n\n b\tc "), "a b c");
  EXPECT_EQ(sanitizeLine("影影影", 2), "影影…");
  EXPECT_EQ(sanitizeLine("abc", 3), "abc");
}

TEST(Capped, KeepsHeadAndTailAndSaysWhatIsMissing) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "line " + std::to_string(i) + "\n";
  const std::string cut = capped(text, 2000);
  EXPECT_LT(cut.size(), 2100u);
  EXPECT_THAT(cut, testing::StartsWith("line 0\n"));
  EXPECT_THAT(cut, testing::EndsWith("line 999\n"));
  EXPECT_THAT(cut, HasSubstr(" of 8890 bytes are left out here"));
  EXPECT_EQ(capped("short", 2000), "short");
}

TEST(Capped, NeverCutsACodePoint) {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += "影";
  for (std::size_t limit = 1000; limit < 1004; ++limit) {
    const std::string cut = capped(text, limit);
    EXPECT_EQ(sanitize(cut), cut);
    EXPECT_LT(cut.size(), limit + 100);
  }
}

TEST(EscapeXml, EscapesAllFiveAndSanitizes) {
  EXPECT_EQ(escapeXml("<a b=\"c\" d='e'>&\x01"),
            "&lt;a b=&quot;c&quot; d=&#39;e&#39;&gt;&amp;\uFFFD");
}

TEST(EncodePath, LeavesNoSchemeQueryOrFragment) {
  EXPECT_EQ(encodePath("a/b c.html"), "a/b%20c.html");
  EXPECT_EQ(encodePath("javascript:x?#\"<"), "javascript%3Ax%3F%23%22%3C");
  EXPECT_EQ(encodePath("影"), "%E5%BD%B1");
}

TEST(Number, WritesAsAPersonWould) {
  EXPECT_EQ(number(12), "12");
  EXPECT_EQ(number(12.50), "12.5");
  EXPECT_EQ(number(1.0 / 3), "0.33");
  EXPECT_EQ(number(-0.001), "0");
  EXPECT_EQ(number(100, 0), "100");
  EXPECT_EQ(number(1e300 * 1e300), "?");
}

TEST(Percent, NeverRoundsADifferenceAway) {
  EXPECT_EQ(percent(0), "0%");
  EXPECT_EQ(percent(1), "100%");
  EXPECT_EQ(percent(0.314), "31.4%");
  EXPECT_EQ(percent(1e-6), "<0.1%");
  EXPECT_EQ(percent(0.9999), ">99.9%");
}

TEST(DisplayWidth, CountsColumns) {
  EXPECT_EQ(displayWidth("abc"), 3u);
  EXPECT_EQ(displayWidth("田中"), 4u);
  EXPECT_EQ(displayWidth("e\u0301"), 1u);
  EXPECT_EQ(displayWidth("か\u3099"), 2u) << "a Mac's decomposed file name";
}

} // namespace
} // namespace ggrade::report
