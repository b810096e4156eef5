#pragma once
/// \file
/// A frame, pass by pass: the filmstrip page and the terminal's table.

#include "trace/trace.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ggrade::report {

/// A GL error or debug message; the program may have chosen its text.
struct InspectedMessage {
  std::string text;
  std::uint32_t count = 1;
  std::uint32_t pass = trace::kNone; ///< index in the trace
};

/// One frame of a program, as the recorder saw it.
struct InspectedFrame {
  std::string name; ///< what was rendered, such as "mirror, the reference"
  trace::Trace trace;
  std::size_t frame = 0;     ///< index in `trace.frames`; if there are none, all passes are shown
  double time = 0;           ///< seconds of the program's clock
  bool framesBefore = false; ///< did the program draw others first, of which the trace has nothing?
  std::uint32_t width = 0, height = 0; ///< of the window, pixels
  std::uint32_t boundFramebuffer = 0;  ///< at the swap
  bool windowSrgb = false;             ///< GL_FRAMEBUFFER_SRGB was on for the window
  bool shadersTimed = false;           ///< the passes' times hold the first use of the shaders, too
  std::string renderer;                ///< GL_RENDERER
  std::string problem;                 ///< why the frame isn't whole, one sentence; mostly empty
  std::vector<InspectedMessage> messages;
  std::uint32_t messagesLost = 0;
};

struct InspectLimits {
  /// Room for pictures and values in the page. What doesn't fit is shown as a small picture
  /// without values, or, once the small pictures have filled a quarter more, not at all.
  std::size_t bytes = std::size_t{64} << 20;
  int pictureSide = 1024; ///< pixels; a larger picture is shrunk (its values are not)
};

/// A page that needs nothing else, works from file:// and, but for the values under the pointer,
/// without scripts. \throws std::runtime_error if a picture can't be encoded.
std::string inspectPage(const InspectedFrame& frame, const InspectLimits& limits = {});

/// One line a pass: number, what it draws into, size, format, draws, milliseconds, reads from.
std::string inspectTable(const InspectedFrame& frame);

} // namespace ggrade::report
