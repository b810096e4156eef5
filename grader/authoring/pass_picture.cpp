#include "authoring/pass_picture.hpp"

#include "assignment/usage_error.hpp"
#include "trace/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ggrade::authoring {

namespace {

constexpr int kColumns = 3;
constexpr int kGap = 4; ///< pixels between pictures, white

/// The last copy of that attachment of a texture of that size.
const trace::CopyRecord& find(const trace::Trace& trace, const std::string& attachment,
                              std::uint32_t width, std::uint32_t height, const std::string& name) {
  for (auto copy = trace.copies.rbegin(); copy != trace.copies.rend(); ++copy) {
    const auto& image = trace.passes.at(copy->pass).images[copy->attachment];
    const bool shows = image.kind == std::uint32_t(trace::ImageKind::texture) ||
                       copy->attachment == trace::kStencil;
    if (shows && copy->width == width && copy->height == height &&
        trace::attachmentName(copy->attachment) == attachment)
      return *copy;
  }
  throw UsageError(
      fmt::format("{}: no pass draws {} of a texture of {}x{}", name, attachment, width, height));
}

/// IEC 61966-2-1.
float srgb(float light) {
  return light <= 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
}

/// Divided by the greatest value of all, and sRGB encoded.
void toDisplay(std::vector<Image>& images) {
  float greatest = 1e-6f;
  for (const Image& image : images)
    for (const float value : image.values()) greatest = std::max(greatest, value);
  for (Image& image : images)
    for (float& value : image.values()) value = srgb(std::max(value, 0.0f) / greatest);
}

/// Where pixel `i` of `count` begins in a row of `from` texels.
int edge(int i, int count, int from) {
  return int(std::int64_t(i) * from / count);
}

/// Draws `image` into the rectangle of `sheet`: every pixel is the mean of the texels under it.
void place(const Image& image, Image& sheet, int left, int top, int width, int height) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int x0 = edge(x, width, image.width()), y0 = edge(y, height, image.height());
      const int x1 = std::max(x0 + 1, edge(x + 1, width, image.width()));
      const int y1 = std::max(y0 + 1, edge(y + 1, height, image.height()));
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (int v = y0; v < y1; ++v)
          for (int u = x0; u < x1; ++u) sum += double(image.at(u, v, c));
        sheet.at(left + x, top + y, c) = float(sum / ((x1 - x0) * (y1 - y0)));
      }
    }
}

} // namespace

Image passPicture(const trace::Trace& trace, const nlohmann::json& wanted,
                  const std::string& name) {
  const bool light = wanted.value("light", false);
  std::vector<Image> images;
  const nlohmann::json& named = wanted.at("attachment");
  const auto attachments = named.is_array() ? named : nlohmann::json::array({named});
  for (const auto& size : wanted.at("sizes"))
    for (const std::string attachment : attachments) {
      const trace::CopyRecord& copy = find(trace, attachment, size.at(0), size.at(1), name);
      images.push_back(light ? firstChannels(trace.image(copy), 3)
                             : trace::picture(trace, copy).rgb);
    }
  if (light) toDisplay(images);

  const int count = int(images.size());
  const int columns = std::min(count, kColumns), rows = (count + kColumns - 1) / kColumns;
  const int height = wanted.at("height");
  const int width = images.at(0).width() * height / images.at(0).height();
  Image sheet(columns * (width + kGap) - kGap, rows * (height + kGap) - kGap, 3, 1);
  for (int i = 0; i < count; ++i)
    place(images[std::size_t(i)], sheet, i % kColumns * (width + kGap),
          i / kColumns * (height + kGap), width, height);
  return sheet;
}

} // namespace ggrade::authoring
