#pragma once
/// \file
/// Builds a folder of student files into a program, and renders scenes with it, both in the
/// sandbox.

#include "assignment/assignment.hpp"
#include "capture/channel_reader.hpp"
#include "diagnosis/outcome.hpp"
#include "grading/drawing.hpp"
#include "rubric/evidence.hpp"
#include "sandbox/sandbox.hpp"

namespace ggrade::grading {

using rubric::Moments;

/// A run may take so much processor time: a busy machine must not cost a student points.
inline constexpr double kRunSeconds = 10;
/// And so much more for each frame beyond the first few. Graded scenes have no more than those; who
/// times a program in many frames waits for them.
inline constexpr double kFrameSeconds = 2;
inline constexpr std::size_t kFewFrames = 4;
/// And so many times that by the clock, for a program that waits forever.
inline constexpr double kWallFactor = 3;

/// How submissions are built and run, and the programs that they are compared with: in the sandbox,
/// unless somebody who trusts them all has spelled out `none` before anything was run. Every result
/// says which.
sandbox::Isolation& isolation();

/// Whether gradings of this process count each fault once (grading/repair.hpp): scores depend on
/// it.
bool& repairs();

/// What happened when a submission was built or run, in the contract's terms.
struct Happened {
  results::Outcome outcome = results::Outcome::notGradable;
  std::string detail; ///< one sentence with the evidence
  std::string output; ///< what the program or compiler wrote, valid UTF-8
  double seconds = 0;
  bool signalled = false; ///< a signal ended it

  bool ok() const {
    return outcome == results::Outcome::graded || outcome == results::Outcome::glError;
  }
};

/// Compiles `folder`/`id`.cpp to `folder`/`id` with the kit's headers and library. The outcome is
/// `graded`, `buildFailed` or `notGradable`.
Happened buildProgram(const std::string& id, const std::filesystem::path& folder,
                      sandbox::Isolation isolation);

/// One run of a program in one scene.
struct Rendering {
  Happened happened;
  channel::Capture capture; ///< what came, also when the run failed later
};

/// A run's shader cache. Compiling shaders takes most of a run's time.
struct ShaderCache {
  std::filesystem::path folder; ///< the run gets a copy of it; empty: no cache at all
  /// Where the cache stands after a run in the sandbox, for the program's next ones; the copy as it
  /// was if the run ended badly or left too much. Empty: it is forgotten.
  std::filesystem::path keep{};
};

/// What is recorded of the passes of programs that are graded, and of those that they are compared
/// with: everything, what the first frame's passes left in textures, and the stencil wherever it
/// is.
trace::Request gradingRequest();

/// These frames of a window of this size (0: as the program asks), but for those before that have
/// their own.
std::vector<channel::PlannedFrame> plannedFrames(const Moments& times, std::uint32_t width,
                                                 std::uint32_t height);

/// Runs `folder`/`id` in `scene` for the given times. What `trace` asks for of the passes stands in
/// the capture's trace; `replacements` are put in place of what passes leave. With `doctor` the
/// framework says on stderr what it finds wrong with the run's first frame.
Rendering renderScene(const std::string& id, const std::filesystem::path& folder,
                      const nlohmann::json& scene, const Moments& times, const ShaderCache& shaders,
                      sandbox::Isolation isolation, const trace::Request& trace = {},
                      const std::vector<channel::PassPixels>& replacements = {},
                      bool doctor = false);

/// The same for any frames. `tape` lies beside the scene, for the player of tapes alone.
Rendering renderFrames(const std::string& id, const std::filesystem::path& folder,
                       const nlohmann::json& scene,
                       const std::vector<channel::PlannedFrame>& frames, const ShaderCache& shaders,
                       sandbox::Isolation isolation, const trace::Request& trace = {},
                       const std::vector<channel::PassPixels>& replacements = {},
                       bool doctor = false, const std::vector<std::byte>& tape = {});

/// Runs any GLFW program, trusted (not in the sandbox), with the caller's environment. A size of 0
/// leaves the window as the program asks.
Rendering renderProgram(const std::vector<std::string>& arguments, const Moments& times,
                        std::uint32_t width, std::uint32_t height,
                        const trace::Request& trace = {});

/// The captured frames in the form that is kept in files.
std::vector<rubric::RawFrame> rawFrames(const channel::Capture& capture);

/// What a capture told besides pictures; `trace` is its own.
diagnosis::Facts factsOf(const channel::Capture& capture, const trace::Trace& trace);

/// Settings of the renderer that pixels depend on, the same for every run: names and values.
const std::vector<std::pair<std::string, std::string>>& rendererPins();

/// Compiler flags and settings of the renderer, the same for every build and run.
std::string pins();

inline Renderer rendererOf(const channel::Capture& capture) {
  return {capture.glVersion, capture.glRenderer};
}

/// What can change a pixel without the submission changing: renderer, compiler, pinned settings.
/// Where a program claims to be drawn by another renderer, the claim comes last, as such.
std::vector<std::pair<std::string, std::string>> fingerprint(const Renderer& renderer,
                                                             const Renderer& claim);

} // namespace ggrade::grading
