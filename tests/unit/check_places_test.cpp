// Lines that editors understand, and the kit's tasks that read them.
#include "check/places.hpp"
#include "grading/toolchain.hpp"
#include "grading/workspace.hpp"
#include "in_japanese.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <regex>

using namespace ggrade;
using namespace ggrade::check;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

namespace fs = std::filesystem;

const std::string kHandedOut = "void frame() {\n"
                               "  begin(); // for TODO(m.2): below\n"
                               "\n"
                               "  // TODO(m.1): draw into it.\n"
                               "  //   Do: bind.\n"
                               "  draw();\n"
                               "    /* TODO(m.2): clip.\n"
                               "     */\n"
                               "  // TODO(m.1) ends here, then TODO(m.2): elsewhere\n"
                               "}\n";

class Places : public testing::Test {
protected:
  Places() {
    for (const char* name : {"stub", "now"}) fs::create_directory(folder_.path() / name);
    write("stub", "m.cpp", kHandedOut);
    write("now", "m.cpp", kHandedOut);
  }
  void write(const char* folder, const char* name, const std::string& text) const {
    std::ofstream(folder_.path() / folder / name) << text;
  }
  fs::path now() const { return folder_.path() / "now"; }
  /// "m.cpp:4:6"
  std::vector<std::string> of(const std::string& todo) const {
    std::vector<std::string> all;
    for (const Place& place : placesOf(todo, {"m.cpp", "m.frag"}, folder_.path() / "stub", now()))
      all.push_back(fmt::format("{}:{}:{}", fs::path(place.file).filename().string(), place.line,
                                place.column));
    return all;
  }

  grading::TemporaryFolder folder_;
};

TEST_F(Places, OfATodoAreItsComments) {
  EXPECT_THAT(of("m.1"), ElementsAre("m.cpp:4:6"));
  EXPECT_THAT(of("m.2"), ElementsAre("m.cpp:7:8"));
  EXPECT_THAT(of("m.3"), IsEmpty());
  write("now", "m.cpp", "#include <a>\n\n" + kHandedOut);
  EXPECT_THAT(of("m.1"), ElementsAre("m.cpp:6:6"));
  write("stub", "m.frag", "// TODO(m.1): sample it\n");
  EXPECT_THAT(of("m.1"), ElementsAre("m.cpp:6:6")) << "the student has no such file";
  write("now", "m.frag", "//TODO(m.1): sample it\r\n");
  EXPECT_THAT(of("m.1"), ElementsAre("m.cpp:6:6", "m.frag:1:3"));
}

TEST_F(Places, OfACommentThatIsGoneAreWhereItsLinesBegin) {
  write("now", "m.cpp",
        "void frame() {\n\tbegin(); // for TODO(m.2): below\n\n  bind();\n  draw();\n}\n");
  EXPECT_THAT(of("m.1"), ElementsAre("m.cpp:4:0"));
  EXPECT_THAT(of("m.2"), ElementsAre("m.cpp:6:0"));
  write("now", "m.cpp", "nothing of it\n");
  EXPECT_THAT(of("m.1"), IsEmpty());
  write("now", "m.cpp", "");
  EXPECT_THAT(of("m.1"), IsEmpty());
}

TEST_F(Places, TheShaderThatReadsTheseSamplersGoesFirst) {
  const std::vector<std::pair<const char*, const char*>> texts = {
      {"m.cpp", "set(\"uOne\", 0); set(\"uTwo\", 1);"},
      {"m.frag", "texture(uOne, at)"},
      {"n.frag", "texture(uOne, at) + texture(uTwo, at)"}};
  for (const auto& [name, text] : texts) write("now", name, text);
  const auto order = [&](const std::set<std::string>& samplers) {
    std::vector<Place> places;
    for (const auto& [name, text] : texts) places.push_back({(now() / name).string(), 1});
    putReaderFirst(places, samplers);
    std::string all;
    for (const Place& place : places) all += fs::path(place.file).filename().string() + ' ';
    return all;
  };
  EXPECT_EQ(order({"uOne", "uTwo", "uIncluded"}), "n.frag m.cpp m.frag ");
  EXPECT_EQ(order({"uOne"}), "m.cpp m.frag n.frag ") << "two of them read it";
  EXPECT_EQ(order({"uTw"}), "m.cpp m.frag n.frag ") << "it is part of another name";
  EXPECT_EQ(order({}), "m.cpp m.frag n.frag ");
}

