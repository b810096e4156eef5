#pragma once
/// \file
/// Shadows as a picture shows them, whatever their colour: how much light a pixel gets is measured
/// between two renderings of the reference, "unlit" (0) and "unshadowed" (1).

#include "image/mask.hpp"

namespace ggrade::rubric {

/// The reference without direct light, and with all of it: no shadow anywhere. RGB, of one size.
struct LightRange {
  const Image& unlit;
  const Image& unshadowed;
};

/// How much of the light reaches each pixel of `image`: 0 in shadow, 1 lit, beyond where it is
/// darker or brighter than either. Means nothing where light makes no difference.
Image visibility(const Image& image, const LightRange& light);

/// Pixels whose first channel is below `value`.
Mask below(const Image& image, float value);

/// Pixels of `region` that no amount of light explains: to the published tolerances neither lit,
/// nor unlit, nor as in `reference`, nor of a colour between lit and unlit.
Mask unexplained(const Image& image, const Image& reference, const LightRange& light,
                 const Mask& region);

} // namespace ggrade::rubric
