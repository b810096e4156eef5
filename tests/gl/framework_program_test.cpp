// Messages of shaders that don't compile or link, as this Mesa words them.

#include "framework_throws.hpp"
#include "framework_window.hpp"
#include <gg/error.hpp>
#include <gmock/gmock.h>

namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kVertex = "#version 410 core\nvoid main() { gl_Position = vec4(0); }\n";
const std::string kFragment = "#version 410 core\nout vec4 oColor;\n"
                              "void main() { oColor = vec4(1); }\n";

class Program : public FrameworkWindow {
protected:
  std::string messageFor(std::initializer_list<const char*> files) const {
    return messageOf<gg::ShaderError>([&] { program(files); });
  }
};

TEST_F(Program, AnErrorHasFileLineColumnTheLineAndACaret) {
  folder.write("a.vert", kVertex);
  folder.write("a.frag",
               "#version 410 core\nout vec4 oColor;\nvoid main() {\n  oColor = foo;\n}\n");
  EXPECT_THAT(messageFor({"a.vert", "a.frag"}), StartsWith("a.frag:4:12: error: `foo' undeclared\n"
                                                           "  oColor = foo;\n"
                                                           "           ^"));
}

TEST_F(Program, AnErrorInAnIncludedFileNamesThatFile) {
  folder.write("a.vert", kVertex);
  folder.write("a.frag", "#version 410 core\n#include \"part.glsl\"\nout vec4 oColor;\n"
                         "void main() { oColor = part(); }\n");
  folder.write("part.glsl", "\nvec4 part() {\n\treturn vec3(1);\n}\n");
  EXPECT_THAT(messageFor({"a.vert", "a.frag"}), StartsWith("part.glsl:3:2: error: "));
  EXPECT_THAT(messageFor({"a.vert", "a.frag"}), HasSubstr("\n\treturn vec3(1);\n\t^"));
}

TEST_F(Program, AnErrorAfterAnIncludeHasItsOwnLine) {
  folder.write("a.vert", kVertex);
  folder.write("a.frag",
               "#version 410 core\r\n#include \"gg/lighting.glsl\"\r\nout vec4 oColor;\r\n"
               "void main() { oColor = bar; }\r\n");
  EXPECT_THAT(messageFor({"a.vert", "a.frag"}),
              StartsWith("a.frag:4:24: error: `bar' undeclared\nvoid main() { oColor = bar; }\n"));
}

TEST_F(Program, ErrorsOfAllStagesComeTogether) {
  folder.write("a.vert", "#version 410 core\nvoid main() { gl_Position = one; }\n");
  folder.write("a.frag", "#version 410 core\nvoid main() { two(); }\n");
  const std::string message = messageFor({"a.vert", "a.frag"});
  EXPECT_THAT(message, StartsWith("a.vert:2:29: error: `one' undeclared\n"));
  EXPECT_THAT(message, HasSubstr("a.frag:2:"));
  EXPECT_NE(message.back(), '\n');
}

TEST_F(Program, ASyntaxErrorAtTheEndOfTheFileHasALine) {
  folder.write("a.vert", kVertex);
  folder.write("a.frag", "#version 410 core\nvoid main() {\n");
  EXPECT_THAT(messageFor({"a.vert", "a.frag"}), StartsWith("a.frag:2:14: error: syntax error"));
}

TEST_F(Program, ALinkErrorNamesBothFiles) {
  folder.write("a.vert", "#version 410 core\nout vec2 vNormal;\n"
                         "void main() { gl_Position = vec4(0); vNormal = vec2(1); }\n");
  folder.write("a.frag", "#version 410 core\nin vec3 vNormal;\nout vec4 oColor;\n"
                         "void main() { oColor = vec4(vNormal, 1); }\n");
  const std::string message = messageFor({"a.vert", "a.frag"});
  EXPECT_THAT(message, StartsWith("a.vert + a.frag: error: does not link: "));
  EXPECT_THAT(message, HasSubstr("vNormal"));
}

TEST_F(Program, AMissingFileAndAnUnknownEndingAreNamed) {
  folder.write("a.vert", kVertex);
  folder.write("a.glsl", kFragment);
  EXPECT_THAT(messageFor({"a.vert", "a.frag"}),
              StartsWith("a.frag: error: there is no such file in "));
  EXPECT_EQ(messageFor({"a.vert", "a.glsl"}),
            "a.glsl: error: the name must end in .vert, .tesc, .tese, .geom or .frag");
  EXPECT_EQ(messageFor({"noending"}),
            "noending: error: the name must end in .vert, .tesc, .tese, .geom or .frag");
}

TEST_F(Program, EveryStageIsKnownByItsEnding) {
  folder.write("a.vert", kVertex);
  folder.write("a.tesc", "#version 410 core\nlayout(vertices = 3) out;\nvoid main() {\n"
                         "  gl_TessLevelOuter[0] = 1; gl_TessLevelInner[0] = 1; }\n");
  folder.write("a.tese", "#version 410 core\nlayout(triangles) in;\n"
                         "void main() { gl_Position = vec4(gl_TessCoord, 1); }\n");
  folder.write("a.geom", "#version 410 core\nlayout(triangles) in;\n"
                         "layout(triangle_strip, max_vertices = 3) out;\nvoid main() {}\n");
  folder.write("a.frag", kFragment);
  EXPECT_NO_THROW(program({"a.vert", "a.tesc", "a.tese", "a.geom", "a.frag"}));
}

TEST_F(Program, IsDeletedWithItsOwner) {
  GLuint name = 0;
  {
    const gg::Program owner = coloring("vec4(1)");
    const gg::Program moved = std::move(const_cast<gg::Program&>(owner));
    name = moved;
    EXPECT_TRUE(glIsProgram(name));
  }
  EXPECT_FALSE(glIsProgram(name));
}

} // namespace
