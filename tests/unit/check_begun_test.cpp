#include "check/begun.hpp"

#include <gmock/gmock.h>

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

std::set<std::string> begunIn(std::string_view stub, std::string_view text) {
  return ggrade::check::begunIn(stub, text).certain;
}
std::set<std::string> possiblyBegunIn(std::string_view stub, std::string_view text) {
  return ggrade::check::begunIn(stub, text).possible;
}

const std::string kStub = R"(#include <gg/gg.hpp>

// TODO(mirror.1): make the framebuffer object.
//   Do: storage.
inline void make() {
  size = 1;
}

void frame() {
  // TODO(mirror.2): draw into it.
  // TODO(mirror.3): cull the front faces.
  draw();
  // TODO(mirror.3) and TODO(mirror.2) end here.
  swap();
}
)";

std::string with(const std::string& after, const std::string& added) {
  std::string text = kStub;
  text.insert(text.find(after) + after.size(), "\n" + added);
  return text;
}

TEST(CheckBegun, NothingIsBegunInTheFileAsItWasHandedOut) {
  EXPECT_THAT(begunIn(kStub, kStub), IsEmpty());
}

TEST(CheckBegun, ALineBelongsToTheTodoAboveIt) {
  EXPECT_THAT(begunIn(kStub, with("size = 1;", "  glGenTextures(1, &t);")),
              ElementsAre("mirror.1"));
  EXPECT_THAT(begunIn(kStub, with("draw into it.", "  bind();")), ElementsAre("mirror.2"));
  EXPECT_THAT(begunIn(kStub, with("front faces.", "  cull();")), ElementsAre("mirror.3"));
  EXPECT_THAT(begunIn(kStub, with("draw();", "  again();")), ElementsAre("mirror.3"));
}

TEST(CheckBegun, AChangedLineCounts) {
  std::string text = kStub;
  text.replace(text.find("size = 1"), 8, "size = 2");
  EXPECT_THAT(begunIn(kStub, text), ElementsAre("mirror.1"));
}

TEST(CheckBegun, AStatementRightAboveATodoIsChangedForIt) {
  const std::string stub = "void main() {\n"
                           "  vec3 normal = uNormal * aNormal;\n"
                           "  // TODO(mirror.5): negate it.\n"
                           "  gl_Position = vec4(0);\n"
                           "  // TODO(mirror.6): clip.\n"
                           "}\n";
  const auto now = [&](const std::string& from, const std::string& to) {
    std::string text = stub;
    return begunIn(stub, text.replace(text.find(from), from.size(), to));
  };
  EXPECT_THAT(now("= uNormal * aNormal", "= -(uNormal * aNormal)"), ElementsAre("mirror.5"));
  EXPECT_THAT(now("vec4(0)", "vec4(0, 0, 0, 1)"), ElementsAre("mirror.6"));
  // What is added there is the work of whoever's place it is.
  EXPECT_THAT(now("vec4(0);\n", "vec4(0);\n  normal = -normal;\n"), ElementsAre("mirror.5"));
  EXPECT_THAT(now("void main() {\n", "void main() {\n  int i = 0;\n"), IsEmpty());
}

TEST(CheckBegun, APlaceEndsWhereOneComesFilledIn) {
  const std::string stub =
      "// TODO(shadow.4): ask it.\n// DONE(mirror.2): draw into it.\nbind();\n";
  EXPECT_THAT(begunIn(stub, stub + "unbind();\n"), ElementsAre("mirror.2"));
}

TEST(CheckBegun, APlaceOfSeveralTodosIsNobodys) {
  EXPECT_THAT(begunIn(kStub, with("end here.", "  cull(back);")), IsEmpty());
  EXPECT_THAT(begunIn(kStub, with("#include <gg/gg.hpp>", "#include <vector>")), IsEmpty());
}

const std::string kVisibility = R"(float visibility(vec3 world) {
  // TODO(shadow.4): ask the map, uShadowMap.
  //   Given: `world`.
  // TODO(shadow.6): bonus: if uShadowBias is 3, move the point along uNormal.
  // Then TODO(shadow.4) goes on.
  // TODO(shadow.5): bonus: if uPcfRadius > 0, the mean of uShadowMap.
  // Then TODO(shadow.4) goes on.
  return 1.0;
}
)";
const std::string kAll = "  world += uShadowBias;\n  float sum = texture(uShadowMap);\n"
                         "  for (int i = -uPcfRadius; i < 3; ++i) sum += 1;\n  return sum;\n";

TEST(CheckBegun, WhatIsWrittenBelowTheLastCommentIsKnownByItsNames) {
  std::string text = kVisibility;
  text.replace(text.find("  return 1.0;\n"), 14, kAll);
  EXPECT_THAT(begunIn(kVisibility, text), ElementsAre("shadow.4", "shadow.5", "shadow.6"));
}

