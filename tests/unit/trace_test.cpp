// Recorded passes as values, and as files.

#include "assignment/usage_error.hpp"
#include "trace/trace.hpp"

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"
#include "trace_samples.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <functional>

namespace ggrade::trace {
namespace {

namespace fs = std::filesystem;
using samples::mirror;
using testing::ElementsAre;
using testing::HasSubstr;

/// The definition in IEEE 754.
double halfByDefinition(std::uint32_t half) {
  const double sign = half >> 15 ? -1 : 1;
  const int exponent = int(half >> 10 & 31);
  const double fraction = half & 1023;
  if (exponent == 31) return fraction > 0 ? std::nan("") : sign * INFINITY;
  if (exponent == 0) return sign * std::ldexp(fraction / 1024, -14);
  return sign * std::ldexp(1 + fraction / 1024, exponent - 15);
}

TEST(Trace, EveryHalfFloatIsExact) {
  for (std::uint32_t half = 0; half < 65536; ++half) {
    const double expected = halfByDefinition(half);
    const float value = halfToFloat(std::uint16_t(half));
    if (std::isnan(expected)) {
      ASSERT_TRUE(std::isnan(value)) << half;
      continue;
    }
    ASSERT_EQ(double(value), expected) << half;
    ASSERT_EQ(std::signbit(value), half >> 15 != 0) << half;
  }
  EXPECT_EQ(halfToFloat(0x7BFF), 65504);
  EXPECT_EQ(halfToFloat(0x0001), 0x1p-24F);
}

template <typename Value>
std::vector<float> decoded(PixelType type, std::uint32_t width, std::uint32_t height,
                           const std::vector<Value>& values) {
  const Image image = decodePixels(std::as_bytes(std::span(values)), type, width, height);
  EXPECT_EQ(image.width(), int(width));
  EXPECT_EQ(image.height(), int(height));
  EXPECT_EQ(image.channels(), channelsOf(type));
  return {image.values().begin(), image.values().end()};
}

TEST(Trace, PixelsOfEveryType) {
  EXPECT_THAT(decoded<std::uint8_t>(PixelType::u8x4, 1, 2, {0, 51, 255, 255, 1, 2, 3, 4}),
              ElementsAre(0, 0.2F, 1, 1, 1 / 255.F, 2 / 255.F, 3 / 255.F, 4 / 255.F));
  EXPECT_THAT(decoded<std::uint8_t>(PixelType::u8x1, 3, 1, {0, 1, 255}), ElementsAre(0, 1, 255));
  EXPECT_THAT(decoded<std::uint16_t>(PixelType::f16x4, 1, 1, {0x3C00, 0xC000, 0x7C00, 0x0000}),
              ElementsAre(1, -2, INFINITY, 0));
  EXPECT_THAT(decoded<float>(PixelType::f32x4, 1, 1, {1e30F, -0.5F, 0, 1}),
              ElementsAre(1e30F, -0.5F, 0, 1));
  EXPECT_THAT(decoded<float>(PixelType::f32x1, 2, 1, {0.25F, 1}), ElementsAre(0.25F, 1));
  EXPECT_THAT(decoded<std::int32_t>(PixelType::i32x4, 1, 1, {-7, 0, 1 << 24, 1}),
              ElementsAre(-7, 0, 16777216, 1));
  EXPECT_THAT(decoded<std::uint32_t>(PixelType::u32x4, 1, 1, {7, 0, 0x80000000U, 1}),
              ElementsAre(7, 0, 2147483648.F, 1));
  EXPECT_THROW(decoded<float>(PixelType::f32x1, 2, 2, {1, 2, 3}), std::invalid_argument);
}

TEST(Trace, FindsWhatBelongsToAPass) {
  const Trace trace = mirror();
  ASSERT_EQ(trace.passesOf(0).size(), 2U);
  EXPECT_EQ(trace.indexOf(trace.passesOf(0)[1]), 1U);
  const PassRecord& window = trace.passes[1];
  ASSERT_EQ(trace.stepsOf(window).size(), 1U);
  EXPECT_EQ(trace.stepsOf(window)[0].pass, 1U);
  EXPECT_TRUE(trace.matricesOf(trace.steps[1]).empty());
  EXPECT_STREQ(trace.matricesOf(trace.steps[0])[0].name, "uProjection");
  EXPECT_STREQ(trace.samplesOf(trace.steps[1])[0].uniform, "uReflection");
  EXPECT_EQ(trace.copyOf(0, kDepth), &trace.copies[1]);
  EXPECT_EQ(trace.copyOf(1, 0), nullptr);
  EXPECT_EQ(trace.copyOf(0, 0, 0), nullptr) << "a copy after the pass is none after its step";
}

TEST(Trace, FilesHoldEverything) {
  const TemporaryFolder folder;
  Trace trace = mirror();
  trace.passesLost = 1, trace.stepsLost = 2, trace.matricesLost = 3, trace.samplesLost = 4,
  trace.copiesLost = 5;
  save(trace, folder.path() / "new");
  const Trace loaded = load(folder.path() / "new");
  EXPECT_TRUE(loaded.pixels.empty());
  EXPECT_EQ(loaded.frames.at(0).imageBytes, 4096U);
  EXPECT_EQ(toJson(loaded), toJson(trace));
  EXPECT_EQ(loaded.copiesLost, 5U);
  for (std::size_t i = 0; i < trace.copies.size(); ++i) {
    const Image kept = trace.image(trace.copies[i]), read = loaded.image(loaded.copies[i]);
    EXPECT_THAT(std::vector<float>(read.values().begin(), read.values().end()),
                testing::ElementsAreArray(kept.values()));
  }
  // The first value of the first copy is in the top row: rows are kept as they are.
  const Image image = loaded.image(loaded.copies[0]);
  const auto first = image.pixel(0, 0);
  EXPECT_THAT(std::vector<float>(first.begin(), first.end()), ElementsAre(0.5F, 1, 2, 1));
}

TEST(Trace, FramesOfARunAreARunOfTheirOwn) {
  const Trace one = mirror();
  Trace twice = mirror();
  twice.frames.push_back(one.frames[0]);
  twice.frames[1].firstPass = 2;
  for (PassRecord pass : one.passes) {
    pass.frame = 1;
    pass.firstStep += std::uint32_t(one.steps.size());
    twice.passes.push_back(pass);
  }
  for (StepRecord step : one.steps) {
    step.pass += 2;
    step.firstMatrix += std::uint32_t(one.matrices.size());
    step.firstSample += std::uint32_t(one.samples.size());
    twice.steps.push_back(step);
  }
  twice.matrices.insert(twice.matrices.end(), one.matrices.begin(), one.matrices.end());
  for (SampleRecord sample : one.samples) {
    if (sample.writer != kNone) sample.writer += 2;
    twice.samples.push_back(sample);
  }
  for (CopyRecord copy : one.copies) {
    copy.pass += 2;
    copy.offset += one.pixels.size();
    twice.copies.push_back(copy);
  }
  twice.pixels.insert(twice.pixels.end(), one.pixels.begin(), one.pixels.end());
  for (const std::size_t frame : {0, 1}) {
    const Trace part = framesOf(twice, frame, 1);
    EXPECT_EQ(toJson(part), toJson(one)) << frame;
    EXPECT_EQ(part.pixels, one.pixels);
    const TemporaryFolder folder;
    save(part, folder.path());
    EXPECT_EQ(toJson(load(folder.path())), toJson(one)) << frame;
  }
  const Trace both = framesOf(twice, 0, 2);
  EXPECT_EQ(both.passes.size(), 4U);
  EXPECT_EQ(both.copies.size(), one.copies.size()) << "those of its first frame";
  // The texture that was drawn in the frame before has no writer in this one.
  twice.samples.back().writer = 0;
  EXPECT_EQ(framesOf(twice, 1, 1).samples.back().writer, kNone);
}

TEST(Trace, NothingRecordedIsNoFault) {
  const TemporaryFolder folder;
  EXPECT_TRUE(load(folder.path()).passes.empty());
  EXPECT_TRUE(load(folder.path() / "missing").frames.empty());
  save({}, folder.path());
  EXPECT_TRUE(load(folder.path()).passes.empty());
  EXPECT_EQ(fs::file_size(folder.path() / "copies.bin"), 0U);
}

TEST(Trace, AFileThatIsCutOffIsRefusedByName) {
  const TemporaryFolder folder;
  save(mirror(), folder.path());
  const fs::path records = folder.path() / "trace.bin", copies = folder.path() / "copies.bin";
  const auto message = [&] { return messageOf<UsageError>([&] { load(folder.path()); }); };
  for (std::uintmax_t size = fs::file_size(records); size-- > 0;
       size -= std::min<std::uintmax_t>(size, 97)) {
    fs::resize_file(records, size);
    EXPECT_EQ(message(), records.string() + " is cut off") << size;
  }
  save(mirror(), folder.path());
  fs::resize_file(records, fs::file_size(records) + 1);
  EXPECT_EQ(message(), records.string() + " is longer than it says");
  save(mirror(), folder.path());
  fs::resize_file(copies, fs::file_size(copies) - 1);
  EXPECT_EQ(message(), copies.string() + " is cut off");
  fs::remove(copies);
  EXPECT_EQ(message(), copies.string() + " is cut off");
  folder.write("trace.bin", std::string(4096, 'x'));
  EXPECT_THAT(message(), HasSubstr("trace.bin was written by another version of this tool"));
}

TEST(Trace, AFileThatNamesWhatItDoesNotHoldIsRefused) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::function<void(Trace&)>& damage) {
    Trace trace = mirror();
    damage(trace);
    save(trace, folder.path());
    return messageOf<UsageError>([&] { load(folder.path()); });
  };
  const std::string why = (folder.path() / "trace.bin").string() + " is damaged: remove it";
  EXPECT_EQ(refused([](Trace& trace) { trace.frames[0].passCount = 3; }), why);
  EXPECT_EQ(refused([](Trace& trace) { trace.passes[1].firstStep = 2; }), why);
  EXPECT_EQ(refused([](Trace& trace) { trace.steps[0].pass = 2; }), why);
  EXPECT_EQ(refused([](Trace& trace) { trace.steps[0].firstMatrix = 0xFFFFFFFF; }), why);
  EXPECT_EQ(refused([](Trace& trace) { trace.steps[1].sampleCount = 2; }), why);
  EXPECT_EQ(refused([](Trace& trace) { trace.samples[0].writer = 2; }), why);
  EXPECT_EQ(refused([](Trace& trace) {
              std::memset(trace.matrices[0].name, 'x', sizeof trace.matrices[0].name);
            }),
            why);
  EXPECT_EQ(refused([](Trace& trace) { trace.copies[0].pass = 2; }), why);
  EXPECT_EQ(refused([](Trace& trace) { trace.copies[0].width = 3; }), why);
  EXPECT_EQ(refused([](Trace& trace) { trace.copies[0].type = 99; }), why);
  EXPECT_EQ(refused([](Trace& trace) { trace.copies[1].offset += 1; }), why);
  EXPECT_EQ(refused([](Trace& trace) { // so many pixels that their bytes are few again
              trace.copies[0].width = trace.copies[0].height = 0x80000000;
              trace.copies[0].bytes = 0;
            }),
            why);
  save(mirror(), folder.path());
  EXPECT_EQ(load(folder.path()).passes.size(), 2u);
}

