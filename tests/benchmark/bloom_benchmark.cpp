// What the bloom of solutions/floor costs at 1280 x 720, and how exact it is: against a Gaussian
// that is as wide, by the number of levels, by formats, level by level. All of it is drawn by
// OSMesa with the pins of every grading, unless the environment says otherwise. Prints Markdown.
//
// Times are medians of many draws that take turns, with their quartiles; what counts are the
// ratios. Errors are against double precision (solutions/floor/truth_pyramid.hpp) of the same
// stored scene.

#include "../../solutions/floor/bloom.hpp"
#include "../../solutions/floor/truth_pyramid.hpp"

#include "grading/program.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <numeric>
#include <random>

using ggrade::truth::Edge;
using ggrade::truth::Light;

namespace {

const glm::ivec2 kSize(1280, 720);
// The defaults of assignments/floor/assignment.json.
constexpr int kLevels = 6, kFilter = 3;
constexpr float kThreshold = 1;

// --- Light ---

/// Lamps up to 40 times as bright as white before a dim wall, and sparks of one pixel.
std::vector<glm::vec3> lamps() {
  std::vector<glm::vec3> pixels;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x)
      pixels.emplace_back(glm::vec3(0.1f, 0.2f, 0.3f) * (0.5f + float(x) / float(kSize.x)));
  std::mt19937 random(1);
  const auto upTo = [&](int end) { return int(random() % unsigned(end)); };
  for (int lamp = 0; lamp < 40; ++lamp) {
    const glm::vec2 middle(upTo(kSize.x), upTo(kSize.y));
    const float radius = lamp < 20 ? float(3 + upTo(38)) : 0.5f;
    const glm::vec3 color =
        glm::vec3(1 + upTo(8), 1 + upTo(8), 1 + upTo(8)) * (lamp < 20 ? 5.0f : 40.0f);
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x)
        if (glm::distance(glm::vec2(x, y), middle) <= radius)
          pixels[std::size_t(y * kSize.x + x)] = color;
  }
  return pixels;
}

Light lightIn(const gg::Texture& texture, const glm::ivec2& size) {
  std::vector<glm::vec3> pixels(std::size_t(size.x * size.y));
  glBindTexture(GL_TEXTURE_2D, texture);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_FLOAT, pixels.data());
  Light light(size.x, size.y);
  std::copy(pixels.begin(), pixels.end(), light.pixels.begin());
  return light;
}

Light lightOf(const Bloom::Level& level) {
  return lightIn(level.color, level.size);
}

/// Root of the mean square of what is wrong, as a share of the brightest that is wanted.
double error(const Light& found, const Light& wanted) {
  double sum = 0, peak = 0;
  for (std::size_t i = 0; i < wanted.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      sum += std::pow(found.pixels[i][c] - wanted.pixels[i][c], 2);
      peak = std::max(peak, wanted.pixels[i][c]);
    }
  return std::sqrt(sum / (3.0 * double(wanted.pixels.size()))) / peak;
}

/// What the bloom makes of a scene, in double precision, at the size of level 0.
Light truth(const Light& scene, double threshold, int levels) {
  return floor_truth::levelSum(floor_truth::brightPass(scene, threshold), levels, kFilter,
                               Edge::mirror);
}

/// Second moment of what the bloom makes of one bright pixel about it, along an axis of `size`
/// pixels, in square pixels of the scene: the mean of 64 places about the middle, which is how many
/// a pixel can have within one of the smallest level. The other axis changes nothing: each level
/// conserves the energy of every row.
double impulseVariance(int size) {
  double second = 0;
  for (int place = size / 2 - 32; place < size / 2 + 32; ++place) {
    Light row(size, 1);
    row.at(place, 0) = glm::dvec3(1);
    const Light sum = truth(row, 0, kLevels);
    const double pixel = double(size) / sum.width;
    double total = 0, moment = 0;
    for (int x = 0; x < sum.width; ++x) {
      total += sum.at(x, 0).x;
      moment += sum.at(x, 0).x * std::pow((x + 0.5) * pixel - (place + 0.5), 2);
    }
    second += moment / total / 64;
  }
  return second;
}

// --- What is drawn ---

