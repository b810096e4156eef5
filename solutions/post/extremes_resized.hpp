#pragma once
/// \file
/// A solution drawn in a window whose size changes between two frames.

#include "grading/program.hpp"
#include "grading/toolchain.hpp"

#include <gtest/gtest.h>

namespace extremes {

/// Draws the solution that was built beside the tests, trusted as draw() does it.
///   frames: time (seconds), width, height (pixels)
inline std::vector<ggrade::Image>
resized(const std::string& assignment, const nlohmann::json& scene,
        const std::vector<ggrade::channel::PlannedFrame>& frames) {
  using namespace ggrade;
  const auto build = std::filesystem::path(toolchain::kCaptureFolder).parent_path();
  const grading::Rendering rendering =
      grading::renderFrames(assignment, build / "solutions" / assignment, scene, frames,
                            {build / "tests/extremes/shaders"}, sandbox::Isolation::none);
  EXPECT_EQ(rendering.happened.outcome, results::Outcome::graded) << rendering.happened.detail;
  std::vector<Image> images;
  for (const channel::CapturedFrame& frame : rendering.capture.frames)
    images.push_back(Image::fromBytes(frame.pixels, int(frame.width), int(frame.height)));
  return images;
}

} // namespace extremes
