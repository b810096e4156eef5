// Shadows held against ray-traced shadows of a point, or of a round light.

#include "truth_world.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace floor_truth;
using glm::dvec2;

namespace {

/// Half-width of the band at the shadows' edges that is left out, in texels of the map; with soft
/// shadows their radius comes on top.
constexpr double kBandTexels = 2;
/// Where light and shadow differ by less (in any channel, 0 to 1), a picture doesn't tell them
/// apart.
constexpr double kTellable = 4.0 / 255;

struct Point {
  bool judged = false; ///< faces the light, light shows, no silhouette beside it
  bool inShadow = false;
  double share = 1; ///< of the light that is seen
  bool onMap = false;
  dvec2 map{0};          ///< on a shadow map that sees all objects, -1 to 1
  dvec3 lit{0}, dark{0}; ///< as the window shows it
};

struct Shadows {
  Image picture;
  std::vector<Point> points;               ///< row by row
  std::vector<std::array<dvec2, 2>> edges; ///< on the map, between neighbouring pixels
};

/// The light's camera as this truth assumes it, to know how large a texel is: a square frustum
/// about the ball in which objects can be. It sees more than a frustum that just encloses them, so
/// its texels and the band are larger. Sides of 79 degrees at most.
class MapOfBall {
public:
  explicit MapOfBall(const World& world) : light_(world.light) {
    const dvec3 toMiddle = world.ballMiddle - light_;
    const double distance = glm::length(toMiddle), radius = world.ballRadius;
    forward_ = distance > 0 ? toMiddle / distance : dvec3(0, -1, 0);
    const dvec3 up = std::abs(forward_.y) > 0.99 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
    right_ = glm::normalize(glm::cross(forward_, up));
    up_ = glm::cross(right_, forward_);
    if (distance > radius)
      tangent_ = std::min(tangent_, radius / std::sqrt(distance * distance - radius * radius));
  }
  /// Does the map show it? Then where, -1 to 1.
  bool project(const dvec3& position, dvec2& map) const {
    const dvec3 from = position - light_;
    const double depth = glm::dot(from, forward_);
    if (depth <= 0) return false;
    map = dvec2(glm::dot(from, right_), glm::dot(from, up_)) / (depth * tangent_);
    return std::max(std::abs(map.x), std::abs(map.y)) <= 1;
  }

private:
  dvec3 light_, forward_, right_, up_;
  double tangent_ = 5;
};

/// The light's radius, world space; 0 for a point.
double lightRadius(const truth::Rendered& rendered) {
  return rendered.truth.is_null() ? 0 : rendered.truth.value("light_radius", 0.0);
}

Shadows trace(const truth::Rendered& rendered) {
  const double radius = lightRadius(rendered);
  const World world = worldWithoutBloom(rendered, "the shadows'");
  const MapOfBall map(world);
  const std::vector<Seen> all = look(world);
  const int width = world.width, height = world.height;
  Shadows made;
  made.points.resize(all.size());
  truth::Light picture(width, height);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Surface& surface = all[i].surface;
    Point& point = made.points[i];
    point.lit = cut(world.shown(all[i], 1)), point.dark = cut(world.shown(all[i], 0));
    if (surface.id != kNothing) {
      point.inShadow = world.inShadow(surface);
      point.share = radius > 0 ? world.shareOfLight(surface, radius) : point.inShadow ? 0 : 1;
      point.onMap = map.project(surface.position, point.map);
      const dvec3 toLight = world.light - surface.position;
      const dvec3 apart = glm::abs(point.lit - point.dark);
      point.judged = !world.onTileLine(surface) && glm::dot(surface.normal, toLight) > 0 &&
                     glm::dot(surface.face, toLight) > 0 &&
                     std::max({apart.x, apart.y, apart.z}) >= kTellable;
    }
    picture.pixels[i] = glm::mix(point.dark, point.lit, point.share);
  }
  made.picture = imageOf(picture);

  const auto compareNeighbours = [&](std::size_t i, std::size_t j) {
    Point &a = made.points[i], &b = made.points[j];
    if (!continues(all[i].surface, all[j].surface)) {
      a.judged = b.judged = false;
      return;
    }
    if (a.inShadow != b.inShadow && a.onMap && b.onMap) made.edges.push_back({a.map, b.map});
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
      if (x + 1 < width) compareNeighbours(i, i + 1);
      if (y + 1 < height) compareNeighbours(i, i + std::size_t(width));
    }
  return made;
}

/// The texels of a map of `size` x `size` that lie within `reach` texels of a shadow's edge.
class Band {
public:
  Band(const Shadows& shadows, int size, double reach)
      : size_(size), near_(std::size_t(size) * std::size_t(size)) {
    for (const auto& [a, b] : shadows.edges) {
      const dvec2 from = texels(a), to = texels(b);
      const int steps = 1 + int(2 * glm::distance(from, to));
      for (int i = 0; i <= steps; ++i) mark(from + (to - from) * (double(i) / steps), reach);
    }
  }
  bool has(const Point& point) const {
    if (!point.onMap) return false;
    const dvec2 at = texels(point.map);
    return near_[index(clamped(at.x), clamped(at.y))];
  }

private:
  dvec2 texels(const dvec2& map) const { return (map + 1.0) * (0.5 * size_); }
  int clamped(double texel) const { return std::clamp(int(std::floor(texel)), 0, size_ - 1); }
  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(size_) + std::size_t(x);
  }
  void mark(const dvec2& at, double reach) {
    for (int y = clamped(at.y - reach); y <= clamped(at.y + reach); ++y)
      for (int x = clamped(at.x - reach); x <= clamped(at.x + reach); ++x)
        near_[index(x, y)] = true;
  }

  int size_;
  std::vector<bool> near_;
};

