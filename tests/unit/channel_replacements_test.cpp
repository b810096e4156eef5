// The judging side of replaced outputs: plans that no run could follow, and children that claim
// what cannot have been.

#include "channel_child.hpp"
#include "framework_throws.hpp"

#include <gmock/gmock.h>

#include <GL/glcorearb.h>

namespace ggrade::channel {
namespace {

using trace::PixelType;

trace::Request passes() {
  trace::Request request{};
  request.passes = 1;
  return request;
}

/// 2 x 3 pixels whose bytes count up, row 0 on top.
PassPixels colours() {
  PassPixels pixels{0, 0, PixelType::u8x4, GL_RGBA8, 2, 3, {}};
  for (int i = 0; i < 24; ++i) pixels.pixels.push_back(std::byte(i));
  return pixels;
}

PassPixels depths() {
  PassPixels pixels{1, trace::kDepth, PixelType::f32x1, GL_DEPTH_COMPONENT24, 1, 1, {}};
  pixels.pixels.resize(4, std::byte(0x11));
  return pixels;
}

/// A run of one frame with two passes, whose child has made both replacements.
class ChannelReplacements : public testing::Test {
protected:
  ChannelReplacements()
      : channel_({{0, 2, 2}}, kDefaultMaxPixels, passes(), {colours(), depths()}) {
    Header& header = child_.header();
    header.started = header.contextMade = header.framesDone = 1;
    header.frames[0].written = 1;
    header.frames[0].width = header.frames[0].height = 2;
    header.frames[0].passCount = 2;
    header.replacements[0] = header.replacements[1] =
        static_cast<std::uint32_t>(ReplacementAnswer::done);
    trace::Tables& tables = child_.tables();
    tables.counts.passes = 2;
    for (std::uint32_t i = 0; i < 2; ++i) {
      trace::PassRecord& pass = tables.passes[i];
      pass.kind = static_cast<std::uint32_t>(trace::PassKind::draw);
      const auto texture = static_cast<std::uint32_t>(trace::ImageKind::texture);
      pass.images[0] = {texture, 1, GL_TEXTURE_2D, 0, trace::kNone, GL_RGBA8, 2, 3, 0};
      pass.images[trace::kDepth] = {
          texture, 2, GL_TEXTURE_2D, 0, trace::kNone, GL_DEPTH_COMPONENT24, 1, 1, 0};
    }
  }
  Channel channel_;
  ChildView child_{channel_};
};

TEST_F(ChannelReplacements, StandInTheFileWithTheBottomRowFirst) {
  const Plan& plan = channel_.plan();
  ASSERT_EQ(plan.replacementCount, 2U);
  EXPECT_EQ(plan.replacements[0].bytes, 24U);
  EXPECT_EQ(plan.replacements[1].offset, 32U) << "where any value may begin";
  const unsigned char* const bytes =
      child_.copies(plan) + replacementsOffset(plan) - copiesOffset(plan);
  EXPECT_EQ(bytes[0], 16);
  EXPECT_EQ(bytes[7], 23);
  EXPECT_EQ(bytes[8], 8);
  EXPECT_EQ(bytes[16], 0);
  EXPECT_EQ(bytes[32], 0x11);
  EXPECT_EQ(totalBytes(plan), replacementsOffset(plan) + 48);
}

TEST_F(ChannelReplacements, AnswersAreReadInOrder) {
  child_.header().replacements[1] = static_cast<std::uint32_t>(ReplacementAnswer::refused);
  const Capture capture = channel_.read();
  EXPECT_EQ(capture.error, "");
  EXPECT_THAT(capture.replacements,
              testing::ElementsAre(ReplacementAnswer::done, ReplacementAnswer::refused));
}

TEST_F(ChannelReplacements, EveryForgeryIsNamed) {
  struct Case {
    const char* error;
    void (*forge)(Header&, trace::Tables&);
  };
  const Case cases[] = {
      {"replacements[1].answer: 4 is above 3",
       [](Header& header, trace::Tables&) { header.replacements[1] = 4; }},
      {"replacements[1].pass: 1 + 1 is above 1",
       [](Header& header, trace::Tables& tables) {
         tables.counts.passes = header.frames[0].passCount = 1;
       }},
      {"replacements[1].frame: 1 is not 0",
       [](Header& header, trace::Tables& tables) {
         header.frames[0].passCount = 1;
         tables.passes[1].frame = 1;
       }},
      {"replacements[0].kind: 3 is not 2",
       [](Header&, trace::Tables& tables) {
         tables.passes[0].images[0].kind =
             static_cast<std::uint32_t>(trace::ImageKind::renderbuffer);
       }},
      {"replacements[0].samples: 4 is not 0",
       [](Header&, trace::Tables& tables) { tables.passes[0].images[0].samples = 4; }},
      {"replacements[0].format: 34842 is not 32856",
       [](Header&, trace::Tables& tables) { tables.passes[0].images[0].format = GL_RGBA16F; }},
      {"replacements[0].width: 3 is not 2",
       [](Header&, trace::Tables& tables) { tables.passes[0].images[0].width = 3; }},
      {"replacements[1].height: 2 is not 1",
       [](Header&, trace::Tables& tables) { tables.passes[1].images[trace::kDepth].height = 2; }},
  };
  for (const Case& bad : cases) {
    Channel channel({{0, 2, 2}}, kDefaultMaxPixels, passes(), {colours(), depths()});
    ChildView child(channel);
    child.header() = child_.header();
    child.tables() = child_.tables();
    bad.forge(child.header(), child.tables());
    const Capture capture = channel.read();
    EXPECT_EQ(capture.error, bad.error);
    EXPECT_TRUE(capture.frames.empty());
    EXPECT_TRUE(capture.replacements.empty());
  }
  EXPECT_EQ(channel_.read().error, "");
}

TEST_F(ChannelReplacements, OnlyThosePlannedAreRead) {
  child_.header().replacements[2] = 99;
  EXPECT_EQ(channel_.read().error, "");
  EXPECT_EQ(channel_.read().replacements.size(), 2U);
  EXPECT_TRUE(Channel({{0, 2, 2}}).read().replacements.empty());
}

TEST(ChannelReplacementPlans, ThatNoRunCouldFollowAreRefused) {
  struct Case {
    const char* error;
    void (*spoil)(PassPixels&);
  };
  const Case cases[] = {
      {"a pass is one of 4096", [](PassPixels& pixels) { pixels.pass = trace::kMaxPasses; }},
      {"what is replaced is colour, or depth by floats",
       [](PassPixels& pixels) { pixels.attachment = trace::kStencil; }},
      {"what is replaced is colour, or depth by floats",
       [](PassPixels& pixels) { pixels.attachment = trace::kDepth; }},
      {"what is replaced is colour, or depth by floats",
       [](PassPixels& pixels) { pixels.type = PixelType::f32x1; }},
      {"what is replaced is colour, or depth by floats",
       [](PassPixels& pixels) { pixels.type = PixelType(99); }},
      {"what is replaced has 1 to 16384 pixels a side",
       [](PassPixels& pixels) { pixels.width = 0, pixels.pixels.clear(); }},
      {"what is replaced has 1 to 16384 pixels a side",
       [](PassPixels& pixels) { pixels.height = 16385; }},
      {"as many bytes are put in place as the image has",
       [](PassPixels& pixels) { pixels.pixels.pop_back(); }},
      {"as many bytes are put in place as the image has",
       [](PassPixels& pixels) { pixels.type = PixelType::f16x4; }},
  };
  const auto make = [](const std::vector<PassPixels>& all, const trace::Request& request) {
    return messageOf<std::invalid_argument>([&] {
      Channel({{0, 2, 2}}, kDefaultMaxPixels, request, all);
    });
  };
  for (const Case& bad : cases) {
    PassPixels pixels = colours();
    bad.spoil(pixels);
    EXPECT_EQ(make({pixels}, passes()), std::string("capture plan: ") + bad.error);
  }
  EXPECT_EQ(make({colours()}, {}), "capture plan: nothing is replaced without the passes");
  EXPECT_EQ(make(std::vector<PassPixels>(33, colours()), passes()),
            "capture plan: 32 outputs at most are replaced");
}

} // namespace
} // namespace ggrade::channel
