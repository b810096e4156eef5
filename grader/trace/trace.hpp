#pragma once
/// \file
/// The recorded passes of a run, as a rubric, a report or a person asks for them.

#include "image/image.hpp"
#include "trace/records.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ggrade::trace {

/// What GL held and what came of a frame.
struct FrameTrace {
  std::uint32_t firstPass = 0, passCount = 0;
  std::uint64_t imageBytes = 0;  ///< textures (all levels) and renderbuffers at the swap
  std::uint64_t bufferBytes = 0; ///< buffer objects
};

/// Are these draws of a mesh, not of full-screen quads?
bool drawsMesh(const StepRecord& step);

/// All records have been checked: indices lie in their tables, sizes agree. Passes stand in the
/// order in which they began.
struct Trace {
  std::vector<FrameTrace> frames; ///< as many as were swapped; empty if nothing was asked for
  std::vector<PassRecord> passes;
  std::vector<StepRecord> steps;
  std::vector<MatrixRecord> matrices;
  std::vector<SampleRecord> samples;
  std::vector<CopyRecord> copies;
  std::uint32_t passesLost = 0, stepsLost = 0, matricesLost = 0, samplesLost = 0, copiesLost = 0;

  std::span<const StepRecord> stepsOf(const PassRecord& pass) const;
  /// Did a pass draw a mesh, not full-screen quads alone, however many?
  bool drewObjects(const PassRecord& pass) const;
  std::span<const MatrixRecord> matricesOf(const StepRecord& step) const;
  std::span<const SampleRecord> samplesOf(const StepRecord& step) const;
  /// Index of a pass in `passes`.
  std::uint32_t indexOf(const PassRecord& pass) const {
    return static_cast<std::uint32_t>(&pass - passes.data());
  }
  std::span<const PassRecord> passesOf(std::size_t frame) const;

  /// The copy of an attachment after a pass (after a step, if one is named), or null.
  const CopyRecord* copyOf(std::uint32_t pass, std::uint32_t attachment,
                           std::uint32_t step = kNone) const;
  /// Its pixels, row 0 on top: 4 channels (colour, integers as whole numbers) or 1 (depth 0 to 1,
  /// stencil 0 to 255). Throws UsageError when the file of copies can't be read.
  Image image(const CopyRecord& copy) const;
  /// The same as stored, row 0 on top: copy.bytes bytes of copy.type. Throws like `image`.
  std::vector<std::byte> bytesOf(const CopyRecord& copy) const;

  /// Bytes of all copies: in memory, or in this file when `pixels` is empty.
  std::vector<std::byte> pixels;
  std::filesystem::path pixelFile;
};

/// `count` frames from `first` on as a trace of their own, whose copies are those of its first
/// frame. What they sample of frames before has no writer. `all` has its copies in memory.
Trace framesOf(const Trace& all, std::size_t first, std::size_t count);

/// Writes `trace.bin` and `copies.bin` to `folder`; for this tool's own use, on this machine.
/// Throws UsageError when the disk is full.
void save(const Trace& trace, const std::filesystem::path& folder);
/// Reads them back; copies are read when they are asked for. An empty Trace if there is no
/// `trace.bin`. Throws UsageError for a file that is cut off or names what it does not hold.
Trace load(const std::filesystem::path& folder);

/// "RGBA16F" for GL_RGBA16F, "0x1234" for a number that has no name here. Formats, targets, blend
/// factors, comparison functions, wrap modes, filters, framebuffer status.
std::string glName(std::uint32_t value);

/// "TRIANGLES" for GL_TRIANGLES: what a draw can be told to draw.
std::string modeName(std::uint32_t mode);

/// "color0" to "color7", "depth", "stencil".
std::string attachmentName(std::uint32_t attachment);

/// The value of an IEEE 754 half float, exact; NaN stays NaN, Inf stays Inf.
float halfToFloat(std::uint16_t half);

/// 4 or 1, see PixelType.
int channelsOf(PixelType type);

/// "u8x4", "f16x4", ...: the name in trace.json and on pages.
const char* pixelTypeName(PixelType type);

/// `bytes` holds width x height pixels of `type`, row 0 on top. u8x4 becomes 0 to 1; stencil and
/// integers become whole numbers (exact up to 2^24); floats are as stored. Throws
/// std::invalid_argument unless `bytes` has exactly the size of the image.
Image decodePixels(std::span<const std::byte> bytes, PixelType type, std::uint32_t width,
                   std::uint32_t height);

/// The files that were made of a copy, for trace.json; empty names where there is none.
struct CopyFiles {
  std::string image, raw; ///< a picture, and its values as 4-byte floats
  std::string scale;      ///< what the picture's values mean, see picture.hpp
  double low = 0, high = 1;
};

/// The keys `passes` and `lost` of trace.json; docs/trace.md is the schema. `files` belong to the
/// copies of the same index; it may be shorter.
nlohmann::json toJson(const Trace& trace, const std::vector<CopyFiles>& files = {});

} // namespace ggrade::trace
