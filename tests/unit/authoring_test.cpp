#include "authoring/handout.hpp"
#include "authoring/pass_picture.hpp"
#include "authoring/solution_blocks.hpp"

#include "assignment/assignment.hpp"
#include "framework_throws.hpp"
#include "in_japanese.hpp"
#include "trace/picture.hpp"
#include "trace_samples.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <sstream>

using namespace ggrade;
using authoring::blocks;
using authoring::withFilled;
using testing::ElementsAre;

namespace {

const std::string kSolution = "int a;\n"
                              "// BEGIN SOLUTION(mirror.1)\n"
                              "int b;\n"
                              "// END SOLUTION(mirror.1)\n"
                              "int c;\n"
                              "  // BEGIN SOLUTION(mirror.2)\n"
                              "  int d;\n"
                              "  // END SOLUTION(mirror.2)\n"
                              "  // BEGIN SOLUTION(mirror.1)\n"
                              "  int e;\n"
                              "  // END SOLUTION(mirror.1)\n";

TEST(SolutionBlocks, AreTakenOutUnlessFilled) {
  EXPECT_EQ(withFilled(kSolution, "a.cpp", {}), "int a;\nint c;\n");
  EXPECT_EQ(withFilled(kSolution, "a.cpp", {"mirror.1"}), "int a;\nint b;\nint c;\n  int e;\n");
  EXPECT_EQ(withFilled(kSolution, "a.cpp", {"mirror.2"}), "int a;\nint c;\n  int d;\n");
  EXPECT_EQ(withFilled(kSolution, "a.cpp", {"mirror.1", "mirror.2"}),
            "int a;\nint b;\nint c;\n  int d;\n  int e;\n");
  EXPECT_THAT(blocks(kSolution, "a.cpp"), ElementsAre("int b;\n", "  int d;\n", "  int e;\n"));
  EXPECT_THAT(authoring::blocksByTodo(kSolution, "a.cpp"),
              ElementsAre(testing::Pair("mirror.1", "int b;\n  int e;\n"),
                          testing::Pair("mirror.2", "  int d;\n")));
}

TEST(SolutionBlocks, TextWithoutThemStaysAsItIs) {
  EXPECT_EQ(withFilled("", "a.cpp", {}), "");
  EXPECT_EQ(withFilled("\n\nint a;\n\n\n", "a.cpp", {}), "\n\nint a;\n\n\n");
  // A mark is alone on its line.
  const std::string prose = "int a; // BEGIN SOLUTION(mirror.1)\n// see SOLUTION(mirror.1)\n";
  EXPECT_EQ(withFilled(prose, "a.cpp", {}), prose);
  EXPECT_THAT(blocks(prose, "a.cpp"), ElementsAre());
}

TEST(SolutionBlocks, BlankLinesThatMeetBecomeOne) {
  const std::string text = "int a;\n\n// BEGIN SOLUTION(mirror.1)\nint b;\n"
                           "// END SOLUTION(mirror.1)\n\nint c;\n";
  EXPECT_EQ(withFilled(text, "a.cpp", {}), "int a;\n\nint c;\n");
  EXPECT_EQ(withFilled(text, "a.cpp", {"mirror.1"}), "int a;\n\nint b;\n\nint c;\n");
  // At the start of a file none is left.
  EXPECT_EQ(
      withFilled("// BEGIN SOLUTION(m.1)\nint a;\n// END SOLUTION(m.1)\n\nint b;\n", "a.cpp", {}),
      "int b;\n");
}

std::string problem(const std::string& text) {
  return messageOf<UsageError>([&] { withFilled(text, "floor.cpp", {}); });
}

TEST(SolutionBlocks, MistakesNameFileAndLine) {
  EXPECT_EQ(problem("int a;\n// BEGIN SOLUTION(mirror.1)\nint b;\n"),
            "floor.cpp:2: SOLUTION(mirror.1) is never closed");
  EXPECT_EQ(problem("int a;\n\n// END SOLUTION(mirror.1)\n"),
            "floor.cpp:3: END SOLUTION(mirror.1) has no BEGIN before it");
  EXPECT_EQ(problem("// BEGIN SOLUTION(mirror.1)\n// BEGIN SOLUTION(mirror.2)\n"),
            "floor.cpp:2: SOLUTION(mirror.2) begins inside SOLUTION(mirror.1) of line 1");
  EXPECT_EQ(problem("// BEGIN SOLUTION(mirror.1)\n// END SOLUTION(mirror.2)\n"),
            "floor.cpp:2: END SOLUTION(mirror.2) has no BEGIN before it");
}

/// An assignment with one part and an item of every kind.
Assignment sample() {
  Assignment made;
  made.id = "floor";
  Part part;
  part.id = "mirror";
  using results::ItemKind;
  const auto item = [](const char* title, ItemKind kind, double points, const char* step) {
    ItemDeclaration one;
    one.title = title;
    one.kind = kind;
    one.points = points;
    one.step = step;
    return one;
  };
  part.items = {item("It is there", ItemKind::gain, 62.5, "mirror.2"),
                item("It is clipped", ItemKind::gain, 37.5, "mirror.12"),
                item("The rest is unharmed", ItemKind::keep, 100, "mirror.1"),
                item("It is blurred", ItemKind::bonus, 10, "mirror.3")};
  part.items[1].beyondLecture = true;
  part.items[3].beyondLecture = true;
  made.parts = {part};
  return made;
}

std::string expand(const std::string& text, const std::string& code = "int count;\n") {
  return authoring::expandHandout(
      text, "handout.md", sample(),
      [&](const std::string& file) {
        EXPECT_THAT(file, testing::AnyOf("floor.cpp", "mirror.hpp", "tile.frag", "shadow.glsl"));
        return code;
      },
      [](const std::string& part) {
        return part == "mirror" ? "a table\n" : part == "" ? "growth\n" : "";
      });
}

TEST(HandoutExcerpt, IsTheCodeFromTheAnchorToItsEnd) {
  const std::string code = "int count = 6;\n"
                           "// draws {\n"
                           "void draw(\n    int i) {\n  if (i) {\n    go();\n  }\n}\n"
                           "int last = 7;\n";
  EXPECT_EQ(expand("Look:\n{{excerpt floor.cpp \"void draw(\"}}\nDone.\n", code),
            "Look:\n```cpp\nvoid draw(\n    int i) {\n  if (i) {\n    go();\n  }\n}\n```\nDone.\n");
  EXPECT_EQ(expand("{{excerpt floor.cpp \"count\"}}\n", code), "```cpp\nint count = 6;\n```\n");
}

TEST(HandoutExcerpt, NamesTheLanguage) {
  const std::string code = "uniform bool uMirror;\n";
  for (const char* file : {"tile.frag", "shadow.glsl"})
    EXPECT_EQ(expand("{{excerpt " + std::string(file) + " \"uniform\"}}\n", code),
              "```glsl\n" + code + "```\n");
  EXPECT_EQ(expand("{{excerpt mirror.hpp \"count\"}}\n"), "```cpp\nint count;\n```\n");
}

TEST(HandoutPoints, AreARowForEveryItem) {
  EXPECT_EQ(expand("Points:\n{{points mirror}}\nDone.\n"),
            "Points:\n| points | what | step |\n| ---: | --- | --- |\n"
            "| 62.5 | It is there | 2 |\n"
            "| 37.5 | It is clipped (beyond the lecture) | 12 |\n"
            "| −100 | The rest is unharmed | 1 |\n"
            "| +10 | It is blurred (bonus) | 3 |\nDone.\n");
}

TEST(HandoutPoints, StandInTheLanguageThatWasChosen) {
  const InJapanese japanese;
  EXPECT_EQ(expand("{{points mirror}}\n"), "| 配点 | 評価項目 | 手順 |\n| ---: | --- | --- |\n"
                                           "| 62.5 | It is there | 2 |\n"
                                           "| 37.5 | It is clipped（講義の範囲外） | 12 |\n"
                                           "| −100 | The rest is unharmed | 1 |\n"
                                           "| +10 | It is blurred（加点） | 3 |\n");
}

TEST(HandoutTradeoff, IsWhatWasMeasuredOfThePartOrOfAll) {
  EXPECT_EQ(expand("{{tradeoff mirror}}\n{{tradeoff}}\n"), "a table\ngrowth\n");
}

TEST(HandoutDirective, MistakesNameFileAndLine) {
  const auto problem = [&](const std::string& text) {
    return messageOf<UsageError>([&] { expand(text); });
  };
  EXPECT_EQ(problem("one\n{{excerpt floor.cpp \"gone\"}}\n"),
            "handout.md:2: floor.cpp has no line with \"gone\"");
  EXPECT_EQ(problem("one\n\n{{points shadow}}\n"), "handout.md:3: floor has no part shadow");
  const std::string rest = " is none of {{excerpt FILE \"ANCHOR\"}}, {{points PART}}, {{tradeoff "
                           "PART}} and {{tradeoff}}";
  EXPECT_EQ(problem("{{excerpt floor.cpp}}\n"), "handout.md:1: {{excerpt floor.cpp}}" + rest);
  EXPECT_EQ(problem("see {{points mirror}}\n"), "handout.md:1: see {{points mirror}}" + rest);
  EXPECT_EQ(
      problem("{{tradeoff shadow}}\n"),
      "handout.md:1: {{tradeoff shadow}}: nothing was measured; ggrade tradeoff floor --adopt "
      "does it");
}

/// The row of a Markdown table that holds `text`, or nothing.
std::string rowWith(const std::string& markdown, const std::string& text) {
  std::istringstream in(markdown);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("| ") && line.find(text) != line.npos) return line;
  return "";
}

