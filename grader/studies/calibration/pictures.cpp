#include "calibration/pictures.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>

namespace ggrade::calibration {

using rubric::RawFrame;

const std::vector<PictureKind>& pictureKinds() {
  static const std::vector<PictureKind> kinds = {
      {"black", "Black frames"},
      {"grey", "Frames of one grey"},
      {"white", "White frames"},
      {"noise", "Noise"},
      {"frozen", "The first frame again and again"},
      {"other scene", "Right pictures, but of another scene"},
      {"public frames", "The public scene's right pictures in every scene"}};
  return kinds;
}

namespace {

/// The picture at the size of `like`: the nearest pixel of `from`, each.
std::vector<std::uint8_t> resized(const RawFrame& from, const RawFrame& like) {
  std::vector<std::uint8_t> pixels(like.pixels.size());
  for (std::uint32_t y = 0; y < like.height; ++y)
    for (std::uint32_t x = 0; x < like.width; ++x) {
      const std::size_t u = std::size_t(x) * from.width / like.width;
      const std::size_t v = std::size_t(y) * from.height / like.height;
      std::copy_n(&from.pixels[(v * from.width + u) * 4], 4,
                  &pixels[(std::size_t(y) * like.width + x) * 4]);
    }
  return pixels;
}

} // namespace

std::vector<RawFrame> pictures(const std::string& kind,
                               const std::vector<std::vector<RawFrame>>& all,
                               const std::vector<bool>& isPublic, std::size_t index) {
  std::vector<RawFrame> frames = all.at(index);
  const auto fill = [&](auto&& value) {
    for (RawFrame& frame : frames)
      for (std::size_t i = 0; i < frame.pixels.size(); ++i)
        frame.pixels[i] = i % 4 == 3 ? 255 : std::uint8_t(value());
  };
  const auto show = [&](std::size_t scene) {
    for (std::size_t i = 0; i < frames.size(); ++i)
      frames[i].pixels = resized(all[scene].at(std::min(i, all[scene].size() - 1)), frames[i]);
  };
  if (kind == "black") {
    fill([] { return 0; });
  } else if (kind == "grey") {
    fill([] { return 128; });
  } else if (kind == "white") {
    fill([] { return 255; });
  } else if (kind == "noise") {
    std::mt19937 engine(static_cast<unsigned>(index));
    fill([&] { return engine() >> 24; });
  } else if (kind == "frozen") {
    for (RawFrame& frame : frames) frame.pixels = frames[0].pixels;
  } else if (kind == "other scene") {
    show((index + 1) % all.size());
  } else if (kind == "public frames") {
    const auto known = std::find(isPublic.begin(), isPublic.end(), true);
    show(known == isPublic.end() ? 0 : std::size_t(known - isPublic.begin()));
  } else {
    throw std::logic_error("no pictures of kind " + kind);
  }
  return frames;
}

} // namespace ggrade::calibration