struct Counts {
  double lit = 0, dark = 0, falseShadow = 0, falseLight = 0;
  static double share(double wrong, double of) { return of > 0 ? wrong / of : 0; }
};

/// The colours of pixels in the light of a round source, `"truth": { "light_radius": 0.1 }`,
/// against the truth's. Errors, of the same pixels as below:
///   soft RMSE        root of the mean square difference, over all channels
///   penumbra RMSE    the same where the truth lies between light and shadow
truth::Judgement judgeSoft(const truth::Rendered& rendered, const Shadows& shadows) {
  double squares = 0, count = 0, innerSquares = 0, innerCount = 0;
  Image difference(rendered.window.width(), rendered.window.height(), 3);
  for (std::size_t i = 0; i < shadows.points.size(); ++i) {
    const Point& point = shadows.points[i];
    if (!point.judged) continue;
    const int x = int(i) % rendered.window.width(), y = int(i) / rendered.window.width();
    const auto pixel = rendered.window.pixel(x, y);
    const dvec3 apart =
        dvec3(pixel[0], pixel[1], pixel[2]) - glm::mix(point.dark, point.lit, point.share);
    const double square = glm::dot(apart, apart) / 3;
    squares += square, ++count;
    if (point.share > 0 && point.share < 1) innerSquares += square, ++innerCount;
    // Red: too dark, blue: too light.
    difference.at(x, y, apart.x + apart.y + apart.z < 0 ? 0 : 2) =
        std::min(1.0f, 4 * float(std::sqrt(square)));
  }
  const auto root = [](double sum, double of) { return of > 0 ? std::sqrt(sum / of) : 0; };
  return {{{"soft RMSE", root(squares, count)}, {"penumbra RMSE", root(innerSquares, innerCount)}},
          shadows.picture,
          firstChannels(rendered.window, 3),
          difference};
}

/// Errors, of a point of light:
///   wrong pixels           share of the pixels that show light for shadow or the other way round
///   false shadow or light  the larger of the next two
///   false shadow           share of the pixels with light that show a shadow (acne)
///   false light            share of the pixels in shadow that show light (leaks, peter-panning)
/// The last three leave out a band of two texels of the shadow map (and the radius of its soft
/// edge) at the shadows' edges: they tell what is wrong besides the map's resolution, and are 0 for
/// any map that is coarse enough. So settings are compared by the first, which leaves out no edge.
/// A pixel shows what it is nearer to: its colour with light, or without. Nowhere counted are
/// surfaces turned from the light, pixels whose two colours are too close, one pixel at
/// silhouettes. The truth's shadows are hard: a soft edge is half wrong. For a round light see
/// judgeSoft.
truth::Judgement judge(const truth::Rendered& rendered) {
  const auto shadows = kept<Shadows>(rendered, trace);
  if (lightRadius(rendered) > 0) return judgeSoft(rendered, *shadows);
  const json& quality = rendered.scene.at("quality");
  const Band band(*shadows, quality.at("shadow_size").get<int>(),
                  kBandTexels + quality.at("pcf_radius").get<int>());
  Counts inner, all;
  Image difference(rendered.window.width(), rendered.window.height(), 3);
  for (std::size_t i = 0; i < shadows->points.size(); ++i) {
    const Point& point = shadows->points[i];
    if (!point.judged) continue;
    const int x = int(i) % rendered.window.width(), y = int(i) / rendered.window.width();
    const auto pixel = rendered.window.pixel(x, y);
    const dvec3 color(pixel[0], pixel[1], pixel[2]);
    const bool showsShadow = glm::distance(color, point.dark) < glm::distance(color, point.lit);
    const bool inBand = band.has(point);
    const auto count = [&](Counts& counts) {
      ++(point.inShadow ? counts.dark : counts.lit);
      if (showsShadow != point.inShadow) ++(showsShadow ? counts.falseShadow : counts.falseLight);
    };
    count(all);
    if (!inBand) count(inner);
    // Red: false shadow, blue: false light, pale in the band.
    if (showsShadow != point.inShadow)
      for (const int c : {showsShadow ? 0 : 2}) difference.at(x, y, c) = inBand ? 0.4f : 1.0f;
  }
  const double falseShadow = Counts::share(inner.falseShadow, inner.lit);
  const double falseLight = Counts::share(inner.falseLight, inner.dark);
  truth::Judgement answer;
  answer.errors = {
      {"wrong pixels", Counts::share(all.falseShadow + all.falseLight, all.lit + all.dark)},
      {"false shadow or light", std::max(falseShadow, falseLight)},
      {"false shadow", falseShadow},
      {"false light", falseLight}};
  answer.truth = shadows->picture;
  answer.rendered = firstChannels(rendered.window, 3);
  answer.difference = difference;
  return answer;
}

GGRADE_TRUTH("shadow", judge);

} // namespace