/// Is there an assignment's Japanese? One without is English only.
bool isIn(gg::Language language, const std::filesystem::path& assignment) {
  return language == gg::Language::english || std::filesystem::exists(assignment / "words.ja.json");
}

/// A handout's language: how its files end, and what its headings of steps begin with.
struct Written {
  gg::Language language;
  std::string ending, step;
};
const Written kWritten[] = {{gg::Language::english, ".md", "\n## Step "},
                            {gg::Language::japanese, ".ja.md", "\n## 手順"}};

class Handouts : public testing::TestWithParam<Written> {
protected:
  void SetUp() override { gg::setLanguage(GetParam().language); }
  void TearDown() override { gg::setLanguage(gg::Language::english); }

  std::filesystem::path root_ = GGRADE_SOURCE_DIR "/assignments";
};

INSTANTIATE_TEST_SUITE_P(Every, Handouts, testing::ValuesIn(kWritten), [](const auto& info) {
  return std::string(gg::name(info.param.language));
});

TEST_P(Handouts, SayThePointsOfEveryItemAndTheWeightOfEveryPart) {
  const std::string& ending = GetParam().ending;
  int items = 0;
  for (const Assignment& assignment : loadAssignments(root_)) {
    if (!isIn(GetParam().language, assignment.folder)) continue;
    const std::string overview = readFile(assignment.folder / ("README" + ending));
    for (const Part& part : assignment.parts) {
      const bool alone = assignment.isOnePart();
      const std::string handout =
          alone ? overview : readFile(assignment.folder / (part.id + ending));
      for (const ItemDeclaration& item : part.items) {
        ++items;
        std::ostringstream points;
        points << item.points << " | ";
        EXPECT_THAT(rowWith(handout, " | " + item.title), testing::HasSubstr(points.str()))
            << part.id << ": " << item.title;
      }
      std::ostringstream weight;
      weight << " | " << 100 * part.weight << " | ";
      if (!alone) {
        EXPECT_THAT(rowWith(overview, "](" + part.id + ending + ")"),
                    testing::HasSubstr(weight.str()));
      }
      for (const Todo& todo : part.todos) {
        const std::string number = todo.id.substr(todo.id.find('.') + 1);
        EXPECT_THAT(handout, testing::HasSubstr(GetParam().step + number)) << todo.id;
        EXPECT_THAT(handout, testing::HasSubstr("(handout/" + part.id + "-" + number + ".png)"));
      }
    }
  }
  EXPECT_GT(items, 20);
}

