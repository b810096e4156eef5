#pragma once
/// \file
/// The program's state that reading framebuffers depends on.

#include "capture/recorder/pixel_state.hpp"

namespace ggrade::capture::recorder {

/// While this exists, pixels are read as they are into plain memory, and the read framebuffer may
/// be bound elsewhere. The destructor puts all of it back. The context must be current.
class ReadState {
public:
  ReadState();
  ~ReadState();
  ReadState(const ReadState&) = delete;
  ReadState& operator=(const ReadState&) = delete;

private:
  GLuint framebuffer_;
  GLuint clamp_;
  PixelState pack_;
};

} // namespace ggrade::capture::recorder
