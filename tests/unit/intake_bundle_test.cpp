#include "intake/bundle.hpp"

#include <gmock/gmock.h>

#include <sstream>

namespace ggrade::intake {
namespace {

using testing::HasSubstr;

std::string bundleOf(const std::vector<Entry>& entries) {
  std::ostringstream out;
  writeBundleMark(out);
  for (const Entry& entry : entries) writeEntry(out, entry);
  writeEntry(out, {.name = "", .kind = Kind::end});
  return out.str();
}

Entry file(std::string_view name, std::string_view bytes) {
  return {.name = name, .modified = -7, .size = bytes.size(), .bytes = bytes};
}

/// Why `bundle` is refused.
std::string refusal(const std::string& bundle, const Limits& limits = kUploadLimits) {
  try {
    readBundle(bundle, limits);
    return "(accepted)";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Bundle, ComesBackAsItWasWritten) {
  const std::string bytes("a\0b", 3);
  const std::string bundle = bundleOf({file("floor.cpp", bytes),
                                       {.name = "link", .kind = Kind::symbolicLink},
                                       {.name = "big", .kind = Kind::tooLarge, .size = 1ull << 40},
                                       file("", "")});
  const std::vector<Entry> entries = readBundle(bundle, kUploadLimits);
  ASSERT_EQ(entries.size(), 4u);
  EXPECT_EQ(entries[0].name, "floor.cpp");
  EXPECT_EQ(entries[0].kind, Kind::file);
  EXPECT_EQ(entries[0].modified, -7);
  EXPECT_EQ(entries[0].bytes, bytes);
  EXPECT_EQ(entries[1].kind, Kind::symbolicLink);
  EXPECT_EQ(entries[2].size, 1ull << 40);
  EXPECT_EQ(entries[3].bytes, "");
}

TEST(Bundle, IsLittleEndianAsDocumented) {
  EXPECT_EQ(bundleOf({}), "GGBUNDL1" + std::string(4, '\0') + '\x0B' + std::string(16, '\0'));
  const std::string one = bundleOf({file("n", "xyz")});
  EXPECT_EQ(one.substr(8, 29), std::string("\1\0\0\0n\0\xF9\xFF\xFF\xFF\xFF\xFF\xFF\xFF\3\0\0\0"
                                           "\0\0\0\0xyz\0\0\0\0",
                                           29));
}

TEST(Bundle, IsRefusedCutAnywhereAndWithAnythingBehind) {
  const std::string whole = bundleOf({file("floor.cpp", "int main;")});
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THAT(refusal(whole.substr(0, length)), HasSubstr("are left")) << length;
  EXPECT_EQ(refusal(whole + "x"), "something follows its end");
  EXPECT_EQ(refusal("GGBUNDL2" + whole.substr(8)), "it is no bundle");
}

TEST(Bundle, ClaimsBeyondTheLimitsAreRefused) {
  Limits limits;
  limits.entries = 2;
  limits.clutter = 1;
  limits.bytes = 10;
  limits.fileBytes = 8;
  const Entry clutter{.name = ".git", .kind = Kind::clutter};
  EXPECT_EQ(refusal(bundleOf({file("a", "12345678"), file("b", "90"), clutter}), limits),
            "(accepted)");
  EXPECT_EQ(refusal(bundleOf({file("a", "123456789")}), limits),
            "a file beyond the limit, of bytes: 9");
  EXPECT_EQ(refusal(bundleOf({file("a", "12345678"), file("b", "901")}), limits),
            "it holds more bytes than allowed");
  EXPECT_EQ(refusal(bundleOf({file("a", ""), file("b", ""), file("c", "")}), limits),
            "it holds more entries than allowed");
  EXPECT_EQ(refusal(bundleOf({clutter, clutter}), limits), "it holds more entries than allowed");
}

TEST(Bundle, NumbersThatOverflowAreRefused) {
  std::string bundle = bundleOf({file("n", "xyz")});
  std::string size = bundle;
  size.replace(8 + 14, 8, 8, '\xFF');
  EXPECT_EQ(refusal(size), "a file beyond the limit, of bytes: 18446744073709551615");
  std::string name = bundle;
  name.replace(8, 4, 4, '\xFF');
  EXPECT_EQ(refusal(name), "a name of bytes: 4294967295");
  std::string kind = bundle;
  kind[8 + 5] = '\x0C';
  EXPECT_EQ(refusal(kind), "unknown kind of entry: 12");
}

TEST(Bundle, CutsNamesToWhatIsReadable) {
  const std::string name(100000, 'n');
  const std::string bundle = bundleOf({file(name, "x")});
  EXPECT_EQ(readBundle(bundle, kUploadLimits).at(0).name.size(), kLongestPath);
}

} // namespace
} // namespace ggrade::intake