/// The Markdown files of a folder in one language, by name.
std::map<std::string, std::string> handoutsIn(const std::filesystem::path& folder,
                                              const std::string& ending) {
  std::map<std::string, std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.substr(std::min(name.find('.'), name.size())) == ending)
      texts[name] = readFile(entry.path());
  }
  return texts;
}

TEST_P(Handouts, ShowOnlyPicturesThatAreThereAndAllOfThem) {
  for (const Assignment& assignment : loadAssignments(root_)) {
    if (!isIn(GetParam().language, assignment.folder)) continue;
    std::string texts;
    for (const auto& [name, text] : handoutsIn(assignment.folder, GetParam().ending)) texts += text;
    for (std::size_t at = 0; (at = texts.find("](handout/", at)) != texts.npos; ++at) {
      const std::string name = texts.substr(at + 2, texts.find(')', at) - at - 2);
      EXPECT_TRUE(std::filesystem::exists(assignment.folder / name)) << name;
    }
    // Of a picture with words in it each language has its own.
    const bool english = GetParam().language == gg::Language::english;
    for (const auto& entry : std::filesystem::directory_iterator(assignment.folder / "handout")) {
      const std::filesystem::path& file = entry.path();
      const bool japanese = file.stem().extension() == ".ja";
      auto twin = file;
      twin.replace_extension(".ja" + file.extension().string());
      if (english ? japanese : !japanese && std::filesystem::exists(twin)) continue;
      EXPECT_THAT(texts, testing::HasSubstr("(handout/" + file.filename().string() + ")"));
    }
  }
}

