#include "shader_log.hpp"

#include <gtest/gtest.h>

namespace {

using gg::detail::ShaderSource;
using gg::detail::translateLog;

const ShaderSource kSource{
    "",
    {{"a.frag", {"#version 410 core", "#include \"b.glsl\"", "\toColor = foo;"}},
     {"b.glsl", {"float x = y;"}}}};

TEST(ShaderLog, MesaGivesFileLineColumnAndCaret) {
  EXPECT_EQ(translateLog("0:3(11): error: `foo' undeclared\n", kSource),
            "a.frag:3:11: error: `foo' undeclared\n"
            "\toColor = foo;\n"
            "\t         ^\n");
}

TEST(ShaderLog, MesaCountsARunOfBlanksAsOneColumn) {
  const ShaderSource source{"", {{"a.frag", {"    a  =  \t b;"}}}};
  EXPECT_EQ(translateLog("0:1(6): error: x\n", source), "a.frag:1:13: error: x\n"
                                                        "    a  =  \t b;\n"
                                                        "          \t ^\n");
}

TEST(ShaderLog, NumbersOfAnIncludedFileLeadToIt) {
  EXPECT_EQ(translateLog("0:10001(11): error: `y' undeclared\n", kSource),
            "b.glsl:1:11: error: `y' undeclared\n"
            "float x = y;\n"
            "          ^\n");
}

TEST(ShaderLog, MesaPreprocessorErrorsAreErrors) {
  EXPECT_EQ(translateLog("0:3(2): preprocessor error: bad token\n", kSource),
            "a.frag:3:2: error: bad token\n\toColor = foo;\n\t^\n");
}

TEST(ShaderLog, NvidiaGivesNoColumn) {
  EXPECT_EQ(translateLog("0(3) : error C1503: undefined variable \"foo\"\n", kSource),
            "a.frag:3: error: undefined variable \"foo\"\n\toColor = foo;\n");
}

TEST(ShaderLog, AppleAmdAndIntelGiveNoColumn) {
  EXPECT_EQ(translateLog("ERROR: 0:10001: Use of undeclared identifier 'y'\r\n", kSource),
            "b.glsl:1: error: Use of undeclared identifier 'y'\nfloat x = y;\n");
  EXPECT_EQ(translateLog("WARNING: 0:3: 'foo' : unused\n", kSource),
            "a.frag:3: warning: 'foo' : unused\n\toColor = foo;\n");
}

TEST(ShaderLog, UnknownLinesStay) {
  EXPECT_EQ(translateLog("2 compilation errors. No code generated.\n\n", kSource),
            "2 compilation errors. No code generated.\n");
}

TEST(ShaderLog, ANumberBeyondTheFilesLosesOnlyThePosition) {
  EXPECT_EQ(translateLog("0:70003(1): error: strange\n", kSource), "error: strange\n");
  EXPECT_EQ(translateLog("0:10009(1): error: past the end\n", kSource),
            "b.glsl:9:1: error: past the end\n");
}

TEST(ShaderLog, OnlyWarningsOfAShaderThatCompiled) {
  constexpr bool kOnlyWarnings = true;
  EXPECT_EQ(translateLog("No errors.\n0:3(2): warning: `foo' used uninitialized\n", kSource,
                         kOnlyWarnings),
            "a.frag:3:2: warning: `foo' used uninitialized\n\toColor = foo;\n\t^\n");
  EXPECT_EQ(translateLog("No errors.\n", kSource, kOnlyWarnings), "");
}

TEST(ShaderLog, StopsAfterTwentyMessages) {
  std::string log;
  for (int i = 0; i < 500; ++i) log += "0:10001(1): error: again\n";
  const std::string text = translateLog(log, kSource);
  std::size_t count = 0;
  for (std::size_t at = text.find("again"); at != text.npos; at = text.find("again", at + 1))
    ++count;
  EXPECT_EQ(count, 20u);
}

TEST(ShaderLog, AVeryLongLineIsNoTrouble) {
  const std::string line(1000000, '1');
  EXPECT_EQ(translateLog(line, kSource), line + "\n");
}

} // namespace
