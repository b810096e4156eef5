#pragma once
/// \file
/// What a wrong picture is, told from the right one alone: upside down, shifted, too dark, ...

#include "image/image.hpp"

#include <optional>
#include <span>
#include <string>

namespace ggrade::diagnosis {

/// One wrong picture beside the right one. All must have the same channels; `reference` is not
/// empty.
struct Pair {
  const Image* student = nullptr;
  const Image* reference = nullptr;
  const Image* before = nullptr; ///< the reference one frame earlier, or null
  const Image* stub = nullptr;   ///< what the handed-out program shows, or null
};

/// What turns the right picture into the wrong one.
struct Generic {
  enum class Kind {
    otherSize,
    black,
    constant, ///< one colour everywhere
    stub,
    lastFrame,
    upsideDown,
    mirrored, ///< left and right exchanged
    turned,   ///< both
    redBlueSwapped,
    encodedTwice, ///< the sRGB curve once too often
    notEncoded,
    shifted,
    scaled ///< brighter or darker by a factor
  };
  Kind kind = Kind::black;
  int dx = 0, dy = 0;  ///< shifted: pixels to the right and down
  double factor = 1;   ///< scaled
  double likeness = 0; ///< 0 to 1: how much of what is wrong it explains, in the worst pair
};

/// One sentence on `what` ("The window's picture"): "The window's picture is upside down."
std::string describe(const Generic& generic, const std::string& what);

/// The change that explains all pairs, or nothing. Pairs that are right count as explained where
/// the change leaves the picture as it is.
std::optional<Generic> generic(std::span<const Pair> pairs);

/// Is the light that a picture adds to `before` that of the right one but for a factor? Of light,
/// or of light encoded by the sRGB curve. Pictures of one size and as many channels; what either of
/// them cuts off at 1 doesn't count.
bool addsScaledLight(const Image& student, const Image& reference, const Image& before);

} // namespace ggrade::diagnosis
