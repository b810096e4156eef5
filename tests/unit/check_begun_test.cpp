#include "check/begun.hpp"

#include <gmock/gmock.h>

using ggrade::check::begunIn;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

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