TEST_P(Handouts, BeginWithALinkToTheOtherLanguageAndLinkTextsOfTheirOwn) {
  const bool english = GetParam().language == gg::Language::english;
  int links = 0;
  for (const Assignment& assignment : loadAssignments(root_)) {
    if (!isIn(gg::Language::japanese, assignment.folder)) continue;
    for (const auto& [name, text] : handoutsIn(assignment.folder, GetParam().ending)) {
      const std::string stem = name.substr(0, name.find('.'));
      const std::string other =
          english ? "[日本語](" + stem + ".ja.md)\n\n" : "[English](" + stem + ".md)\n\n";
      ASSERT_TRUE(text.starts_with(other)) << assignment.id << ": " << name;
      static const std::regex kLink("\\]\\(([^):#]+\\.md)(#[^)]*)?\\)");
      const std::string rest = text.substr(other.size());
      for (std::sregex_iterator link(rest.begin(), rest.end(), kLink), none; link != none; ++link) {
        ++links;
        const std::string to = (*link)[1];
        EXPECT_TRUE(std::filesystem::exists(assignment.folder / to)) << name << ": " << to;
        EXPECT_EQ(to.ends_with(".ja.md"), !english) << name << ": " << to;
      }
    }
  }
  EXPECT_GT(links, 5);
}

