// Blits, copies, mipmap generations and compute shaders: each is a pass of its own, which says what
// is read and what is written. They begin before the GL call and are complete after it, because
// some of them define the image that they write.

#include "capture/recorder/bound.hpp"
#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/recorder.hpp"
#include "capture/recorder/session.hpp"

#include <algorithm>
#include <cstdlib>

namespace ggrade::capture::recorder {
namespace {

using trace::ImageKind;
using trace::ImageRef;
using trace::kNone;
using trace::PassKind;

constexpr std::uint32_t kMaxLevels = 32;

trace::SampleRecord readOf(Session& session, ImageRef image, std::uint32_t attachment = 0) {
  trace::SampleRecord sample{};
  describe(image, attachment, session.state().windowSize);
  sample.image = image;
  sample.writer = session.shared().writers.of(session.placeOf(image), image.level, image.level);
  return sample;
}

/// What reading these aspects of the bound read framebuffer reads.
std::vector<trace::SampleRecord> readsOfFramebuffer(Session& session, GLbitfield mask) {
  std::vector<trace::SampleRecord> reads;
  const GLuint framebuffer = number(GL_READ_FRAMEBUFFER_BINDING);
  const auto read = [&](std::uint32_t attachment) {
    const ImageRef image = attachedImage(GL_READ_FRAMEBUFFER, framebuffer, attachment);
    if (image.kind != static_cast<std::uint32_t>(ImageKind::none))
      reads.push_back(readOf(session, image, attachment));
  };
  const std::uint32_t color = attachmentOf(integer(GL_READ_BUFFER));
  if (mask & GL_COLOR_BUFFER_BIT && color != kNone) read(color);
  if (mask & GL_DEPTH_BUFFER_BIT) read(trace::kDepth);
  if (mask & GL_STENCIL_BUFFER_BIT) read(trace::kStencil);
  return reads;
}

bool isNone(const ImageRef& image) {
  return image.kind == static_cast<std::uint32_t>(ImageKind::none);
}

GLint distance(GLint a, GLint b) {
  const std::int64_t wide = std::abs(std::int64_t{a} - b);
  return static_cast<GLint>(std::min<std::int64_t>(wide, INT32_MAX));
}

void recordBlit(Session& session, const GLint (&to)[4], GLbitfield mask) {
  OpenPass& pass = beginPass(session, PassKind::blit);
  trace::PassRecord& record = pass.record;
  const Target target = boundTarget();
  record.framebuffer = target.framebuffer;
  record.status = gl().checkFramebufferStatus(GL_DRAW_FRAMEBUFFER);
  record.drawBuffers = target.drawBuffers;
  record.viewport[0] = std::min(to[0], to[2]);
  record.viewport[1] = std::min(to[1], to[3]);
  record.viewport[2] = distance(to[0], to[2]);
  record.viewport[3] = distance(to[1], to[3]);
  std::uint32_t asked = mask & GL_COLOR_BUFFER_BIT ? target.drawBuffers : 0;
  if (mask & GL_DEPTH_BUFFER_BIT) asked |= 1U << trace::kDepth;
  if (mask & GL_STENCIL_BUFFER_BIT) asked |= 1U << trace::kStencil;
  for (std::uint32_t i = 0; i < trace::kAttachments; ++i) {
    ImageRef& image = record.images[i];
    image = target.images[i];
    describe(image, i, session.state().windowSize);
    if (asked >> i & 1 && !isNone(image) && record.status == GL_FRAMEBUFFER_COMPLETE)
      record.written |= 1U << i;
  }
  addReadStep(session, pass, readsOfFramebuffer(session, mask));
}

/// Puts what a copy or mipmap generation writes where its format says. Its aspects.
Aspects place(Session& session, trace::PassRecord& record, ImageRef image) {
  describe(image, 0, session.state().windowSize);
  const Aspects aspects = aspectsOf(image);
  const auto put = [&](std::uint32_t attachment) {
    record.images[attachment] = image;
    record.written |= 1U << attachment;
  };
  if (aspects.color) {
    put(0);
    record.drawBuffers = 1;
  }
  if (aspects.depth) put(trace::kDepth);
  if (aspects.stencil) put(trace::kStencil);
  return aspects;
}

void beginCopy(Session& session, const ImageRef& to) {
  if (to.name) beginPass(session, PassKind::copy).destination = to;
}

void beginMipmap(Session& session, GLuint texture) {
  if (!texture) return;
  const auto base = static_cast<std::uint32_t>(textureParameter(texture, GL_TEXTURE_BASE_LEVEL));
  beginPass(session, PassKind::mipmap).destination = textureLevel(texture, base);
}

void endCopy(Session& session, OpenPass& pass) {
  const Aspects aspects = place(session, pass.record, pass.destination);
  if (!isNone(pass.source)) {
    addReadStep(session, pass, {readOf(session, pass.source)});
    return;
  }
  pass.record.framebuffer = kNone;
  addReadStep(session, pass,
              readsOfFramebuffer(session, (aspects.color ? GL_COLOR_BUFFER_BIT : 0U) |
                                              (aspects.depth ? GL_DEPTH_BUFFER_BIT : 0U) |
                                              (aspects.stencil ? GL_STENCIL_BUFFER_BIT : 0U)));
}

/// The first level below the base stands for all that have been generated.
void endMipmap(Session& session, OpenPass& pass) {
  const ImageRef base = pass.destination;
  const auto last = static_cast<std::uint32_t>(textureParameter(base.name, GL_TEXTURE_MAX_LEVEL));
  for (std::uint32_t level = base.level + 1; level <= std::min(last, base.level + kMaxLevels);
       ++level) {
    if (levelParameter(base.name, level, GL_TEXTURE_WIDTH) == 0) break;
    if (level == base.level + 1) place(session, pass.record, textureLevel(base.name, level));
    pass.otherWrites.push_back({session.placeOf(base.name), level, kNone});
  }
  addReadStep(session, pass, {readOf(session, base)});
}

ImageRef imageOf(const CopySide& side) {
  const auto level = static_cast<std::uint32_t>(side.level);
  if (side.target != GL_RENDERBUFFER) {
    const bool layered = side.target != GL_TEXTURE_2D && side.target != GL_TEXTURE_RECTANGLE &&
                         side.target != GL_TEXTURE_1D && side.target != GL_TEXTURE_2D_MULTISAMPLE;
    return textureLevel(side.name, level, layered ? static_cast<std::uint32_t>(side.z) : kNone);
  }
  ImageRef image{};
  image.kind = static_cast<std::uint32_t>(ImageKind::renderbuffer);
  image.name = side.name;
  image.layer = kNone;
  return image;
}

std::uint32_t layerOf(GLenum target, GLint layer) {
  if (target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z)
    return target - GL_TEXTURE_CUBE_MAP_POSITIVE_X;
  return layer < 0 ? kNone : static_cast<std::uint32_t>(layer);
}

} // namespace

void blit(const GLint (&to)[4], GLbitfield mask) {
  if (Session session; session) recordBlit(session, to, mask);
}

void blitOf(GLuint from, GLuint framebuffer, const GLint (&to)[4], GLbitfield mask) {
  Session session;
  if (!session) return;
  const Bound read(GL_READ_FRAMEBUFFER, GL_READ_FRAMEBUFFER_BINDING, from);
  const Bound drawn(GL_DRAW_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER_BINDING, framebuffer);
  if (read.valid && drawn.valid) recordBlit(session, to, mask);
}

void copyToBound(GLenum target, GLint level, GLint layer) {
  if (Session session; session)
    beginCopy(session, textureLevel(boundTexture(target), static_cast<std::uint32_t>(level),
                                    layerOf(target, layer)));
}

void copyTo(GLuint texture, GLint level, GLint layer) {
  if (Session session; session)
    beginCopy(session,
              textureLevel(texture, static_cast<std::uint32_t>(level), layerOf(GL_NONE, layer)));
}

void copyImage(const CopySide& from, const CopySide& to) {
  Session session;
  if (!session || !from.name || !to.name) return;
  beginCopy(session, imageOf(to));
  session.context().pass->source = imageOf(from);
}

void mipmapOfBound(GLenum target) {
  if (Session session; session) beginMipmap(session, boundTexture(target));
}

void mipmapOf(GLuint texture) {
  if (Session session; session) beginMipmap(session, texture);
}

void dispatch() {
  Session session;
  if (!session) return;
  OpenPass& pass = beginPass(session, PassKind::imageStore);
  if (OpenStep* const step = stepFor(session, pass)) recordMatrices(session, *step);
  noteImageStores(session, pass, currentPrograms());
  std::uint32_t slot = 0;
  for (const OtherWrite& write : pass.otherWrites) {
    if (slot == trace::kColors) break;
    ImageRef& image = pass.record.images[slot];
    image = textureLevel(write.place.name, write.level, write.layer);
    describe(image, slot, {});
    pass.record.drawBuffers |= 1U << slot;
    pass.record.written |= 1U << slot++;
  }
}

void ended() {
  Session session;
  if (!session || !session.context().pass) return;
  OpenPass& pass = *session.context().pass;
  pass.lastCall = passClock();
  switch (static_cast<PassKind>(pass.record.kind)) {
  case PassKind::draw:
    return;
  case PassKind::copy:
    endCopy(session, pass);
    break;
  case PassKind::mipmap:
    endMipmap(session, pass);
    break;
  default:
    break;
  }
  if (session.failed()) {
    pass.record.written = 0;
    pass.otherWrites.clear();
  }
  endPass(session);
}

} // namespace ggrade::capture::recorder
