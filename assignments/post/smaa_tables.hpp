// The tables that smaa_weights.frag reads (SMAA: Jimenez, Echevarria, Sousa and Gutierrez, 2012).
#pragma once

#include <gg/gg.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// A picture of two numbers a texel, row 0 first.
struct Table {
  glm::ivec2 size;
  std::vector<glm::vec2> texels = std::vector<glm::vec2>(std::size_t(size.x) * std::size_t(size.y));

  glm::vec2& at(int x, int y) { return texels[std::size_t(y * size.x + x)]; }
};

// How a search ends. A look between four pixels gives a sum of edges, in 32nds: 21 for the nearer
// pixel of the row, 7 for the farther one, 3 and 1 for those below them.
//   x: the sum of the edges across the row, y: of those along it
//   red: halves of how many of both pixels still belong to the line, to the left; green: to the
//   right
inline Table searchTable() {
  struct Edges {
    bool near, far, nearBelow, farBelow;
  };
  const auto edgesOf = [](int sum) {
    Edges edges{};
    if ((edges.near = sum >= 21)) sum -= 21;
    if ((edges.far = sum >= 7)) sum -= 7;
    if ((edges.nearBelow = sum >= 3)) sum -= 3;
    edges.farBelow = sum >= 1;
    return edges;
  };
  Table table{{33, 33}};
  for (int y = 0; y < 33; ++y) {
    for (int x = 0; x < 33; ++x) {
      const Edges across = edgesOf(x), along = edgesOf(y);
      const bool nearCrossed = across.near || across.nearBelow;
      const bool farCrossed = across.far || across.farBelow;
      // An edge across lies on a pixel's left: to the left it is met after the pixel, to the right
      // before it.
      const int left = !along.near ? 0 : !along.far || nearCrossed ? 1 : 2;
      const int right = !along.near || nearCrossed ? 0 : !along.far || farCrossed ? 1 : 2;
      table.at(x, y) = 0.5f * glm::vec2(left, right);
    }
  }
  return table;
}

// What lies between a line and an edge, in one pixel of the edge, on this side of the edge (x) and
// on the other one (y): the integral of the line's height, split by its sign.
//   from, to: the line's ends (x: along the edge, y: height, this side being up)
inline glm::dvec2 levelAreas(const glm::dvec2& from, const glm::dvec2& to, double pixel) {
  const double begin = std::max(from.x, pixel), end = std::min(to.x, pixel + 1);
  const double slope = (to.y - from.y) / (to.x - from.x);
  if (begin >= end || slope == 0) return glm::dvec2(0);
  const double y1 = from.y + slope * (begin - from.x), y2 = from.y + slope * (end - from.x);
  const auto square = [](double value) { return value * value; };
  const double high = square(std::max(y2, 0.0)) - square(std::max(y1, 0.0));
  const double low = square(std::min(y2, 0.0)) - square(std::min(y1, 0.0));
  return glm::dvec2(high, -low) / (2 * slope);
}

// The areas for an edge that goes on for so many pixels to the left and to the right.
//   crossings: edges across its left (x) and right end: 3 on this side, 1 on the other one, 4 on
//   both
inline glm::dvec2 levelPattern(const glm::ivec2& crossings, double left, double right) {
  const auto height = [](int crossing) { return crossing == 3 ? 0.5 : crossing == 1 ? -0.5 : 0.0; };
  double y1 = height(crossings.x), y2 = height(crossings.y);
  // A line can leave a crossing on both sides either way: opposite to its other end.
  if (crossings.x == 4) y1 = -height(crossings.y);
  if (crossings.y == 4) y2 = -height(crossings.x);
  const double length = left + right + 1;
  const glm::dvec2 from(0, y1), middle(length / 2, 0), to(length, y2);
  if (y1 * y2 < 0) return levelAreas(from, to, left); // a Z
  glm::dvec2 first = levelAreas(from, middle, left), second = levelAreas(middle, to, left);
  if (y1 * y2 > 0) { // a U: short ones are smoothed more
    const double share = std::min(length / 32, 1.0);
    first = glm::mix(glm::sqrt(2.0 * first) / 2.0, first, share);
    second = glm::mix(glm::sqrt(2.0 * second) / 2.0, second, share);
  }
  return first + second; // an L: one of both is 0
}

// The area of a pixel's part below a line.
//   from, to: on the line (x: along the row, y: up); pixel: its lower left corner
inline double areaBelow(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& pixel) {
  const double slope = (to.y - from.y) / (to.x - from.x);
  const double y1 = from.y + slope * (pixel.x - from.x) - pixel.y, y2 = y1 + slope;
  // The integral of the line's height, held between 0 and 1.
  const auto integral = [](double y) { return y < 0 ? 0 : y < 1 ? y * y / 2 : y - 0.5; };
  return (integral(y2) - integral(y1)) / slope;
}

// The areas for stairs that go on for so many steps to the left and to the right, in coordinates in
// which they go from (1, 0) to the upper right.
//   ends: how they go on at the left end (x) and at the right one: 0 not at all, 1 and 2 by an edge
//         along the column or row, 3 by both
inline glm::dvec2 diagonalPattern(const glm::ivec2& ends, double left, double right) {
  // What a line begins and ends with isn't known where the stairs end with nothing or with both
  // edges. There, it is the mean of two lines.
  static constexpr double kBegin[2][4][2] = {{{0, 0}, {1, 0}, {1, 1}, {1, 1}},
                                             {{1, 0}, {1, 0}, {1, 1}, {1, 0}}};
  static constexpr double kEnd[2][4][2] = {{{0, 0}, {1, 1}, {1, 0}, {1, 1}},
                                           {{1, 0}, {1, 1}, {1, 0}, {1, 0}}};
  const double length = left + right + 1;
  glm::dvec2 sum(0);
  for (int i = 0; i < 2; ++i) {
    const double *begin = kBegin[i][ends.x], *end = kEnd[i][ends.y];
    const glm::dvec2 from(begin[0], begin[1]), to(length + end[0], length + end[1]);
    sum += glm::dvec2(1 - areaBelow(from, to, {left + 1, left}),
                      areaBelow(from, to, {left + 1, left + 1}));
  }
  return sum / 2.0;
}

// What lines cut off: red of this pixel, green of the one across the edge. The left half is for
// edges along rows or columns: 5 times 5 patterns by what crosses the ends (left and right: x and
// y), in each the square roots of how far these are (0 to 15). The right half is for diagonals: 4
// times 4 patterns, in each how far the ends are (0 to 19).
inline Table areaTable() {
  Table table{{160, 80}};
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 80; ++x) {
      const glm::ivec2 root(x % 16, y % 16), steps(x % 20, y % 20);
      table.at(x, y) = levelPattern({x / 16, y / 16}, root.x * root.x, root.y * root.y);
      // Shorter stairs aren't looked up.
      if (steps.x + steps.y > 2)
        table.at(x + 80, y) = diagonalPattern({x / 20, y / 20}, steps.x, steps.y);
    }
  }
  return table;
}