/// What a handout has in both languages, line by line: levels of headings, directives, pictures,
/// fences, rows of tables and entries of lists.
std::vector<std::string> structureOf(const std::string& markdown) {
  static const std::regex kHeading("(#+) .*"), kPicture("!\\[[^\\]]*\\]\\(([^)]*)\\)");
  std::vector<std::string> found;
  bool fenced = false;
  std::istringstream in(markdown);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```")) {
      fenced = !fenced;
      found.push_back(line);
    } else if (fenced) {
      continue;
    } else if (std::regex_match(line, match, kHeading)) {
      found.push_back(match[1]);
    } else if (line.starts_with("{{")) {
      found.push_back(line);
    } else if (line.starts_with("| ")) {
      found.push_back("a row of " + std::to_string(std::ranges::count(line, '|')));
    } else if (line.starts_with("- ")) {
      found.push_back("-");
    }
    for (std::sregex_iterator picture(line.begin(), line.end(), kPicture), none; picture != none;
         ++picture)
      found.push_back((*picture)[1]);
  }
  return found;
}

TEST(HandoutLanguages, HaveTheSameStructure) {
  int handouts = 0;
  for (const Assignment& assignment : loadAssignments(GGRADE_SOURCE_DIR "/assignments")) {
    if (!isIn(gg::Language::japanese, assignment.folder)) continue;
    const std::filesystem::path solution =
        std::filesystem::path(GGRADE_SOURCE_DIR "/solutions") / assignment.id;
    const auto japanese = handoutsIn(solution, ".ja.md");
    for (const auto& [name, text] : handoutsIn(solution, ".md")) {
      ++handouts;
      const auto same = japanese.find(name.substr(0, name.size() - 2) + "ja.md");
      ASSERT_NE(same, japanese.end()) << assignment.id << ": " << name << " is English only";
      EXPECT_EQ(structureOf(same->second), structureOf(text)) << assignment.id << ": " << name;
    }
  }
  EXPECT_GE(handouts, 8);
}

/// `wanted` with the attachment and sizes given as JSON text.
Image passPicture(const trace::Trace& trace, const std::string& wanted) {
  return authoring::passPicture(trace, nlohmann::json::parse(wanted), "handout.json: bloom.3");
}

TEST(PassPicture, MagnifiesInSquaresAndDividesByTheGreatestValue) {
  // Of 2 x 2 pixels on the bottom row first; the red channel is 0.5, 1, 2, 1 in the recording.
  const trace::Trace trace = trace::samples::mirror();
  const Image stored = trace.image(*trace.copyOf(0, 0));
  const Image light = passPicture(
      trace, R"({"attachment": "color0", "sizes": [[2, 2]], "height": 4, "light": true})");
  ASSERT_EQ(light.sizeText(), "4x4");
  ASSERT_EQ(light.channels(), 3);
  const auto display = [](float value) { return 1.055f * std::pow(value, 1 / 2.4f) - 0.055f; };
  int bright = 0;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      for (int c = 0; c < 3; ++c) {
        const float value = stored.at(x / 2, y / 2, c) / 2;
        EXPECT_NEAR(light.at(x, y, c), value > 0 ? display(value) : 0, 1e-5) << x << ' ' << y;
        bright += value == 1;
      }
  EXPECT_EQ(bright, 4); // the one value of 2, in a square of its own
}

TEST(PassPicture, ReducesByTheMean) {
  const trace::Trace trace = trace::samples::mirror();
  const trace::CopyPicture depth = trace::picture(trace, *trace.copyOf(0, trace::kDepth));
  float mean = 0;
  for (int i = 0; i < 4; ++i) mean += depth.rgb.at(i % 2, i / 2, 1) / 4;
  // The depth is a renderbuffer's in the recording; make it a texture's.
  trace::Trace textured = trace;
  textured.passes[0].images[trace::kDepth] = trace::samples::texture(GL_DEPTH_COMPONENT24, 2, 2);
  const Image one =
      passPicture(textured, R"({"attachment": "depth", "sizes": [[2, 2]], "height": 1})");
  ASSERT_EQ(one.sizeText(), "1x1");
  EXPECT_NEAR(one.at(0, 0, 1), mean, 1e-5);
}

TEST(PassPicture, StandsInRowsOfThreeAndTakesTheLastPassOfEachSize) {
  trace::Trace trace = trace::samples::mirror();
  // A later pass into a texture of the same size, all blue.
  trace.passes.push_back(trace.passes[0]);
  trace::samples::addCopy<float>(trace, 2, 0, trace::PixelType::f32x4, 2, 2,
                                 {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1});
  const Image sheet = passPicture(trace, R"({"attachment": "color0", "height": 2,
                             "sizes": [[2, 2], [2, 2], [2, 2], [2, 2]]})");
  ASSERT_EQ(sheet.sizeText(), "14x8"); // 3 * 2 + 2 * 4, 2 * 2 + 4
  for (const auto& [x, y] : {std::pair(0, 0), {13, 1}, {0, 7}})
    EXPECT_THAT(sheet.pixel(x, y), ElementsAre(0, 0, 1)) << x << ' ' << y;
  for (const auto& [x, y] : {std::pair(2, 0), {0, 3}, {13, 7}}) // gaps, and where none is left
    EXPECT_THAT(sheet.pixel(x, y), ElementsAre(1, 1, 1)) << x << ' ' << y;
}

// What one pass draws at once stands side by side.
TEST(PassPicture, TakesSeveralAttachments) {
  trace::Trace trace = trace::samples::mirror();
  trace.passes[0].images[1] = trace::samples::texture(GL_RGBA32F, 2, 2);
  trace::samples::addCopy<float>(trace, 0, 1, trace::PixelType::f32x4, 2, 2,
                                 {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1});
  const Image first =
      passPicture(trace, R"({"attachment": "color0", "sizes": [[2, 2]], "height": 2})");
  const Image both =
      passPicture(trace, R"({"attachment": ["color1", "color0"], "sizes": [[2, 2]], "height": 2})");
  ASSERT_EQ(both.sizeText(), "8x2"); // 2 * 2 + 4
  EXPECT_THAT(both.pixel(0, 0), ElementsAre(0, 1, 0));
  EXPECT_THAT(both.pixel(3, 0), ElementsAre(1, 1, 1)); // the gap
  EXPECT_EQ(both.at(7, 1, 0), first.at(1, 1, 0));
}

// The window's colours are the picture itself; its stencil is to be seen nowhere else.
TEST(PassPicture, ShowsTheWindowsStencil) {
  trace::Trace trace = trace::samples::mirror();
  trace::ImageRef& image = trace.passes[1].images[trace::kStencil];
  image = trace::samples::texture(GL_DEPTH24_STENCIL8, 2, 1);
  image.kind = std::uint32_t(trace::ImageKind::window);
  trace::samples::addCopy<std::uint8_t>(trace, 1, trace::kStencil, trace::PixelType::u8x1, 2, 1,
                                        {0, 255});
  const Image one =
      passPicture(trace, R"({"attachment": "stencil", "sizes": [[2, 1]], "height": 1})");
  EXPECT_THAT(one.pixel(0, 0), ElementsAre(0, 0, 0));
  EXPECT_NE(one.at(1, 0, 0) + one.at(1, 0, 1) + one.at(1, 0, 2), 0);
}

TEST(PassPicture, SaysWhatNoPassDraws) {
  const trace::Trace trace = trace::samples::mirror();
  const auto problem = [&](const std::string& wanted) {
    return messageOf<UsageError>([&] { passPicture(trace, wanted); });
  };
  EXPECT_EQ(problem(R"({"attachment": "color0", "sizes": [[4, 2]], "height": 4})"),
            "handout.json: bloom.3: no pass draws color0 of a texture of 4x2");
  // A renderbuffer is nobody's texture.
  EXPECT_EQ(problem(R"({"attachment": "depth", "sizes": [[2, 2]], "height": 4})"),
            "handout.json: bloom.3: no pass draws depth of a texture of 2x2");
}

} // namespace
