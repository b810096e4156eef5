#pragma once
// Passes as the rubrics look for them, see also rubric/passes.hpp.

#include "image/image.hpp"
#include "rubric/passes.hpp"

#include <glm/mat4x4.hpp>

#include <vector>

namespace floor_rubric {

using namespace ggrade;

using rubric::Drawn;
using rubric::sampledLater;

/// The colours of `image` (any size) at the pixels of a picture of another size, bilinear, clamped
/// at the edges; the first `channels` channels.
Image resampled(const Image& image, int width, int height, int channels);

/// The matrices that a step used at its first draw (those recorded first under each name), and the
/// products of two of them, in both orders; of the first 24 that differ.
std::vector<glm::dmat4> matricesAndProducts(const std::vector<glm::dmat4>& matrices);
/// Those of the first 24 that differ that are perspective, and the products of a projection and of
/// something affine: what a camera may have drawn with.
std::vector<glm::dmat4> perspectives(const std::vector<glm::dmat4>& matrices);
std::vector<glm::dmat4> matricesOf(const trace::Trace& trace, const trace::StepRecord& step);

} // namespace floor_rubric
