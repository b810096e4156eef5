// Motion blur held against what the shutter lets in: one ray through each pixel's middle at each of
// 256 moments.

#include "truth_world.hpp"

#include "truth/kept.hpp"
#include "truth/truth.hpp"

using namespace post_truth;

namespace {

constexpr int kMoments = 256;
/// Differences below this are none, of 1: as much as two steps of a byte.
constexpr double kNone = 2.0 / 255;

enum class Where : char { rest, elsewhere, inside, beyond };

struct Traced {
  Image wanted, sharp;
  std::vector<Where> where; // by rows
};

Traced trace(const truth::Rendered& rendered) {
  const int width = rendered.window.width(), height = rendered.window.height();
  const double open =
      number(rendered.scene, "/motion/shutter") * number(rendered.truth, "/seconds");
  const bool still =
      number(rendered.scene, "/motion/speed") == 0 && number(rendered.scene, "/motion/turn") == 0;
  const int moments = still || open == 0 ? 1 : kMoments;
  const auto count = std::size_t(width) * std::size_t(height);
  std::vector<dvec3> sums(count);
  std::vector<bool> passed(count); // by something that moves by itself
  for (int i = 0; i < moments; ++i) {
    const double time = rendered.time + open * ((i + 0.5) / moments - 0.5);
    const World world(rendered.scene, time, width, height);
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
      const auto x = double(pixel % std::size_t(width)), y = double(pixel / std::size_t(width));
      const Sight sight = world.through(x + 0.5, y + 0.5);
      sums[pixel] += sight.light / double(moments);
      if (sight.thing >= 0 && moves(world.kindOf(sight.thing))) passed[pixel] = true;
    }
  }
  Traced traced{Image(width, height, 3), Image(width, height, 3), {}};
  const World world(rendered.scene, rendered.time, width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t pixel = traced.where.size();
      const Sight sight = world.through(x + 0.5, y + 0.5);
      set(traced.wanted, x, y, encoded(toned(sums[pixel])));
      set(traced.sharp, x, y, encoded(toned(sight.light)));
      Where where = Where::rest;
      if (apart(traced.wanted, traced.sharp, x, y) > kNone) {
        const bool own = sight.thing >= 0 && moves(world.kindOf(sight.thing));
        where = own ? Where::inside : passed[pixel] ? Where::beyond : Where::elsewhere;
      }
      traced.where.push_back(where);
    }
  return traced;
}

/// `truth` says how many `seconds` lie between this frame and the one before. The shutter is open
/// for motion.shutter of them; the frame's time is the middle of that. Errors, of the picture as
/// displayed (0 to 1):
///   mean error where something moves  pixels whose truth isn't the sharp picture
///   inside outlines                   those that show something at this time that moves by itself
///   beyond outlines                   those that only show it earlier or later
///   mean error                        all; textures that are filtered are a part of it
truth::Judgement judge(const truth::Rendered& rendered) {
  const auto traced = truth::kept<Traced>(rendered, trace);
  truth::Mean moving, inside, beyond, all;
  std::size_t pixel = 0;
  for (int y = 0; y < rendered.window.height(); ++y)
    for (int x = 0; x < rendered.window.width(); ++x) {
      const double off = apart(rendered.window, traced->wanted, x, y);
      const Where where = traced->where[pixel++];
      all.add(off);
      if (where != Where::rest) moving.add(off);
      if (where == Where::inside) inside.add(off);
      if (where == Where::beyond) beyond.add(off);
    }
  truth::Judgement answer;
  answer.errors = {{"mean error where something moves", moving.value()},
                   {"inside outlines", inside.value()},
                   {"beyond outlines", beyond.value()},
                   {"mean error", all.value()}};
  answer.truth = traced->wanted;
  answer.rendered = firstChannels(rendered.window, 3);
  answer.difference = truth::shownDifference(answer.rendered, answer.truth);
  return answer;
}

GGRADE_TRUTH("motion_blur", judge);

} // namespace
