// `ggrade inspect` as a user runs it, and the page that it writes.
#include "../grading/tool.hpp"
#include "browser.hpp"

#include <gmock/gmock.h>

using namespace tool;
using ggrade::report::Browser;
using ggrade::report::Visit;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

namespace {

class Inspect : public Browser {
protected:
  Ended inspect(const Arguments& arguments) {
    Arguments all = {"inspect", "--out", page_, "--size", "160x120"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return runTool(all);
  }

  fs::path page_ = folder_ / "made" / "shadow.html";
};

TEST_F(Inspect, ShowsTheReferencesShadowMapAndWhoReadsIt) {
  const Ended ended = inspect({"shadow", "--solution", "--time", "0.5", "--steps"});
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(ended.out, ContainsRegex("1  texture .*DEPTH_COMPONENT.*6 +[0-9.]+\n"));
  EXPECT_THAT(ended.out,
              ContainsRegex("2  window .*160 x 120 +RGBA8 .*7 +[0-9.]+  pass 1's depth\n"));
  EXPECT_THAT(ended.out, HasSubstr(page_.string() + "\n"));

  const std::string html = read(page_);
  EXPECT_THAT(html, HasSubstr("shadow, the reference: a frame, pass by pass"));
  EXPECT_THAT(html, HasSubstr("<dd>0.5 s</dd>"));
  EXPECT_THAT(html, HasSubstr("distance from the eye, black"));
  EXPECT_THAT(html, HasSubstr("compares LEQUAL"));
  EXPECT_THAT(html, HasSubstr("colour after step 1"));
  EXPECT_THAT(html, Not(HasSubstr("Nobody reads this pass")));

  const Visit seen = visit(html);
  EXPECT_EQ(seen.console, "");
  EXPECT_THAT(seen.dom, HasSubstr("data-ready=\"true\""));
}

TEST_F(Inspect, ShowsAStudentsFolder) {
  Submission submission = Submission::solution();
  const Ended ended = inspect({"mirror", submission.path()});
  ASSERT_EQ(ended.exitCode, 0) << ended.errors;
  EXPECT_THAT(ended.out, HasSubstr("pass 1's colour"));
  EXPECT_THAT(read(page_), HasSubstr("GL_CLIP_DISTANCE0 is on"));
}

TEST_F(Inspect, AProgramThatDoesNotCompileLeavesNoPage) {
  Submission submission = Submission::stub();
  submission.write("floor.cpp", "int main(\n");
  const Ended ended = inspect({"mirror", submission.path()});
  EXPECT_EQ(ended.exitCode, 1);
  EXPECT_THAT(ended.errors, HasSubstr("floor.cpp:1"));
  EXPECT_FALSE(fs::exists(page_));
}

TEST_F(Inspect, APassThatCameBeforeACrashIsShown) {
  Submission submission = Submission::stub();
  submission.replace("floor.cpp", "window.swapBuffers();", "__builtin_trap();");
  const Ended ended = inspect({"mirror", submission.path()});
  EXPECT_EQ(ended.exitCode, 1);
  EXPECT_THAT(ended.out, HasSubstr("1  window"));
  EXPECT_THAT(read(page_), AllOf(HasSubstr("<b>Pass 1</b> draws into the window"),
                                 HasSubstr("<span class=\"sign\" aria-hidden=\"true\">✗</span>")));
}

TEST_F(Inspect, RefusesWhatItCannotShowInOneSentence) {
  const std::pair<Arguments, const char*> kCases[] = {
      {{"nothing"}, "nothing"},
      {{"mirror", "/nowhere"}, "/nowhere is not a folder of files"},
      {{"mirror", "/", "--solution"}, "name either a folder or --solution"},
      {{"mirror", "--time", "-1"}, "--time -1: a time is a number of seconds from 0"},
      {{"mirror", "--out", "/tmp"}, "/tmp is a folder: --out names the page's file"},
  };
  for (const auto& [arguments, message] : kCases) {
    Arguments all = {"inspect"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ended ended = runTool(all);
    EXPECT_EQ(ended.exitCode, 2) << message;
    EXPECT_THAT(ended.errors, HasSubstr(message));
  }
}

} // namespace
