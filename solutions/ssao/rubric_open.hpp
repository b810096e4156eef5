#pragma once
// How open surfaces are: in a frame of the window, in what a scene's picture of the occlusion
// shows, and in the textures that passes left.

#include "rubric/light.hpp"
#include "rubric/measures.hpp"
#include "rubric/passes.hpp"

#include <string>
#include <vector>

namespace ssao_rubric {

using namespace ggrade;
using namespace ggrade::rubric;

/// What a frame of a scene shows where, in the reference.
struct Regions {
  Mask covered; // by surfaces
  Mask edges;   // within two pixels of where one surface ends and another begins
  Image open;   // as the reference has it, with its blur; one channel
};
const Regions& regionsOf(const SceneEvidence& scene, std::size_t frame);

/// How open the window shows each pixel to be, by its colour between no ambient light and all of
/// it; one channel. Means nothing where ambient light makes no difference.
Image openInWindow(const View& view, std::size_t frame);

/// A texture that a pass over the whole screen left in the first frame and that was read later: its
/// first channel, as large as the window.
struct Opening {
  Drawn drawn;
  Image open;
};
std::vector<Opening> openings(const View& view);

/// The mean over the (2 reach + 1)^2 pixels around each, of those in `region`. Noise goes, and how
/// it was made doesn't matter.
Image smoothed(const Image& image, const Mask& region, int reach);

/// How far apart two pictures are in `region`: the sum of their differences as a share of all that
/// `wanted` keeps out. 1 for a picture without any occlusion.
double apart(const Image& found, const Image& wanted, const Mask& region);

/// The frame's occlusion in a scene whose picture it is (debug.picture 3); one channel.
Image shownOpen(const View& view, std::size_t frame);

} // namespace ssao_rubric
