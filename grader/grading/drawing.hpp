#pragma once
/// \file
/// What programs draw with on this machine: the context behind the capture library, and the
/// libraries that it brings along.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace ggrade::grading {

/// What draws: GL_VERSION and GL_RENDERER.
struct Renderer {
  std::string version, name;
};

/// Chooses what this process and those that it starts draw with, before anything is drawn (it is
/// kept in the environment, as GGRADE_CONTEXT). "auto": OSMesa where it is, else EGL with llvmpipe.
/// "osmesa" and "egl" are these; "gpu" is EGL with the first graphics card.
void chooseContext(const std::string& name);

struct Drawing {
  std::string context; ///< "osmesa", "egl" or "gpu"
  Renderer renderer;
  /// All files that a run reads to draw, canonical but for their own names. They are being read
  /// into memory: so no run finds out which of them another has read.
  std::vector<std::filesystem::path> files;
};

/// Nothing here can draw; what() says why, with the remedy.
struct CannotDraw : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Found out by running a program of ours that is linked as submissions are. Throws CannotDraw.
const Drawing& drawing();

/// Empty where programs can draw as drawing() found; else what has become of it: its packages may
/// be updated while a class is graded.
std::string drawsNoMore();

} // namespace ggrade::grading
