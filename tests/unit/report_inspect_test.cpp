// The filmstrip of a frame: what the page and the table say of a trace made by hand.
#include "in_japanese.hpp"
#include "report/inspect.hpp"
#include "report/inspect_graph.hpp"
#include "report/inspect_pixels.hpp"
#include "report/inspect_words.hpp"
#include "report_inspect_samples.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include <limits>
#include <regex>

namespace ggrade::report {
namespace {

using namespace trace;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

std::vector<std::string> texts(const std::vector<Note>& notes) {
  std::vector<std::string> found;
  for (const Note& note : notes) found.push_back(note.text);
  return found;
}

std::vector<std::string> notesOf(const InspectedFrame& frame, std::uint32_t pass) {
  return texts(passNotes(FrameGraph(frame.trace, 0), pass));
}

std::size_t occurrences(const std::string& text, std::string_view word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(InspectGraph, KnowsWhoReadsWhom) {
  const InspectedFrame frame = samples::frame();
  const FrameGraph graph(frame.trace, 0);
  ASSERT_THAT(graph.reads(), SizeIs(1));
  EXPECT_EQ(graph.reads()[0].writer, 0u);
  EXPECT_EQ(graph.reads()[0].reader, 2u);
  EXPECT_EQ(readWords(graph, graph.reads()[0]), "pass 1's colour");
  EXPECT_THAT(graph.readersOf(0), SizeIs(1));
  EXPECT_THAT(graph.readersOf(1), IsEmpty());
}

TEST(InspectGraph, NumbersPassesWithinTheirFrameAndLeavesOutEarlierWriters) {
  InspectedFrame frame = samples::frame();
  frame.trace.frames = {{0, 1, 0, 0}, {1, 2, 0, 0}};
  const FrameGraph graph(frame.trace, 1);
  EXPECT_EQ(graph.number(2), 2u);
  EXPECT_THAT(graph.reads(), IsEmpty());
  EXPECT_THAT(texts(passNotes(graph, 2)),
              testing::Contains(HasSubstr("it holds what an earlier frame left")));
}

TEST(InspectGraph, AFrameThatWasNeverSwappedIsShownToo) {
  InspectedFrame frame = samples::frame();
  frame.trace.frames.clear();
  EXPECT_EQ(FrameGraph(frame.trace, 0).count(), 3u);
}

TEST(InspectGraph, TellsAPassThatIsDrawnOverFromOneThatIsClearedAway) {
  InspectedFrame frame = samples::frame();
  frame.trace.passes[1].images[0] = frame.trace.passes[0].images[0];
  EXPECT_FALSE(FrameGraph(frame.trace, 0).isDrawnOver(0)) << "pass 2 clears it";
  frame.trace.passes[1].cleared = 0;
  EXPECT_TRUE(FrameGraph(frame.trace, 0).isDrawnOver(0));
}

TEST(InspectWords, ATitleSaysWhatIsDrawnInto) {
  const InspectedFrame frame = samples::frame();
  const auto& passes = frame.trace.passes;
  EXPECT_EQ(passTitle(passes[0]), "draws into a texture, 4 x 3 RGBA16F, with depth renderbuffer");
  EXPECT_EQ(passTitle(passes[1]), "clears a texture, 4 x 4 RGBA8");
  EXPECT_EQ(passTitle(passes[2]), "draws into the window, 8 x 6");

  PassRecord map = passes[0];
  map.drawBuffers = 0;
  map.images[0] = {};
  map.images[kDepth] = samples::image(ImageKind::texture, 9, GL_DEPTH_COMPONENT24, 64, 64);
  EXPECT_EQ(passTitle(map), "draws into a texture, depth only, 64 x 64 DEPTH_COMPONENT24");

  PassRecord level = passes[1];
  level.kind = std::uint32_t(PassKind::mipmap);
  level.images[0].target = GL_TEXTURE_CUBE_MAP;
  level.images[0].level = 2;
  level.images[0].layer = 3;
  EXPECT_EQ(passTitle(level), "makes the mipmaps of level 2, face -Y of a texture, 4 x 4 RGBA8");

  PassRecord two = passes[0];
  two.images[1] = passes[1].images[0];
  two.drawBuffers = 3;
  EXPECT_THAT(passTitle(two), HasSubstr("draws into 2 images, 4 x 3, formats differ"));

  PassRecord broken = passes[0];
  broken.status = GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
  EXPECT_EQ(passTitle(broken), "tries to draw into an incomplete framebuffer");
}

TEST(InspectWords, StateIsNamedAsOpenGlNamesIt) {
  StepRecord step = samples::frame().trace.steps[0];
  step.blend = 1;
  step.blendSource = step.blendSourceAlpha = GL_SRC_ALPHA;
  step.blendDestination = step.blendDestinationAlpha = GL_ONE;
  step.blendEquation = step.blendEquationAlpha = GL_FUNC_ADD;
  step.cullFace = GL_FRONT;
  step.clipDistances = 5;
  step.colorMask = 0;
  std::string all;
  for (const StateWord& word : stateWords(step)) all += word.label + ": " + word.value + "\n";
  EXPECT_THAT(all,
              AllOf(HasSubstr("depth test: LESS\n"),
                    HasSubstr("blending: SRC_ALPHA x source + ONE x destination\n"),
                    HasSubstr("culling: FRONT faces, front is CCW\n"),
                    HasSubstr("clip distances: 0, 2\n"), HasSubstr("colour mask: no channel\n")));
}

TEST(InspectNotes, AreOnlyWhatTheRecordsShow) {
  const InspectedFrame frame = samples::frame();
  EXPECT_THAT(notesOf(frame, 0), IsEmpty());
  EXPECT_THAT(notesOf(frame, 1),
              testing::ElementsAre("It is cleared, but nothing is drawn into it.",
                                   HasSubstr("Nobody reads this pass")));
  EXPECT_THAT(notesOf(frame, 2), IsEmpty());
}

TEST(InspectNotes, NameAnIncompleteFramebufferAndWhatItMeans) {
  InspectedFrame frame = samples::frame();
  frame.trace.passes[1].status = GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER;
  EXPECT_THAT(notesOf(frame, 1),
              testing::ElementsAre(AllOf(HasSubstr("FRAMEBUFFER_INCOMPLETE_READ_BUFFER"),
                                         HasSubstr("glReadBuffer(GL_NONE)"))));
}

TEST(InspectNotes, NameAViewportOfAnotherSize) {
  InspectedFrame frame = samples::frame();
  frame.trace.steps[2].viewport[2] = 4;
  EXPECT_THAT(notesOf(frame, 2),
              testing::ElementsAre(HasSubstr("viewport is 4 x 6 at (0, 0), but what is drawn into "
                                             "is 8 x 6")));
}

TEST(InspectNotes, NameTexturesThatReadBlackOrAreDrawnIntoAtTheSameTime) {
  InspectedFrame frame = samples::frame();
  frame.trace.samples[0].incomplete = 1;
  frame.trace.samples[0].feedback = 1;
  EXPECT_THAT(notesOf(frame, 2),
              testing::ElementsAre(HasSubstr("uReflection (unit 1): the texture is incomplete"),
                                   HasSubstr("a feedback loop")));
  frame.trace.samples[0].feedback = 0;
  frame.trace.samples[0].image.width = 0;
  EXPECT_THAT(notesOf(frame, 2), testing::ElementsAre(HasSubstr("has no image")));
  frame.trace.samples[0] = {};
  frame.trace.samples[0].writer = kNone;
  EXPECT_THAT(notesOf(frame, 2), testing::ElementsAre(HasSubstr("no texture is bound")));
}

TEST(InspectNotes, NameTestsWithoutTheirBuffer) {
  InspectedFrame frame = samples::frame();
  frame.trace.steps[2].depthTest = GL_LESS;
  frame.trace.steps[2].stencilTest = 1;
  EXPECT_THAT(notesOf(frame, 2), testing::ElementsAre(HasSubstr("there is no depth attachment"),
                                                      HasSubstr("no stencil attachment")));
}

TEST(InspectNotes, DepthTestOfAFullScreenPassIsNamedOnlyWhereNoMatrixIsUsed) {
  InspectedFrame frame = samples::frame();
  frame.trace.steps[1].vertices = 4;
  EXPECT_THAT(notesOf(frame, 0), testing::ElementsAre(HasSubstr("4 vertices are drawn without")));
  frame.trace.steps[1].firstMatrix = 0;
  frame.trace.steps[1].matrixCount = 1;
  EXPECT_THAT(notesOf(frame, 0), IsEmpty());
}

TEST(InspectNotes, OfTheFrameNameWhatWasLeftBoundAndWhatWasLost) {
  InspectedFrame frame = samples::frame();
  frame.boundFramebuffer = 2;
  frame.trace.passesLost = 5904;
  frame.trace.copiesLost = 1;
  EXPECT_THAT(texts(frameNotes(frame)),
              testing::ElementsAre(HasSubstr("Framebuffer 2 was bound when"),
                                   HasSubstr("Left out of this page: passes (5,904)"),
                                   HasSubstr("Left out of this page: pictures (1)")));
}

TEST(InspectPixels, ValuesComeBackBitForBit) {
  const std::vector<float> values = {0.1F, std::numeric_limits<float>::quiet_NaN(), -3e38F, 1};
  const auto bytes = std::as_bytes(std::span(values));
  const auto packed = packedValues(bytes, 4);
  std::vector<unsigned char> runs(16);
  uLongf size = 16;
  ASSERT_EQ(uncompress(runs.data(), &size, packed.data(), packed.size()), Z_OK);
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0, value = 0; i < 4; ++i) {
      value = (value + runs[k * 4 + i]) & 255;
      EXPECT_EQ(value, std::to_integer<std::size_t>(bytes[i * 4 + k])) << k << " " << i;
    }
}

TEST(InspectPixels, NotANumberAndOneColourAreNamed) {
  InspectedFrame frame = samples::frame();
  const std::uint16_t nan = 0x7E00;
  std::memcpy(&frame.trace.pixels[2 * 4 * 2], &nan, 2); // red of (2, 0)
  EXPECT_THAT(inspectPage(frame), HasSubstr("colour: 1 pixel holds NaN or Inf, the first NaN at "
                                            "(2,0), channel R."));
  std::fill(frame.trace.pixels.begin() + std::ptrdiff_t(frame.trace.copies[2].offset),
            frame.trace.pixels.end(), std::byte{51});
  EXPECT_THAT(inspectPage(frame),
              HasSubstr("colour is the same in every pixel: (0.2, 0.2, 0.2, 0.2) everywhere."));
}

TEST(InspectPage, HasEveryPassWithItsPicturesStateAndLinks) {
  const std::string page = inspectPage(samples::frame());
  EXPECT_EQ(occurrences(page, "<section class=\"pass card\""), 3u);
  EXPECT_EQ(occurrences(page, "class=\"pass-card\""), 3u);
  EXPECT_THAT(page, HasSubstr("<title>homework: a frame, pass by pass</title>"));
  EXPECT_THAT(page, HasSubstr("<b>Pass 1</b> draws into a texture, 4 x 3 RGBA16F, with depth"));
  EXPECT_THAT(page, HasSubstr("<span class=\"small soft\">reads pass 1&apos;s colour</span>"));
  EXPECT_THAT(page, HasSubstr("href=\"#pass-3\" data-to=\"3\">pass 3 (its colour)</a>"));
  EXPECT_THAT(page, HasSubstr("data-from=\"1\" data-to=\"3\" d=\"M"));
  EXPECT_THAT(page, HasSubstr("12.50 ms"));
  EXPECT_THAT(page, HasSubstr("5.0 MB <span class=\"soft small\">images</span> 1.2 kB"));
  EXPECT_THAT(page, HasSubstr("<code>(0.25, 0, 0, 1)</code>"));
  EXPECT_THAT(page, HasSubstr("<div class=\"changed\"><dt>depth test</dt><dd>LEQUAL <span "
                              "class=\"soft\">(was LESS)</span>"));
  EXPECT_EQ(occurrences(page, "<script type=\"application/octet-stream\""), 3u);
  EXPECT_EQ(occurrences(page, "data:image/png"), 3u + 2u) << "three pictures, two of them on cards";
}

TEST(InspectPage, WhatNoPassDrewWasUploadedUnlessThereWereFramesBefore) {
  InspectedFrame frame = samples::frame();
  for (SampleRecord& sample : frame.trace.samples) sample.writer = kNone;
  EXPECT_THAT(inspectPage(frame), HasSubstr("<td>no pass: uploaded</td>"));
  frame.framesBefore = true;
  EXPECT_THAT(inspectPage(frame),
              AllOf(HasSubstr("<td>no pass of this frame: uploaded, or drawn before it</td>"),
                    Not(HasSubstr("no pass: uploaded"))));
}

TEST(InspectPage, AnAttachmentThatIsNotClearedNamesThePassWhoseValuesItHolds) {
  InspectedFrame frame = samples::frame();
  frame.trace.passes[1].images[0] = frame.trace.passes[0].images[0];
  frame.trace.passes[1].cleared = 0;
  EXPECT_THAT(inspectPage(frame), HasSubstr("not cleared, holds <a href=\"#pass-1\" data-to=\"1\">"
                                            "pass 1&apos;s</a>"));
}

TEST(InspectPage, FourThousandPassesTakeSeconds) {
  InspectedFrame frame = samples::frame();
  Trace& trace = frame.trace;
  const ImageRef images[] = {samples::image(ImageKind::texture, 1, GL_RGBA8, 4, 4),
                             samples::image(ImageKind::texture, 2, GL_RGBA8, 4, 4)};
  while (trace.passes.size() < kMaxPasses) {
    const auto index = std::uint32_t(trace.passes.size());
    trace.passes.push_back(samples::pass(3, 4, 4));
    trace.passes.back().images[0] = images[index % 2];
    samples::addStep(trace, 1);
    samples::addSample(trace, "uSource", images[1 - index % 2], index - 1);
    samples::addSample(trace, "uFirst", images[1 - index % 2], 0);
  }
  trace.frames[0].passCount = kMaxPasses;
  const std::string page = inspectPage(frame);
  EXPECT_EQ(occurrences(page, "<section class=\"pass card\""), kMaxPasses);
  EXPECT_LT(page.size(), 32'000'000u);
}

TEST(InspectPage, AMatrixIsATableOfItsRows) {
  EXPECT_THAT(inspectPage(samples::frame()),
              HasSubstr("<code>uView</code> <span class=\"soft\">draw 1</span></figcaption><table "
                        "class=\"matrix\"><tr><td>0</td><td>4</td><td>8</td><td>12</td></tr>"));
}

TEST(InspectPage, TextOfTheProgramIsEscaped) {
  InspectedFrame frame = samples::frame();
  std::strcpy(frame.trace.samples[0].uniform, "<script>alert(1)</script>");
  std::strcpy(frame.trace.matrices[0].name, "</table><script>alert(2)</script>");
  frame.trace.samples[0].feedback = 1;
  frame.messages = {{"<script>alert(3)</script> {{name}}", 2, 2}, {"<!-- values -->", 1, kNone}};
  frame.name = "<script>alert(4)</script> {{time}}";
  const std::string page = inspectPage(frame);
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(1)"));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(2)"));
  EXPECT_THAT(page, HasSubstr("<a href=\"#pass-3\" data-to=\"3\">pass 3</a>: "
                              "&lt;script&gt;alert(3)&lt;/script&gt; {{name}} <span "
                              "class=\"soft\">(2 times)</span>"));
  EXPECT_THAT(page, HasSubstr("&lt;!-- values --&gt;"));
  EXPECT_THAT(page, HasSubstr("{{time}}: a frame, pass by pass</h1>"));
}