std::unique_ptr<Bloom> bloomOf(GLenum format, int levels, const std::vector<glm::vec3>& scene) {
  auto bloom = std::make_unique<Bloom>();
  makeScene(*bloom, kSize, format);
  makeLevels(*bloom, levels, format, GL_MIRRORED_REPEAT);
  glBindTexture(GL_TEXTURE_2D, bloom->color);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize.x, kSize.y, GL_RGB, GL_FLOAT, scene.data());
  return bloom;
}

/// As bloomPasses() of bloom.hpp draws them.
void drawBloom(const Bloom& bloom, float threshold) {
  glBindSampler(0, bloom.sampler);
  brightPass(bloom, threshold);
  downPasses(bloom, kFilter);
  upPasses(bloom, kFilter);
  glBindSampler(0, 0);
}

/// One axis of a Gaussian to three standard deviations: the middle sample, then those to one side.
struct Samples {
  std::vector<float> offsets, weights;

  explicit Samples(double variance) {
    const int reach = int(std::ceil(3 * std::sqrt(variance)));
    double sum = -1; // the middle one stands on both sides
    for (int i = 0; i <= reach; ++i) {
      offsets.push_back(float(i));
      weights.push_back(float(std::exp(-i * i / (2 * variance))));
      sum += 2 * weights.back();
    }
    for (float& weight : weights) weight /= float(sum);
  }

  /// Every two neighbours in one bilinear sample between them (Rideout; Rakos 2010).
  Samples paired() const {
    Samples half = *this;
    half.offsets.resize(1);
    half.weights.resize(1);
    for (std::size_t i = 1; i < weights.size(); i += 2) {
      const float second = i + 1 < weights.size() ? weights[i + 1] : 0;
      half.weights.push_back(weights[i] + second);
      half.offsets.push_back(offsets[i] + second / half.weights.back());
    }
    return half;
  }

  int count() const { return 2 * int(weights.size()) - 1; }
};

/// Two draws at full size, one an axis, in the scene's format.
class Gaussian {
public:
  Gaussian(const Samples& across, const Samples& down, GLint filter) : axes_{across, down} {
    for (Bloom::Level& target : targets_) {
      glBindTexture(GL_TEXTURE_2D, target.color);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, kSize.x, kSize.y, 0, GL_RGBA, GL_FLOAT, nullptr);
      glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.color, 0);
      if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("the Gaussian's framebuffer object is not complete");
    }
    glSamplerParameteri(sampler_, GL_TEXTURE_MIN_FILTER, filter);
    glSamplerParameteri(sampler_, GL_TEXTURE_MAG_FILTER, filter);
    glSamplerParameteri(sampler_, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
    glSamplerParameteri(sampler_, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
  }

  void draw(const Bloom& of) const {
    program_.use();
    program_.set("uSource", 0);
    glBindSampler(0, sampler_);
    glViewport(0, 0, kSize.x, kSize.y);
    for (std::size_t i = 0; i < 2; ++i) {
      const GLsizei count = GLsizei(axes_[i].weights.size());
      program_.set("uAxis", i == 0 ? glm::vec2(1, 0) : glm::vec2(0, 1));
      program_.set("uCount", count);
      glUniform1fv(glGetUniformLocation(program_, "uOffset"), count, axes_[i].offsets.data());
      glUniform1fv(glGetUniformLocation(program_, "uWeight"), count, axes_[i].weights.data());
      glBindFramebuffer(GL_FRAMEBUFFER, targets_[i].framebuffer);
      glBindTexture(GL_TEXTURE_2D, i == 0 ? of.color : targets_[0].color);
      drawScreen(of);
    }
    glBindSampler(0, 0);
  }

  Light light() const { return lightIn(targets_[1].color, kSize); }
  int samples() const { return axes_[0].count() + axes_[1].count(); }

private:
  gg::Program program_{{"solutions/floor/screen.vert", "tests/benchmark/gaussian.frag"},
                       GGRADE_SOURCE_DIR};
  std::array<Samples, 2> axes_; // across, down
  std::array<Bloom::Level, 2> targets_;
  gg::Sampler sampler_;
};

// --- Time ---

