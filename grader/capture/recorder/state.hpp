#pragma once
/// \file
/// The state that a step is a run of equal draws in. The context must be current.

#include "capture/recorder/images.hpp"
#include "trace/records.hpp"

namespace ggrade::capture::recorder {

/// GL's state now, as a step's record without pass, draws, matrices and samples; `mode` and
/// `program` are left 0.
trace::StepRecord readState();

/// Mask of the attachments that a draw with this state can change.
std::uint32_t writtenBy(const trace::StepRecord& state, const Target& target);

/// Mask of the attachments that a clear of these changes, and of those that it covers to the last
/// pixel. `asked` is the mask of attachments named by the call, `images` have been described.
struct ClearEffect {
  std::uint32_t written = 0, covered = 0;
};
ClearEffect effectOfClear(std::uint32_t asked, const Target& target, const trace::ImageRef* images);

} // namespace ggrade::capture::recorder
