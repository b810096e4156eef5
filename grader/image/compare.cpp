#include "image/compare.hpp"

#include "image/neighbourhood.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace ggrade {
namespace {

void checkOptions(const Image& reference, const CompareOptions& options) {
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance))
    throw std::invalid_argument("compare: the tolerance must be a finite number of 0 or more");
  if (options.radius < 0 || options.radius > kMaxRadius)
    throw std::invalid_argument("compare: the radius must be 0 to " + std::to_string(kMaxRadius));
  if (options.channels < 0 || options.channels > 4)
    throw std::invalid_argument("compare: channels must be 0 to 4");
  if (options.windowSide < 1)
    throw std::invalid_argument("compare: the window's side must be at least 1");
  if (options.mask && !reference.empty() &&
      (options.mask->width() != reference.width() || options.mask->height() != reference.height()))
    throw std::invalid_argument("compare: the mask is " + std::to_string(options.mask->width()) +
                                "x" + std::to_string(options.mask->height()) + ", the reference " +
                                reference.sizeText());
}

Comparison refused(ComparisonStatus status, std::string message) {
  Comparison result;
  result.status = status;
  result.message = std::move(message);
  return result;
}

// Why the images cannot be compared; empty if they can.
std::optional<Comparison> obstacle(const Image& student, const Image& reference, int channels,
                                   const CompareOptions& options) {
  if (student.empty())
    return refused(ComparisonStatus::nothingToCompare, gg::say("there is no image"));
  if (reference.empty())
    return refused(ComparisonStatus::nothingToCompare, gg::say("there is no reference image"));
  if (!sameSize(student, reference))
    return refused(
        ComparisonStatus::sizesDiffer,
        gg::say("the image is {}, the reference {}", student.sizeText(), reference.sizeText()));
  const bool enough = student.channels() >= channels && reference.channels() >= channels;
  if (!enough || (options.channels == 0 && student.channels() != reference.channels()))
    return refused(ComparisonStatus::channelsDiffer,
                   gg::say("the image has {} channels, the reference {}; {} are compared",
                           student.channels(), reference.channels(), channels));
  if (const auto bad = findNonFinite(student, channels)) {
    auto result = refused(ComparisonStatus::studentNotFinite,
                          gg::say("the image: {}", bad->text(student.channels())));
    result.nonFinite = bad;
    return result;
  }
  if (const auto bad = findNonFinite(reference, channels)) {
    auto result = refused(ComparisonStatus::referenceNotFinite,
                          gg::say("the reference: {}", bad->text(reference.channels())));
    result.nonFinite = bad;
    return result;
  }
  if (options.mask && options.mask->count() == 0)
    return refused(ComparisonStatus::nothingToCompare,
                   gg::say("no pixel lies in the region to judge"));
  return std::nullopt;
}

// How far each value lies outside the other image's range, both ways; 0 or less is inside.
void rangeErrors(std::span<const float> student, std::span<const float> reference,
                 const NeighbourhoodRows& studentRange, const NeighbourhoodRows& referenceRange,
                 std::vector<float>& errors) {
  const std::size_t count = student.size();
  errors.resize(count);
  const float* s = student.data();
  const float* r = reference.data();
  const float *sLow = studentRange.low().data(), *sHigh = studentRange.high().data();
  const float *rLow = referenceRange.low().data(), *rHigh = referenceRange.high().data();
  float* __restrict out = errors.data();
  const auto larger = [](float a, float b) { return a > b ? a : b; };
  for (std::size_t i = 0; i < count; ++i)
    out[i] =
        larger(larger(rLow[i] - s[i], s[i] - rHigh[i]), larger(sLow[i] - r[i], r[i] - sHigh[i]));
}

PixelDifference pixelDifference(const Image& student, const Image& reference, int x, int y,
                                int channel, float error) {
  PixelDifference result{.x = x, .y = y, .channel = channel, .error = error};
  std::ranges::copy(student.pixel(x, y), result.student.begin());
  std::ranges::copy(reference.pixel(x, y), result.reference.begin());
  return result;
}

std::string summary(const Comparison& result, int channels) {
  std::string text =
      gg::say("{:.3g}% of {} pixels differ", 100 * result.wrongShare, result.judgedPixels);
  if (result.wrongPixels == 0) return text;
  text += gg::say(", densest at ({},{}): {:.0f}% of {}x{}", result.densest.middleX,
                  result.densest.middleY, 100 * result.densest.share, result.densest.width,
                  result.densest.height);
  if (!result.worst) return text;
  const auto& worst = *result.worst;
  const auto channel = std::size_t(worst.channel);
  return text + gg::say(", worst at ({},{}): {} is {:.4g}, expected {:.4g}", worst.x, worst.y,
                        channelName(worst.channel, channels), worst.student[channel],
                        worst.reference[channel]);
}

