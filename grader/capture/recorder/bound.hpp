#pragma once
/// \file
/// Another framebuffer, bound for a while.

#include "capture/recorder/gl_calls.hpp"

namespace ggrade::capture::recorder {

/// Binds framebuffers for as long as it lives. `valid` is false for names that aren't framebuffers.
class Bound {
public:
  Bound(GLenum target, GLenum query, GLuint framebuffer)
      : valid(framebuffer == 0 || gl().isFramebuffer(framebuffer)), target_(target),
        before_(number(query)) {
    if (valid) gl().bindFramebuffer(target_, framebuffer);
  }
  ~Bound() { gl().bindFramebuffer(target_, before_); }
  Bound(const Bound&) = delete;
  Bound& operator=(const Bound&) = delete;
  const bool valid;

private:
  GLenum target_;
  GLuint before_;
};

} // namespace ggrade::capture::recorder
