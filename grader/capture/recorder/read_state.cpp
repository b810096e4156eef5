#include "capture/recorder/read_state.hpp"

#include "capture/recorder/gl_calls.hpp"

namespace ggrade::capture::recorder {

ReadState::ReadState()
    : framebuffer_(number(GL_READ_FRAMEBUFFER_BINDING)), clamp_(number(GL_CLAMP_READ_COLOR)),
      pack_(PixelDirection::pack) {
  if (clamp_ != GL_FALSE) gl().clampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
}

ReadState::~ReadState() {
  if (clamp_ != GL_FALSE) gl().clampColor(GL_CLAMP_READ_COLOR, clamp_);
  gl().bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
}

} // namespace ggrade::capture::recorder