TEST(Trace, CopiesThatVanishAreNamed) {
  const TemporaryFolder folder;
  save(mirror(), folder.path());
  const Trace trace = load(folder.path());
  const fs::path copies = folder.path() / "copies.bin";
  fs::resize_file(copies, 1);
  EXPECT_EQ(messageOf<UsageError>([&] { trace.image(trace.copies[0]); }),
            copies.string() + " is cut off");
  fs::remove(copies);
  EXPECT_EQ(messageOf<UsageError>([&] { trace.image(trace.copies[0]); }),
            "can't read " + copies.string());
}

TEST(Trace, AFullDiskIsSaid) {
  EXPECT_THAT(messageOf<UsageError>([] { save(mirror(), "/proc/nowhere"); }),
              HasSubstr("can't write /proc/nowhere/copies.bin: "));
  const TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder.path() / "trace.bin");
  EXPECT_EQ(messageOf<UsageError>([&] { save(mirror(), folder.path()); }),
            "can't write " + (folder.path() / "trace.bin").string() + ": No space left on device");
}

TEST(Trace, NamesOfGl) {
  EXPECT_EQ(glName(GL_RGBA16F), "RGBA16F");
  EXPECT_EQ(glName(GL_DEPTH24_STENCIL8), "DEPTH24_STENCIL8");
  EXPECT_EQ(glName(GL_ONE_MINUS_SRC_ALPHA), "ONE_MINUS_SRC_ALPHA");
  EXPECT_EQ(glName(GL_CLAMP_TO_EDGE), "CLAMP_TO_EDGE");
  EXPECT_EQ(glName(GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT), "FRAMEBUFFER_INCOMPLETE_ATTACHMENT");
  EXPECT_EQ(glName(0x1234), "0x1234");
  EXPECT_EQ(glName(3), "0x0003");
  EXPECT_EQ(modeName(GL_TRIANGLES), "TRIANGLES");
  EXPECT_EQ(modeName(GL_POINTS), "POINTS");
  EXPECT_EQ(modeName(7), "0x0007");
  EXPECT_EQ(attachmentName(3), "color3");
  EXPECT_EQ(attachmentName(kDepth), "depth");
  EXPECT_EQ(attachmentName(kStencil), "stencil");
}

} // namespace
} // namespace ggrade::trace
