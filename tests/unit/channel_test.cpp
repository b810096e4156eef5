// The judging side of the capture channel against children that write what they like.

#include "channel_child.hpp"
#include "framework_throws.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sys/stat.h>
#include <unistd.h>

namespace ggrade::channel {
namespace {

/// A channel of two 2x2 frames whose child has written both, rows numbered from the bottom.
class ChannelRead : public testing::Test {
protected:
  ChannelRead() : channel_({{0.25, 2, 2}, {0.5, 2, 2}}), child_(channel_) {
    Header& header = child_.header();
    header.started = header.contextMade = 1;
    header.framesDone = 2;
    header.contextSeconds = 0.06;
    std::strcpy(header.glVersion, "4.5");
    for (std::uint32_t i = 0; i < 2; ++i) {
      header.frames[i].written = 1;
      header.frames[i].width = header.frames[i].height = 2;
      for (int byte = 0; byte < 16; ++byte) {
        child_.slot(channel_.plan(), i)[byte] = static_cast<unsigned char>(16 * i + byte);
      }
    }
    header.messageCount = 1;
    header.messages[0] = {1, 1, 3, trace::kNone, "GL_INVALID_ENUM in glEnable"};
  }
  Channel channel_;
  ChildView child_;
};

TEST_F(ChannelRead, CopiesFramesWithTheTopRowFirst) {
  const Capture capture = channel_.read();
  ASSERT_EQ(capture.error, "");
  EXPECT_TRUE(capture.started);
  EXPECT_TRUE(capture.contextMade);
  EXPECT_FALSE(capture.endedByCapture);
  EXPECT_EQ(capture.contextSeconds, 0.06);
  EXPECT_EQ(capture.glVersion, "4.5");
  ASSERT_EQ(capture.frames.size(), 2U);
  EXPECT_EQ(capture.frames[1].time, 0.5);
  EXPECT_THAT(capture.frames[0].pixels,
              testing::ElementsAre(8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_EQ(capture.frames[1].pixels[0], 24);
  ASSERT_EQ(capture.messages.size(), 1U);
  EXPECT_EQ(capture.messages[0].kind, MessageKind::glError);
  EXPECT_EQ(capture.messages[0].count, 3U);
  EXPECT_EQ(capture.messages[0].text, "GL_INVALID_ENUM in glEnable");
}

TEST_F(ChannelRead, OddHeightsKeepTheirMiddleRow) {
  const Channel channel({{0, 1, 3}});
  ChildView child(channel);
  child.header().framesDone = 1;
  child.header().frames[0].written = 1;
  child.header().frames[0].width = 1;
  child.header().frames[0].height = 3;
  for (int byte = 0; byte < 12; ++byte)
    child.slot(channel.plan(), 0)[byte] = static_cast<unsigned char>(byte);
  EXPECT_THAT(channel.read().frames.at(0).pixels,
              testing::ElementsAre(8, 9, 10, 11, 4, 5, 6, 7, 0, 1, 2, 3));
}

/// Two frames before one that is looked at, and one after it.
TEST(ChannelUnseen, FramesAreNoneForWhoReads) {
  const Channel channel({{0.1, 1, 1, 1}, {0.2, 3, 3, 1}, {0.3, 2, 2}, {0.4, 1, 1, 1}, {0.5, 2, 2}},
                        kDefaultMaxPixels, everything(0));
  ChildView child(channel);
  Header& header = child.header();
  header.framesDone = 2;
  header.frames[0].width = 77; // of these nothing is read, and so nothing is checked
  EXPECT_EQ(channel.read().error, "");
  EXPECT_TRUE(channel.read().frames.empty());
  EXPECT_EQ(channel.read().unseenFrames, 2U);

  header.framesDone = 5;
  for (const int i : {2, 4}) {
    header.frames[i].written = 1;
    header.frames[i].width = header.frames[i].height = 2;
    header.frames[i].firstPass = i == 2 ? 0 : 2;
    header.frames[i].passCount = i == 2 ? 2 : 1;
    std::memset(child.slot(channel.plan(), std::uint32_t(i)), 10 * i, 16);
  }
  child.tables().counts.passes = 3;
  for (std::uint32_t i = 0; i < 3; ++i) {
    child.tables().passes[i].kind = 1;
    child.tables().passes[i].frame = i == 2;
  }
  header.messageCount = 5;
  for (std::uint32_t i = 0; i < 5; ++i) header.messages[i] = {1, i, 1, trace::kNone, ""};
  const Capture capture = channel.read();
  ASSERT_EQ(capture.error, "");
  ASSERT_EQ(capture.frames.size(), 2U);
  EXPECT_EQ(capture.unseenFrames, 3U);
  EXPECT_EQ(capture.frames[0].time, 0.3);
  EXPECT_EQ(capture.frames[1].time, 0.5);
  EXPECT_EQ(capture.frames[0].pixels[0], 20);
  EXPECT_EQ(capture.frames[1].pixels[0], 40);
  ASSERT_EQ(capture.trace.frames.size(), 2U);
  EXPECT_EQ(capture.trace.passesOf(0).size(), 2U);
  EXPECT_EQ(capture.trace.passesOf(1).size(), 1U);
  std::vector<std::uint32_t> frames; // a message belongs to the next one that is seen
  for (const CapturedMessage& message : capture.messages) frames.push_back(message.frame);
  EXPECT_THAT(frames, testing::ElementsAre(0, 0, 0, 1, 1));

  child.tables().passes[2].frame = 4;
  EXPECT_EQ(channel.read().error, "passes[2].frame: 4 is above 2");
}

TEST_F(ChannelRead, UntouchedFileIsAProgramThatNeverStarted) {
  const Channel fresh({{0, 2, 2}});
  const Capture capture = fresh.read();
  EXPECT_EQ(capture.error, "");
  EXPECT_FALSE(capture.started);
  EXPECT_TRUE(capture.frames.empty());
}

TEST_F(ChannelRead, TrustsItsOwnPlanOnly) {
  std::memset(static_cast<void*>(&child_.header().plan), 0xFF, sizeof(Plan));
  const Capture capture = channel_.read();
  EXPECT_EQ(capture.error, "");
  EXPECT_EQ(capture.frames.size(), 2U);
  EXPECT_EQ(capture.frames[0].time, 0.25);
}

TEST_F(ChannelRead, SanitizesText) {
  std::strcpy(child_.header().messages[0].text, "a\x1B[2J\xFF");
  EXPECT_EQ(channel_.read().messages[0].text, "a\xEF\xBF\xBD[2J\xEF\xBF\xBD");
}

TEST_F(ChannelRead, AllOnesAreRefused) {
  child_.fill(0xFF);
  const Capture capture = channel_.read();
  EXPECT_EQ(capture.error, "started: 4294967295 is above 1");
  EXPECT_TRUE(capture.frames.empty());
  EXPECT_TRUE(capture.messages.empty());
}

TEST_F(ChannelRead, EveryForgeryIsNamed) {
  struct Case {
    const char* error;
    void (*forge)(Header&);
  };
  const Case cases[] = {
      {"contextMade: 2 is above 1", [](Header& header) { header.contextMade = 2; }},
      {"endedByCapture: 7 is above 1", [](Header& header) { header.endedByCapture = 7; }},
      {"framesDone: 3 is above 2", [](Header& header) { header.framesDone = 3; }},
      {"framesDone: 4294967295 is above 2", [](Header& header) { header.framesDone = ~0U; }},
      {"messageCount: 65 is above 64", [](Header& header) { header.messageCount = 65; }},
      {"contextSeconds: nan is not a time from 0 to 1000000 seconds",
       [](Header& header) { header.contextSeconds = std::numeric_limits<double>::quiet_NaN(); }},
      {"shaderSeconds: inf is not a time from 0 to 1000000 seconds",
       [](Header& header) { header.shaderSeconds = std::numeric_limits<double>::infinity(); }},
      {"glVersion: the text does not end",
       [](Header& header) { std::memset(header.glVersion, 'x', sizeof(header.glVersion)); }},
      {"glRenderer: the text does not end",
       [](Header& header) { std::memset(header.glRenderer, 'x', sizeof(header.glRenderer)); }},
      {"messages[0].kind: 0 is below 1", [](Header& header) { header.messages[0].kind = 0; }},
      {"messages[0].kind: 4 is above 3", [](Header& header) { header.messages[0].kind = 4; }},
      {"messages[0].frame: 65 is above 64", [](Header& header) { header.messages[0].frame = 65; }},
      {"messages[0].text: the text does not end",
       [](Header& header) { std::memset(header.messages[0].text, 'x', sizeof(Message::text)); }},
      {"frames[1].written: 2 is above 1", [](Header& header) { header.frames[1].written = 2; }},
      {"frames[1].windowSrgb: 2 is above 1",
       [](Header& header) { header.frames[1].windowSrgb = 2; }},
      {"frames[1].width: 0 is below 1", [](Header& header) { header.frames[1].width = 0; }},
      {"frames[1].width: 20000 is above 16384",
       [](Header& header) { header.frames[1].width = 20000; }},
      {"frames[1].height: 4294967295 is above 16384",
       [](Header& header) { header.frames[1].height = ~0U; }},
      {"frames[0].bytes: 24 is above 16", [](Header& header) { header.frames[0].width = 3; }},
      {"frames[0].size: 1x4 is not the planned 2x2",
       [](Header& header) { header.frames[0].width = 1, header.frames[0].height = 4; }},
      {"frames[0].seconds: -1.000000 is not a time from 0 to 1000000 seconds",
       [](Header& header) { header.frames[0].seconds = -1; }},
  };
  const Header good = child_.header();
  for (const Case& bad : cases) {
    child_.header() = good;
    bad.forge(child_.header());
    const Capture capture = channel_.read();
    EXPECT_EQ(capture.error, bad.error);
    EXPECT_TRUE(capture.frames.empty());
  }
  child_.header() = good;
  EXPECT_EQ(channel_.read().error, "");
}

TEST_F(ChannelRead, AFrameThatWasTooLargeHasASizeAndNoPixels) {
  const Channel channel({{0, 0, 0}}); // the program chooses the size
  ChildView child(channel);
  child.header().framesDone = 1;
  child.header().frames[0].width = 9999;
  child.header().frames[0].height = 2;
  const Capture capture = channel.read();
  EXPECT_EQ(capture.error, "");
  EXPECT_EQ(capture.frames[0].width, 9999U);
  EXPECT_TRUE(capture.frames[0].pixels.empty());
}

TEST(Channel, CannotBeResizedByTheChild) {
  const Channel channel({{0, 4, 4}});
  EXPECT_NE(ftruncate(channel.descriptor(), 0), 0);
  EXPECT_NE(ftruncate(channel.descriptor(), 1 << 20), 0);
  EXPECT_NE(fcntl(channel.descriptor(), F_ADD_SEALS, F_SEAL_WRITE), 0);
  struct stat status {};
  fstat(channel.descriptor(), &status);
  EXPECT_EQ(static_cast<std::uint64_t>(status.st_size), totalBytes(channel.plan()));
  EXPECT_EQ(totalBytes(channel.plan()) - slotOffset(channel.plan(), 0), kPage);
}

TEST(Channel, LeavesRoomForSizesThatTheProgramChooses) {
  EXPECT_EQ(Channel({{0, 0, 100}}).plan().slotBytes, std::uint64_t{4} * 1920 * 1080);
  EXPECT_EQ(Channel({{0, 0, 0}, {0, 40, 30}}, 500).plan().slotBytes, std::uint64_t{4} * 1200);
}

TEST(Channel, RefusesImpossiblePlans) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Channel({}), std::invalid_argument);
  EXPECT_THROW(Channel(std::vector<PlannedFrame>(65, {0, 1, 1})), std::invalid_argument);
  EXPECT_THROW(Channel({{-1, 1, 1}}), std::invalid_argument);
  EXPECT_THROW(Channel({{nan, 1, 1}}), std::invalid_argument);
  EXPECT_THROW(Channel({{0, 16385, 1}}), std::invalid_argument);
  EXPECT_THROW(Channel({{0, 0, 0}}, 0), std::invalid_argument);
  EXPECT_THROW(Channel({{0, 1, 1, 2}}), std::invalid_argument);
  EXPECT_THROW(Channel({{0, 1, 1, 1}}), std::invalid_argument) << "nothing is looked at";
}

TEST(Channel, RefusesImpossibleRequests) {
  struct Case {
    const char* error;
    void (*ask)(trace::Request&);
  };
  const Case cases[] = {
      {"what is recorded is 0 or 1", [](trace::Request& request) { request.passes = 2; }},
      {"what is recorded is 0 or 1", [](trace::Request& request) { request.stepCopies = 7; }},
      {"times are by no clock, 1 or 2", [](trace::Request& request) { request.times = 3; }},
      {"copies are of attachments 0 to 9", [](trace::Request& request) { request.copies = 1024; }},
      {"copies are of attachments 0 to 9",
       [](trace::Request& request) { request.windowCopies = 1024; }},
      {"copies are made in 64 frames at most",
       [](trace::Request& request) { request.copyFrames = 65; }},
      {"there is room for 2 GiB of copies at most",
       [](trace::Request& request) { request.copyBytes = kMaxCopyBytes + 1; }},
      {"64 frames at most are taped", [](trace::Request& request) { request.tapeFrames = 65; }},
      {"there is room for 1 GiB of tape at most",
       [](trace::Request& request) { request.tapeBytes = kMaxTapeBytes + 1; }},
      {"a tape has frames and room, or neither",
       [](trace::Request& request) { request.tapeFrames = 1; }},
      {"a tape has frames and room, or neither",
       [](trace::Request& request) { request.tapeBytes = 4096; }},
      {"nothing is recorded of passes without the passes",
       [](trace::Request& request) { request.passes = 0; }},
  };
  for (const Case& bad : cases) {
    trace::Request request{};
    request.passes = request.copies = 1;
    request.copyBytes = 4096;
    EXPECT_NO_THROW(Channel({{0, 1, 1}}, kDefaultMaxPixels, request));
    bad.ask(request);
    EXPECT_EQ(messageOf<std::invalid_argument>([&] {
                Channel({{0, 1, 1}}, kDefaultMaxPixels, request);
              }),
              std::string("capture plan: ") + bad.error);
  }
}

} // namespace
} // namespace ggrade::channel