struct Timed {
  std::function<void()> draw;
  int draws = 1;                      ///< of one measurement
  std::vector<double> milliseconds{}; ///< of a draw
};

/// All of them once for the shaders' sake, then in turn. A processor's time, not the clock's:
/// OSMesa draws in the thread that asks it to, and what else the machine does counts for less.
void measure(std::vector<Timed>& all, int repetitions) {
  for (const Timed& one : all) one.draw();
  glFinish();
  for (int i = 0; i < repetitions; ++i)
    for (Timed& one : all) {
      const std::clock_t start = std::clock();
      for (int draw = 0; draw < one.draws; ++draw) {
        one.draw();
        glFinish();
      }
      one.milliseconds.push_back(1e3 * double(std::clock() - start) / CLOCKS_PER_SEC / one.draws);
    }
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::size_t(std::lround(share * double(values.size() - 1)))];
}

/// Median and quartiles of how many times `slow` took as long as `fast`, turn by turn.
std::string times(const Timed& slow, const Timed& fast, int digits = 2) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < slow.milliseconds.size(); ++i)
    ratios.push_back(slow.milliseconds[i] / fast.milliseconds[i]);
  return fmt::format("{:.{}f} ({:.{}f} to {:.{}f})", quantile(ratios, 0.5), digits,
                     quantile(ratios, 0.25), digits, quantile(ratios, 0.75), digits);
}

std::string milliseconds(const Timed& of) {
  return fmt::format("{:.3g}", quantile(of.milliseconds, 0.5));
}

// --- Tables ---

void againstGaussian(int repetitions, const std::vector<glm::vec3>& scene) {
  const double across = impulseVariance(kSize.x), down = impulseVariance(kSize.y);
  const Samples x(across), y(down);
  const auto bloom = bloomOf(GL_RGBA16F, kLevels, scene);
  const Gaussian all(x, y, GL_NEAREST), pairs(x.paired(), y.paired(), GL_LINEAR);

  std::vector<Timed> timed = {{[&] { drawBloom(*bloom, kThreshold); }, 4},
                              {[&] { all.draw(*bloom); }},
                              {[&] { pairs.draw(*bloom); }}};
  measure(timed, repetitions);

  const Light stored = lightIn(bloom->color, kSize);
  const Light gaussian =
      ggrade::truth::apply(stored, ggrade::truth::gaussian(kSize.x, across, Edge::mirror),
                           ggrade::truth::gaussian(kSize.y, down, Edge::mirror));
  // Without a threshold the bloom is a filter of the whole scene, as the Gaussian is.
  drawBloom(*bloom, 0);
  const Light sum = lightOf(bloom->levels[0]);
  const Light large = apply(sum, floor_truth::upFilter(kFilter, {sum.width, sum.height},
                                                       {kSize.x, kSize.y}, Edge::mirror));

  fmt::print("\n## Against one Gaussian as wide\n\n"
             "The bloom spreads a pixel's light with a variance of {:.1f} square pixels across and "
             "{:.1f} down: standard deviations of {:.2f} and {:.2f} pixels. Errors are RMSE as a "
             "share of the greatest value, over the whole scene.\n\n"
             "| | ms | time against the bloom's | samples of a pixel | error against its own "
             "truth | against the exact Gaussian |\n| --- | ---: | ---: | ---: | ---: | ---: |\n",
             across, down, std::sqrt(across), std::sqrt(down));
  fmt::print("| the bloom | {} | 1 | | {:.2g} | {:.2g} |\n", milliseconds(timed[0]),
             error(sum, truth(stored, 0, kLevels)), error(large, gaussian));
  const auto row = [&](const char* name, const Gaussian& of, const Timed& time) {
    const double wrong = error(of.light(), gaussian);
    fmt::print("| {} | {} | {} | {} | {:.2g} | {:.2g} |\n", name, milliseconds(time),
               times(time, timed[0], 1), of.samples(), wrong, wrong);
  };
  row("two draws, every pixel within 3 standard deviations", all, timed[1]);
  row("two draws, one bilinear sample for two pixels", pairs, timed[2]);
}

