#pragma once
/// \file
/// What is worth a second look in a frame. Only facts that the records show; whether it is a
/// mistake is for the reader to say.

#include "report/inspect.hpp"
#include "report/inspect_graph.hpp"

#include <string>
#include <vector>

namespace ggrade::report {

struct Note {
  /// Breaks drawing for certain; may well be a mistake; mostly is meant.
  enum class Kind { wrong, odd, fact };
  Kind kind = Kind::odd;
  std::string text; ///< names of uniforms are the program's own: escape it
};

/// Of the frame as a whole: framebuffer left bound, sRGB on the window, what was lost to limits.
std::vector<Note> frameNotes(const InspectedFrame& frame);
/// Of one pass, from its records alone (see inspect_pixels.hpp for what its pixels show).
std::vector<Note> passNotes(const FrameGraph& graph, std::uint32_t pass);

} // namespace ggrade::report
