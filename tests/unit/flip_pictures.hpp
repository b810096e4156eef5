#pragma once
/// \file
/// Pictures that FLIP's tests are made of, the same on every machine.

#include "image/image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace flip_pictures {

using ggrade::Image;

/// Numerical Recipes' generator; the upper 8 bits as 0 to 1.
class Random {
public:
  explicit Random(std::uint32_t seed) : state_(seed) {}
  float operator()() {
    state_ = state_ * 1664525u + 1013904223u;
    return float(state_ >> 24) / 255.0f;
  }

private:
  std::uint32_t state_;
};

inline Image noise(std::uint32_t seed, int width, int height, int channels = 3) {
  Random random(seed);
  Image image(width, height, channels);
  for (float& value : image.values()) value = random();
  return image;
}

inline Image constant(int width, int height, float r, float g, float b) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.at(x, y, 0) = r;
      image.at(x, y, 1) = g;
      image.at(x, y, 2) = b;
    }
  return image;
}

/// Red grows to the right, green downwards, blue falls both ways.
inline Image gradient(int width, int height) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.at(x, y, 0) = float(x * 255 / (width - 1)) / 255;
      image.at(x, y, 1) = float(y * 255 / (height - 1)) / 255;
      image.at(x, y, 2) = float(255 - (x + y) * 255 / (width + height)) / 255;
    }
  return image;
}

inline Image withSquare(Image image, int left, int top, int side, float r, float g, float b) {
  for (int y = top; y < top + side; ++y)
    for (int x = left; x < left + side; ++x) {
      image.at(x, y, 0) = r;
      image.at(x, y, 1) = g;
      image.at(x, y, 2) = b;
    }
  return image;
}

/// Dark grey left of column `at`, light grey from it on.
inline Image step(int width, int height, int at) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = (x < at ? 51.0f : 204.0f) / 255;
  return image;
}

/// Noise over 16 stops, from dark on the left to bright on the right.
inline Image hdrNoise(std::uint32_t seed, int width, int height) {
  Random random(seed);
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y, c) = std::exp2(float(x * 16 / width) - 8.0f) * (0.5f + random());
  return image;
}

inline float largest(const Image& map) {
  float value = 0;
  for (const float error : map.values()) value = std::max(value, error);
  return value;
}

} // namespace flip_pictures
