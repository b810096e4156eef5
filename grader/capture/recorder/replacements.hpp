#pragma once
/// \file
/// Puts pixels that the judging side has chosen in place of what a pass left.

#include "capture/recorder/session.hpp"

namespace ggrade::capture::recorder {

/// Makes the plan's replacements of this pass, which has ended, and answers to them. Leaves GL's
/// state as it was.
void replaceOutputs(const OpenPass& pass);

} // namespace ggrade::capture::recorder
