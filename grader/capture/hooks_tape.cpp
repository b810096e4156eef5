// Everything that draws, clears or moves pixels, for the tape. Without a tape these functions have
// no hooks here.

#include "capture/gl_hooks.hpp"
#include "capture/tape/calls.hpp"
#include "capture/tape/objects.hpp"
#include "capture/tape/writer.hpp"

#include <vector>

namespace ggrade::capture {
namespace {

using tape::Vertices;

Vertices indexed(GLsizei count, GLenum type, const void* offset, GLint baseVertex = 0) {
  return {0, count, type, reinterpret_cast<std::uintptr_t>(offset), baseVertex};
}

void tapeOne(GLenum mode, const Vertices& run, GLsizei instances = 1, GLuint baseInstance = 0) {
  tape::draw(mode, {&run, 1}, instances, baseInstance);
}

constexpr auto tapedArrays = [](GLenum mode, GLint first, GLsizei count) {
  tapeOne(mode, {first, count});
};
constexpr auto tapedArraysInstanced = [](GLenum mode, GLint first, GLsizei count,
                                         GLsizei instances) {
  tapeOne(mode, {first, count}, instances);
};
constexpr auto tapedArraysBaseInstance = [](GLenum mode, GLint first, GLsizei count,
                                            GLsizei instances, GLuint base) {
  tapeOne(mode, {first, count}, instances, base);
};
constexpr auto tapedElements = [](GLenum mode, GLsizei count, GLenum type, const void* offset) {
  tapeOne(mode, indexed(count, type, offset));
};
constexpr auto tapedElementsBase = [](GLenum mode, GLsizei count, GLenum type, const void* offset,
                                      GLint base) {
  tapeOne(mode, indexed(count, type, offset, base));
};
constexpr auto tapedElementsInstanced = [](GLenum mode, GLsizei count, GLenum type,
                                           const void* offset, GLsizei instances) {
  tapeOne(mode, indexed(count, type, offset), instances);
};
constexpr auto tapedElementsInstancedBase = [](GLenum mode, GLsizei count, GLenum type,
                                               const void* offset, GLsizei instances, GLint base) {
  tapeOne(mode, indexed(count, type, offset, base), instances);
};
constexpr auto tapedElementsBaseInstance = [](GLenum mode, GLsizei count, GLenum type,
                                              const void* offset, GLsizei instances, GLuint base) {
  tapeOne(mode, indexed(count, type, offset), instances, base);
};
constexpr auto tapedElementsBoth = [](GLenum mode, GLsizei count, GLenum type, const void* offset,
                                      GLsizei instances, GLint base, GLuint instance) {
  tapeOne(mode, indexed(count, type, offset, base), instances, instance);
};
constexpr auto tapedRange = [](GLenum mode, GLuint, GLuint, GLsizei count, GLenum type,
                               const void* offset) { tapeOne(mode, indexed(count, type, offset)); };
constexpr auto tapedRangeBase = [](GLenum mode, GLuint, GLuint, GLsizei count, GLenum type,
                                   const void* offset, GLint base) {
  tapeOne(mode, indexed(count, type, offset, base));
};
constexpr auto tapedMultiArrays = [](GLenum mode, const GLint* firsts, const GLsizei* counts,
                                     GLsizei draws) {
  std::vector<Vertices> runs;
  for (GLsizei i = 0; i < draws; ++i) runs.push_back({firsts[i], counts[i]});
  tape::draw(mode, runs);
};
constexpr auto tapedMultiElements = [](GLenum mode, const GLsizei* counts, GLenum type,
                                       const void* const* offsets, GLsizei draws) {
  std::vector<Vertices> runs;
  for (GLsizei i = 0; i < draws; ++i) runs.push_back(indexed(counts[i], type, offsets[i]));
  tape::draw(mode, runs);
};
constexpr auto tapedMultiElementsBase = [](GLenum mode, const GLsizei* counts, GLenum type,
                                           const void* const* offsets, GLsizei draws,
                                           const GLint* bases) {
  std::vector<Vertices> runs;
  for (GLsizei i = 0; i < draws; ++i)
    runs.push_back(indexed(counts[i], type, offsets[i], bases[i]));
  tape::draw(mode, runs);
};

constexpr auto tapedClearing = [](GLbitfield mask) { tape::clear(mask); };

template <typename Value> constexpr char kType = 'f';
template <> constexpr char kType<GLint> = 'i';
template <> constexpr char kType<GLuint> = 'u';

template <typename Value>
void tapeClear(const GLuint* framebuffer, GLenum buffer, GLint drawBuffer, const Value* values) {
  if (!values) return;
  std::array<double, 4> all{};
  for (std::size_t i = 0; i < (buffer == GL_COLOR ? 4U : 1U); ++i)
    all[i] = static_cast<double>(values[i]);
  tape::clearBuffer(framebuffer, buffer, drawBuffer, kType<Value>, all);
}
constexpr auto tapedClearingBuffer = [](GLenum buffer, GLint drawBuffer, const auto* values) {
  tapeClear(nullptr, buffer, drawBuffer, values);
};
constexpr auto tapedClearingBoth = [](GLenum buffer, GLint drawBuffer, GLfloat depth,
                                      GLint stencil) {
  tape::clearBuffer(nullptr, buffer, drawBuffer, 'b', {depth, static_cast<double>(stencil)});
};
constexpr auto tapedClearingNamed = [](GLuint framebuffer, GLenum buffer, GLint drawBuffer,
                                       const auto* values) {
  tapeClear(&framebuffer, buffer, drawBuffer, values);
};
constexpr auto tapedClearingNamedBoth = [](GLuint framebuffer, GLenum buffer, GLint drawBuffer,
                                           GLfloat depth, GLint stencil) {
  tape::clearBuffer(&framebuffer, buffer, drawBuffer, 'b', {depth, static_cast<double>(stencil)});
};

constexpr auto tapedBlitting = [](GLint a, GLint b, GLint c, GLint d, GLint e, GLint f, GLint g,
                                  GLint h, GLbitfield mask, GLenum filter) {
  tape::blit(nullptr, nullptr, {a, b, c, d, e, f, g, h}, mask, filter);
};
constexpr auto tapedBlittingNamed = [](GLuint from, GLuint to, GLint a, GLint b, GLint c, GLint d,
                                       GLint e, GLint f, GLint g, GLint h, GLbitfield mask,
                                       GLenum filter) {
  tape::blit(&from, &to, {a, b, c, d, e, f, g, h}, mask, filter);
};

constexpr auto tapedCopyImage2 = [](GLenum target, GLint level, GLenum format, GLint x, GLint y,
                                    GLsizei width, GLsizei height, GLint) {
  tape::copy(0, {target, level, {}, {x, y, width, height}, format});
};
constexpr auto tapedCopySub2 = [](GLenum target, GLint level, GLint toX, GLint toY, GLint x,
                                  GLint y, GLsizei width, GLsizei height) {
  tape::copy(0, {target, level, {toX, toY, 0}, {x, y, width, height}});
};
constexpr auto tapedCopySub3 = [](GLenum target, GLint level, GLint toX, GLint toY, GLint toZ,
                                  GLint x, GLint y, GLsizei width, GLsizei height) {
  tape::copy(0, {target, level, {toX, toY, toZ}, {x, y, width, height}});
};
constexpr auto tapedCopyNamed2 = [](GLuint texture, GLint level, GLint toX, GLint toY, GLint x,
                                    GLint y, GLsizei width, GLsizei height) {
  tape::copy(texture, {GL_TEXTURE_2D, level, {toX, toY, 0}, {x, y, width, height}});
};
constexpr auto tapedCopyImages = [](GLuint from, GLenum fromTarget, GLint fromLevel, GLint fromX,
                                    GLint fromY, GLint fromZ, GLuint to, GLenum toTarget,
                                    GLint toLevel, GLint toX, GLint toY, GLint toZ, GLsizei width,
                                    GLsizei height, GLsizei depth) {
  tape::copyImage({from, fromTarget, fromLevel, fromZ}, {fromX, fromY, fromZ},
                  {to, toTarget, toLevel, toZ}, {toX, toY, toZ}, {width, height, depth});
};
constexpr auto tapedMipmap = [](GLenum target) { tape::mipmap(0, target); };
constexpr auto tapedMipmapNamed = [](GLuint texture) { tape::mipmap(texture, GL_TEXTURE_2D); };

constexpr auto tapedLinking = [](GLuint program) { tape::linkProgram(program); };
constexpr auto tapedBinary = [](GLuint program, auto...) { tape::otherProgram(program); };
constexpr auto tapedBuffers = [](auto...) { tape::buffersChanged(); };

/// A call that a tape can't hold.
template <Name name> constexpr auto kRefused = [](auto...) { tape::refuseCall(name.text); };
#define GG_REFUSED(name) GG_AROUND(name, kRefused<#name>)

const Hook kTapeHooks[] = {
    GG_AROUND(glDrawArrays, tapedArrays),
    GG_AROUND(glDrawArraysInstanced, tapedArraysInstanced),
    GG_AROUND(glDrawArraysInstancedBaseInstance, tapedArraysBaseInstance),
    GG_AROUND(glDrawElements, tapedElements),
    GG_AROUND(glDrawElementsBaseVertex, tapedElementsBase),
    GG_AROUND(glDrawElementsInstanced, tapedElementsInstanced),
    GG_AROUND(glDrawElementsInstancedBaseVertex, tapedElementsInstancedBase),
    GG_AROUND(glDrawElementsInstancedBaseInstance, tapedElementsBaseInstance),
    GG_AROUND(glDrawElementsInstancedBaseVertexBaseInstance, tapedElementsBoth),
    GG_AROUND(glDrawRangeElements, tapedRange),
    GG_AROUND(glDrawRangeElementsBaseVertex, tapedRangeBase),
    GG_AROUND(glMultiDrawArrays, tapedMultiArrays),
    GG_AROUND(glMultiDrawElements, tapedMultiElements),
    GG_AROUND(glMultiDrawElementsBaseVertex, tapedMultiElementsBase),
    GG_AROUND(glClear, tapedClearing),
    GG_AROUND(glClearBufferfi, tapedClearingBoth),
    GG_AROUND(glClearBufferfv, tapedClearingBuffer),
    GG_AROUND(glClearBufferiv, tapedClearingBuffer),
    GG_AROUND(glClearBufferuiv, tapedClearingBuffer),
    GG_AROUND(glClearNamedFramebufferfi, tapedClearingNamedBoth),
    GG_AROUND(glClearNamedFramebufferfv, tapedClearingNamed),
    GG_AROUND(glClearNamedFramebufferiv, tapedClearingNamed),
    GG_AROUND(glClearNamedFramebufferuiv, tapedClearingNamed),
    GG_AROUND(glBlitFramebuffer, tapedBlitting),
    GG_AROUND(glBlitNamedFramebuffer, tapedBlittingNamed),
    GG_AROUND(glCopyTexImage2D, tapedCopyImage2),
    GG_AROUND(glCopyTexSubImage2D, tapedCopySub2),
    GG_AROUND(glCopyTexSubImage3D, tapedCopySub3),
    GG_AROUND(glCopyTextureSubImage2D, tapedCopyNamed2),
    GG_AROUND(glCopyImageSubData, tapedCopyImages),
    GG_AROUND(glGenerateMipmap, tapedMipmap),
    GG_AROUND(glGenerateTextureMipmap, tapedMipmapNamed),
    GG_AROUND(glLinkProgram, tapedLinking),
    GG_AROUND(glProgramBinary, tapedBinary),
    // what buffers hold
    GG_AROUND(glBufferData, tapedBuffers),
    GG_AROUND(glBufferSubData, tapedBuffers),
    GG_AROUND(glBufferStorage, tapedBuffers),
    GG_AROUND(glCopyBufferSubData, tapedBuffers),
    GG_AROUND(glClearBufferData, tapedBuffers),
    GG_AROUND(glClearBufferSubData, tapedBuffers),
    GG_AROUND(glInvalidateBufferData, tapedBuffers),
    GG_AROUND(glInvalidateBufferSubData, tapedBuffers),
    GG_AROUND(glUnmapBuffer, tapedBuffers),
    GG_AROUND(glFlushMappedBufferRange, tapedBuffers),
    GG_AROUND(glDeleteBuffers, tapedBuffers),
    GG_AROUND(glNamedBufferData, tapedBuffers),
    GG_AROUND(glNamedBufferSubData, tapedBuffers),
    GG_AROUND(glNamedBufferStorage, tapedBuffers),
    GG_AROUND(glCopyNamedBufferSubData, tapedBuffers),
    GG_AROUND(glClearNamedBufferData, tapedBuffers),
    GG_AROUND(glClearNamedBufferSubData, tapedBuffers),
    GG_AROUND(glUnmapNamedBuffer, tapedBuffers),
    GG_AROUND(glFlushMappedNamedBufferRange, tapedBuffers),
    GG_AROUND(glReadPixels, tapedBuffers),
    GG_AROUND(glGetTexImage, tapedBuffers),
    // what isn't recorded
    GG_REFUSED(glBegin),
    GG_REFUSED(glBeginConditionalRender),
    GG_REFUSED(glBeginTransformFeedback),
    GG_REFUSED(glBindImageTexture),
    GG_REFUSED(glBindImageTextures),
    GG_REFUSED(glBindProgramPipeline),
    GG_REFUSED(glBitmap),
    GG_REFUSED(glCallList),
    GG_REFUSED(glCallLists),
    GG_REFUSED(glCopyPixels),
    GG_REFUSED(glCopyTexImage1D),
    GG_REFUSED(glCopyTexSubImage1D),
    GG_REFUSED(glCopyTextureSubImage1D),
    GG_REFUSED(glCopyTextureSubImage3D),
    GG_REFUSED(glDepthRangeArrayv),
    GG_REFUSED(glDepthRangeIndexed),
    GG_REFUSED(glDispatchCompute),
    GG_REFUSED(glDispatchComputeIndirect),
    GG_REFUSED(glDrawArraysIndirect),
    GG_REFUSED(glDrawElementsIndirect),
    GG_REFUSED(glDrawPixels),
    GG_REFUSED(glDrawTransformFeedback),
    GG_REFUSED(glDrawTransformFeedbackInstanced),
    GG_REFUSED(glDrawTransformFeedbackStream),
    GG_REFUSED(glDrawTransformFeedbackStreamInstanced),
    GG_REFUSED(glMultiDrawArraysIndirect),
    GG_REFUSED(glMultiDrawElementsIndirect),
    GG_REFUSED(glRectf),
    GG_REFUSED(glRecti),
    GG_REFUSED(glScissorArrayv),
    GG_REFUSED(glScissorIndexed),
    GG_REFUSED(glTextureView),
    GG_REFUSED(glViewportArrayv),
    GG_REFUSED(glViewportIndexedf),
};

} // namespace

std::span<const Hook> tapeHooks() {
  return tape::isWanted ? std::span<const Hook>(kTapeHooks) : std::span<const Hook>();
}

} // namespace ggrade::capture