TEST_F(Places, AMessageNamesTheTodoInWhoseLinesItIs) {
  const auto at = [&](const std::string& message) {
    return todoAt(message, {"m.1", "m.2"}, folder_.path() / "stub", now());
  };
  EXPECT_EQ(at("glClear: GL_INVALID_VALUE (m.cpp:4)"), "m.1");
  EXPECT_EQ(at("glClear: GL_INVALID_VALUE (m.cpp:6)"), "m.1");
  EXPECT_EQ(at("frame 1: glClear() (m.cpp:9); 1 of 2 frames came"), "m.2");
  EXPECT_EQ(at("glClear: GL_INVALID_VALUE (m.cpp:3)"), "") << "before all of them";
  EXPECT_EQ(at("glClear: GL_INVALID_VALUE (other.cpp:9)"), "");
  EXPECT_EQ(at("glClear(GL_COLOR_BUFFER_BIT) forgotten"), "");
}

TEST_F(Places, AMessageAboutWhatWasHandedOutNamesNoTodo) {
  const std::string below = "\n\nvoid given() {\n  glDraw();\n}\n";
  write("stub", "n.cpp", "// TODO(m.1): do it\nvoid mine() {\n}" + below);
  write("now", "n.cpp", "// TODO(m.1): do it\nvoid mine() {\n  glDraw();\n  more();\n}" + below);
  const auto at = [&](const std::string& message) {
    return todoAt(message, {"m.1", "m.2"}, folder_.path() / "stub", now());
  };
  EXPECT_EQ(at("glDraw: GL_INVALID_VALUE (n.cpp:4)"), "m.1");
  EXPECT_EQ(at("glDraw: GL_INVALID_VALUE (n.cpp:8)"), "");
}

TEST(CheckPlaces, ALineIsFoundAfterOneThatStandsOnce) {
  EXPECT_EQ(lineNow("a\n}\nb\n}\nX\n", "a\n}\nb\n}\nnew\n", 5), 5) << "lines that stand twice";
  EXPECT_EQ(lineNow("a\nX\n", "more\na\n\nnew\n", 2), 4);
  EXPECT_EQ(lineNow("a\nX\n", "b\na", 2), 2) << "at the end";
  EXPECT_EQ(lineNow("a\nX\n", "a\na\n", 2), std::nullopt) << "which of them?";
  EXPECT_EQ(lineNow("", "", 1), std::nullopt);
}

TEST_F(Places, NamesBecomePathsAndPlacesComeFirst) {
  const std::string path = (now() / "m.cpp").string();
  EXPECT_EQ(withPaths("m.cpp:3:5: error: what\n  3 | x\n", now()),
            path + ":3:5: error: what\n  3 | x\n");
  EXPECT_EQ(withPaths("In file included from m.cpp:1:\nm.cpp: In function", now()),
            "In file included from " + path + ":1:\n" + path + ": In function");
  EXPECT_EQ(withPaths("OpenGL: error: GL_INVALID_VALUE in glClear (m.cpp:12)", now()),
            path + ":12: error: OpenGL: GL_INVALID_VALUE in glClear");
  EXPECT_EQ(withPaths("frame doctor: nothing (m.cpp:12)", now()),
            path + ":12: warning: frame doctor: nothing");
  EXPECT_EQ(withPaths("program: m.cpp:3:5: error: what", now()), path + ":3:5: error: what");
  for (const char* other : {"", "\n", "n.cpp:3:5: error: what", "said (n.cpp:3)", "/a/m.cpp:3: x"})
    EXPECT_EQ(withPaths(other, now()), other);
  const InJapanese japanese;
  EXPECT_EQ(withPaths(gg::say("OpenGL: error: {}", "x") + " (m.cpp:12)", now())
                .substr(0, path.size() + 10),
            path + ":12: error");
}

