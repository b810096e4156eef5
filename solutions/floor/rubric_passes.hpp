#pragma once
// Passes as the rubrics look for them: by what they are, never by a name.

#include "image/image.hpp"
#include "trace/trace.hpp"

#include <glm/mat4x4.hpp>

#include <vector>

namespace floor_rubric {

using namespace ggrade;

/// A picture that one pass drew and a later one sampled.
struct Drawn {
  const trace::PassRecord* pass = nullptr; ///< that drew it
  std::uint32_t attachment = 0;
  const trace::CopyRecord* copy = nullptr;
  const trace::PassRecord* reader = nullptr; ///< the first that sampled it
  const trace::StepRecord* readingStep = nullptr;
  std::uint32_t format = 0; ///< internal format
};

/// Every attachment of frame 0 that a later pass of the frame samples and that was copied, in the
/// order in which the passes drew; the first 64.
std::vector<Drawn> sampledLater(const trace::Trace& trace);

/// Was this drawn as a mesh, not as a full-screen quad?
bool drewObjects(const trace::PassRecord& pass);

/// The colours of `image` (any size) at the pixels of a picture of another size, bilinear, clamped
/// at the edges; the first `channels` channels.
Image resampled(const Image& image, int width, int height, int channels);

/// The matrices that a step used at its first draw (those recorded first under each name), and the
/// products of two of them, in both orders; of the first 24 that differ.
std::vector<glm::dmat4> matricesAndProducts(const std::vector<glm::dmat4>& matrices);
std::vector<glm::dmat4> matricesOf(const trace::Trace& trace, const trace::StepRecord& step);

} // namespace floor_rubric
