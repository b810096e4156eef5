#pragma once
/// \file
/// What programs with known faults show, rendered once and kept, for the diagnosis to compare with.

#include "diagnosis/match.hpp"
#include "grading/references.hpp"

#include <functional>

namespace ggrade::grading {

/// A program that a submission may show the same as: one with a known fault, or an unfinished one.
struct Candidate {
  std::string name;
  std::string group; ///< see diagnosis::Signature
  Recipe recipe;
};

/// What the reference shows in a scene of the plan.
using ReferenceViews = std::function<const diagnosis::SceneViews&(std::size_t scene)>;

/// What each of the candidates shows in the scenes with these numbers, rendered in the
/// sandbox unless it lies in the cache; an empty SceneViews where it shows nothing there. A program
/// that can't be made any more (its patch doesn't apply) shows nothing at all: `ggrade calibrate`
/// names it. `stencil`: see diagnosis::views. Throws Interrupted.
std::vector<diagnosis::Signature>
renderSignatures(const Target& target, const std::filesystem::path& solutionFolder,
                 const std::vector<Candidate>& candidates, const std::vector<std::size_t>& scenes,
                 const References& references, const ReferenceViews& reference,
                 const Progress& progress, bool stencil = false);

/// The frames in a folder (see rubric::writeFrames), RGB.
std::vector<Image> framesIn(const std::filesystem::path& folder);
/// What lies in a folder of frames and passes (see rubric::writeFrames, trace::save).
diagnosis::SceneViews viewsIn(const std::filesystem::path& folder, bool stencil = false);

} // namespace ggrade::grading
