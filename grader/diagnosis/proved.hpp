#pragma once
/// \file
/// Causes that were proved by drawing a submission again with the reference's in one place, in
/// words for its author. They say where, never what stands there in the reference.

#include "results/results.hpp"

#include <string>
#include <vector>

namespace ggrade::diagnosis {

/// "the viewport", "the uniform uView", "visibility() in the fragment shader".
std::string nameOf(const results::ProvedCause& cause);

/// One sentence or two; `causes` is not empty.
std::string sentenceOf(const std::vector<results::ProvedCause>& causes);

} // namespace ggrade::diagnosis