/// Takes away what stands from `begin` to the next `end`, wherever that is.
std::string without(std::string text, std::string_view begin, std::string_view end) {
  for (auto at = text.find(begin); at != text.npos; at = text.find(begin, at))
    text.replace(at, text.find(end, at) + end.size() - at, " ");
  return text;
}

/// English words that a reader of the page or table sees.
std::vector<std::string> englishIn(std::string text) {
  text = without(without(text, "<style>", "</style>"), "<script", "</script>");
  text = without(text, "<", ">");
  std::vector<std::string> found;
  const std::regex word("[A-Za-z_]*[a-z]{3,}[A-Za-z_]*");
  for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at)
    found.push_back(at->str());
  return found;
}

TEST(InspectPage, IsJapaneseWhereTheReaderIs) {
  InspectedFrame frame = samples::frame();
  frame.trace.passes[1].status = GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
  frame.boundFramebuffer = 2;
  frame.trace.copiesLost = 1;
  ASSERT_GT(englishIn(inspectPage(frame)).size(), 300u) << "the page was not read";
  const InJapanese japanese;
  const std::string page = inspectPage(frame);
  EXPECT_THAT(page, HasSubstr("<html lang=\"ja\">"));
  EXPECT_THAT(page,
              HasSubstr("<b>パス1</b> テクスチャに描画, 4 x 3 RGBA16F, 深度はレンダーバッファ"));
  EXPECT_THAT(page, HasSubstr("読み出し：パス1のカラー"));
  EXPECT_THAT(page, HasSubstr("data-point=\"画素にポインタを合わせると、値を読めます。\""));
  // Names that the program gave, and OpenGL's.
  EXPECT_THAT(englishIn(page),
              testing::Each(testing::AnyOf("homework", "uView", "uReflection", "glBindFramebuffer",
                                           "OpenGL", "llvmpipe")));
  EXPECT_THAT(englishIn(inspectTable(frame)), IsEmpty());
}

