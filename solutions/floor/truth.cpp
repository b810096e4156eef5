// The mirror held against a ray-traced planar reflection.

#include "truth_world.hpp"

#include "image/mask.hpp"

#include <cmath>
#include <stdexcept>

using namespace floor_truth;

namespace {

struct Mirror {
  Image picture; ///< the whole window, RGB, 0 to 1
  Mask floor;    ///< pixels that show the floor
  Mask inner;    ///< of these, the ones without an edge among their neighbours
};

/// The light of every pixel's reflection, blurred as the scene asks. The blur is a Gaussian of
/// `mirror.blur` window heights over the sharp reflection as all pixels of the window would show
/// it, beyond the window's edge the nearest pixel.
truth::Light reflections(const World& world, const std::vector<Seen>& all, double blur) {
  truth::Light sharp(world.width, world.height);
  for (std::size_t i = 0; i < all.size(); ++i) sharp.pixels[i] = all[i].reflection;
  if (blur == 0) return sharp;
  const double variance = std::pow(blur * world.height, 2);
  return apply(sharp, truth::gaussian(world.width, variance, truth::Edge::clamp),
               truth::gaussian(world.height, variance, truth::Edge::clamp));
}

/// Without an edge of the floor, or of what it reflects, among its neighbours?
bool isInner(const World& world, const std::vector<Seen>& all, int x, int y) {
  const auto at = [&](int u, int v) -> const Seen& {
    return all[std::size_t(v) * std::size_t(world.width) + std::size_t(u)];
  };
  const Seen& here = at(x, y);
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, world.height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, world.width - 1); ++u)
      if (at(u, v).surface.id != kFloor || at(u, v).reflected.id != here.reflected.id) return false;
  return true;
}

Mirror trace(const truth::Rendered& rendered) {
  const World world = worldWithoutBloom(rendered, "the mirror's");
  std::vector<Seen> all = look(world);
  const truth::Light reflection =
      reflections(world, all, rendered.scene.at("mirror").at("blur").get<double>());
  truth::Light picture(world.width, world.height);
  Mirror made;
  made.floor = made.inner = Mask(world.width, world.height);
  for (int y = 0; y < world.height; ++y)
    for (int x = 0; x < world.width; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(world.width) + std::size_t(x);
      all[i].reflection = reflection.pixels[i];
      picture.pixels[i] = cut(world.shown(all[i], world.visibility(all[i].surface)));
      if (all[i].surface.id != kFloor || world.onTileLine(all[i].surface)) continue;
      made.floor.set(x, y);
      made.inner.set(x, y, isInner(world, all, x, y));
    }
  made.picture = imageOf(picture);
  return made;
}

double rmse(const Image& found, const Image& wanted, const Mask& where) {
  double sum = 0, count = 0;
  for (int y = 0; y < wanted.height(); ++y)
    for (int x = 0; x < wanted.width(); ++x) {
      if (!where.at(x, y)) continue;
      for (int c = 0; c < 3; ++c)
        sum += std::pow(double(found.at(x, y, c)) - double(wanted.at(x, y, c)), 2), ++count;
    }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

/// Errors, in the window's values from 0 to 1:
///   reflection RMSE  over the pixels of the floor, but for a band of one pixel at the edges of the
///                    floor and of the objects that it reflects
///   edge RMSE        over all pixels of the floor
/// Light without a reflection and shadows are the program's own, so their errors count, too; ask in
/// a scene without shadows. A pixel right on the line between two tiles counts nowhere.
truth::Judgement judge(const truth::Rendered& rendered) {
  const auto mirror = kept<Mirror>(rendered, trace);
  truth::Judgement answer;
  answer.errors = {{"reflection RMSE", rmse(rendered.window, mirror->picture, mirror->inner)},
                   {"edge RMSE", rmse(rendered.window, mirror->picture, mirror->floor)}};
  answer.truth = mirror->picture;
  answer.rendered = firstChannels(rendered.window, 3);
  answer.difference = shownDifference(answer.rendered, answer.truth);
  return answer;
}

GGRADE_TRUTH("mirror", judge);

} // namespace
