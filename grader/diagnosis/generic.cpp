#include "diagnosis/generic.hpp"

#include "diagnosis/match.hpp"
#include "diagnosis/views.hpp"
#include "image/compare.hpp"

#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace ggrade::diagnosis {

using gg::say;

namespace {

using Kind = Generic::Kind;

/// Least of what is wrong that a change must explain.
constexpr double kExplained = 0.85;
/// A change of brightness below this is none: such a picture is black.
constexpr double kLeastFactor = 0.05;
/// Shares of a picture below which two are the same, and from which on they are not.
constexpr double kAlike = 5e-4, kDifferent = 2e-3;
/// Shifts are looked for up to this share of the picture's side.
constexpr double kFarthest = 0.08;

double meanDistance(const Image& a, const Image& b) {
  const std::vector<float> distances = distance(&a, &b);
  return std::accumulate(distances.begin(), distances.end(), 0.0) / double(distances.size());
}

Image mapped(const Image& image, const std::function<std::pair<int, int>(int, int)>& from) {
  Image out(image.width(), image.height(), image.channels());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const auto [u, v] = from(x, y);
      std::ranges::copy(image.pixel(u, v), out.pixel(x, y).begin());
    }
  return out;
}

Image changed(const Image& image, const std::function<float(float)>& to) {
  Image out = image;
  std::ranges::transform(out.values(), out.values().begin(), to);
  return out;
}

float encoded(float value) {
  const float v = std::clamp(value, 0.0f, 1.0f);
  return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
}

