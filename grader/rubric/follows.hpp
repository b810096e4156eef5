#pragma once
/// \file
/// What changes in a scene must change in the picture, and nothing else: metamorphic relations
/// (Chen, Cheung, Yiu 1998). Each compares two pictures of the submission with each other. The
/// reference only says how large the change is, so that a picture that is wrong, but wrong in the
/// same way before and after, loses nothing here.

#include "rubric/measures.hpp"

#include <functional>

namespace ggrade::rubric {

/// The pixels of a frame of a view in which an effect (reflection, shadow, bloom) shows.
using Effect = std::function<Mask(const View& view, std::size_t frame)>;

/// Judges one scene: without a base, whether the effect changes from the first frame to the second
/// (time passes); of a scene of the base's size, whether it changes with what the scene says; of a
/// scene of another size, whether it stays as it was, seen through the other window. A submission
/// that has no such effect has nothing that could follow: quality 1.
Verdict follows(const View& view, const Effect& effect, const std::string& what);

/// The mask of a window of one size as a window of another shows it: the field of view is that of
/// the height, so a wider window shows more on the left and right. `seen` gets the pixels that
/// `mask` has anything to say about.
Mask throughWindow(const Mask& mask, int width, int height, Mask& seen);

} // namespace ggrade::rubric
