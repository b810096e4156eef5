#pragma once
/// \file
/// Made-up pictures without any symmetry, and runs made of them.

#include "diagnosis/views.hpp"

#include <cmath>

namespace ggrade::diagnosis::samples {

/// A chequered floor under a bright disc and a small box, lit from the left: no two of its flips,
/// colours or moments look alike.
inline Image scene(int width = 320, int height = 240, float moved = 0) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float u = (float(x) + 0.5f) / float(width), v = (float(y) + 0.5f) / float(height);
      const bool tile = (int(u * 10) + int(v * 8)) % 2 == 0;
      float r = 0.15f + 0.2f * u, g = 0.2f + 0.1f * v, b = tile && v > 0.5f ? 0.55f : 0.3f;
      if (std::hypot(u - 0.3f - moved, (v - 0.4f) * 0.75f) < 0.16f) {
        r = 0.9f - u;
        g = 0.35f;
        b = 0.12f;
      }
      if (u > 0.62f + moved && u < 0.8f + moved && v > 0.15f && v < 0.3f) {
        r = 0.1f;
        g = 0.7f - v;
        b = 0.2f;
      }
      image.at(x, y, 0) = r;
      image.at(x, y, 1) = g;
      image.at(x, y, 2) = b;
    }
  return image;
}

/// `image` with the pixels of a rectangle (in shares of its sides) in one colour.
inline Image painted(Image image, float left, float top, float right, float bottom, float value) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const float u = (float(x) + 0.5f) / float(image.width());
      const float v = (float(y) + 0.5f) / float(image.height());
      if (u < left || u > right || v < top || v > bottom) continue;
      for (int c = 0; c < image.channels(); ++c) image.at(x, y, c) = value;
    }
  return image;
}

/// One scene: a depth texture and a colour texture of objects, and two frames of the window.
inline SceneViews views(const Image& depth, const Image& texture, const Image& first,
                        const Image& second) {
  SceneViews views;
  views.passes.push_back({{true, true, 0, 0}, 512, 512, reduced(depth, 1)});
  views.passes.push_back({{false, true, 0, 0}, 640, 480, reduced(texture, 3)});
  views.windows = {reduced(first, 3), reduced(second, 3)};
  views.width = first.width();
  views.height = first.height();
  return views;
}

inline SceneViews views() {
  return views(Image(64, 64, 1, 0.4f), scene(256, 256), scene(), scene(320, 240, 0.05f));
}

} // namespace ggrade::diagnosis::samples
