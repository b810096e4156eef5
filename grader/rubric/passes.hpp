#pragma once
/// \file
/// Passes as rubrics look for them: by what they are, never by a name.

#include "trace/trace.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace ggrade::rubric {

/// A picture that one pass drew and a later one sampled.
struct Drawn {
  const trace::PassRecord* pass = nullptr; ///< that drew it
  std::uint32_t attachment = 0;
  bool ofObjects = false; ///< a mesh was drawn, not full-screen quads alone
  const trace::CopyRecord* copy = nullptr;
  const trace::PassRecord* reader = nullptr; ///< the first that sampled it
  const trace::StepRecord* readingStep = nullptr;
  std::uint32_t format = 0; ///< internal format
  std::string uniform;      ///< the sampler that it was first read through
};

/// Every attachment of frame 0 that a later pass of the frame samples and that was copied, in the
/// order in which the passes drew; the first 64.
std::vector<Drawn> sampledLater(const trace::Trace& trace);

} // namespace ggrade::rubric