/// Of one bright pixel's light, how far from it do these shares arrive? In pixels of the scene; the
/// mean of 16 places in the middle.
std::array<double, 2> reach(int levels, std::array<double, 2> shares) {
  std::vector<double> ring(std::size_t(kSize.x)); // light by distance, in pixels of the scene
  for (int place = 0; place < 16; ++place) {
    const glm::ivec2 at = kSize / 2 + glm::ivec2(17 * place % 64, 39 * place % 64);
    Light scene(kSize.x, kSize.y);
    scene.at(at.x, at.y) = glm::dvec3(1);
    const Light sum = truth(scene, 0, levels);
    for (int y = 0; y < sum.height; ++y)
      for (int x = 0; x < sum.width; ++x) {
        const glm::dvec2 offset = 2.0 * (glm::dvec2(x, y) + 0.5) - (glm::dvec2(at) + 0.5);
        ring[std::size_t(glm::length(offset))] += sum.at(x, y).x;
      }
  }
  const double total = std::accumulate(ring.begin(), ring.end(), 0.0);
  std::array<double, 2> radii{};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    double inside = 0;
    while (inside < shares[i] * total) inside += ring[std::size_t(radii[i]++)];
  }
  return radii;
}

void byLevels(int repetitions, const std::vector<glm::vec3>& scene) {
  constexpr int kMost = 9;
  std::vector<std::unique_ptr<Bloom>> blooms;
  std::vector<Timed> timed;
  for (int levels = 1; levels <= kMost; ++levels) {
    blooms.push_back(bloomOf(GL_RGBA16F, levels, scene));
    timed.push_back({[&bloom = *blooms.back()] { drawBloom(bloom, kThreshold); }, 4});
  }
  measure(timed, repetitions);
  const Light bright = floor_truth::brightPass(lightIn(blooms[0]->color, kSize), kThreshold);

  fmt::print("\n## By the number of levels\n\n"
             "How far half and nine tenths of a bright pixel's light reach; and what share of the "
             "scene's bloom is elsewhere than the sum of exact Gaussians would have it.\n\n"
             "| levels | the smallest | half within | 90% within | of the height | not as the "
             "Gaussians | time against {} levels |\n"
             "| ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n",
             kLevels);
  for (int levels = 1; levels <= kMost; ++levels) {
    const glm::ivec2 smallest = blooms[std::size_t(levels - 1)]->levels.back().size;
    const auto [half, most] = reach(levels, {0.5, 0.9});
    const auto errors =
        floor_truth::compareLight(floor_truth::levelSum(bright, levels, kFilter, Edge::mirror),
                                  floor_truth::gaussianSum(bright, levels, kFilter, Edge::mirror));
    fmt::print("| {} | {} x {} | {} px | {} px | {:.0f}% | {:.1f}% | {} |\n", levels, smallest.x,
               smallest.y, half, most, 100 * most / kSize.y, 100 * errors.misplaced,
               times(timed[std::size_t(levels - 1)], timed[kLevels - 1]));
  }
}

