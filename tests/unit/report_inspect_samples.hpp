#pragma once
// A frame made by hand: pass 1 draws into a 4 x 3 half-float texture with a depth renderbuffer,
// pass 2 only clears a texture, pass 3 draws to the window and reads the texture of pass 1.
#include "report/inspect.hpp"

#include <GL/glcorearb.h>

#include <bit>
#include <cstring>
#include <string_view>
#include <vector>

namespace ggrade::report::samples {

using namespace trace;

inline ImageRef image(ImageKind kind, std::uint32_t name, std::uint32_t format, std::uint32_t width,
                      std::uint32_t height) {
  return {std::uint32_t(kind),
          name,
          kind == ImageKind::texture ? std::uint32_t(GL_TEXTURE_2D) : 0,
          0,
          kNone,
          format,
          width,
          height,
          0};
}

inline PassRecord pass(std::uint32_t framebuffer, std::uint32_t width, std::uint32_t height) {
  PassRecord record{};
  record.kind = std::uint32_t(PassKind::draw);
  record.framebuffer = framebuffer;
  record.status = GL_FRAMEBUFFER_COMPLETE;
  record.drawBuffers = 1;
  record.cleared = record.written = 1;
  record.clearColor[0] = 0.25F;
  record.clearColor[3] = 1;
  record.clearDepth = 1;
  record.viewport[2] = std::int32_t(width);
  record.viewport[3] = std::int32_t(height);
  return record;
}

inline StepRecord step(std::uint32_t ofPass, std::uint32_t program, const PassRecord& record) {
  StepRecord made{};
  made.outputs = ~0U;
  made.pass = ofPass;
  made.program = program;
  made.mode = GL_TRIANGLES;
  made.draws = 2;
  made.vertices = 1200;
  made.frontFace = GL_CCW;
  made.colorMask = 15;
  made.depthWrite = 1;
  std::memcpy(made.viewport, record.viewport, sizeof made.viewport);
  return made;
}

/// Adds a step to the last pass.
inline StepRecord& addStep(Trace& trace, std::uint32_t program) {
  PassRecord& record = trace.passes.back();
  StepRecord made = step(std::uint32_t(trace.passes.size() - 1), program, record);
  made.firstMatrix = std::uint32_t(trace.matrices.size());
  made.firstSample = std::uint32_t(trace.samples.size());
  if (record.stepCount == 0) record.firstStep = std::uint32_t(trace.steps.size());
  ++record.stepCount;
  record.draws += made.draws;
  record.vertices += made.vertices;
  trace.steps.push_back(made);
  return trace.steps.back();
}

inline void addMatrix(Trace& trace, std::string_view name) {
  MatrixRecord matrix{};
  name.copy(matrix.name, sizeof matrix.name - 1);
  for (int i = 0; i < 16; ++i) matrix.values[i] = float(i); // column 3 holds 12 to 15
  trace.matrices.push_back(matrix);
  ++trace.steps.back().matrixCount;
}

inline SampleRecord& addSample(Trace& trace, std::string_view uniform, const ImageRef& image,
                               std::uint32_t writer) {
  SampleRecord sample{};
  sample.unit = 1;
  sample.image = image;
  sample.writer = writer;
  sample.minFilter = sample.magFilter = GL_LINEAR;
  sample.wrapS = sample.wrapT = GL_CLAMP_TO_EDGE;
  uniform.copy(sample.uniform, sizeof sample.uniform - 1);
  trace.samples.push_back(sample);
  ++trace.steps.back().sampleCount;
  return trace.samples.back();
}

template <typename Value>
void addCopy(Trace& trace, std::uint32_t ofPass, std::uint32_t attachment, PixelType type,
             std::uint32_t width, std::uint32_t height, const std::vector<Value>& values) {
  CopyRecord copy{ofPass, kNone,  attachment,          std::uint32_t(type),
                  width,  height, trace.pixels.size(), values.size() * sizeof(Value)};
  const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
  trace.pixels.insert(trace.pixels.end(), bytes, bytes + copy.bytes);
  trace.copies.push_back(copy);
}

inline InspectedFrame frame() {
  InspectedFrame frame;
  frame.name = "homework";
  frame.width = 8;
  frame.height = 6;
  frame.renderer = "llvmpipe";
  Trace& trace = frame.trace;
  trace.frames = {{0, 3, 5'000'000, 1200}};

  const ImageRef texture = image(ImageKind::texture, 7, GL_RGBA16F, 4, 3);
  PassRecord first = pass(2, 4, 3);
  first.images[0] = texture;
  first.images[kDepth] = image(ImageKind::renderbuffer, 1, GL_DEPTH_COMPONENT24, 4, 3);
  first.cleared = first.written = 1 | 1U << kDepth;
  first.seconds = 0.0125;
  trace.passes.push_back(first);
  addStep(trace, 3).depthTest = GL_LESS;
  addMatrix(trace, "uView");
  addStep(trace, 4).blend = 0;
  trace.steps.back().depthTest = GL_LEQUAL;

  PassRecord second = pass(3, 4, 4);
  second.images[0] = image(ImageKind::texture, 8, GL_RGBA8, 4, 4);
  trace.passes.push_back(second);

  PassRecord third = pass(0, 8, 6);
  third.images[0] = image(ImageKind::window, 0, GL_RGBA8, 8, 6);
  trace.passes.push_back(third);
  addStep(trace, 5);
  addSample(trace, "uReflection", texture, 0);

  std::vector<std::uint16_t> halves(4 * 3 * 4, 0x3C00); // 1.0
  halves[(1 * 4 + 2) * 4 + 0] = 0x4100;                 // 2.5 at (2, 1), red
  halves[(1 * 4 + 2) * 4 + 1] = 0xB800;                 // -0.5, green
  addCopy(trace, 0, 0, PixelType::f16x4, 4, 3, halves);
  std::vector<float> depths(4 * 3, 1.0F);
  depths[2] = 0.9873F;
  addCopy(trace, 0, kDepth, PixelType::f32x1, 4, 3, depths);
  std::vector<std::uint8_t> bytes(8 * 6 * 4, 255);
  bytes[(2 * 8 + 5) * 4 + 1] = 128; // (5, 2), green
  addCopy(trace, 2, 0, PixelType::u8x4, 8, 6, bytes);
  return frame;
}

} // namespace ggrade::report::samples
