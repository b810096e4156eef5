// Afterglow held against its closed form: of all frames so far the brightest light, each dimmed by
// the time that has passed since.

#include "truth_world.hpp"

#include "truth/kept.hpp"
#include "truth/truth.hpp"

using namespace post_truth;

namespace {

/// Differences below this are none, of 1: as much as two steps of a byte.
constexpr double kNone = 2.0 / 255;

struct Traced {
  Image wanted, without; // with the afterglow and without
};

Traced trace(const truth::Rendered& rendered) {
  const int width = rendered.window.width(), height = rendered.window.height();
  const double seconds = number(rendered.scene, "/afterglow/seconds");
  std::vector<double> ago = rendered.truth.at("before").get<std::vector<double>>();
  ago.push_back(0);
  std::vector<dvec3> brightest(std::size_t(width) * std::size_t(height));
  Traced traced{Image(width, height, 3), Image(width, height, 3)};
  for (const double since : ago) {
    const World world(rendered.scene, rendered.time - since, width, height);
    const double left = since > 0 ? std::exp(-since / seconds) : 1; // of a constant of 0: nothing
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const dvec3 light = world.through(x + 0.5, y + 0.5).light;
        dvec3& most = brightest[std::size_t(y) * std::size_t(width) + std::size_t(x)];
        most = glm::max(most, left * light);
        set(traced.wanted, x, y, encoded(toned(most)));
        set(traced.without, x, y, encoded(toned(light)));
      }
  }
  return traced;
}

/// `truth` says which frames came `before` this one: how many seconds before it, each. Errors, of
/// the picture as displayed (0 to 1):
///   mean error where it glows  pixels whose truth is brighter than this frame's light alone
///   mean error                 all; textures that are filtered are a part of it
///   left behind                how much brighter than it should be, where nothing glows any more
truth::Judgement judge(const truth::Rendered& rendered) {
  const auto traced = truth::kept<Traced>(rendered, trace);
  truth::Mean glowing, all, left;
  for (int y = 0; y < rendered.window.height(); ++y)
    for (int x = 0; x < rendered.window.width(); ++x) {
      const double off = apart(rendered.window, traced->wanted, x, y);
      all.add(off);
      if (apart(traced->wanted, traced->without, x, y) > kNone) {
        glowing.add(off);
        continue;
      }
      double brighter = 0;
      for (int c = 0; c < 3; ++c)
        brighter +=
            std::max(double(rendered.window.at(x, y, c)) - double(traced->wanted.at(x, y, c)), 0.0);
      left.add(brighter / 3);
    }
  truth::Judgement answer;
  answer.errors = {{"mean error where it glows", glowing.value()},
                   {"mean error", all.value()},
                   {"left behind", left.value()}};
  answer.truth = traced->wanted;
  answer.rendered = firstChannels(rendered.window, 3);
  answer.difference = truth::shownDifference(answer.rendered, answer.truth);
  return answer;
}

GGRADE_TRUTH("afterglow", judge);

} // namespace