TEST(CheckPlaces, FromHereUnlessTheyLieElsewhere) {
  EXPECT_EQ(shown(fs::current_path() / "a" / "b.cpp"), "a/b.cpp");
  EXPECT_EQ(shown("a/../b.cpp"), "b.cpp");
  EXPECT_EQ(shown("/elsewhere/b.cpp"), "/elsewhere/b.cpp");
}

/// The lines that `check` prints, and what must not be taken for one.
const std::vector<Problem> kProblems = {{{"assignments/m/m.cpp", 4, 6}, "error", "m.1 is wrong: x"},
                                        {{"m.frag", 12, 0}, "warning", "frame doctor: what: now"},
                                        {{"/a folder/m.cpp", 1, 1}, "note", "m.1 goes on here"}};
const char* const kNoProblems[] = {"the compiler says: m.cpp:3:5: error: what",
                                   "コンパイラのメッセージ：m.cpp:3:5: error: what",
                                   "  | m.cpp:3:5: error: what",
                                   "m: [##--] 1 of 2 done (1.2 s)",
                                   "First wrong picture: the window at 0.9 s: 3% of it",
                                   "out/check-m.html"};

TEST(CheckPlaces, ALineIsReadAsItIsWritten) {
  for (const Problem& problem : kProblems) {
    const auto read = problemIn(lineOf(problem));
    ASSERT_TRUE(read) << lineOf(problem);
    EXPECT_EQ(lineOf(*read), lineOf(problem));
    EXPECT_EQ(read->place.column, problem.place.column);
  }
  EXPECT_EQ(problemIn("m.cpp:3:5: fatal error: no such file")->severity, "error");
}

/// As Visual Studio Code reads them: by each pattern, from each line.
TEST(CheckPlaces, TheKitsTasksReadThem) {
  const fs::path file =
      fs::path(toolchain::kSourceFolder) / "grader/authoring/kit/vscode/tasks.json";
  std::ifstream in(file);
  const nlohmann::json tasks = nlohmann::json::parse(in);
  ASSERT_EQ(tasks.at("version"), "2.0.0");
  ASSERT_EQ(tasks.at("tasks").size(), 2u);
  for (const nlohmann::json& task : tasks.at("tasks")) {
    SCOPED_TRACE(task.at("label"));
    EXPECT_EQ(task.at("command"), "${workspaceFolder}/ggrade");
    EXPECT_EQ(task.at("args").at(0), "check");
    const nlohmann::json& matcher = task.at("problemMatcher");
    const nlohmann::json& pattern = matcher.at("pattern");
    const std::regex form(pattern.at("regexp").get<std::string>());
    const auto group = [&](const char* name) { return pattern.at(name).get<std::size_t>(); };
    for (const Problem& problem : kProblems) {
      const std::string line = lineOf(problem);
      std::smatch match;
      ASSERT_TRUE(std::regex_search(line, match, form)) << line;
      EXPECT_EQ(match[group("file")], problem.place.file);
      EXPECT_EQ(match[group("line")], std::to_string(problem.place.line));
      EXPECT_EQ(match[group("column")],
                problem.place.column ? std::to_string(problem.place.column) : "");
      EXPECT_EQ(match[group("severity")], problem.severity);
      EXPECT_EQ(match[group("message")], problem.text);
    }
    for (const std::string line : kNoProblems) EXPECT_FALSE(std::regex_search(line, form)) << line;
    EXPECT_EQ(matcher.contains("background"), task.value("isBackground", false));
    if (!matcher.contains("background")) continue;
    const nlohmann::json& background = matcher.at("background");
    EXPECT_TRUE(std::regex_search(gg::say("ggrade: looking at {} ...", "assignments/m"),
                                  std::regex(background.at("beginsPattern").get<std::string>())));
    const std::regex ends(background.at("endsPattern").get<std::string>());
    EXPECT_TRUE(std::regex_search(std::string("out/check-m.html"), ends));
    EXPECT_FALSE(std::regex_search(
        gg::say("ggrade: watching {}; the page is {}; Ctrl-C ends this", "m", "a.html"), ends));
  }
}

} // namespace
