#pragma once
/// \file
/// Tapes: what a program drew, drawn again without the program (grader/replay).

#include "grading/program.hpp"

namespace ggrade::grading {

/// As gradingRequest, and all of these frames go on a tape, those before among them.
trace::Request tapingRequest(const Moments& times);

/// Draws the tape again in the sandbox: as it is, or as each of these JSON patches (RFC 6902) of
/// its commands has it, one after the other from the start, all frames of `times` each.
/// \param size of the window, pixels
/// \param shaders an empty cache's folder or none
Rendering play(const std::vector<std::byte>& tape, const std::vector<nlohmann::json>& patches,
               const std::vector<std::uint32_t>& size, const Moments& times,
               const ShaderCache& shaders, const trace::Request& request);

/// As `play` with grading's request: for each patch what it drew, with its first frame's passes;
/// without frames where the player didn't get that far. Throws where one alone runs out of time:
/// with shaders of the tape's own, each could.
/// \param frameBytes copies of one frame's passes take
std::vector<channel::Capture> playEach(const std::vector<std::byte>& tape,
                                       const std::vector<nlohmann::json>& patches,
                                       const std::vector<std::uint32_t>& size, const Moments& times,
                                       const ShaderCache& shaders, std::uint64_t frameBytes);

/// Where the second drew something else than the first, in words; empty: every frame, and every
/// copy of every pass, is equal bit for bit.
std::string differenceOf(const channel::Capture& drawn, const channel::Capture& played);

} // namespace ggrade::grading
