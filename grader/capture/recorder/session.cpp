#include "capture/recorder/session.hpp"

#include "capture/channel_writer.hpp"
#include "capture/recorder/gl_calls.hpp"

namespace ggrade::capture::recorder {
namespace {

/// Never destroyed: the program's own destructors may still call GL.
Shared& sharedState() {
  static Shared* const instance = new Shared;
  return *instance;
}

Context& contextOf(ContextState& state, Shared& shared) {
  if (!state.recorder) {
    state.recorder = std::make_shared<Context>();
    state.recorder->id = shared.contexts++;
    state.recorder->compatible =
        integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT;
  }
  return *state.recorder;
}

} // namespace

Shared::Shared() : request(plan()->trace) {}

Session::Session() : shared_(sharedState()), state_(currentState()), lock_(shared_.mutex) {
  if (!state_ || shared_.frame >= plan()->frameCount) return;
  Context& context = contextOf(*state_, shared_);
  if (context.insideBegin) return;
  // In a display list nothing is drawn yet, and some of our calls would become part of it.
  if (context.compatible && integer(GL_LIST_INDEX) != 0) return;
  context_ = &context;
  failed_ = collectError(*state_) != GL_NO_ERROR;
  state_->quiet = true;
}

Session::~Session() {
  if (!context_) return;
  while (gl().getError() != GL_NO_ERROR) {
  }
  state_->quiet = false;
}

bool Session::isSeen() const {
  return shared_.frame >= plan()->frameCount || !plan()->frames[shared_.frame].unseen;
}

void Session::countFrame(std::uint32_t& firstPass, std::uint32_t& passCount) {
  const std::uint32_t passes = shared_.tables.passes();
  firstPass = shared_.firstPassOfFrame;
  passCount = passes - firstPass;
  shared_.firstPassOfFrame = passes;
  if (isSeen()) ++shared_.seenFrames;
  ++shared_.frame;
}

Place Session::placeOf(const trace::ImageRef& image) const {
  const bool window = image.kind == static_cast<std::uint32_t>(trace::ImageKind::window);
  return {image.kind, window ? context_->id : state_->shareGroup, image.name};
}

Place Session::placeOf(GLuint texture) const {
  return placeOf(textureLevel(texture, 0));
}

} // namespace ggrade::capture::recorder