void byFormat(int repetitions, const std::vector<glm::vec3>& scene) {
  struct Format {
    const char* name;
    GLenum format;
    int bytes;
  };
  const Format formats[] = {{"RGBA8", GL_RGBA8, 4},
                            {"R11F_G11F_B10F", GL_R11F_G11F_B10F, 4},
                            {"RGBA16F", GL_RGBA16F, 8},
                            {"RGBA32F", GL_RGBA32F, 16}};
  // The same scene with nothing brighter than 1, which 8 bits can hold.
  std::vector<glm::vec3> dim = scene;
  for (glm::vec3& pixel : dim) pixel = glm::min(pixel, 1.0f);
  const auto lightOfScene = [](const std::vector<glm::vec3>& pixels) {
    Light light(kSize.x, kSize.y);
    std::copy(pixels.begin(), pixels.end(), light.pixels.begin());
    return light;
  };
  const Light wanted = truth(lightOfScene(scene), kThreshold, kLevels);
  constexpr double kDimThreshold = 0.25;
  const Light wantedDim = truth(lightOfScene(dim), kDimThreshold, kLevels);

  std::vector<std::unique_ptr<Bloom>> blooms;
  std::vector<Timed> timed;
  for (const Format& format : formats) {
    blooms.push_back(bloomOf(format.format, kLevels, scene));
    timed.push_back({[&bloom = *blooms.back()] { drawBloom(bloom, kThreshold); }, 4});
  }
  measure(timed, repetitions);

  fmt::print("\n## By format\n\n"
             "Light that is not where it should be, as a share of all of it: of the scene with "
             "threshold {}, and of the scene cut off at 1 with threshold {}, which 8 bits can "
             "hold.\n\n"
             "| format | bytes a pixel | time against RGBA8's | misplaced | misplaced where "
             "nothing exceeds 1 |\n| --- | ---: | ---: | ---: | ---: |\n",
             kThreshold, kDimThreshold);
  for (std::size_t i = 0; i < blooms.size(); ++i) {
    const auto misplaced = [&](const Light& of) {
      return 100 * floor_truth::compareLight(lightOf(blooms[i]->levels[0]), of).misplaced;
    };
    const double whole = misplaced(wanted);
    const auto low = bloomOf(formats[i].format, kLevels, dim);
    drawBloom(*low, float(kDimThreshold));
    const double part =
        100 * floor_truth::compareLight(lightOf(low->levels[0]), wantedDim).misplaced;
    fmt::print("| {} | {} | {} | {:.3g}% | {:.3g}% |\n", formats[i].name, formats[i].bytes,
               times(timed[i], timed[0]), whole, part);
  }
}

void levelByLevel(int repetitions) {
  // A bloom of two levels for each step, of the sizes that the whole one has there.
  std::vector<std::unique_ptr<Bloom>> steps;
  std::vector<Timed> down, up;
  glm::ivec2 size = kSize;
  for (int level = 1; level < kLevels; ++level, size = steps.back()->levels[0].size) {
    steps.push_back(std::make_unique<Bloom>());
    Bloom& step = *steps.back();
    step.size = size;
    makeLevels(step, 2, GL_RGBA16F, GL_MIRRORED_REPEAT);
    glBindSampler(0, step.sampler);
    const int draws = 4 << (2 * level); // small ones take too little to be measured alone
    down.push_back({[&step] { downPasses(step, kFilter); }, draws});
    up.push_back({[&step] { upPasses(step, kFilter); }, draws});
  }
  // Both at the same time would leave the smaller of two levels in the processor's cache.
  glBindSampler(0, steps[0]->sampler);
  measure(down, repetitions);
  measure(up, repetitions);

  fmt::print("\n## Level by level\n\n"
             "Down into a level from the one before, and up from it.\n\n"
             "| level | size | down: ms | the one before against it | up: ms | the one before "
             "against it |\n| ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const glm::ivec2 of = steps[i]->levels[1].size;
    const auto ratio = [&](const std::vector<Timed>& all) {
      return i == 0 ? std::string() : times(all[i - 1], all[i]);
    };
    fmt::print("| {} | {} x {} | {} | {} | {} | {} |\n", i + 1, of.x, of.y, milliseconds(down[i]),
               ratio(down), milliseconds(up[i]), ratio(up));
  }
}

} // namespace

/// Arguments: how often everything is measured (15).
int main(int count, char** arguments) {
  for (const auto& [name, value] : ggrade::grading::rendererPins())
    setenv(name.c_str(), value.c_str(), 0);
  const int repetitions = count > 1 ? std::max(std::atoi(arguments[1]), 1) : 15;
  std::setvbuf(stdout, nullptr, _IOLBF, 0); // it takes minutes: show every row
  const gg::Window window("bloom", {8, 8});
  const std::vector<glm::vec3> scene = lamps();
  fmt::print("# The bloom at {} x {}: {} levels, filter {}, RGBA16F, threshold {}\n\n"
             "{}, on a software renderer. Medians (and quartiles) of {} measurements in turn.\n",
             kSize.x, kSize.y, kLevels, kFilter, kThreshold,
             reinterpret_cast<const char*>(glGetString(GL_RENDERER)), repetitions);
  againstGaussian(repetitions, scene);
  byLevels(repetitions, scene);
  byFormat(repetitions, scene);
  levelByLevel(repetitions);
}
