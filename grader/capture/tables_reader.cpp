#include "capture/tables_reader.hpp"

#include "capture/channel.hpp"

#include <GL/glcorearb.h>

namespace ggrade::channel {
namespace {

using namespace trace;

constexpr std::uint32_t kColorMask = (1U << kColors) - 1;
constexpr std::uint32_t kAttachmentMask = (1U << kAttachments) - 1;

template <typename Enum> constexpr std::uint32_t number(Enum value) {
  return static_cast<std::uint32_t>(value);
}

bool checkFlags(Checker& check, const std::string& at,
                std::initializer_list<std::pair<const char*, std::uint32_t>> flags) {
  for (const auto& [name, value] : flags)
    if (!check.atMost(at + name, value, 1)) return false;
  return true;
}

bool checkImage(Checker& check, const std::string& at, const ImageRef& image) {
  // A buffer texture is as wide as its buffer has texels; nothing is ever made of that size.
  const std::uint32_t widest = image.target == GL_TEXTURE_BUFFER ? UINT32_MAX : kMaxSide;
  return check.atMost(at + "kind", image.kind, number(ImageKind::renderbuffer)) &&
         check.atMost(at + "width", image.width, widest) &&
         check.atMost(at + "height", image.height, kMaxSide);
}

bool checkPass(Checker& check, std::uint32_t index, const Trace& tables, std::uint32_t frames) {
  const PassRecord& pass = tables.passes[index];
  const std::string at = element("passes", index);
  // The frame after the last swap may have begun.
  if (!check.atMost(at + "frame", pass.frame, frames) ||
      !check.atLeast(at + "kind", pass.kind, number(PassKind::draw)) ||
      !check.atMost(at + "kind", pass.kind, number(PassKind::imageStore)) ||
      !check.atMost(at + "drawBuffers", pass.drawBuffers, kColorMask) ||
      !check.atMost(at + "cleared", pass.cleared, kAttachmentMask) ||
      !check.atMost(at + "written", pass.written, kAttachmentMask) ||
      !check.seconds(at + "seconds", pass.seconds) ||
      !check.range(at + "steps", pass.firstStep, pass.stepCount, tables.steps.size()))
    return false;
  for (std::uint32_t i = 0; i < kAttachments; ++i)
    if (!checkImage(check, at + "images[" + std::to_string(i) + "].", pass.images[i])) return false;
  for (std::uint32_t i = 0; i < pass.stepCount; ++i)
    if (!check.equal(element("steps", pass.firstStep + i) + "pass",
                     tables.steps[pass.firstStep + i].pass, index))
      return false;
  return true;
}

bool isCompareOrOff(Checker& check, const std::string& at, std::uint32_t value) {
  return check.oneOf(
      at, value,
      {0, GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS});
}

/// How far the rows of other tables that steps name are used up: steps name theirs one after
/// another, never the same twice, or a few records would make endless work.
struct Used {
  std::uint64_t matrices = 0, samples = 0;
};

bool checkStep(Checker& check, std::uint32_t index, const Trace& tables, Used& used) {
  const StepRecord& step = tables.steps[index];
  const std::string at = element("steps", index);
  if (!check.range(at + "pass", step.pass, 1, tables.passes.size()) ||
      !check.atMost(at + "mode", step.mode, GL_PATCHES) ||
      !check.oneOf(at + "cullFace", step.cullFace, {0, GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}) ||
      !isCompareOrOff(check, at + "depthTest", step.depthTest) ||
      !checkFlags(check, at,
                  {{"depthWrite", step.depthWrite},
                   {"depthClamp", step.depthClamp},
                   {"blend", step.blend},
                   {"stencilTest", step.stencilTest},
                   {"scissorTest", step.scissorTest},
                   {"polygonOffset", step.polygonOffset},
                   {"framebufferSrgb", step.framebufferSrgb},
                   {"rasterizerDiscard", step.rasterizerDiscard}}) ||
      !check.atMost(at + "colorMask", step.colorMask, 15) ||
      !check.atMost(at + "matrixCount", step.matrixCount, kMaxMatricesOfStep) ||
      !check.range(at + "matrices", step.firstMatrix, step.matrixCount, tables.matrices.size()) ||
      !check.range(at + "samples", step.firstSample, step.sampleCount, tables.samples.size()))
    return false;
  if (step.matrixCount > 0) {
    if (!check.atLeast(at + "firstMatrix", step.firstMatrix, used.matrices)) return false;
    used.matrices = std::uint64_t{step.firstMatrix} + step.matrixCount;
  }
  if (step.sampleCount > 0) {
    if (!check.atLeast(at + "firstSample", step.firstSample, used.samples)) return false;
    used.samples = std::uint64_t{step.firstSample} + step.sampleCount;
  }
  return true;
}

bool checkSample(Checker& check, std::uint32_t index, Trace& tables) {
  SampleRecord& sample = tables.samples[index];
  const std::string at = element("samples", index);
  return checkImage(check, at + "image.", sample.image) &&
         (sample.writer == kNone ||
          check.range(at + "writer", sample.writer, 1, tables.passes.size())) &&
         checkFlags(check, at,
                    {{"feedback", sample.feedback}, {"incomplete", sample.incomplete}}) &&
         check.text(at + "uniform", sample.uniform);
}

/// Which types the pixels of an attachment can have.
bool checkType(Checker& check, const std::string& at, const CopyRecord& copy) {
  if (copy.attachment == kDepth) return check.equal(at, copy.type, number(PixelType::f32x1));
  if (copy.attachment == kStencil) return check.equal(at, copy.type, number(PixelType::u8x1));
  return check.oneOf(at, copy.type,
                     {number(PixelType::u8x4), number(PixelType::f16x4), number(PixelType::f32x4),
                      number(PixelType::i32x4), number(PixelType::u32x4)});
}

/// `used`: bytes that the copies before have taken. They stand one after another, so that all of
/// them together are never more than the room for them.
bool checkCopy(Checker& check, std::uint32_t index, const Trace& tables, std::uint64_t copyBytes,
               std::uint64_t& used) {
  const CopyRecord& copy = tables.copies[index];
  const std::string at = element("copies", index);
  if (!check.range(at + "pass", copy.pass, 1, tables.passes.size()) ||
      !check.atMost(at + "attachment", copy.attachment, kStencil) ||
      !checkType(check, at + "type", copy) || !check.atLeast(at + "width", copy.width, 1) ||
      !check.atMost(at + "width", copy.width, kMaxSide) ||
      !check.atLeast(at + "height", copy.height, 1) ||
      !check.atMost(at + "height", copy.height, kMaxSide) ||
      !check.equal(at + "bytes", copy.bytes,
                   std::uint64_t{copy.width} * copy.height *
                       bytesPerPixel(static_cast<PixelType>(copy.type))) ||
      !check.atLeast(at + "offset", copy.offset, used) ||
      !check.atMost(at + "offset", copy.offset, copyBytes) ||
      !check.range(at + "offset", copy.offset, copy.bytes, copyBytes))
    return false;
  used = copy.offset + copy.bytes;
  if (copy.step == kNone) return true;
  return check.range(at + "step", copy.step, 1, tables.steps.size()) &&
         check.equal(at + "step's pass", tables.steps[copy.step].pass, copy.pass);
}

bool checkFrameRanges(Checker& check, const Trace& tables) {
  for (std::uint32_t i = 0; i < tables.frames.size(); ++i) {
    const FrameTrace& frame = tables.frames[i];
    if (!check.range(element("frames", i) + "passes", frame.firstPass, frame.passCount,
                     tables.passes.size()))
      return false;
    for (std::uint32_t k = 0; k < frame.passCount; ++k)
      if (!check.equal(element("passes", frame.firstPass + k) + "frame",
                       tables.passes[frame.firstPass + k].frame, i))
        return false;
  }
  return true;
}

} // namespace

bool checkTables(Checker& check, Trace& tables, std::uint32_t frames, std::uint64_t copyBytes) {
  for (std::uint32_t i = 0; i < tables.passes.size(); ++i)
    if (!checkPass(check, i, tables, frames)) return false;
  Used used;
  for (std::uint32_t i = 0; i < tables.steps.size(); ++i)
    if (!checkStep(check, i, tables, used)) return false;
  for (std::uint32_t i = 0; i < tables.matrices.size(); ++i)
    if (!check.text(element("matrices", i) + "name", tables.matrices[i].name)) return false;
  for (std::uint32_t i = 0; i < tables.samples.size(); ++i)
    if (!checkSample(check, i, tables)) return false;
  std::uint64_t usedBytes = 0;
  for (std::uint32_t i = 0; i < tables.copies.size(); ++i)
    if (!checkCopy(check, i, tables, copyBytes, usedBytes)) return false;
  return checkFrameRanges(check, tables);
}

void turnCopies(Trace& trace) {
  for (const CopyRecord& copy : trace.copies) {
    const std::uint64_t rowBytes = copy.bytes / copy.height;
    std::byte* const first = trace.pixels.data() + copy.offset;
    for (std::uint32_t y = 0; y < copy.height / 2; ++y) {
      std::byte* const row = first + y * rowBytes;
      std::swap_ranges(row, row + rowBytes, first + (copy.height - 1 - y) * rowBytes);
    }
  }
}

} // namespace ggrade::channel
