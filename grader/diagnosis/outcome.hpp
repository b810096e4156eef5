#pragma once
/// \file
/// Faults that need no picture to be told: nothing came, nothing went where it should, or
/// OpenGL was in a state in which drawing shows nothing.

#include "results/results.hpp"
#include "trace/trace.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ggrade::diagnosis {

/// What the capture counted in one frame of the public scene.
struct FrameFacts {
  unsigned windowDraws = 0;      ///< draws that went to the window
  unsigned boundFramebuffer = 0; ///< at the swap; 0 is the window
};

/// What a program's runs told besides pictures: the first scene's, and how a bad one ended.
struct Facts {
  std::vector<FrameFacts> frames;
  std::vector<std::string> incomplete; ///< status of framebuffers that were drawn into in vain
  bool endedItself = false;            ///< the run that ended badly was not ended by a signal
};

/// Of what is seen where a framebuffer object is still bound as the window is shown.
inline constexpr const char* kLeftBound = "framebuffer_left_bound";

/// The diagnosis of a result that has an outcome other than `graded`, or whose frames show nothing
/// because nothing was drawn to the window; nothing where only pictures can tell. `result.outcome`,
/// `.detail`, `.compilerOutput` and the scenes' messages are read.
std::optional<results::Diagnosis> outcomeDiagnosis(const results::Result& result,
                                                   const Facts& facts);

/// The compiler's warnings of kinds that explain a program which does something else than it says,
/// a line each, at most `most`: `floor.cpp:280:5: warning: multi-line comment [-Wcomment]`.
std::vector<std::string> tellingWarnings(const std::string& compilerOutput, std::size_t most = 3);

/// One sentence on each state, as the recorder saw it, that explains a window without a picture: a
/// closed colour mask, an empty scissor or viewport, a depth test that nothing passes, a clear
/// after the last draw, ... For a program whose picture is wrong: a right one may have reasons for
/// some of them.
std::vector<std::string> stateFaults(const trace::Trace& trace);

/// A texture that a sampler reads; pixels.
struct Sampled {
  bool isDepth = false;
  std::uint32_t width = 0, height = 0;
  bool byObject = false;  ///< by the settings of a sampler object
  bool isComplete = true; ///< else it reads as black
  friend bool operator==(const Sampled&, const Sampled&) = default;
};

/// Of the samplers, by name, that read a texture in the first frame, the last one.
std::map<std::string, Sampled> sampledTextures(const trace::Trace& trace);

} // namespace ggrade::diagnosis
