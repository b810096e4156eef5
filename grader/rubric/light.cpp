#include "rubric/light.hpp"

#include "image/compare.hpp"

#include <algorithm>
#include <cmath>

namespace ggrade::rubric {

Image visibility(const Image& image, const LightRange& light) {
  Image out(image.width(), image.height(), 1);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      float along = 0, length = 1e-9f;
      for (int c = 0; c < 3; ++c) {
        const float range = light.unshadowed.at(x, y, c) - light.unlit.at(x, y, c);
        along += (image.at(x, y, c) - light.unlit.at(x, y, c)) * range;
        length += range * range;
      }
      out.at(x, y) = along / length;
    }
  return out;
}

Mask below(const Image& image, float value) {
  Mask mask(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) mask.set(x, y, image.at(x, y) < value);
  return mask;
}

Mask unexplained(const Image& image, const Image& reference, const LightRange& light,
                 const Mask& region) {
  CompareOptions options;
  options.mask = &region;
  Mask wrong = region;
  for (const Image* other : {&reference, &light.unlit, &light.unshadowed})
    if (const Comparison comparison = compare(image, *other, options); comparison.compared())
      wrong = wrong & comparison.wrong;
  const Image amount = visibility(image, light);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      if (!wrong.at(x, y)) continue;
      const float v = std::clamp(amount.at(x, y), 0.0f, 1.0f);
      bool between = true;
      for (int c = 0; c < 3; ++c) {
        const float unlit = light.unlit.at(x, y, c);
        const float expected = unlit + v * (light.unshadowed.at(x, y, c) - unlit);
        between &= std::abs(image.at(x, y, c) - expected) <= 2 * tolerances().tolerance;
      }
      if (between) wrong.set(x, y, false);
    }
  return wrong;
}

} // namespace ggrade::rubric
