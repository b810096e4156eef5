#pragma once
/// \file
/// One submission after it was rendered and judged, for who looks closer.

#include "diagnosis/outcome.hpp"
#include "grading/references.hpp"

namespace ggrade::grading {

struct Submitted {
  const ScenePlan& plan;
  const References& references;
  std::vector<std::filesystem::path> folders; ///< its frames and passes, by scene
  diagnosis::Facts facts;                     ///< of the first scene
};

} // namespace ggrade::grading
