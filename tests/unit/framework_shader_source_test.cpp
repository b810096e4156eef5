#include "shader_source.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"
#include <gg/error.hpp>
#include <gmock/gmock.h>

namespace {

using gg::detail::readShader;
using testing::ElementsAre;
using testing::HasSubstr;

class ShaderSource : public testing::Test {
protected:
  std::string messageFor(const std::string& name) {
    return messageOf<gg::ShaderError>([&] { readShader(name, folder.path()); });
  }
  TemporaryFolder folder;
};

TEST_F(ShaderSource, IncludesAreNumberedByFile) {
  folder.write("a.frag", "#version 410 core\n#include \"sub/b.glsl\"\nlast\n");
  folder.write("sub/b.glsl", "first\n  #  include <c.glsl> // twice as deep\nthird\n");
  folder.write("c.glsl", "only\n");
  const auto source = readShader("a.frag", folder.path());
  EXPECT_EQ(source.text, "#version 410 core\n"
                         "#line 10001\nfirst\n"
                         "#line 20001\nonly\n"
                         "#line 10003\nthird\n"
                         "#line 3\nlast\n");
  ASSERT_EQ(source.files.size(), 3u);
  EXPECT_EQ(source.files[1].name, "sub/b.glsl");
  EXPECT_THAT(source.files[2].lines, ElementsAre("only"));
}

TEST_F(ShaderSource, TheProgramsFolderComesBeforeTheFramework) {
  folder.write("a.frag", "#version 410 core\n#include \"gg/lighting.glsl\"\n");
  EXPECT_THAT(readShader("a.frag", folder.path()).text, HasSubstr("Lit blinnPhong("));
  folder.write("gg/lighting.glsl", "my own\n");
  EXPECT_THAT(readShader("a.frag", folder.path()).text, HasSubstr("\nmy own\n"));
}

TEST_F(ShaderSource, AFileIsIncludedOnce) {
  folder.write("a.frag", "#version 410 core\n#include \"b\"\n#include \"b\"\n");
  folder.write("b", "text\n");
  EXPECT_EQ(readShader("a.frag", folder.path()).text,
            "#version 410 core\n#line 10001\ntext\n#line 3\n#line 4\n");
}

TEST_F(ShaderSource, ACycleIsAnError) {
  folder.write("a.frag", "#version 410 core\n#include \"b\"\n");
  folder.write("b", "\n#include \"c\"\n");
  folder.write("c", "\n\n#include \"b\"\n");
  EXPECT_EQ(messageFor("a.frag"), "c:3: error: \"b\" includes itself");
  folder.write("self.frag", "#version 410 core\n#include \"self.frag\"\n");
  EXPECT_EQ(messageFor("self.frag"), "self.frag:2: error: \"self.frag\" includes itself");
}

TEST_F(ShaderSource, AMissingFileIsNamedWhereItIsAskedFor) {
  folder.write("a.frag", "#version 410 core\n\n#include \"lightning.glsl\"\n");
  EXPECT_EQ(messageFor("a.frag"),
            "a.frag:3: error: there is no file \"lightning.glsl\" beside the "
            "program, and the framework has only gg/lighting.glsl, gg/pyramid.glsl");
  EXPECT_THAT(messageFor("none.frag"),
              testing::StartsWith("none.frag: error: there is no such file in "));
}

TEST_F(ShaderSource, CommentsAreNoDirectives) {
  folder.write("a.frag", "/* head\n#include \"x\"\n*/ // more\n#version 410 core\n"
                         "// #include \"y\"\n/* */ #include \"z\" /* */\n#includes\n");
  folder.write("z", "zzz\n");
  EXPECT_EQ(readShader("a.frag", folder.path()).text,
            "/* head\n#include \"x\"\n*/ // more\n#version 410 core\n"
            "// #include \"y\"\n#line 10001\nzzz\n#line 7\n#includes\n");
}

TEST_F(ShaderSource, ByteOrderMarksAndLineEndsOfOtherSystemsGo) {
  folder.write("a.frag", "\xEF\xBB\xBF#version 410 core\r\n#include \"b\"\r\nlast");
  folder.write("b", "\xEF\xBB\xBFold\rMac\r");
  const auto source = readShader("a.frag", folder.path());
  EXPECT_EQ(source.text, "#version 410 core\n#line 10001\nold\nMac\n#line 3\nlast\n");
}

TEST_F(ShaderSource, VersionMustComeFirst) {
  const std::string expected = "a.frag:2: error: the first line must be \"#version 410 core\"";
  for (const char* text :
       {"\nvoid main() {}\n", "\n#version 330 core\n", "\n#version 410 es\n",
        "\n#version 410 compatibility\n", "\n#version\n", "\n#version x\n", "\n#include \"b\"\n"}) {
    folder.write("a.frag", text);
    folder.write("b", "\n");
    if (std::string(text).find("include") == std::string::npos)
      EXPECT_EQ(messageFor("a.frag"), expected) << text;
    else
      EXPECT_EQ(messageFor("a.frag"),
                "a.frag:1: error: the first line must be \"#version 410 core\"");
  }
  folder.write("a.frag", "");
  EXPECT_EQ(messageFor("a.frag"), "a.frag:1: error: the first line must be \"#version 410 core\"");
  folder.write("a.frag", "#version 410\n");
  EXPECT_EQ(readShader("a.frag", folder.path()).text, "#version 410\n");
}

TEST_F(ShaderSource, OtherMistakesHaveALine) {
  folder.write("a.frag", "#version 410 core\n#include b.glsl\n");
  EXPECT_EQ(messageFor("a.frag"), "a.frag:2: error: #include needs a name in quotes");
  folder.write("a.frag", "#version 410 core\n#include \"b\"\n");
  folder.write("b", "\n#version 410 core\n");
  EXPECT_EQ(messageFor("a.frag"), "b:2: error: an included file has no #version");
  folder.write("a.frag", "#version 410 core\n" + std::string(10000, '\n'));
  EXPECT_EQ(messageFor("a.frag"), "a.frag:10000: error: a shader file must be shorter than this");
}

} // namespace
