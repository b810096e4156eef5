#pragma once
/// \file
/// A small recording: a pass into a texture with depth, and the window's that samples it.

#include "trace/trace.hpp"

#include <GL/glcorearb.h>

#include <cstring>

namespace ggrade::trace::samples {

inline constexpr std::uint32_t number(PixelType type) {
  return static_cast<std::uint32_t>(type);
}

/// Appends the pixels of a copy.
template <typename Value>
CopyRecord& addCopy(Trace& trace, std::uint32_t pass, std::uint32_t attachment, PixelType type,
                    std::uint32_t width, std::uint32_t height, const std::vector<Value>& values) {
  const auto* const bytes = reinterpret_cast<const std::byte*>(values.data());
  trace.copies.push_back({pass, kNone, attachment, number(type), width, height, trace.pixels.size(),
                          values.size() * sizeof(Value)});
  trace.pixels.insert(trace.pixels.end(), bytes, bytes + values.size() * sizeof(Value));
  return trace.copies.back();
}

inline ImageRef texture(std::uint32_t format, std::uint32_t width, std::uint32_t height) {
  return {static_cast<std::uint32_t>(ImageKind::texture),
          7,
          GL_TEXTURE_2D,
          0,
          kNone,
          format,
          width,
          height,
          0};
}

/// gluPerspective's matrix for an aspect and a scale of 1.
inline MatrixRecord perspective(const char* name, float nearest, float farthest) {
  MatrixRecord matrix{};
  std::strcpy(matrix.name, name);
  matrix.values[0] = matrix.values[5] = 1;
  matrix.values[10] = -(farthest + nearest) / (farthest - nearest);
  matrix.values[11] = -1;
  matrix.values[14] = -2 * farthest * nearest / (farthest - nearest);
  return matrix;
}

/// The depth in the buffer of what is `distance` away.
inline float depthAt(float distance, float nearest, float farthest) {
  return farthest * (distance - nearest) / (distance * (farthest - nearest));
}

inline Trace mirror() {
  Trace trace;
  trace.frames = {{0, 2, 4096, 512}};
  PassRecord reflection{};
  reflection.kind = static_cast<std::uint32_t>(PassKind::draw);
  reflection.framebuffer = 1;
  reflection.status = GL_FRAMEBUFFER_COMPLETE;
  reflection.images[0] = texture(GL_RGBA16F, 2, 2);
  reflection.images[kDepth] = {static_cast<std::uint32_t>(ImageKind::renderbuffer),
                               3,
                               0,
                               0,
                               kNone,
                               GL_DEPTH_COMPONENT24,
                               2,
                               2,
                               0};
  reflection.drawBuffers = 1;
  reflection.cleared = reflection.written = 1 | 1U << kDepth;
  reflection.clearColor[1] = 0.2F;
  reflection.clearDepth = 1;
  reflection.viewport[2] = reflection.viewport[3] = 2;
  reflection.draws = 1;
  reflection.vertices = 36;
  reflection.stepCount = 1;
  PassRecord window = reflection;
  window.framebuffer = 0;
  window.images[0] = {
      static_cast<std::uint32_t>(ImageKind::window), 0, 0, 0, kNone, GL_RGBA8, 2, 2, 0};
  window.images[kDepth] = {};
  window.cleared = 0;
  window.written = 1;
  window.firstStep = 1;
  trace.passes = {reflection, window};

  StepRecord step{};
  step.outputs = ~0U;
  step.pass = 0;
  step.program = 5;
  step.mode = GL_TRIANGLES;
  step.draws = 1;
  step.vertices = 36;
  step.cullFace = GL_FRONT;
  step.frontFace = GL_CCW;
  step.depthTest = GL_LESS;
  step.depthWrite = 1;
  step.colorMask = 15;
  step.clipDistances = 1;
  step.viewport[2] = step.viewport[3] = 2;
  step.matrixCount = 1;
  StepRecord floor = step;
  floor.pass = 1;
  floor.firstMatrix = 1;
  floor.matrixCount = 0;
  floor.sampleCount = 1;
  floor.blend = 1;
  floor.blendSource = floor.blendSourceAlpha = GL_ONE;
  floor.blendDestination = floor.blendDestinationAlpha = GL_ONE_MINUS_SRC_ALPHA;
  floor.blendEquation = floor.blendEquationAlpha = GL_FUNC_ADD;
  floor.stencilTest = 1;
  floor.stencil[0] = floor.stencil[1] = {GL_ALWAYS, 1, 255, 255, GL_KEEP, GL_INCR_WRAP, GL_REPLACE};
  floor.scissorTest = 1;
  floor.polygonOffset = 1;
  floor.polygonOffsetFactor = 1.1F;
  trace.steps = {step, floor};
  trace.matrices = {perspective("uProjection", 1, 9)};
  SampleRecord sample{};
  sample.unit = 2;
  sample.image = reflection.images[0];
  sample.writer = 0;
  sample.minFilter = sample.magFilter = GL_LINEAR;
  sample.wrapS = sample.wrapT = GL_CLAMP_TO_EDGE;
  sample.compareMode = GL_COMPARE_REF_TO_TEXTURE;
  sample.compareFunc = GL_LEQUAL;
  std::strcpy(sample.uniform, "uReflection");
  trace.samples = {sample};
  // One pixel is 0.5, 1, 2 and 1.
  addCopy<std::uint16_t>(
      trace, 0, 0, PixelType::f16x4, 2, 2,
      {0x3800, 0x3C00, 0x4000, 0x3C00, 0, 0, 0, 0x3C00, 0, 0, 0, 0x3C00, 0, 0, 0, 0x3C00});
  addCopy<float>(trace, 0, kDepth, PixelType::f32x1, 2, 2,
                 {depthAt(2, 1, 9), depthAt(4, 1, 9), depthAt(3, 1, 9), 1});
  return trace;
}

} // namespace ggrade::trace::samples
