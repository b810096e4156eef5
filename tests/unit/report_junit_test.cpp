#include "report/reports.hpp"
#include "report/write_file.hpp"
#include "report_samples.hpp"

#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>
#include <unistd.h>

namespace ggrade::report {
namespace {

using testing::HasSubstr;
using testing::Not;

// Python stands in for an XML parser of our own: python3-glad brings it, its expat is strict.
bool isWellFormed(const std::string& xml) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("ggrade-junit-" + std::to_string(getpid()) + ".xml");
  writeFile(path, xml);
  const std::string command = "/usr/bin/python3 -c 'import sys, xml.dom.minidom; "
                              "xml.dom.minidom.parse(sys.argv[1])' " +
                              path.string() + " 2>/dev/null";
  const bool good = std::system(command.c_str()) == 0;
  std::filesystem::remove(path);
  return good;
}

TEST(Junit, HasOneCaseAnItemWithTheCounts) {
  const std::string xml = junit(samples::partial(16, 12));
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"floor.mirror\" tests=\"6\" failures=\"3\" "
                             "errors=\"0\" skipped=\"1\""));
  EXPECT_THAT(
      xml,
      HasSubstr(
          "<testcase classname=\"floor.mirror\" name=\"mirror.where\" time=\"0\"></testcase>"));
  EXPECT_THAT(xml, HasSubstr("<failure type=\"points\" message=\"7.5 / 15: 7.9% of the pixels "
                             "behind objects differ.\">"));
  EXPECT_THAT(xml, HasSubstr("<property name=\"outcome\" value=\"graded\"/>"));
  EXPECT_THAT(xml, HasSubstr("<property name=\"seed\" value=\"8131\"/>"));
  EXPECT_THAT(xml, HasSubstr("<skipped message=\"bonus +0 / 10: The reflection is sharp.\"/>"));
  EXPECT_TRUE(isWellFormed(xml));
}

TEST(Junit, HasASuiteAPart) {
  results::Result result = samples::perfect(16, 12);
  result.items[3].id = "shadow.acne";
  const std::string xml = junit(result);
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"floor.mirror\" tests=\"5\" failures=\"0\""));
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"floor.shadow\" tests=\"1\" failures=\"0\""));
  EXPECT_TRUE(isWellFormed(xml));
}

TEST(Junit, ItemsThatWereNeverJudgedAreErrors) {
  const std::string xml = junit(samples::noFrame());
  EXPECT_THAT(xml, HasSubstr("failures=\"0\" errors=\"6\""));
  EXPECT_THAT(xml, HasSubstr("<error type=\"no_frame\" message=\"The program drew no frame: "
                             "glfwSwapBuffers was never reached.\"/>"));
  EXPECT_TRUE(isWellFormed(xml));
}

TEST(Junit, ARunWithoutItemsIsNoSuccess) {
  results::Result result;
  result.assignment = "floor", result.part = "mirror";
  const std::string xml = junit(result);
  EXPECT_THAT(xml, HasSubstr("tests=\"1\" failures=\"0\" errors=\"1\""));
  EXPECT_THAT(xml, HasSubstr("<error type=\"not_gradable\""));
  EXPECT_TRUE(isWellFormed(xml));
}

TEST(Junit, HostileTextsStayText) {
  const std::string xml = junit(samples::hostile());
  EXPECT_THAT(xml, Not(HasSubstr("<script>")));
  EXPECT_THAT(xml, HasSubstr("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;"));
  EXPECT_TRUE(isWellFormed(xml));
  EXPECT_FALSE(isWellFormed("<a>\x01</a>")) << "the checker is asleep";
}

} // namespace
} // namespace ggrade::report
