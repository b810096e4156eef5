// Pixels that the judging side puts in place of what a pass left: what is put in, what stays as it
// was, and where nothing is changed.

#include "capture_traces.hpp"

#include <gmock/gmock.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include <cmath>
#include <cstring>
#include <functional>

namespace ggrade::test {
namespace {

using channel::PassPixels;
using channel::ReplacementAnswer;
using testing::ElementsAre;
using trace::kDepth;
using trace::kStencil;
using trace::PixelType;

constexpr std::uint32_t kWidth = 16, kHeight = 8; // of the program formats

/// `value(i)` is the i-th number of the pixels, row 0 on top.
template <typename Value>
PassPixels pixels(std::uint32_t attachment, PixelType type, GLenum format,
                  const std::function<Value(std::uint32_t)>& value, std::uint32_t width = kWidth,
                  std::uint32_t height = kHeight) {
  PassPixels result{0, attachment, type, format, width, height, {}};
  result.pixels.resize(trace::bytesPerPixel(type) * width * height);
  for (std::uint32_t i = 0; i < result.pixels.size() / sizeof(Value); ++i) {
    const Value one = value(i);
    std::memcpy(result.pixels.data() + i * sizeof(Value), &one, sizeof(Value));
  }
  return result;
}

PassPixels bytes(GLenum format = GL_RGBA8, std::uint32_t width = kWidth,
                 std::uint32_t height = kHeight) {
  return pixels<std::uint8_t>(
      0, PixelType::u8x4, format,
      [](std::uint32_t i) { return static_cast<std::uint8_t>(i * 7 + 3); }, width, height);
}

/// Positive, finite and not subnormal, which this GL stores as 0 in R11F_G11F_B10F; `mask` leaves
/// the bits that a format has.
PassPixels halves(GLenum format, std::uint32_t mask, std::uint32_t width = kWidth,
                  std::uint32_t height = kHeight) {
  const bool alpha = format == GL_RGBA16F;
  return pixels<std::uint16_t>(
      0, PixelType::f16x4, format,
      [=](std::uint32_t i) {
        return static_cast<std::uint16_t>(!alpha && i % 4 == 3 ? 0x3C00
                                                               : 0x400 + (i * 199 % 0x7800 & mask));
      },
      width, height);
}

PassPixels floats() {
  return pixels<float>(0, PixelType::f32x4, GL_RGBA32F, [](std::uint32_t i) {
    return static_cast<float>(std::ldexp(1.0 / 3, static_cast<int>(i % 200) - 100)) *
           (i % 2 ? 1.0F : -1.0F);
  });
}

/// The i-th of the depths that are put in, as a whole number of so many bits.
std::uint32_t depthBits(std::uint32_t i, std::uint32_t bits) {
  return static_cast<std::uint32_t>(std::uint64_t{i} * 0x9E3779B1U >> (32 - bits)) &
         ((1U << bits) - 1);
}

PassPixels depths(GLenum format, std::uint32_t bits, std::uint32_t width = kWidth,
                  std::uint32_t height = kHeight) {
  return pixels<float>(
      kDepth, PixelType::f32x1, format,
      [=](std::uint32_t i) {
        return static_cast<float>(depthBits(i, bits) / double((1U << bits) - 1));
      },
      width, height);
}

CaptureRun replaced(const std::string& program, std::vector<std::string> words,
                    const std::vector<PassPixels>& replacements, int frames = 1) {
  CaptureOptions options;
  options.arguments = std::move(words);
  options.trace = everything();
  options.replacements = replacements;
  const std::vector<channel::PlannedFrame> planned(static_cast<std::size_t>(frames), {0, 8, 8});
  CaptureRun run = runCaptured(program, planned, options);
  EXPECT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_EQ(run.capture.error, "");
  return run;
}

std::vector<std::byte> bytesAfter(const CaptureRun& run, std::uint32_t pass,
                                  std::uint32_t attachment) {
  const trace::CopyRecord* const copy = run.capture.trace.copyOf(pass, attachment);
  return copy ? run.capture.trace.bytesOf(*copy) : std::vector<std::byte>();
}

std::string number(GLenum value) {
  return std::to_string(value);
}

struct Color {
  const char* name;
  PassPixels pixels;
  char kind; ///< of the clear
};

void PrintTo(const Color& color, std::ostream* out) {
  *out << color.name;
}

class CaptureReplacedColor : public testing::TestWithParam<Color> {};

TEST_P(CaptureReplacedColor, IsExactlyWhatWasPutIn) {
  const Color& color = GetParam();
  const std::vector<std::string> words = {
      "color", number(color.pixels.format), std::string(1, color.kind), "1", "0", "1", "1"};
  const CaptureRun run = replaced("formats", words, {color.pixels});
  EXPECT_THAT(run.capture.replacements, ElementsAre(ReplacementAnswer::done));
  EXPECT_EQ(bytesAfter(run, 0, 0), color.pixels.pixels);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, CaptureReplacedColor,
    testing::Values(Color{"RGBA8", bytes(), 'f'}, Color{"RGBA16F", halves(GL_RGBA16F, 0xFFFF), 'f'},
                    Color{"RGBA32F", floats(), 'f'},
                    Color{"R11F_G11F_B10F", halves(GL_R11F_G11F_B10F, 0xFFC0), 'f'},
                    Color{"RGBA32UI",
                          pixels<std::uint32_t>(0, PixelType::u32x4, GL_RGBA32UI,
                                                [](std::uint32_t i) { return i * 0x9E3779B1U; }),
                          'u'},
                    Color{"RGBA16I",
                          pixels<std::int32_t>(0, PixelType::i32x4, GL_RGBA16I,
                                               [](std::uint32_t i) { return 99 - int(i); }),
                          'i'}),
    [](const auto& info) { return info.param.name; });

struct Depth {
  const char* name;
  GLenum format;
  std::uint32_t bits;
  bool packed;
};

void PrintTo(const Depth& depth, std::ostream* out) {
  *out << depth.name;
}

class CaptureReplacedDepth : public testing::TestWithParam<Depth> {};

TEST_P(CaptureReplacedDepth, IsExactAndStencilIsKept) {
  const Depth& depth = GetParam();
  std::vector<std::string> words = {depth.packed ? "depth_stencil" : "depth", number(depth.format),
                                    "0.7"};
  if (depth.packed) words.push_back("200");
  const CaptureRun run = replaced("formats", words, {depths(depth.format, depth.bits)});
  EXPECT_THAT(run.capture.replacements, ElementsAre(ReplacementAnswer::done));
  const trace::Trace& trace = run.capture.trace;
  const double most = double((1U << depth.bits) - 1);
  for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
    const std::vector<double> value = valueAfter(trace, 0, kDepth, i % kWidth, i / kWidth);
    ASSERT_EQ(value.size(), 1U);
    EXPECT_EQ(std::llround(value[0] * most), depthBits(i, depth.bits)) << "pixel " << i;
    if (depth.packed) {
      EXPECT_THAT(valueAfter(trace, 0, kStencil, i % kWidth, i / kWidth),
                  ElementsAre(i / kWidth < 4 ? 100 : 200))
          << "pixel " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, CaptureReplacedDepth,
                         testing::Values(Depth{"DEPTH16", GL_DEPTH_COMPONENT16, 16, false},
                                         Depth{"DEPTH24", GL_DEPTH_COMPONENT24, 24, false},
                                         Depth{"DEPTH32F", GL_DEPTH_COMPONENT32F, 24, false},
                                         Depth{"D24S8", GL_DEPTH24_STENCIL8, 24, true},
                                         Depth{"D32FS8", GL_DEPTH32F_STENCIL8, 24, true}),
                         [](const auto& info) { return info.param.name; });

TEST(CaptureReplacedDepths, OfSixteenBitsAreExactOverTheWholeRange) {
  PassPixels all = depths(GL_DEPTH_COMPONENT16, 16);
  for (const std::uint32_t first : {1U, 30'000U, 60'000U}) {
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
      const float value = static_cast<float>((first + 43 * i) / 65535.0);
      std::memcpy(all.pixels.data() + 4 * i, &value, 4);
    }
    const CaptureRun run =
        replaced("formats", {"depth", number(GL_DEPTH_COMPONENT16), "0.7"}, {all});
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i)
      EXPECT_EQ(std::lround(valueAfter(run.capture.trace, 0, kDepth, i % kWidth, i / kWidth).at(0) *
                            65535),
                first + 43 * i);
  }
}

std::vector<double> firstOf(const PassPixels& from) {
  const auto* const first = reinterpret_cast<const std::uint8_t*>(from.pixels.data());
  return {double(first[0]), double(first[1]), double(first[2]), double(first[3])};
}

TEST(CaptureReplaced, OutputsAreWhatLaterPassesSample) {
  const PassPixels put = bytes(GL_RGBA8, 8, 8);
  const CaptureRun run = replaced("replaced", {"sampled"}, {put}, 2);
  EXPECT_THAT(run.capture.replacements, ElementsAre(ReplacementAnswer::done));
  const std::vector<double> first = firstOf(put);
  EXPECT_EQ(valueAfter(run.capture.trace, 0, 0), first);
  EXPECT_EQ(valueAfter(run.capture.trace, 1, 0), first);
  EXPECT_EQ(bytesAfter(run, 1, 0), put.pixels);
  EXPECT_THAT(pixel(run.capture.frames.at(0), 0, 0),
              ElementsAre(int(first[0]), int(first[1]), int(first[2]), int(first[3])));
  EXPECT_THAT(pixel(run.capture.frames.at(1), 0, 0), ElementsAre(64, 128, 191, 255))
      << "only the first frame's";
  const trace::Trace& trace = run.capture.trace;
  EXPECT_EQ(trace.samplesOf(trace.stepsOf(trace.passes[1])[0])[0].writer, 0U)
      << "it is still the pass's output";
}

TEST(CaptureReplaced, NothingAskedForChangesNothing) {
  const CaptureRun run = replaced("replaced", {"sampled"}, {});
  EXPECT_TRUE(run.capture.replacements.empty());
  EXPECT_THAT(pixel(run.capture.frames.at(0), 0, 0), ElementsAre(64, 128, 191, 255));
}

TEST(CaptureReplaced, OddPixelStateNeitherDisturbsNorIsDisturbed) {
  const PassPixels color = halves(GL_RGBA16F, 0xFFFF, 8, 8);
  const PassPixels depth = depths(GL_DEPTH24_STENCIL8, 24, 8, 8);
  const CaptureRun run = replaced("replaced", {"odd_state"}, {color, depth});
  EXPECT_EQ(run.output, "");
  EXPECT_THAT(run.capture.replacements,
              ElementsAre(ReplacementAnswer::done, ReplacementAnswer::done));
  EXPECT_EQ(bytesAfter(run, 0, 0), color.pixels);
  for (std::uint32_t i = 0; i < 64; ++i) {
    const trace::Trace& trace = run.capture.trace;
    EXPECT_EQ(std::llround(valueAfter(trace, 0, kDepth, i % 8, i / 8).at(0) * 0xFFFFFF),
              depthBits(i, 24));
    EXPECT_THAT(valueAfter(trace, 0, kStencil, i % 8, i / 8), ElementsAre(77));
  }
}

/// The whole of what a pass left, where all of it has one value.
void expectEverywhere(const CaptureRun& run, std::uint32_t pass, const std::vector<double>& value) {
  for (std::uint32_t i = 0; i < 64; ++i)
    EXPECT_EQ(valueAfter(run.capture.trace, pass, 0, i % 8, i / 8), value) << "pixel " << i;
}

TEST(CaptureReplaced, LevelsLayersAndFacesAreMeantAlone) {
  PassPixels put = bytes(GL_RGBA8, 8, 8);
  const CaptureRun level = replaced("replaced", {"level"}, {put});
  EXPECT_THAT(level.capture.replacements, ElementsAre(ReplacementAnswer::done));
  EXPECT_EQ(bytesAfter(level, 0, 0), put.pixels);
  put.pass = 1;
  for (const char* scenario : {"array", "cube"}) {
    const CaptureRun run = replaced("replaced", {scenario}, {put}, 2);
    EXPECT_THAT(run.capture.replacements, ElementsAre(ReplacementAnswer::done)) << scenario;
    EXPECT_EQ(bytesAfter(run, 1, 0), put.pixels) << scenario;
    expectEverywhere(run, 0, {51, 102, 153, 255});
  }
  const CaptureRun whole = replaced("replaced", {"whole_array"}, {put});
  EXPECT_THAT(whole.capture.replacements, ElementsAre(ReplacementAnswer::otherImage));
  expectEverywhere(whole, 1, {51, 102, 153, 255});
}

TEST(CaptureReplaced, OtherImagesAreLeftAsTheyAreAndNamed) {
  struct Case {
    const char* what;
    std::vector<std::string> words; ///< that make an image of 16x8
    PassPixels put;
    const char* message;
  };
  const std::vector<std::string> rgba8 = {"color", number(GL_RGBA8), "f", "0.2", "0.4", "0.6", "1"};
  const auto with = [&](const char* holder) {
    std::vector<std::string> words = rgba8;
    words.insert(words.begin(), holder);
    return words;
  };
  const auto srgb = [&] {
    std::vector<std::string> words = rgba8;
    words[1] = number(GL_SRGB8_ALPHA8);
    return words;
  };
  const Case cases[] = {
      {"size", rgba8, bytes(GL_RGBA8, 8, 8),
       "pass 0: its attachment 0, 16x8 of format 0x8058, cannot take 8x8 pixels of 0x8058"},
      {"turned size", rgba8, bytes(GL_RGBA8, 8, 16),
       "pass 0: its attachment 0, 16x8 of format 0x8058, cannot take 8x16 pixels of 0x8058"},
      {"format", rgba8, halves(GL_RGBA16F, 0xFFFF),
       "pass 0: its attachment 0, 16x8 of format 0x8058, cannot take 16x8 pixels of 0x881A"},
      {"renderbuffer", with("renderbuffer"), bytes(),
       "pass 0: its attachment 0, 16x8 of format 0x8058, cannot take 16x8 pixels of 0x8058"},
      {"multisampled", with("multisampled_texture"), bytes(),
       "pass 0: its attachment 0, 16x8 of format 0x8058, cannot take 16x8 pixels of 0x8058"},
      {"sRGB", srgb(),
       pixels<float>(0, PixelType::f32x4, GL_SRGB8_ALPHA8, [](std::uint32_t) { return 0.5F; }),
       "pass 0: its attachment 0, 16x8 of format 0x8C43, cannot take 16x8 pixels of 0x8C43"},
      {"nothing attached", rgba8, depths(GL_DEPTH_COMPONENT24, 24),
       "pass 0: its attachment 8, 0x0 of format 0x0, cannot take 16x8 pixels of 0x81A6"},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.what);
    const CaptureRun plain = replaced("formats", one.words, {});
    const CaptureRun run = replaced("formats", one.words, {one.put});
    EXPECT_THAT(run.capture.replacements, ElementsAre(ReplacementAnswer::otherImage));
    EXPECT_THAT(texts(run.capture, channel::MessageKind::capture), ElementsAre(one.message));
    EXPECT_EQ(bytesAfter(run, 0, 0), bytesAfter(plain, 0, 0));
  }
}

TEST(CaptureReplaced, PassesThatNeverComeAreNotReached) {
  PassPixels put = bytes(GL_RGBA8, 8, 8);
  put.pass = 2; // the second frame's first
  const CaptureRun run = replaced("replaced", {"sampled"}, {put}, 2);
  EXPECT_THAT(run.capture.replacements, ElementsAre(ReplacementAnswer::notReached));
  expectEverywhere(run, 2, {64, 128, 191, 255});
}

/// GL refuses integers for an image of floats.
TEST(CaptureReplaced, WhatGlRefusesIsSaidAndLeavesNoError) {
  const PassPixels put = pixels<std::uint32_t>(
      0, PixelType::u32x4, GL_RGBA8, [](std::uint32_t i) { return i; }, 8, 8);
  const CaptureRun run = replaced("replaced", {"sampled"}, {put});
  EXPECT_THAT(run.capture.replacements, ElementsAre(ReplacementAnswer::refused));
  EXPECT_TRUE(texts(run.capture, channel::MessageKind::glError).empty());
  EXPECT_TRUE(texts(run.capture, channel::MessageKind::glDebug).empty());
  expectEverywhere(run, 0, {64, 128, 191, 255});
}

} // namespace
} // namespace ggrade::test
