#include "report/inspect_pixels.hpp"

#include "report/inspect_words.hpp"
#include "report/picture.hpp"
#include "trace/picture.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ggrade::report {

using namespace trace;

namespace {

constexpr int kThumbnailSide = 300; ///< pixels: a card is 220 wide, screens have up to 1.5 of them
constexpr int kSmallSide = 160;     ///< of pictures that stand in for larger ones

void describeValues(const Image& image, PagePixels& pixels) {
  const int channels = std::min(image.channels(), 3);
  float low = std::numeric_limits<float>::infinity(), high = -low;
  const std::span<const float> first = image.pixel(0, 0);
  bool uniform = true;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const std::span<const float> pixel = image.pixel(x, y);
      if (uniform && !std::ranges::equal(pixel, first)) uniform = false;
      for (const float value : pixel.first(std::size_t(channels))) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
  pixels.uniform = uniform;
  if (uniform) {
    for (const float value : first)
      pixels.range += (pixels.range.empty() ? "" : ", ") + fmt::format("{:.4g}", value);
    pixels.range =
        gg::say("{} everywhere", first.size() > 1 ? "(" + pixels.range + ")" : pixels.range);
  } else if (low <= high) {
    pixels.range = gg::say("{:.4g} to {:.4g}", low, high);
  }
  if (const auto bad = findNonFinite(image)) pixels.notANumber = bad->text(image.channels());
}

/// How much has been put into the page, and how much may be.
class Room {
public:
  explicit Room(std::size_t bytes) : bytes_(bytes) {}
  /// Takes `size` bytes, or nothing if that is more than is left of `share` times the room.
  bool take(std::size_t size, double share) {
    if (double(used_ + size) > double(bytes_) * share) return false;
    used_ += size;
    return true;
  }

private:
  std::size_t bytes_, used_ = 0;
};

} // namespace

std::vector<unsigned char> packedValues(std::span<const std::byte> bytes,
                                        std::size_t bytesPerPixel) {
  std::vector<unsigned char> runs(bytes.size());
  const std::size_t pixels = bytes.size() / bytesPerPixel;
  for (std::size_t k = 0; k < bytesPerPixel; ++k) {
    unsigned before = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
      const auto value = std::to_integer<unsigned>(bytes[i * bytesPerPixel + k]);
      runs[k * pixels + i] = static_cast<unsigned char>(value - before);
      before = value;
    }
  }
  uLongf size = compressBound(uLong(runs.size()));
  std::vector<unsigned char> packed(size);
  if (compress2(packed.data(), &size, runs.data(), uLong(runs.size()), 4) != Z_OK)
    throw std::runtime_error("a picture's values can't be compressed: out of memory");
  packed.resize(size);
  return packed;
}

PagePixelsOfFrame pagePixels(const FrameGraph& graph, const std::vector<std::uint32_t>& mains,
                             const InspectLimits& limits) {
  const Trace& trace = graph.trace();
  PagePixelsOfFrame result;
  std::vector<const CopyRecord*> copies;
  for (const CopyRecord& copy : trace.copies)
    if (graph.holds(copy.pass) &&
        (copy.step == kNone || graph.pass(copy.pass).stepCount > 1)) // the only step is the pass
      copies.push_back(&copy);
  std::ranges::stable_sort(copies, {}, [](const CopyRecord* copy) {
    return std::pair(copy->step != kNone, copy->pass);
  });
  Room room(limits.bytes);
  for (const CopyRecord* copy : copies) {
    PagePixels pixels;
    pixels.copy = copy;
    describeValues(trace.image(*copy), pixels);
    const CopyPicture shown = picture(trace, *copy);
    pixels.scale = shown.scale;
    pixels.low = shown.low;
    pixels.high = shown.high;
    if (shown.scale.starts_with("stretched depth by "))
      pixels.depth = depthScale(trace, graph.pass(copy->pass));
    if (std::ranges::binary_search(mains, std::uint32_t(copy - trace.copies.data())))
      pixels.thumbnail = pngDataUri(thumbnail(shown.rgb, kThumbnailSide, kThumbnailSide));

    std::string large = pngDataUri(thumbnail(shown.rgb, limits.pictureSide, limits.pictureSide));
    std::string values = base64(
        packedValues(trace.bytesOf(*copy), bytesPerPixel(static_cast<PixelType>(copy->type))));
    if (room.take(large.size() + values.size() + pixels.thumbnail.size(), 1)) {
      pixels.picture = std::move(large);
      pixels.values = std::move(values);
    } else {
      ++result.withoutValues;
      pixels.picture = pngDataUri(thumbnail(shown.rgb, kSmallSide, kSmallSide));
      if (!room.take(pixels.picture.size() + pixels.thumbnail.size(), 1.25)) {
        ++result.withoutPicture;
        pixels.picture.clear();
        pixels.thumbnail.clear();
      }
    }
    result.copies.push_back(std::move(pixels));
  }
  return result;
}

} // namespace ggrade::report
