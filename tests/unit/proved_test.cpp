// Proved causes in words.

#include "diagnosis/proved.hpp"

#include <gmock/gmock.h>

using namespace ggrade;
using diagnosis::nameOf;
using diagnosis::sentenceOf;
using testing::HasSubstr;

namespace {

TEST(Proved, UnitsInWords) {
  EXPECT_EQ(nameOf({{0}, "", "viewport", {}}), "the viewport");
  EXPECT_EQ(nameOf({{0}, "", "uniform uView", {}}), "the uniform uView");
  EXPECT_EQ(nameOf({{0}, "", "function visibility in fragment", {}}),
            "visibility() in the fragment shader");
  EXPECT_EQ(nameOf({{0}, "", "lines mirror.5 of main in vertex", {}}),
            "what stands below TODO(mirror.5) in main() of the vertex shader");
  EXPECT_EQ(nameOf({{0}, "", "clipDistance0", {}}), "the clipping");
  EXPECT_EQ(nameOf({{0}, "", "lineWidth", {}}), "OpenGL's state lineWidth");
}

TEST(Proved, SaysWhereAndWhatWasSpoiled) {
  EXPECT_EQ(sentenceOf({{{0}, "", "clear", {"mirror.2"}}}),
            "Proved by drawing it again: with nothing changed but this in pass 1, all is right: "
            "what is cleared, and to what.");
  EXPECT_EQ(sentenceOf({{{1}, "", "viewport", {}}}),
            "Proved by drawing it again: with nothing changed but this in pass 2, all is right: "
            "the viewport. The handed-out program has it right: a call of yours changes it, and "
            "doesn't put it back.");
  EXPECT_EQ(
      sentenceOf(
          {{{0}, "", "clear", {"a.1"}}, {{1}, "", "depth", {"a.2"}}, {{1}, "", "blend", {"a.2"}}}),
      "Proved by drawing it again: with nothing changed but this, all is right: what is "
      "cleared, and to what in pass 1, the depth test in pass 2 and the blending in pass 2.");
  EXPECT_EQ(sentenceOf({{{1}, "", "function comparison in fragment", {}}}),
            "Proved by drawing it again: with nothing changed but this in pass 2, all is right: "
            "comparison() in the fragment shader. The handed-out program has it right: a line of "
            "it was changed.");
}

TEST(Proved, WhatIsNotDrawnIsCalledSo) {
  EXPECT_EQ(nameOf({{0}, "", "draws", {"mirror.4"}}), "what is drawn");
  EXPECT_EQ(nameOf({{}, "", "draws", {"mirror.4"}, true}), "what isn't drawn yet");
}

TEST(Proved, WhatHasOneNameIsNamedOnce) {
  EXPECT_EQ(sentenceOf({{{0}, "", "uniform uSize", {"bloom.3"}},
                        {{}, "bloom.5", "draws", {"bloom.5"}, true},
                        {{}, "bloom.6", "draws", {"bloom.6"}, true}}),
            "Proved by drawing it again: with nothing changed but this, all is right: the uniform "
            "uSize in pass 1 and what isn't drawn yet.");
}

TEST(Proved, OfAStateThatIsLeftBesideWorkThatLacksNoWordIsOfTheHandedOutProgram) {
  EXPECT_EQ(sentenceOf({{{1}, "", "viewport", {}}, {{0}, "", "draws", {"mirror.4"}}}),
            "Proved by drawing it again: with nothing changed but this, all is right: the viewport "
            "in pass 2 and what is drawn in pass 1.");
}

TEST(Proved, WhatIsWrongComesBeforeWhatIsNotBegun) {
  results::ProvedCause lacks{{}, "", "draws", {"mirror.4", "mirror.5"}, true};
  lacks.notBegun = lacks.todos;
  results::ProvedCause partly{{1}, "", "shader fragment", {"mirror.3", "mirror.7"}};
  partly.notBegun = {"mirror.7"};
  EXPECT_EQ(sentenceOf({lacks, partly}),
            "Proved by drawing it again: with nothing changed but this in pass 2, all is right: "
            "the fragment shader. What isn't begun yet was put in for this: mirror.4, mirror.5, "
            "mirror.7.");
  EXPECT_EQ(sentenceOf({lacks}),
            "Proved by drawing it again: with nothing changed but this, all is right: what isn't "
            "drawn yet.");
}

TEST(Proved, PassesOfOneRoleAreNamedTogether) {
  EXPECT_EQ(sentenceOf({{{4, 5, 6}, "", "blend", {"bloom.5"}}}),
            "Proved by drawing it again: with nothing changed but this in the passes 5, 6, 7, "
            "all is right: the blending.");
}

TEST(Proved, SaysWhatTheSubmissionHas) {
  results::ProvedCause cause{{0}, "", "viewport", {"mirror.2"}};
  cause.own = "0, 0, 640, 480";
  EXPECT_EQ(sentenceOf({cause}),
            "Proved by drawing it again: with nothing changed but this in pass 1, all is right: "
            "the viewport (yours: 0, 0, 640, 480).");
}

TEST(Proved, SaysThatNoTextureIsReadOrTheOneThatIsDrawnInto) {
  results::ProvedCause cause{{0}, "", "texture uGlow", {"afterglow.1"}};
  cause.own = results::kNoTexture;
  EXPECT_THAT(sentenceOf({cause}), HasSubstr("what the sampler uGlow reads (yours: no texture)."));
  cause.own = results::kDrawnInto;
  EXPECT_THAT(sentenceOf({cause}), HasSubstr("(yours: what the same pass draws into)."));
}

} // namespace
