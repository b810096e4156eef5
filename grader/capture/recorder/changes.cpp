// What changes or ends an image that a pass may have drawn into, and what ends a pass without
// drawing.

#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/recorder.hpp"
#include "capture/recorder/session.hpp"
#include "capture/tape/objects.hpp"

#include <span>

namespace ggrade::capture::recorder {
namespace {

using trace::ImageKind;

/// Ends the open pass, so that its copies are made, if the image is one that it draws into.
void endPassOf(Session& session, ImageKind kind, GLuint name) {
  if (!session.context().pass) return;
  for (const trace::ImageRef& image : session.context().pass->record.images) {
    if (image.kind == static_cast<std::uint32_t>(kind) && image.name == name)
      return endPass(session);
  }
}

void recordUpload(Session& session, GLuint texture, GLint level) {
  if (!texture) return;
  endPassOf(session, ImageKind::texture, texture);
  session.shared().writers.forget(session.placeOf(texture), static_cast<std::uint32_t>(level));
  tape::imageChanged(ImageKind::texture, texture);
}

Place renderbufferPlace(Session& session, GLuint renderbuffer) {
  return {static_cast<std::uint32_t>(ImageKind::renderbuffer), session.state().shareGroup,
          renderbuffer};
}

void recordRenderbuffer(Session& session, GLuint renderbuffer) {
  endPassOf(session, ImageKind::renderbuffer, renderbuffer);
  session.shared().writers.forget(renderbufferPlace(session, renderbuffer));
  tape::imageChanged(ImageKind::renderbuffer, renderbuffer);
}

} // namespace

void uploadedToBound(GLenum target, GLint level) {
  if (Session session; session) recordUpload(session, boundTexture(target), level);
}

void uploaded(GLuint texture, GLint level) {
  if (Session session; session) recordUpload(session, texture, level);
}

void renderbufferChanged(GLuint renderbuffer) {
  if (Session session; session) recordRenderbuffer(session, renderbuffer);
}

void boundRenderbufferChanged() {
  if (Session session; session) recordRenderbuffer(session, number(GL_RENDERBUFFER_BINDING));
}

void invalidated() {
  if (Session session; session) endPass(session);
}

void texturesDeleted(GLsizei count, const GLuint* names) {
  Session session;
  if (!session || count <= 0 || !names) return;
  for (const GLuint name : std::span(names, static_cast<std::size_t>(count))) {
    endPassOf(session, ImageKind::texture, name);
    session.shared().writers.forget(session.placeOf(name));
    tape::imageDeleted(ImageKind::texture, name);
  }
}

void renderbuffersDeleted(GLsizei count, const GLuint* names) {
  Session session;
  if (!session || count <= 0 || !names) return;
  for (const GLuint name : std::span(names, static_cast<std::size_t>(count))) {
    recordRenderbuffer(session, name);
    tape::imageDeleted(ImageKind::renderbuffer, name);
  }
}

void programChanged(GLuint program) {
  if (Session session; session)
    session.shared().programs.forget(session.state().shareGroup, program);
}

void leave() {
  if (Session session; session) endPass(session);
}

} // namespace ggrade::capture::recorder
