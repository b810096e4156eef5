#include "capture/checker.hpp"

#include <gtest/gtest.h>

namespace ggrade::channel {
namespace {

constexpr char kBad[] = "\xEF\xBF\xBD";

TEST(SanitizedUtf8, KeepsText) {
  const std::string text = "GL_INVALID_ENUM\tin\nglEnable: \xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80";
  EXPECT_EQ(sanitizedUtf8(text), text);
  EXPECT_EQ(sanitizedUtf8(""), "");
}

TEST(SanitizedUtf8, ReplacesControlCharacters) {
  EXPECT_EQ(sanitizedUtf8("a\x1B[31m"), std::string("a") + kBad + "[31m");
  EXPECT_EQ(sanitizedUtf8("\x7F"), kBad);
  EXPECT_EQ(sanitizedUtf8("\xC2\x9B"), kBad);
  EXPECT_EQ(sanitizedUtf8("\xC2\xA0"), "\xC2\xA0");
  EXPECT_EQ(sanitizedUtf8(std::string_view("a\0b", 3)), std::string("a") + kBad + "b");
}

TEST(SanitizedUtf8, ReplacesBytesThatAreNoCharacter) {
  const std::string one = kBad;
  EXPECT_EQ(sanitizedUtf8("\xFFx"), one + "x");
  EXPECT_EQ(sanitizedUtf8("\x80"), one);
  EXPECT_EQ(sanitizedUtf8("\xC3"), one) << "cut short";
  EXPECT_EQ(sanitizedUtf8("\xE2\x82"), one + one) << "cut short";
  EXPECT_EQ(sanitizedUtf8("\xC0\x80"), one + one) << "overlong";
  EXPECT_EQ(sanitizedUtf8("\xE0\x80\x80"), one + one + one) << "overlong";
  EXPECT_EQ(sanitizedUtf8("\xED\xA0\x80"), one + one + one) << "surrogate";
  EXPECT_EQ(sanitizedUtf8("\xF4\x90\x80\x80"), one + one + one + one) << "above U+10FFFF";
}

} // namespace
} // namespace ggrade::channel