TEST(InspectPage, SaysWhatTheLimitLeftOut) {
  InspectLimits limits;
  limits.bytes = 700;
  const std::string page = inspectPage(samples::frame(), limits);
  EXPECT_THAT(page, HasSubstr("This page is limited to 700 bytes: "));
  EXPECT_THAT(page, HasSubstr("without values under the pointer"));
  EXPECT_LT(occurrences(page, "<script type=\"application/octet-stream\""), 3u);
}

TEST(InspectPage, WithoutRoomThereIsStillThePage) {
  InspectLimits limits;
  limits.bytes = 0;
  const std::string page = inspectPage(samples::frame(), limits);
  EXPECT_THAT(page, HasSubstr("3 of 3 pictures are small and without values under the pointer. 3 "
                              "of them are left out."));
  EXPECT_THAT(page, Not(HasSubstr("data:image/png")));
  EXPECT_EQ(occurrences(page, "<section class=\"pass card\""), 3u);
}

TEST(InspectPage, WithoutPassesSaysSo) {
  InspectedFrame frame;
  frame.name = "empty";
  frame.problem = "the program never swapped its buffers";
  EXPECT_THAT(inspectPage(frame), AllOf(HasSubstr("No pass was recorded"),
                                        HasSubstr("the program never swapped its buffers")));
}

TEST(InspectTable, IsOneLineAPass) {
  EXPECT_EQ(inspectTable(samples::frame()),
            "pass  draws into  size   format   draws     ms  reads\n"
            "   1  texture 7   4 x 3  RGBA16F      4  12.50\n"
            "   2  texture 8   4 x 4  RGBA8        0\n"
            "   3  window      8 x 6  RGBA8        2         pass 1's colour\n");
}

} // namespace
} // namespace ggrade::report
