// Smooth edges held against what a pixel would show if it were looked at in 256 places: everything
// that lies in it, by the area that it covers.

#include "truth_world.hpp"

#include "truth/kept.hpp"
#include "truth/truth.hpp"

#include <array>

using namespace post_truth;

namespace {

/// Rows and columns of a pixel's samples: one in each cell, no two in the same 256th of its width
/// or height (Chiu et al. 1994, "Multi-Jittered Sampling"). An edge that runs along rows or columns
/// covers as many as its area says, to 1/256.
constexpr int kCells = 16;
constexpr int kReversed[kCells] = {0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
double within(int cell, int other) {
  return (cell + (kReversed[other] + 0.5) / kCells) / kCells;
}

/// Angles of edges, degrees from the window's rows; each class ends where the next one begins.
struct Angles {
  const char* name;
  double below;
};
constexpr Angles kAngles[] = {{"edges up to 10 degrees", 10},
                              {"edges of 10 to 45 degrees", 45},
                              {"edges of 45 to 80 degrees", 80},
                              {"edges above 80 degrees", 91}};

struct Pixel {
  int angles = -1;        ///< of the edge in it, index of kAngles; -1: there is none
  bool thin = false;      ///< shows a wire that is thinner than a pixel
  bool highlight = false; ///< nothing but the rippled ball
};

struct Traced {
  Image wanted;
  Image blended;             // the mean of displayed values instead of light
  std::vector<Pixel> pixels; // by rows
  const Pixel& at(int x, int y) const {
    return pixels[std::size_t(y) * std::size_t(wanted.width()) + std::size_t(x)];
  }
};

bool differ(const Sight& a, const Sight& b) {
  if (a.thing != b.thing) return true;
  return a.thing >= 0 && glm::dot(a.face, b.face) < 0.7; // of a ball all faces are one
}

/// Neighbouring cells that show different things: side by side, and one above the other. An edge
/// that runs along rows has the latter only.
int angleOf(const std::array<std::array<Sight, kCells>, kCells>& cells) {
  int across = 0, down = 0;
  for (int j = 0; j < kCells; ++j)
    for (int i = 0; i < kCells; ++i) {
      if (i + 1 < kCells) across += differ(cells[j][i], cells[j][i + 1]);
      if (j + 1 < kCells) down += differ(cells[j][i], cells[j + 1][i]);
    }
  if (across + down == 0) return -1;
  const double degrees = std::atan2(across, down) * 180 / std::numbers::pi;
  int index = 0;
  while (degrees >= kAngles[index].below) ++index;
  return index;
}

Traced trace(const truth::Rendered& rendered) {
  const int width = rendered.window.width(), height = rendered.window.height();
  const World world(rendered.scene, rendered.time, width, height);
  const double thick = number(rendered.scene, "/wires/thickness");
  const double unit = height / (2 * glm::length(world.camera().up)); // pixels, at a depth of 1
  Traced traced{Image(width, height, 3), Image(width, height, 3), {}};
  std::array<std::array<Sight, kCells>, kCells> cells;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Pixel& pixel = traced.pixels.emplace_back();
      pixel.highlight = true;
      dvec3 sum(0), shown(0);
      for (int j = 0; j < kCells; ++j)
        for (int i = 0; i < kCells; ++i) {
          const Sight& sight = cells[j][i] = world.through(x + within(i, j), y + within(j, i));
          const dvec3 light = toned(sight.light);
          sum += light, shown += encoded(light);
          const bool something = sight.thing >= 0;
          if (something && world.kindOf(sight.thing) == Thing::wire)
            pixel.thin |= thick * unit < sight.depth;
          pixel.highlight &= something && world.kindOf(sight.thing) == Thing::ripples;
        }
      pixel.angles = angleOf(cells);
      set(traced.wanted, x, y, encoded(sum / double(kCells * kCells)));
      set(traced.blended, x, y, shown / double(kCells * kCells));
    }
  return traced;
}

/// What the last pass made smooth edges of; the window itself if there was no such pass.
Image beforeAntialias(const truth::Rendered& rendered) {
  if (rendered.trace != nullptr)
    for (const trace::PassRecord& pass : rendered.trace->passesOf(0))
      for (const trace::StepRecord& step : rendered.trace->stepsOf(pass))
        for (const trace::SampleRecord& sample : rendered.trace->samplesOf(step)) {
          if (std::string(sample.uniform) != "uPicture" || sample.writer == trace::kNone) continue;
          const trace::CopyRecord* copy = rendered.trace->copyOf(sample.writer, 0);
          if (copy != nullptr) return rendered.trace->image(*copy);
        }
  return rendered.window;
}

/// Is there no edge in the pixel or in any of the eight around it?
bool awayFromEdges(const Traced& traced, int x, int y) {
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, traced.wanted.height() - 1); ++j)
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, traced.wanted.width() - 1); ++i)
      if (traced.at(i, j).angles >= 0) return false;
  return true;
}

/// Errors, of the picture as displayed (0 to 1), each the mean over the pixels that it names:
///   mean error at edges       pixels in which more than one thing or face is seen
///   at edges, blended as displayed   the same against the mean of the samples' displayed values:
///                             how well the covered area is found by those who blend such values
///   edges up to 10 degrees .. those by the angle between edge and rows
///   under a pixel             pixels with a wire that is thinner than they are
///   in highlights             pixels that show nothing but the rippled ball
///   damage away from edges    how far antialiasing changes pixels without an edge nearby; textures
///                             have none
///   mean error                all
truth::Judgement judge(const truth::Rendered& rendered) {
  const auto traced = truth::kept<Traced>(rendered, trace);
  const Image before = beforeAntialias(rendered);
  const Image& found = rendered.window;
  truth::Mean edges, blended, ofAngle[std::size(kAngles)], thin, highlights, damage, all;
  for (int y = 0; y < found.height(); ++y)
    for (int x = 0; x < found.width(); ++x) {
      const Pixel& pixel = traced->at(x, y);
      const double off = apart(found, traced->wanted, x, y);
      all.add(off);
      if (pixel.angles >= 0) {
        edges.add(off), ofAngle[pixel.angles].add(off);
        blended.add(apart(found, traced->blended, x, y));
      }
      if (pixel.thin) thin.add(off);
      if (pixel.highlight) highlights.add(off);
      if (sameSize(before, found) && awayFromEdges(*traced, x, y))
        damage.add(apart(found, before, x, y));
    }
  truth::Judgement answer;
  answer.errors = {{"mean error at edges", edges.value()},
                   {"at edges, blended as displayed", blended.value()}};
  for (std::size_t i = 0; i < std::size(kAngles); ++i)
    answer.errors.push_back({kAngles[i].name, ofAngle[i].value()});
  answer.errors.push_back({"under a pixel", thin.value()});
  answer.errors.push_back({"in highlights", highlights.value()});
  answer.errors.push_back({"damage away from edges", damage.value()});
  answer.errors.push_back({"mean error", all.value()});
  answer.truth = traced->wanted;
  answer.rendered = firstChannels(found, 3);
  answer.difference = truth::shownDifference(answer.rendered, answer.truth);
  return answer;
}

GGRADE_TRUTH("antialias", judge);

} // namespace
