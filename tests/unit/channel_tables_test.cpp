// What the captured side claims of the passes: the judging side takes what is possible, and names
// what isn't.

#include "channel_child.hpp"

#include <GL/glcorearb.h>
#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <random>

namespace ggrade::channel {
namespace {

using namespace trace;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint64_t kRoom = 4096;

/// A run of one whole frame with two passes of two steps, and a third pass after the swap.
class ChannelTables : public testing::Test {
protected:
  ChannelTables() : channel_({{0, 2, 2}, {1, 2, 2}}, kDefaultMaxPixels, everything(kRoom)) {
    Header& header = child_.header();
    header.started = header.contextMade = header.framesDone = 1;
    header.frames[0].written = 1;
    header.frames[0].width = header.frames[0].height = 2;
    header.frames[0].firstPass = 0;
    header.frames[0].passCount = 2;
    header.frames[0].imageBytes = 123;
    header.frames[0].bufferBytes = 45;
    header.messageCount = 1;
    header.messages[0] = {1, 0, 1, 1, "GL_INVALID_ENUM in glEnable"};
    Tables& tables = child_.tables();
    tables.counts = {3, 4, 3, 2, 3, 0, 0, 0, 0, 0, 64};
    for (std::uint32_t i = 0; i < 3; ++i) {
      PassRecord& pass = tables.passes[i];
      pass.frame = i / 2;
      pass.kind = number(PassKind::draw);
      pass.status = GL_FRAMEBUFFER_COMPLETE;
      pass.images[0] = {number(ImageKind::texture), 1, GL_TEXTURE_2D, 0, kNone, GL_RGBA8, 2, 3, 0};
      pass.firstStep = 2 * i;
      pass.stepCount = i < 2 ? 2 : 0;
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
      StepRecord& step = tables.steps[i];
      step.pass = i / 2;
      step.cullFace = GL_BACK;
      step.depthTest = GL_LESS;
      step.firstMatrix = i < 3 ? i : 0;
      step.matrixCount = i < 3 ? 1 : 0;
    }
    tables.steps[1].sampleCount = 1;
    tables.steps[3].firstSample = tables.steps[3].sampleCount = 1;
    std::strcpy(tables.matrices[0].name, "uProjection");
    std::strcpy(tables.samples[0].uniform, "uMap");
    tables.samples[0].writer = kNone;
    tables.samples[1].writer = 0;
    tables.copies[0] = {0, kNone, 0, number(PixelType::u8x4), 2, 3, 0, 24};
    tables.copies[1] = {0, 1, kDepth, number(PixelType::f32x1), 2, 3, 32, 24};
    tables.copies[2] = {1, kNone, kStencil, number(PixelType::u8x1), 2, 3, 56, 6};
    for (std::uint32_t byte = 0; byte < 64; ++byte)
      child_.copies(channel_.plan())[byte] = static_cast<unsigned char>(byte);
  }
  template <typename Enum> static std::uint32_t number(Enum value) {
    return static_cast<std::uint32_t>(value);
  }
  Channel channel_;
  ChildView child_{channel_};
};

TEST_F(ChannelTables, AreCopiedOutAsFarAsTheyAreFilled) {
  const Capture capture = channel_.read();
  ASSERT_EQ(capture.error, "");
  const Trace& trace = capture.trace;
  ASSERT_EQ(trace.frames.size(), 1U);
  EXPECT_EQ(trace.frames[0].passCount, 2U);
  EXPECT_EQ(trace.frames[0].imageBytes, 123U);
  EXPECT_EQ(trace.frames[0].bufferBytes, 45U);
  ASSERT_EQ(trace.passes.size(), 3U);
  EXPECT_EQ(trace.passes[2].frame, 1U) << "of the frame that was never swapped";
  EXPECT_EQ(trace.steps.size(), 4U);
  EXPECT_EQ(trace.matrices.size(), 3U);
  EXPECT_STREQ(trace.matrices[0].name, "uProjection");
  EXPECT_EQ(trace.samplesOf(trace.steps[3])[0].writer, 0U);
  EXPECT_EQ(capture.messages.at(0).pass, 1U);
}

TEST_F(ChannelTables, CopiesHaveTheTopRowFirst) {
  const Trace trace = channel_.read().trace;
  ASSERT_EQ(trace.copies.size(), 3U);
  const Image colour = trace.image(trace.copies[0]);
  EXPECT_EQ(colour.sizeText(), "2x3");
  EXPECT_EQ(std::lround(colour.at(0, 0, 0) * 255), 16);
  EXPECT_EQ(std::lround(colour.at(1, 0, 3) * 255), 23);
  EXPECT_EQ(std::lround(colour.at(0, 1, 0) * 255), 8);
  EXPECT_EQ(std::lround(colour.at(0, 2, 0) * 255), 0);
  const Image stencil = trace.image(trace.copies[2]);
  EXPECT_THAT(std::vector<float>(stencil.values().begin(), stencil.values().end()),
              ElementsAre(60, 61, 58, 59, 56, 57));
}

TEST_F(ChannelTables, AreNotLookedAtUnlessAskedFor) {
  const Channel plain({{0, 2, 2}});
  ChildView child(plain);
  child.header().messageCount = 1;
  child.header().messages[0] = {1, 0, 1, 99, "text"};
  child.header().framesDone = 1;
  child.header().frames[0] = {1, 2, 2, 0, 0, 0, 0, 77, 88, 0, 0, 0, 0};
  const Capture capture = plain.read();
  EXPECT_EQ(capture.error, "");
  EXPECT_TRUE(capture.trace.frames.empty());
  EXPECT_EQ(capture.messages.at(0).pass, kNone);
}

TEST_F(ChannelTables, NamesAreSafeToPrint) {
  Tables& tables = child_.tables();
  std::memset(tables.matrices[1].name, 0xFF, 59); // would be three times as long
  std::strcpy(tables.samples[1].uniform, "u\x1B[2J");
  const Trace trace = channel_.read().trace;
  ASSERT_EQ(trace.matrices.size(), 3U);
  std::string expected;
  for (int i = 0; i < 19; ++i) expected += "\xEF\xBF\xBD";
  EXPECT_EQ(trace.matrices[1].name, expected) << "cut between two characters";
  EXPECT_STREQ(trace.samples[1].uniform, "u\xEF\xBF\xBD[2J");
}

TEST_F(ChannelTables, EveryForgeryIsNamed) {
  struct Case {
    const char* error;
    void (*forge)(Tables&, Header&);
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Case cases[] = {
      {"counts.passes: 4097 is above 4096", [](Tables& t, Header&) { t.counts.passes = 4097; }},
      {"counts.steps: 4294967295 is above 8192", [](Tables& t, Header&) { t.counts.steps = ~0U; }},
      {"counts.matrices: 32769 is above 32768",
       [](Tables& t, Header&) { t.counts.matrices = 32769; }},
      {"counts.samples: 16385 is above 16384",
       [](Tables& t, Header&) { t.counts.samples = 16385; }},
      {"counts.copies: 8193 is above 8192", [](Tables& t, Header&) { t.counts.copies = 8193; }},
      {"counts.copyBytes: 4097 is above 4096",
       [](Tables& t, Header&) { t.counts.copyBytes = 4097; }},
      {"passes[2].frame: 2 is above 1", [](Tables& t, Header&) { t.passes[2].frame = 2; }},
      {"passes[0].kind: 0 is below 1", [](Tables& t, Header&) { t.passes[0].kind = 0; }},
      {"passes[0].kind: 6 is above 5", [](Tables& t, Header&) { t.passes[0].kind = 6; }},
      {"passes[1].drawBuffers: 256 is above 255",
       [](Tables& t, Header&) { t.passes[1].drawBuffers = 256; }},
      {"passes[1].cleared: 1024 is above 1023",
       [](Tables& t, Header&) { t.passes[1].cleared = 1024; }},
      {"passes[1].written: 1024 is above 1023",
       [](Tables& t, Header&) { t.passes[1].written = 1024; }},
      {"passes[0].seconds: nan is not a time from 0 to 1000000 seconds",
       [](Tables& t, Header&) { t.passes[0].seconds = kNan; }},
      {"passes[0].images[9].kind: 4 is above 3",
       [](Tables& t, Header&) { t.passes[0].images[9].kind = 4; }},
      {"passes[0].images[0].width: 16385 is above 16384",
       [](Tables& t, Header&) { t.passes[0].images[0].width = 16385; }},
      {"passes[0].images[0].height: 4294967295 is above 16384",
       [](Tables& t, Header&) { t.passes[0].images[0].height = ~0U; }},
      {"passes[0].steps: 3 + 2 is above 4", [](Tables& t, Header&) { t.passes[0].firstStep = 3; }},
      {"passes[0].steps: 4294967295 + 2 is above 4",
       [](Tables& t, Header&) { t.passes[0].firstStep = ~0U; }},
      {"passes[1].steps: 2 + 4294967295 is above 4",
       [](Tables& t, Header&) { t.passes[1].stepCount = ~0U; }},
      {"steps[0].pass: 0 is not 1", [](Tables& t, Header&) { t.passes[1].firstStep = 0; }},
      {"steps[1].pass: 1 is not 0", [](Tables& t, Header&) { t.steps[1].pass = 1; }},
      {"steps[3].pass: 3 + 1 is above 3",
       [](Tables& t, Header&) { t.steps[3].pass = 3, t.passes[1].stepCount = 1; }},
      {"steps[0].mode: 15 is above 14", [](Tables& t, Header&) { t.steps[0].mode = 15; }},
      {"steps[0].cullFace: 1 is none of the values that are possible",
       [](Tables& t, Header&) { t.steps[0].cullFace = 1; }},
      {"steps[0].depthTest: 9 is none of the values that are possible",
       [](Tables& t, Header&) { t.steps[0].depthTest = 9; }},
      {"steps[0].depthWrite: 2 is above 1", [](Tables& t, Header&) { t.steps[0].depthWrite = 2; }},
      {"steps[0].blend: 2 is above 1", [](Tables& t, Header&) { t.steps[0].blend = 2; }},
      {"steps[0].stencilTest: 2 is above 1",
       [](Tables& t, Header&) { t.steps[0].stencilTest = 2; }},
      {"steps[0].rasterizerDiscard: 2 is above 1",
       [](Tables& t, Header&) { t.steps[0].rasterizerDiscard = 2; }},
      {"steps[0].colorMask: 16 is above 15", [](Tables& t, Header&) { t.steps[0].colorMask = 16; }},
      {"steps[0].matrixCount: 257 is above 256",
       [](Tables& t, Header&) { t.steps[0].matrixCount = 257; }},
      {"steps[2].matrices: 3 + 1 is above 3",
       [](Tables& t, Header&) { t.steps[2].firstMatrix = 3; }},
      {"steps[3].samples: 2 + 1 is above 2",
       [](Tables& t, Header&) { t.steps[3].firstSample = 2; }},
      {"steps[1].firstMatrix: 0 is below 1",
       [](Tables& t, Header&) { t.steps[1].firstMatrix = 0; }},
      {"steps[3].firstSample: 0 is below 1",
       [](Tables& t, Header&) { t.steps[3].firstSample = 0; }},
      {"matrices[2].name: the text does not end",
       [](Tables& t, Header&) { std::memset(t.matrices[2].name, 'x', 60); }},
      {"samples[0].uniform: the text does not end",
       [](Tables& t, Header&) { std::memset(t.samples[0].uniform, 'x', 60); }},
      {"samples[1].writer: 3 + 1 is above 3", [](Tables& t, Header&) { t.samples[1].writer = 3; }},
      {"samples[1].feedback: 2 is above 1", [](Tables& t, Header&) { t.samples[1].feedback = 2; }},
      {"samples[1].incomplete: 2 is above 1",
       [](Tables& t, Header&) { t.samples[1].incomplete = 2; }},
      {"samples[0].image.kind: 9 is above 3",
       [](Tables& t, Header&) { t.samples[0].image.kind = 9; }},
      {"samples[0].image.width: 20000 is above 16384",
       [](Tables& t, Header&) { t.samples[0].image.width = 20000; }},
      {"copies[0].pass: 3 + 1 is above 3", [](Tables& t, Header&) { t.copies[0].pass = 3; }},
      {"copies[0].attachment: 10 is above 9",
       [](Tables& t, Header&) { t.copies[0].attachment = 10; }},
      {"copies[0].type: 8 is none of the values that are possible",
       [](Tables& t, Header&) { t.copies[0].type = 8; }},
      {"copies[1].type: 1 is not 4", [](Tables& t, Header&) { t.copies[1].type = 1; }},
      {"copies[2].type: 4 is not 5", [](Tables& t, Header&) { t.copies[2].type = 4; }},
      {"copies[0].width: 0 is below 1", [](Tables& t, Header&) { t.copies[0].width = 0; }},
      {"copies[0].width: 16385 is above 16384",
       [](Tables& t, Header&) { t.copies[0].width = 16385; }},
      {"copies[0].height: 0 is below 1", [](Tables& t, Header&) { t.copies[0].height = 0; }},
      {"copies[0].height: 16385 is above 16384",
       [](Tables& t, Header&) { t.copies[0].height = 16385; }},
      {"copies[0].bytes: 23 is not 24", [](Tables& t, Header&) { t.copies[0].bytes = 23; }},
      {"copies[0].bytes: 24 is not 1073741824",
       [](Tables& t, Header&) { t.copies[0].width = t.copies[0].height = 16384; }},
      {"copies[1].offset: 23 is below 24", [](Tables& t, Header&) { t.copies[1].offset = 23; }},
      {"copies[2].offset: 59 + 6 is above 64", [](Tables& t, Header&) { t.copies[2].offset = 59; }},
      {"copies[2].offset: 18446744073709551615 is above 64",
       [](Tables& t, Header&) { t.copies[2].offset = ~0ULL; }},
      {"copies[1].step: 4 + 1 is above 4", [](Tables& t, Header&) { t.copies[1].step = 4; }},
      {"copies[1].step's pass: 1 is not 0", [](Tables& t, Header&) { t.copies[1].step = 2; }},
      {"frames[0].passes: 2 + 2 is above 3",
       [](Tables&, Header& header) { header.frames[0].firstPass = 2; }},
      {"passes[2].frame: 1 is not 0",
       [](Tables&, Header& header) { header.frames[0].passCount = 3; }},
      {"messages[0].pass: 3 + 1 is above 3",
       [](Tables&, Header& header) { header.messages[0].pass = 3; }},
  };
  const auto good = std::make_unique<Tables>(child_.tables());
  const Header goodHeader = child_.header();
  for (const Case& bad : cases) {
    child_.tables() = *good;
    child_.header() = goodHeader;
    bad.forge(child_.tables(), child_.header());
    const Capture capture = channel_.read();
    EXPECT_EQ(capture.error, bad.error);
    EXPECT_TRUE(capture.trace.passes.empty());
    EXPECT_TRUE(capture.frames.empty());
  }
  child_.tables() = *good;
  child_.header() = goodHeader;
  EXPECT_EQ(channel_.read().error, "");
}

TEST_F(ChannelTables, ABufferTextureMayBeAsWideAsItLikes) {
  child_.tables().samples[0].image.target = GL_TEXTURE_BUFFER;
  child_.tables().samples[0].image.width = 1 << 27;
  EXPECT_EQ(channel_.read().error, "");
}

TEST_F(ChannelTables, AllOnesAreRefused) {
  std::memset(&child_.tables(), 0xFF, sizeof(Tables));
  EXPECT_EQ(channel_.read().error, "counts.passes: 4294967295 is above 4096");
}

TEST_F(ChannelTables, FullTablesAreReadInTime) {
  Tables& tables = child_.tables();
  tables.counts = {kMaxPasses, kMaxSteps, kMaxMatrices, kMaxSamples, kMaxCopies, 9, 9, 9,
                   9,          9,         kRoom};
  child_.header().frames[0].passCount = kMaxPasses;
  for (std::uint32_t i = 0; i < kMaxPasses; ++i) {
    tables.passes[i] = tables.passes[0];
    tables.passes[i].firstStep = 2 * i;
  }
  for (std::uint32_t i = 0; i < kMaxSteps; ++i) {
    tables.steps[i] = tables.steps[0];
    tables.steps[i].pass = i / 2;
    tables.steps[i].firstMatrix = 4 * i;
    tables.steps[i].matrixCount = 4;
    tables.steps[i].firstSample = 2 * i;
    tables.steps[i].sampleCount = 2;
  }
  for (std::uint32_t i = 0; i < kMaxCopies; ++i)
    tables.copies[i] = {i / 2, kNone, 0, number(PixelType::u8x4), 1, 1, 0, 4};
  EXPECT_EQ(channel_.read().error, "copies[1].offset: 0 is below 4") << "no two share bytes";
  tables.counts.copies = kRoom / 4;
  for (std::uint32_t i = 0; i < kRoom / 4; ++i) tables.copies[i].offset = 4 * i;
  const auto start = std::chrono::steady_clock::now();
  const Capture capture = channel_.read();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  EXPECT_EQ(capture.error, "");
  EXPECT_EQ(capture.trace.passesOf(0).size(), kMaxPasses);
  EXPECT_EQ(capture.trace.copiesLost, 9U);
}

/// Whatever stands in the tables, what is accepted can be used.
TEST_F(ChannelTables, NoBytesCrashTheReader) {
  const auto good = std::make_unique<Tables>(child_.tables());
  std::mt19937 random(1);
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  struct Part {
    std::size_t offset, size;
  };
  const Part parts[] = {{offsetof(Tables, counts), sizeof(Counts)},
                        {offsetof(Tables, passes), 3 * sizeof(PassRecord)},
                        {offsetof(Tables, steps), 4 * sizeof(StepRecord)},
                        {offsetof(Tables, matrices), 3 * sizeof(MatrixRecord)},
                        {offsetof(Tables, samples), 2 * sizeof(SampleRecord)},
                        {offsetof(Tables, copies), 3 * sizeof(CopyRecord)}};
  int accepted = 0, refused = 0;
  for (int round = 0; round < 4000; ++round) {
    auto* const bytes = reinterpret_cast<unsigned char*>(&child_.tables());
    std::vector<std::pair<std::size_t, unsigned char>> before;
    for (std::size_t changes = 1 + below(4); changes-- > 0;) {
      const Part& part = parts[below(std::size(parts))];
      const std::size_t at = part.offset + below(part.size);
      before.emplace_back(at, bytes[at]);
      constexpr unsigned char kOften[] = {0, 1, 2, 0x7F, 0x80, 0xFF};
      bytes[at] = static_cast<unsigned char>(below(2) ? kOften[below(6)] : below(256));
    }
    const Capture capture = channel_.read();
    if (capture.error.empty()) {
      ++accepted;
      const Trace& trace = capture.trace;
      EXPECT_LT(toJson(trace).dump().size(), 1U << 20);
      for (const CopyRecord& copy : trace.copies) EXPECT_FALSE(trace.image(copy).empty());
      for (std::size_t frame = 0; frame < trace.frames.size(); ++frame)
        for (const PassRecord& pass : trace.passesOf(frame)) EXPECT_LT(trace.indexOf(pass), 3U);
    } else {
      ++refused;
      EXPECT_THAT(capture.error, HasSubstr(": "));
    }
    for (auto change = before.rbegin(); change != before.rend(); ++change)
      bytes[change->first] = change->second;
  }
  EXPECT_GT(accepted, 200);
  EXPECT_GT(refused, 200);
  EXPECT_EQ(std::memcmp(&child_.tables(), good.get(), sizeof(Tables)), 0);
}

} // namespace
} // namespace ggrade::channel
