#include "authoring/comments.hpp"

#include "framework_temporary_folder.hpp"

#include <gmock/gmock.h>

#include <fstream>

using namespace ggrade;
using authoring::commentsIn;
using authoring::outOfStep;
using authoring::translated;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

std::vector<std::string> textsIn(std::string_view source) {
  std::vector<std::string> texts;
  for (const authoring::Comment& comment : commentsIn(source)) texts.push_back(comment.text);
  return texts;
}

TEST(Comments, AreLinesOfOneColumnAndMark) {
  EXPECT_THAT(textsIn("// One,\n//   goes  on.\n\n// Two.\nint a; // three,\n       // goes on\n"
                      "  // four\n/// five\n// six\n"),
              ElementsAre("One, goes on.", "Two.", "three, goes on", "four", "five", "six"));
  EXPECT_THAT(textsIn("int a; // one\nint b; // two\n"), ElementsAre("one", "two"))
      << "each stands after code of its own";
}

TEST(Comments, EndWhereABlockOfTheSolutionDoes) {
  EXPECT_THAT(
      textsIn("// TODO(mirror.1): draw.\n// BEGIN SOLUTION(mirror.1)\n// as the floor does\n"
              "// END SOLUTION(mirror.1)\n// Then go on.\n"),
      ElementsAre("TODO(mirror.1): draw.", "as the floor does", "Then go on."));
}

TEST(Comments, AreNotInLiterals) {
  EXPECT_THAT(textsIn("say(\"http://a\"); // one\nchar c = '\"'; // two\n"
                      "int i = 1'000; // three\nsay(\"\\\"// no\");\n"),
              ElementsAre("one", "two", "three"));
}

TEST(Comments, AreTranslatedAndNothingElseIs) {
  const std::string source = "// Draws all\n//   of it.\nvoid draw() {\n"
                             "  int count = 0; ///< of  things\n  // unknown\n}\n";
  EXPECT_EQ(translated(source, {}), source);
  EXPECT_EQ(translated(source, {{"Draws all of it.", {"すべてを描画する。"}},
                                {"of things", {"物の数、", "0以上"}}}),
            "// すべてを描画する。\nvoid draw() {\n  int count = 0; ///< 物の数、\n"
            "                 ///< 0以上\n  // unknown\n}\n");
  EXPECT_EQ(translated("// One.\n", {{"One.", {"上", "", "  下"}}}), "// 上\n//\n//   下\n");
}

/// Nobody shall read in Japanese what is no longer so.
TEST(Comments, ThatHaveChangedAreNamed) {
  const TemporaryFolder folder;
  Assignment assignment;
  assignment.files = {"a.cpp"};
  folder.write("a.cpp", "// Old.\nint a; // (0,0)\n} // namespace\n");
  EXPECT_THAT(outOfStep(assignment, folder.path()), IsEmpty()) << "it is in English alone";
  folder.write("comments.ja.json", "{\"Old.\": [\"古い。\"]}");
  EXPECT_THAT(outOfStep(assignment, folder.path()), IsEmpty());
  folder.write("a.cpp", "\n// New.\nint a; // (0,0)\n");
  EXPECT_EQ(translated("// New.\n", authoring::translationsIn(folder.path())), "// New.\n");
  EXPECT_THAT(outOfStep(assignment, folder.path()),
              ElementsAre(AllOf(HasSubstr("a.cpp:2: "), HasSubstr(": New.")),
                          AllOf(HasSubstr("comments.ja.json: "), HasSubstr(": Old."))));
  folder.write("comments.ja.json", "{\"Old.\": \"古い。\"}");
  EXPECT_THROW(authoring::translationsIn(folder.path()), UsageError);
}

} // namespace
