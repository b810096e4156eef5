#pragma once
/// \file
/// Recorded state in words, and what is worth a second look in a frame.

#include "report/inspect.hpp"
#include "report/inspect_graph.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ggrade::report {

/// A number with as few digits as tell it from its neighbours: "0.1", "inf", "nan".
std::string shortest(float value);
/// "12.3 MB", "480 bytes".
std::string byteWords(std::uint64_t bytes);
/// "1,234".
std::string grouped(std::uint64_t value);
/// "1 draw", "1,234 draws".
std::string drawCount(std::uint64_t draws);
/// "640 x 480 at (0, 0)".
std::string rectangle(const std::int32_t (&box)[4]);

/// "colour 0", or "colour" for the only one; "depth"; "stencil"; "picture" for trace::kNone.
std::string attachmentWords(const trace::PassRecord& pass, std::uint32_t attachment);
/// "texture 3, level 2", "window", "renderbuffer 1".
std::string imageWords(const trace::ImageRef& image);
/// "1024 x 1024", with "4 samples" if there are.
std::string sizeWords(const trace::ImageRef& image);
/// Attachments that a pass is about: draw buffers; depth and stencil too when nothing else.
std::vector<std::uint32_t> mainAttachments(const trace::PassRecord& pass);

/// "draws into a texture, 1024 x 1024 RGBA8, with depth renderbuffer".
std::string passTitle(const trace::PassRecord& pass);
/// What a framebuffer status means and what to do; empty for a complete one.
std::string statusMeaning(std::uint32_t status);

/// One line of a step's state.
struct StateWord {
  std::string label, value;
  bool isOff; ///< off, or none
};
/// Always the same labels in the same order, so that two steps can be compared line by line.
std::vector<StateWord> stateWords(const trace::StepRecord& step);
/// "LINEAR, CLAMP_TO_EDGE"; comparisons named too.
std::string samplerWords(const trace::SampleRecord& sample);

/// "pass 1's depth".
std::string readWords(const FrameGraph& graph, const PassRead& read);

/// What is worth a second look. Only facts that the records show; whether it is a mistake is for
/// the reader to say.
struct Note {
  /// Breaks drawing for certain; may well be a mistake; mostly is meant.
  enum class Kind { wrong, odd, fact };
  Kind kind = Kind::odd;
  std::string text; ///< names of uniforms are the program's own: escape it
};

/// Of the frame as a whole: framebuffer left bound, sRGB on the window, what was lost to limits.
std::vector<Note> frameNotes(const InspectedFrame& frame);
/// Of one pass, from its records alone (what its pixels show: inspect_pixels.hpp).
std::vector<Note> passNotes(const FrameGraph& graph, std::uint32_t pass);

} // namespace ggrade::report