float decoded(float value) {
  const float v = std::clamp(value, 0.0f, 1.0f);
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

/// Mean absolute difference where both overlap, `b` moved by (dx, dy); every `step`th pixel.
double misfit(const Image& a, const Image& b, int dx, int dy, int step) {
  double sum = 0;
  std::size_t count = 0;
  for (int y = std::max(0, dy); y < a.height() + std::min(0, dy); y += step)
    for (int x = std::max(0, dx); x < a.width() + std::min(0, dx); x += step) {
      const auto p = a.pixel(x, y), q = b.pixel(x - dx, y - dy);
      for (std::size_t c = 0; c < p.size(); ++c) sum += double(std::abs(p[c] - q[c]));
      ++count;
    }
  return count ? sum / double(count) : 1e9;
}

/// The shift that fits best: first on small pictures, then to the pixel.
std::pair<int, int> bestShift(const Image& student, const Image& reference) {
  const Image a = reduced(student, student.channels());
  const Image b = reduced(reference, reference.channels());
  const auto search = [](const Image& one, const Image& other, int aroundX, int aroundY, int reach,
                         int step) {
    std::pair<int, int> best{aroundX, aroundY};
    double least = 1e9;
    for (int dy = aroundY - reach; dy <= aroundY + reach; ++dy)
      for (int dx = aroundX - reach; dx <= aroundX + reach; ++dx)
        if (const double off = misfit(one, other, dx, dy, step); off < least) {
          least = off;
          best = {dx, dy};
        }
    return best;
  };
  const int reach = std::max(1, int(std::max(a.width(), a.height()) * kFarthest));
  const auto [dx, dy] = search(a, b, 0, 0, reach, 1);
  const double scale = double(student.width()) / a.width();
  if (scale <= 1) return {dx, dy};
  return search(student, reference, int(std::lround(dx * scale)), int(std::lround(dy * scale)),
                int(std::ceil(scale)), 3);
}

/// How much brighter one is than the other where both are neither dark nor cut off.
double brightness(const Image& student, const Image& reference) {
  std::vector<float> ratios;
  for (std::size_t i = 0; i < reference.values().size(); i += 3)
    if (const float r = reference.values()[i], s = student.values()[i];
        r > 0.05f && r < 0.95f && s < 0.95f)
      ratios.push_back(s / r);
  if (ratios.size() < 16) return 1;
  const auto middle = ratios.begin() + std::ptrdiff_t(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return double(*middle);
}

/// The reference as this change would have it, or nothing where it does not apply.
std::optional<Image> applied(const Generic& change, const Pair& pair) {
  const Image& image = *pair.reference;
  const int right = image.width() - 1, bottom = image.height() - 1;
  using Place = std::pair<int, int>;
  switch (change.kind) {
  case Kind::stub:
    return pair.stub && sameSize(*pair.stub, image) ? std::optional(*pair.stub) : std::nullopt;
  case Kind::lastFrame:
    return pair.before ? *pair.before : image;
  case Kind::upsideDown:
    return mapped(image, [&](int x, int y) { return Place(x, bottom - y); });
  case Kind::mirrored:
    return mapped(image, [&](int x, int y) { return Place(right - x, y); });
  case Kind::turned:
    return mapped(image, [&](int x, int y) { return Place(right - x, bottom - y); });
  case Kind::shifted:
    return mapped(image, [&](int x, int y) {
      return Place(std::clamp(x - change.dx, 0, right), std::clamp(y - change.dy, 0, bottom));
    });
  case Kind::encodedTwice:
    return changed(image, encoded);
  case Kind::notEncoded:
    return changed(image, decoded);
  case Kind::scaled:
    return changed(image,
                   [&](float value) { return std::min(value * float(change.factor), 1.0f); });
  case Kind::redBlueSwapped: {
    if (image.channels() < 3) return std::nullopt;
    Image out = image;
    for (int y = 0; y <= bottom; ++y)
      for (int x = 0; x <= right; ++x) std::swap(out.at(x, y, 0), out.at(x, y, 2));
    return out;
  }
  case Kind::otherSize:
  case Kind::black:
  case Kind::constant:
    break;
  }
  return std::nullopt;
}

/// What moves in from outside of a shifted picture is anything.
Image inside(const Image& image, const Generic& change) {
  if (change.kind != Kind::shifted) return image;
  const int left = std::max(0, change.dx), top = std::max(0, change.dy);
  Image out(image.width() - std::abs(change.dx), image.height() - std::abs(change.dy),
            image.channels());
  for (int y = 0; y < out.height(); ++y)
    for (int x = 0; x < out.width(); ++x)
      std::ranges::copy(image.pixel(x + left, y + top), out.pixel(x, y).begin());
  return out;
}

/// 0 to 1: how much of what is wrong in a pair the change explains.
double explains(const Generic& change, const Pair& pair) {
  const std::optional<Image> image = applied(change, pair);
  if (!image) return 0;
  const Image student = inside(*pair.student, change);
  const double unlike = meanDistance(student, inside(*image, change));
  const double wrong =
      std::max(meanDistance(*pair.student, *pair.reference), meanDistance(*image, *pair.reference));
  if (wrong < kAlike) return 1;
  return std::clamp(1 - unlike / wrong, 0.0, 1.0);
}

bool plainlyOneColour(std::span<const Pair> pairs, Generic& found) {
  bool black = true;
  for (const Pair& pair : pairs) {
    if (!isOneColour(*pair.student)) return false;
    black = black && std::ranges::max(pair.student->values()) <= kTolerance;
  }
  found = {black ? Kind::black : Kind::constant, 0, 0, 1, 1};
  return true;
}

std::string acrossOf(int dx) {
  if (dx == 1) return say("1 pixel to the right");
  if (dx == -1) return say("1 pixel to the left");
  return dx > 0 ? say("{} pixels to the right", dx) : say("{} pixels to the left", -dx);
}

std::string downOf(int dy) {
  if (dy == 1) return say("1 pixel down");
  if (dy == -1) return say("1 pixel up");
  return dy > 0 ? say("{} pixels down", dy) : say("{} pixels up", -dy);
}

} // namespace

std::string describe(const Generic& generic, const std::string& what) {
  switch (generic.kind) {
  case Kind::otherSize:
    return say("{} has another size than the window that the scene asks for.", what);
  case Kind::black:
    return say("{} is black all over.", what);
  case Kind::constant:
    return say("{} has one colour all over.", what);
  case Kind::stub:
    return say("{} is still that of the handed-out program.", what);
  case Kind::lastFrame:
    return say("{} is one frame late: it shows what belongs to the frame before.", what);
  case Kind::upsideDown:
    return say("{} is right, but upside down.", what);
  case Kind::mirrored:
    return say("{} is right, but left and right are exchanged.", what);
  case Kind::turned:
    return say("{} is right, but turned by half a turn.", what);
  case Kind::redBlueSwapped:
    return say("{} is right, but red and blue are exchanged.", what);
  case Kind::encodedTwice:
    return say("{} is too bright in the way of a gamma curve that is applied twice.", what);
  case Kind::notEncoded:
    return say("{} is too dark in the way of a gamma curve that is missing.", what);
  case Kind::scaled:
    return say("{} is right, but {:.2f} times as bright as it should be.", what, generic.factor);
  case Kind::shifted: {
    const std::string across = acrossOf(generic.dx), down = downOf(generic.dy);
    if (generic.dx != 0 && generic.dy != 0)
      return say("{} is right, but shifted by {} and {}.", what, across, down);
    return say("{} is right, but shifted by {}.", what, generic.dx != 0 ? across : down);
  }
  }
  return what;
}

std::optional<Generic> generic(std::span<const Pair> pairs) {
  if (pairs.empty()) return std::nullopt;
  for (const Pair& pair : pairs) {
    if (!pair.student || pair.student->empty()) return std::nullopt;
    if (pair.student->channels() != pair.reference->channels()) return std::nullopt;
    if (findNonFinite(*pair.student)) return std::nullopt;
  }
  Generic found;
  if (plainlyOneColour(pairs, found)) return found;
  if (std::ranges::all_of(
          pairs, [](const Pair& pair) { return !sameSize(*pair.student, *pair.reference); }))
    return Generic{Kind::otherSize, 0, 0, 1, 1};
  if (std::ranges::any_of(
          pairs, [](const Pair& pair) { return !sameSize(*pair.student, *pair.reference); }))
    return std::nullopt;
  const auto worst = std::ranges::max_element(
      pairs, {}, [](const Pair& pair) { return meanDistance(*pair.student, *pair.reference); });
  const Image &student = *worst->student, &reference = *worst->reference;
  if (meanDistance(student, reference) < kDifferent) return std::nullopt;

  std::vector<Generic> candidates;
  for (const Kind kind : {Kind::stub, Kind::lastFrame, Kind::upsideDown, Kind::mirrored,
                          Kind::turned, Kind::redBlueSwapped, Kind::encodedTwice, Kind::notEncoded})
    candidates.push_back({kind, 0, 0, 1, 0});
  if (const auto [dx, dy] = bestShift(student, reference); dx != 0 || dy != 0)
    candidates.push_back({Kind::shifted, dx, dy, 1, 0});
  // What is nearly black, or was, is so for another reason.
  if (const double factor = brightness(student, reference);
      std::abs(factor - 1) > 0.04 && factor > kLeastFactor && factor < 1 / kLeastFactor)
    candidates.push_back({Kind::scaled, 0, 0, factor, 0});

  std::optional<Generic> best;
  for (Generic& change : candidates) {
    change.likeness = explains(change, *worst);
    for (const Pair& pair : pairs)
      if (change.likeness >= kExplained)
        change.likeness = std::min(change.likeness, explains(change, pair));
    if (change.likeness >= kExplained && (!best || change.likeness > best->likeness + 0.01))
      best = change;
  }
  return best;
}

bool addsScaledLight(const Image& student, const Image& reference, const Image& before) {
  constexpr float kCut = 0.98f;
  constexpr double kUnexplained = 0.25; // of the difference, what a factor may leave
  constexpr double kRounding = 1e-5;
  const auto same = [](float value) { return value; };
  for (float (*const light)(float) : {+same, &decoded}) {
    double wanted = 0, both = 0;
    const auto forEach = [&](const auto& visit) {
      for (int y = 0; y < reference.height(); ++y)
        for (int x = 0; x < reference.width(); ++x)
          for (int c = 0; c < reference.channels(); ++c) {
            const float is = student.at(x, y, c), should = reference.at(x, y, c);
            const double dark = double(light(before.at(x, y, c)));
            if (is < kCut && should < kCut)
              visit(double(light(is)) - dark, double(light(should)) - dark);
          }
    };
    forEach([&](double is, double should) { wanted += should * should, both += is * should; });
    if (wanted <= 0) continue;
    double left = 0, all = 0;
    forEach([&](double is, double should) {
      left += std::abs(is - should * both / wanted), all += std::abs(is - should);
    });
    if (left <= kUnexplained * all + kRounding * wanted) return true;
  }
  return false;
}

} // namespace ggrade::diagnosis
