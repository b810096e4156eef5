// The bloom's own passes down and up again (solutions/floor/bloom.hpp), drawn at 200 sizes of level
// 0 in one context: light that stands in a pixel of level 0 is the same light in every level.

#include "../../solutions/floor/bloom.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace {

constexpr int kLevels = 6;
constexpr int kAreaFilter = 3;             // quality.bloom_filter
constexpr float kImpulse = 1000;           // far from the ends of a half float, at every level
using Position = glm::ivec2;               // pixels of level 0
using Positions = std::array<Position, 3>; // one a colour channel: filters leave channels apart

/// 200 sizes of level 0 up to 130: 1 to 10 each way (100); every prime from 11 to 127 by 1, 1 by it
/// (54) and by the next one (26); even widths from 130 down by 6 with odd heights from 11 up (20).
std::vector<glm::ivec2> sizes() {
  std::vector<glm::ivec2> all;
  for (int width = 1; width <= 10; ++width)
    for (int height = 1; height <= 10; ++height) all.emplace_back(width, height);
  int before = 0;
  for (int n = 11; n <= 127; n += 2) {
    if (n % 3 == 0 || n % 5 == 0 || n % 7 == 0) continue; // what else is no prime exceeds 11 * 11
    if (n == 121) continue;
    all.emplace_back(n, 1);
    all.emplace_back(1, n);
    if (before > 0) all.emplace_back(before, n);
    before = n;
  }
  for (int i = 0; i < 20; ++i) all.emplace_back(130 - 6 * i, 11 + 6 * i);
  return all;
}

/// Corners, middles of the edges, the centre, and three at random.
std::array<Positions, 4> positions(const glm::ivec2& size, std::mt19937& random) {
  const glm::ivec2 last = size - 1, middle = size / 2;
  const auto anywhere = [&] {
    const int x = int(random() % unsigned(size.x));
    return Position(x, int(random() % unsigned(size.y)));
  };
  const Position a = anywhere(), b = anywhere(), c = anywhere();
  return {{{Position(0, 0), {last.x, 0}, {0, last.y}},
           {last, {middle.x, 0}, {middle.x, last.y}},
           {Position(0, middle.y), {last.x, middle.y}, middle},
           {a, b, c}}};
}

/// The mean of a texture's pixels; RGB.
glm::dvec3 mean(const Bloom::Level& level) {
  std::vector<glm::vec3> pixels(std::size_t(level.size.x * level.size.y));
  glBindTexture(GL_TEXTURE_2D, level.color);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_FLOAT, pixels.data());
  glm::dvec3 sum(0);
  for (const glm::vec3& pixel : pixels) sum += glm::dvec3(pixel);
  return sum / double(pixels.size());
}

/// The furthest that the three channels are from `wanted`, as a share of it.
double apart(const glm::dvec3& found, double wanted) {
  double most = 0;
  for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(found[c] / wanted - 1));
  return most;
}

/// The largest share of energy that any impulse lost or won, in any level on the way down, or in
/// level 0 when all are added to it.
struct Worst {
  double down = 0, sum = 0;
};

class BloomEnergy : public testing::Test {
protected:
  Worst worst(const std::vector<glm::ivec2>& sizes, GLenum format, GLint edge) {
    Worst all;
    std::mt19937 random(1);
    for (const glm::ivec2& size : sizes) {
      bloom.size = 2 * size;
      makeLevels(bloom, kLevels, format, edge);
      EXPECT_EQ(bloom.levels[0].size, size);
      Worst here;
      for (const Positions& at : positions(size, random)) {
        put(at);
        draw(here, kImpulse / (double(size.x) * size.y));
      }
      EXPECT_LT(std::max(here.down, here.sum), limit) << size.x << " x " << size.y;
      all = {std::max(all.down, here.down), std::max(all.sum, here.sum)};
    }
    RecordProperty("down", std::to_string(all.down));
    RecordProperty("sum", std::to_string(all.sum));
    return all;
  }

  void TearDown() override { EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)); }

  double limit = 0; ///< of a size; 1 is all energy

private:
  /// An impulse in each channel of level 0, nothing else.
  void put(const Positions& at) const {
    const Bloom::Level& level = bloom.levels[0];
    std::vector<glm::vec3> pixels(std::size_t(level.size.x * level.size.y), glm::vec3(0));
    for (int c = 0; c < 3; ++c)
      pixels[std::size_t(at[std::size_t(c)].y * level.size.x + at[std::size_t(c)].x)][c] = kImpulse;
    glBindTexture(GL_TEXTURE_2D, level.color);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, level.size.x, level.size.y, GL_RGB, GL_FLOAT,
                    pixels.data());
  }

  void draw(Worst& worst, double wanted) const {
    glBindSampler(0, bloom.sampler);
    downPasses(bloom, kAreaFilter);
    for (const Bloom::Level& level : bloom.levels)
      worst.down = std::max(worst.down, apart(mean(level), wanted));
    upPasses(bloom, kAreaFilter);
    worst.sum = std::max(worst.sum, apart(mean(bloom.levels[0]), kLevels * wanted));
  }

  gg::Window window{"energy", {8, 8}};
  Bloom bloom;
};

TEST_F(BloomEnergy, OfAnImpulseIsKeptByFloatsAtTwoHundredSizes) {
  ASSERT_EQ(sizes().size(), 200u);
  limit = 1e-4;
  worst(sizes(), GL_RGBA32F, GL_MIRRORED_REPEAT);
}

TEST_F(BloomEnergy, OfAnImpulseIsKeptByHalfFloatsAtTwoHundredSizes) {
  limit = 0.01;
  const Worst found = worst(sizes(), GL_RGBA16F, GL_MIRRORED_REPEAT);
  // Every store cuts off up to 1/1024 of a value here (llvmpipe doesn't round), level by level.
  EXPECT_GT(found.sum, 1e-4) << "half floats are not as good as floats: the test can tell";
}

TEST_F(BloomEnergy, IsNotKeptByClampedEdges) {
  limit = 1;
  EXPECT_GT(worst({{3, 3}, {5, 3}, {7, 10}}, GL_RGBA32F, GL_CLAMP_TO_EDGE).down, 0.1);
}

} // namespace
