#pragma once
/// \file
/// What the judging side asks for of one run, checked and in the form in which it is handed over.

#include "capture/channel_reader.hpp"

#include <vector>

namespace ggrade::channel {

/// Throws std::invalid_argument, naming the rule, for what no run could do.
Plan makePlan(const std::vector<PlannedFrame>& frames, std::uint64_t maxPixels,
              const trace::Request& trace, const std::vector<PassPixels>& replacements);

/// Writes the plan and the replacements' pixels to a file that is `totalBytes(plan)` long. Throws
/// std::system_error.
void writePlan(int descriptor, const Plan& plan, const std::vector<PassPixels>& replacements);

} // namespace ggrade::channel
