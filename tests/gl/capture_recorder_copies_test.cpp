// What copies hold, compared with what was cleared to; and that making them changes nothing.

#include "capture_traces.hpp"

#include <gmock/gmock.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace ggrade::test {
namespace {

using testing::ElementsAre;
using trace::kDepth;
using trace::kStencil;
using trace::PixelType;

struct Format {
  std::string name;
  std::vector<std::string> words; ///< for the program formats
  std::uint32_t attachment;
  PixelType type;
  std::vector<double> lower, upper; ///< values of the lower half of the image, of the upper
  double tolerance = 0;
};

void PrintTo(const Format& format, std::ostream* out) {
  *out << format.name;
}

/// `values` are what the program clears to.
Format color(const std::string& name, GLenum format, char kind, std::vector<double> values,
             PixelType type, std::vector<double> lower, std::vector<double> upper,
             double tolerance = 0) {
  Format result{
      name,     {"color", std::to_string(format), std::string(1, kind)}, 0, type, lower, upper,
      tolerance};
  for (const double value : values) {
    std::ostringstream text;
    text.precision(17);
    text << value;
    result.words.push_back(text.str());
  }
  return result;
}

Format depth(const std::string& name, GLenum format, double tolerance) {
  return {
      name,     {"depth", std::to_string(format), "0.7"}, kDepth, PixelType::f32x1, {0.7}, {0.35},
      tolerance};
}

Format packed(const std::string& name, GLenum format, std::uint32_t attachment, double tolerance) {
  const bool isDepth = attachment == kDepth;
  return {name,
          {"depth_stencil", std::to_string(format), "0.7", "200"},
          attachment,
          isDepth ? PixelType::f32x1 : PixelType::u8x1,
          {isDepth ? 0.7 : 200},
          {isDepth ? 0.35 : 100},
          tolerance};
}

Format in(const std::string& holder, Format format) {
  format.name += "_" + holder;
  format.words.insert(format.words.begin(), holder);
  return format;
}

const double kInfinity = std::numeric_limits<double>::infinity();
const double kNan = std::numeric_limits<double>::quiet_NaN();

/// An 8-bit sRGB value to linear.
double linear(int encoded) {
  const double value = encoded / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// The program doesn't encode, so that 0.2 is stored as the byte 51.
const std::vector<double> kSrgbLower{linear(51), linear(102), linear(204), 102 / 255.0};
const std::vector<double> kSrgbUpper{linear(26), linear(51), linear(102), 51 / 255.0};

const Format kFormats[] = {
    color("RGBA8", GL_RGBA8, 'f', {0.2, 0.4, 0.8, 1}, PixelType::u8x4, {51, 102, 204, 255},
          {26, 51, 102, 128}),
    color("RGB8", GL_RGB8, 'f', {0.2, 0.4, 0.8, 0.4}, PixelType::u8x4, {51, 102, 204, 255},
          {26, 51, 102, 255}),
    color("R8", GL_R8, 'f', {0.2, 0.4, 0.8, 0.4}, PixelType::u8x4, {51, 0, 0, 255},
          {26, 0, 0, 255}),
    color("RGBA16", GL_RGBA16, 'f', {0.2, 0.4, 0.8, 1}, PixelType::f32x4, {0.2, 0.4, 0.8, 1},
          {0.1, 0.2, 0.4, 0.5}, 1e-5),
    color("RGB10_A2", GL_RGB10_A2, 'f', {0.2, 0.4, 0.8, 1}, PixelType::f32x4, {0.2, 0.4, 0.8, 1},
          {0.1, 0.2, 0.4, 2 / 3.0}, 1e-3),
    color("RGBA8_SNORM", GL_RGBA8_SNORM, 'f', {-1, 0, 1, -0.5}, PixelType::f32x4, {-1, 0, 1, -0.5},
          {-0.5, 0, 0.5, -0.25}, 5e-3),
    color("RGBA16F", GL_RGBA16F, 'f', {65504, -2, 0.25, 1.1920928955078125e-7}, PixelType::f16x4,
          {65504, -2, 0.25, 1.1920928955078125e-7}, {32752, -1, 0.125, 5.9604644775390625e-8}),
    color("R16F", GL_R16F, 'f', {3, 1, 1, 1}, PixelType::f16x4, {3, 0, 0, 1}, {1.5, 0, 0, 1}),
    color("R11F_G11F_B10F", GL_R11F_G11F_B10F, 'f', {65024, 0.5, 3, 0.25}, PixelType::f16x4,
          {65024, 0.5, 3, 1}, {32512, 0.25, 1.5, 1}),
    color("RGBA32F", GL_RGBA32F, 'f', {1e30, -0.1, kInfinity, 7}, PixelType::f32x4,
          {1e30, -0.1F, kInfinity, 7}, {5e29, -0.05F, kInfinity, 3.5}, 1e24),
    color("RGBA32F_small", GL_RGBA32F, 'f', {0.1, -0.1, 3e-30, 7}, PixelType::f32x4,
          {0.1F, -0.1F, 3e-30F, 7}, {0.05F, -0.05F, 1.5e-30F, 3.5}),
    color("RGBA32F_nan", GL_RGBA32F, 'f', {kNan, -kInfinity, 1, 0}, PixelType::f32x4,
          {kNan, -kInfinity, 1, 0}, {kNan, -kInfinity, 0.5, 0}),
    color("RGBA16F_nan", GL_RGBA16F, 'f', {kNan, -1, 1, 0}, PixelType::f16x4, {kNan, -1, 1, 0},
          {kNan, -0.5, 0.5, 0}),
    color("SRGB8_ALPHA8", GL_SRGB8_ALPHA8, 'f', {0.2, 0.4, 0.8, 0.4}, PixelType::f32x4, kSrgbLower,
          kSrgbUpper, 1e-7),
    color("RGBA32I", GL_RGBA32I, 'i', {-2147483646, 6, -2, 2147483646}, PixelType::i32x4,
          {-2147483646, 6, -2, 2147483646}, {-1073741823, 3, -1, 1073741823}),
    color("RGBA8I", GL_RGBA8I, 'i', {-128, 126, -2, 4}, PixelType::i32x4, {-128, 126, -2, 4},
          {-64, 63, -1, 2}),
    color("RGBA32UI", GL_RGBA32UI, 'u', {4294967294.0, 6, 2, 0}, PixelType::u32x4,
          {4294967294.0, 6, 2, 0}, {2147483647, 3, 1, 0}),
    color("R16UI", GL_R16UI, 'u', {65534, 6, 2, 4}, PixelType::u32x4, {65534, 0, 0, 1},
          {32767, 0, 0, 1}),
    depth("DEPTH16", GL_DEPTH_COMPONENT16, 1e-5),
    depth("DEPTH24", GL_DEPTH_COMPONENT24, 1e-7),
    depth("DEPTH32F", GL_DEPTH_COMPONENT32F, 5e-8),
    packed("D24S8_depth", GL_DEPTH24_STENCIL8, kDepth, 1e-7),
    packed("D24S8_stencil", GL_DEPTH24_STENCIL8, kStencil, 0),
    packed("D32FS8_depth", GL_DEPTH32F_STENCIL8, kDepth, 5e-8),
    packed("D32FS8_stencil", GL_DEPTH32F_STENCIL8, kStencil, 0),
    in("renderbuffer", color("RGBA8", GL_RGBA8, 'f', {0.2, 0.4, 0.8, 1}, PixelType::u8x4,
                             {51, 102, 204, 255}, {26, 51, 102, 128})),
    in("renderbuffer", packed("D24S8_stencil", GL_DEPTH24_STENCIL8, kStencil, 0)),
    in("renderbuffer", depth("DEPTH16", GL_DEPTH_COMPONENT16, 1e-5)),
    in("multisampled", color("RGBA8", GL_RGBA8, 'f', {0.2, 0.4, 0.8, 1}, PixelType::u8x4,
                             {51, 102, 204, 255}, {26, 51, 102, 128})),
    in("multisampled", color("RGBA16F", GL_RGBA16F, 'f', {1000, -2, 0.25, 1}, PixelType::f16x4,
                             {1000, -2, 0.25, 1}, {500, -1, 0.125, 0.5})),
    in("multisampled", color("SRGB8_ALPHA8", GL_SRGB8_ALPHA8, 'f', {0.2, 0.4, 0.8, 0.4},
                             PixelType::f32x4, kSrgbLower, kSrgbUpper, 1e-7)),
    in("multisampled", color("RGBA32UI", GL_RGBA32UI, 'u', {4294967294.0, 6, 2, 0},
                             PixelType::u32x4, {4294967294.0, 6, 2, 0}, {2147483647, 3, 1, 0})),
    in("multisampled", depth("DEPTH24", GL_DEPTH_COMPONENT24, 1e-7)),
    in("multisampled", packed("D24S8_depth", GL_DEPTH24_STENCIL8, kDepth, 1e-7)),
    in("multisampled", packed("D24S8_stencil", GL_DEPTH24_STENCIL8, kStencil, 0)),
    in("multisampled_texture", color("RGBA16F", GL_RGBA16F, 'f', {1000, -2, 0.25, 1},
                                     PixelType::f16x4, {1000, -2, 0.25, 1}, {500, -1, 0.125, 0.5})),
    in("multisampled_texture", depth("DEPTH32F", GL_DEPTH_COMPONENT32F, 5e-8)),
};

class CaptureCopies : public testing::TestWithParam<Format> {};

void expectValues(const std::vector<double>& found, const std::vector<double>& expected,
                  double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (std::isnan(expected[i])) {
      EXPECT_TRUE(std::isnan(found[i])) << "component " << i << " is " << found[i];
    } else if (std::isinf(expected[i])) {
      EXPECT_EQ(found[i], expected[i]) << "component " << i;
    } else {
      EXPECT_NEAR(found[i], expected[i], tolerance) << "component " << i;
    }
  }
}

TEST_P(CaptureCopies, HoldWhatIsStored) {
  const Format& format = GetParam();
  CaptureOptions options;
  options.arguments = format.words;
  options.trace = everything();
  const CaptureRun run = runCaptured("formats", {{0, 8, 8}}, options);
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  ASSERT_EQ(run.capture.error, "");
  const trace::Trace& trace = run.capture.trace;
  ASSERT_EQ(trace.passes.size(), 1U);
  EXPECT_EQ(trace.copiesLost, 0U);
  const trace::CopyRecord* const copy = trace.copyOf(0, format.attachment);
  ASSERT_NE(copy, nullptr);
  EXPECT_EQ(copy->type, static_cast<std::uint32_t>(format.type));
  EXPECT_EQ(copy->width, 16U);
  EXPECT_EQ(copy->height, 8U);
  for (const std::uint32_t x : {0U, 15U}) {
    for (const std::uint32_t y : {0U, 3U, 4U, 7U}) {
      SCOPED_TRACE(testing::Message() << "pixel " << x << " " << y);
      expectValues(valueOf(trace, *copy, x, y), y < 4 ? format.upper : format.lower,
                   format.tolerance);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, CaptureCopies, testing::ValuesIn(kFormats),
                         [](const auto& info) { return info.param.name; });

TEST(CaptureCopyRequests, ChooseAttachments) {
  trace::Request request = everything();
  request.copies = 1U << kStencil;
  const trace::Trace trace = record("passes", "clears", 1, request).capture.trace;
  ASSERT_EQ(trace.copies.size(), 1U);
  EXPECT_EQ(trace.copies[0].pass, 1U);
  EXPECT_THAT(valueAfter(trace, 1, kStencil, 0, 0), ElementsAre(7));
  EXPECT_THAT(valueAfter(trace, 1, kStencil, 7, 7), ElementsAre(7));
}

TEST(CaptureCopyRequests, LeaveOutTheWindowAndRenderbuffers) {
  trace::Request request = everything();
  request.windowCopies = 0;
  request.renderbufferCopies = 0;
  const trace::Trace trace = record("passes", "blit", 1, request).capture.trace;
  ASSERT_EQ(trace.copies.size(), 1U);
  EXPECT_EQ(trace.copies[0].pass, 1U);
}

// As in a grading: the window's stencil and nothing else of it.
TEST(CaptureCopyRequests, AreForSomeOfTheWindowsAttachments) {
  trace::Request request = everything();
  request.windowCopies = 1U << kStencil;
  const trace::Trace trace = record("passes", "clears", 1, request).capture.trace;
  ASSERT_EQ(trace.copies.size(), 1U);
  EXPECT_THAT(valueAfter(trace, 1, kStencil, 0, 0), ElementsAre(7));
}

TEST(CaptureCopyRequests, EndAfterSomeFrames) {
  trace::Request request = everything();
  request.copyFrames = 2;
  const trace::Trace trace = record("samples", "ping_pong", 3, request).capture.trace;
  EXPECT_EQ(trace.passes.size(), 6U);
  EXPECT_EQ(trace.copies.size(), 4U);
}

TEST(CaptureCopyRequests, CanBeForEveryStep) {
  trace::Request request = everything();
  request.stepCopies = 1;
  const trace::Trace trace = record("passes", "steps", 1, request).capture.trace;
  ASSERT_EQ(trace.steps.size(), 11U);
  for (std::uint32_t step = 0; step < 10; ++step)
    EXPECT_NE(trace.copyOf(0, 0, step), nullptr) << "step " << step;
  EXPECT_EQ(trace.copyOf(0, 0, 10), nullptr) << "nothing was rasterized";
  EXPECT_EQ(trace.copyOf(0, kDepth, 0), nullptr);
  EXPECT_NE(trace.copyOf(0, kDepth, 2), nullptr);
  EXPECT_EQ(trace.copyOf(0, kDepth, 3), nullptr) << "depth writes were off";
  EXPECT_NE(trace.copyOf(0, 0), nullptr);
}

TEST(CaptureCopiesOfTheWindow, AreWhatIsHandedOver) {
  const channel::Capture capture = record("passes", "attachments").capture;
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 8; ++x) {
      const std::vector<int> shown = pixel(capture.frames.at(0), x, y);
      EXPECT_EQ(valueAfter(capture.trace, 3, 0, x, y),
                std::vector<double>(shown.begin(), shown.end()));
    }
  }
}

TEST(CaptureCopiesOfTheWindow, KeepTheTopRowFirst) {
  // A red triangle in the lower left half.
  CaptureOptions options;
  options.trace = everything();
  const channel::Capture capture = runCaptured("triangle", {{0, 32, 16}}, options).capture;
  EXPECT_THAT(valueAfter(capture.trace, 0, 0, 31, 0), ElementsAre(51, 102, 153, 255));
  EXPECT_THAT(valueAfter(capture.trace, 0, 0, 0, 15), ElementsAre(255, 0, 0, 255));
}

/// Whatever is recorded, the program sees its own state, errors and messages.
TEST(CaptureState, IsTheProgramsOwn) {
  const char* const expected = "heard: GL_INVALID_VALUE in glDrawElements\n"
                               "heard: GL_INVALID_VALUE in glDrawElements\n"
                               "heard: GL_INVALID_VALUE in glDrawElements\n"
                               "done\n";
  const CaptureRun plain = record("state_kept", "", 1, {});
  EXPECT_EQ(plain.output, expected);
  trace::Request request = everything();
  request.stepCopies = 1;
  request.times = 1;
  const CaptureRun recorded = record("state_kept", "", 1, request);
  EXPECT_EQ(recorded.output, expected);
  EXPECT_EQ(recorded.capture.messages.size(), plain.capture.messages.size());
  EXPECT_EQ(recorded.capture.trace.passes.size(), 6U);
  EXPECT_EQ(recorded.capture.trace.copiesLost, 0U);
  EXPECT_EQ(recorded.capture.frames.at(0).pixels, plain.capture.frames.at(0).pixels);
}

/// Recording, copies and timing change no pixel.
TEST(CaptureState, LeavesTheImageBitForBit) {
  CaptureOptions options;
  const CaptureRun plain = runCaptured("lit_scene", {{0, 0, 0}, {1, 0, 0}}, options);
  options.trace = everything();
  options.trace.stepCopies = 1;
  options.trace.times = 1;
  const CaptureRun recorded = runCaptured("lit_scene", {{0, 0, 0}, {1, 0, 0}}, options);
  ASSERT_EQ(recorded.capture.error, "");
  ASSERT_EQ(recorded.capture.frames.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(recorded.capture.frames[i].pixels, plain.capture.frames.at(i).pixels) << i;
  EXPECT_EQ(recorded.capture.trace.passes.size(), 2U);
}

} // namespace
} // namespace ggrade::test