// Judges the pixels of one row and adds what it finds to `result`, whose means are sums meanwhile.
void judgeRow(const Image& student, const Image& reference, int y, int channels,
              const std::vector<float>& errors, const CompareOptions& options, Comparison& result) {
  const auto s = student.row(y), r = reference.row(y);
  for (int x = 0; x < reference.width(); ++x) {
    if (options.mask && !options.mask->at(x, y)) continue;
    ++result.judgedPixels;
    const std::size_t first = std::size_t(x) * std::size_t(reference.channels());
    float error = 0;
    int worstChannel = 0;
    double absolute = 0, signedSum = 0;
    for (int c = 0; c < channels; ++c) {
      const std::size_t i = first + std::size_t(c);
      const double difference = double(s[i]) - double(r[i]);
      absolute += std::abs(difference);
      signedSum += difference;
      if (errors[i] > error) {
        error = errors[i];
        worstChannel = c;
      }
    }
    result.meanAbsoluteError += absolute;
    result.meanDifference += signedSum;
    if (error > options.tolerance) {
      ++result.wrongPixels;
      result.wrong.set(x, y);
    }
    if (error > (result.worst ? result.worst->error : 0.0f))
      result.worst = pixelDifference(student, reference, x, y, worstChannel, error);
  }
}

std::size_t judgedIn(const Mask& mask, int y) {
  const auto row = mask.row(y);
  return std::accumulate(row.begin(), row.end(), std::size_t(0));
}

// Both images have the same size and channel count and are finite.
Comparison judge(const Image& student, const Image& reference, int channels,
                 const CompareOptions& options) {
  Comparison result;
  result.status = ComparisonStatus::compared;
  result.wrong = Mask(reference.width(), reference.height());
  NeighbourhoodRows studentRange(student, options.radius);
  NeighbourhoodRows referenceRange(reference, options.radius);
  std::vector<float> errors;
  const auto width = std::size_t(reference.width());
  for (int y = 0; y < reference.height(); ++y) {
    const std::size_t judged = options.mask ? judgedIn(*options.mask, y) : width;
    if (judged == 0) continue;
    // A value lies in its own neighbourhood's range: equal rows have no error, whatever is near.
    const auto s = student.row(y), r = reference.row(y);
    if (std::memcmp(s.data(), r.data(), s.size_bytes()) == 0) {
      result.judgedPixels += judged;
      continue;
    }
    studentRange.moveTo(y);
    referenceRange.moveTo(y);
    rangeErrors(student.row(y), reference.row(y), studentRange, referenceRange, errors);
    judgeRow(student, reference, y, channels, errors, options, result);
  }
  const double values = double(result.judgedPixels) * channels;
  result.meanAbsoluteError /= values;
  result.meanDifference /= values;
  result.wrongShare = double(result.wrongPixels) / double(result.judgedPixels);
  result.densest = densestWindow(result.wrong, options.windowSide);
  result.message = summary(result, reference.channels());
  return result;
}

} // namespace

Tolerances& tolerances() {
  static Tolerances all;
  return all;
}

Comparison compare(const Image& student, const Image& reference, const CompareOptions& options) {
  checkOptions(reference, options);
  const int channels = options.channels == 0 ? reference.channels() : options.channels;
  if (auto refusal = obstacle(student, reference, channels, options)) return *std::move(refusal);
  if (student.channels() != reference.channels())
    return judge(firstChannels(student, channels), firstChannels(reference, channels), channels,
                 options);
  return judge(student, reference, channels, options);
}

BestComparison compareWithBest(const Image& student, std::span<const Image* const> references,
                               const CompareOptions& options) {
  if (references.empty()) throw std::invalid_argument("compareWithBest: there is no reference");
  BestComparison best;
  for (std::size_t i = 0; i < references.size(); ++i) {
    Comparison one = compare(student, *references[i], options);
    const bool better = one.compared() && (!best.comparison.compared() ||
                                           one.wrongShare < best.comparison.wrongShare);
    if (i == 0 || better) best = {std::move(one), i};
    if (best.comparison.compared() && best.comparison.wrongPixels == 0) break;
  }
  return best;
}

} // namespace ggrade