TEST(CheckBegun, CommentsThatAreGoneAreNoEvidence) {
  const std::size_t first = kVisibility.find("  // TODO(shadow.4)"),
                    end = kVisibility.find("  ret");
  std::string text = kVisibility;
  text.erase(first, end - first);
  EXPECT_THAT(begunIn(kVisibility, text), IsEmpty());
  EXPECT_THAT(possiblyBegunIn(kVisibility, text), IsEmpty());
  text.replace(text.find("  return 1.0;\n"), 14, "  return ask(world);\n");
  EXPECT_THAT(begunIn(kVisibility, text), IsEmpty()) << "whose is it?";
  EXPECT_THAT(possiblyBegunIn(kVisibility, text), ElementsAre("shadow.4", "shadow.5", "shadow.6"));
  text.replace(text.find("  return ask(world);\n"), 21, kAll);
  EXPECT_THAT(begunIn(kVisibility, text), ElementsAre("shadow.5", "shadow.6"));
  EXPECT_THAT(possiblyBegunIn(kVisibility, text), ElementsAre("shadow.4"));
}

TEST(CheckBegun, AnotherLayoutIsNoWork) {
  std::string text = kStub;
  text.replace(text.find("void frame() {"), 14, "void frame()\n{");
  text.replace(text.find("  size = 1;"), 11, "  size\n   =\n 1 ; // one");
  text.replace(text.find("  swap();"), 9, "  /* at last */ swap();");
  EXPECT_THAT(begunIn(kStub, text), IsEmpty());
  EXPECT_THAT(possiblyBegunIn(kStub, text), IsEmpty());
  text.replace(text.find("draw into it"), 0, "I do ");
  EXPECT_THAT(begunIn(kStub, text), IsEmpty()) << "a comment that was written into";
}

// The second byte of some characters is a backslash: at a line's end it swallows the next line, for
// the compiler and here.
TEST(CheckBegun, ShiftJis) {
  const std::string stub = "// TODO(mirror.1): \x95\x5C\x8E\xA6\x82\xB7\x82\xE9\nint a = 1;\n";
  EXPECT_THAT(begunIn(stub, stub), IsEmpty());
  EXPECT_THAT(begunIn(stub, stub + "int b; // \x95\x5C\nint c;\n"), ElementsAre("mirror.1"));
  EXPECT_THAT(begunIn("// TODO(mirror.1): x \x95\x5C\nint a;\n", "int a;\n"),
              ElementsAre("mirror.1"));
}

TEST(CheckBegun, AGivenStatementThatStandsElsewhereIsNoWork) {
  std::string text = kStub;
  text.erase(text.find("  swap();\n"), 10);
  text.insert(text.find("  // TODO(mirror.2): draw"), "  swap();\n");
  EXPECT_THAT(begunIn(kStub, text), IsEmpty());
  text.insert(text.find("  // TODO(mirror.3): cull"), "  swap();\n");
  EXPECT_THAT(begunIn(kStub, text), ElementsAre("mirror.2")) << "a second one";
}

// As files of another edition of the kit have it.
TEST(CheckBegun, ATodoOfAnotherFileMayBeBegun) {
  const std::string now = "int b;\n// TODO(mirror.4): draw.\ndraw(b);\n";
  EXPECT_THAT(begunIn("int b;\n", now), IsEmpty());
  EXPECT_THAT(possiblyBegunIn("int b;\n", now), ElementsAre("mirror.4"));
  EXPECT_THAT(possiblyBegunIn("int b;\ndraw(b);\n", now), IsEmpty()) << "it was handed out";
}

TEST(CheckBegun, BrokenTextEndsAnywhere) {
  for (const char* text : {"", "//", "/*", "/* TODO(a.1)", "\"", "'", "#", "#\\", "\\", "a\"b",
                           "// TODO(a.1)\\", "\"\\", "// \\\r\n", "1'000'000", "/", "#\nint a;"})
    for (const std::string& stub : {kStub, std::string(text)}) begunIn(stub, text);
}

TEST(CheckBegun, WhiteSpaceAndCommentsTakenOutAreNoWork) {
  std::string text = kStub;
  for (std::size_t at = 0; (at = text.find("  ", at)) != text.npos; at += 1)
    text.replace(at, 2, "\t");
  EXPECT_THAT(begunIn(kStub, text), IsEmpty());
  text = kStub;
  text.erase(text.find("//   Do: storage.\n"), 18);
  EXPECT_THAT(begunIn(kStub, text), IsEmpty());
  text = kStub;
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2)
    text.replace(at, 1, "\r\n");
  EXPECT_THAT(begunIn(kStub, text), IsEmpty());
}

} // namespace
