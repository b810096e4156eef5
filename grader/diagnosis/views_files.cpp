#include "diagnosis/views.hpp"

#include "assignment/usage_error.hpp"

#include <fmt/format.h>

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace ggrade::diagnosis {

namespace fs = std::filesystem;

namespace {

// Values lie between -1 and 17, see `reduced`.
constexpr float kLow = -1, kSteps = 65535.0f / 18.0f;

std::uint16_t packed(float value) {
  return static_cast<std::uint16_t>(std::lround((value - kLow) * kSteps));
}

struct Header {
  std::int32_t width = 0, height = 0, channels = 0; ///< of the picture; 0: none
  std::int32_t inBase = 0;                          ///< 1: as in the base, no values follow
};

using Values = std::vector<std::uint16_t>;

/// The base's values where it has the same shape; else none.
Values valuesOf(const Image* base, const Header& header) {
  Values values;
  if (base && base->width() == header.width && base->height() == header.height &&
      base->channels() == header.channels)
    for (const float value : base->values()) values.push_back(packed(value));
  return values;
}

/// What value `i` is probably near to: the same one of the base, or that of the pixel before. Only
/// the rest is written, which compresses well.
std::uint16_t expected(const Values& values, const Values& base, std::size_t i, int channels) {
  if (!base.empty()) return base[i];
  return i < std::size_t(channels) ? 0 : values[i - std::size_t(channels)];
}

class Writer {
public:
  explicit Writer(const fs::path& file) : file_(file), out_(gzopen(file.c_str(), "wb1")) {
    if (!out_) fail();
  }
  ~Writer() {
    if (out_) gzclose(out_);
  }
  template <typename Value> void write(const Value& value) { write(&value, sizeof value); }
  void write(const void* data, std::size_t size) {
    if (size > 0 && gzwrite(out_, data, unsigned(size)) != int(size)) fail();
  }
  void picture(const Image& image, const Image* base) {
    Header header{image.width(), image.height(), image.channels(), 0};
    const Values same = valuesOf(base, header);
    Values values;
    for (const float value : image.values()) values.push_back(packed(value));
    header.inBase = !values.empty() && values == same;
    write(header);
    if (header.inBase) return;
    // All low bytes, then all high ones, which are nearly all 0.
    std::vector<std::uint8_t> bytes(2 * values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto rest = std::uint16_t(values[i] - expected(values, same, i, header.channels));
      bytes[i] = std::uint8_t(rest & 0xff);
      bytes[values.size() + i] = std::uint8_t(rest >> 8);
    }
    write(bytes.data(), bytes.size());
  }
  void finish() {
    if (gzclose(std::exchange(out_, nullptr)) != Z_OK) fail();
  }

private:
  [[noreturn]] void fail() const {
    throw UsageError(fmt::format("can't write {}: is the disk full?", file_.string()));
  }

  const fs::path& file_;
  gzFile out_;
};

class Reader {
public:
  explicit Reader(const fs::path& file) : file_(file), in_(gzopen(file.c_str(), "rb")) {
    if (!in_) fail();
  }
  ~Reader() { gzclose(in_); }
  template <typename Value> Value read() {
    Value value{};
    read(&value, sizeof value);
    return value;
  }
  void read(void* data, std::size_t size) {
    if (gzread(in_, data, unsigned(size)) != int(size)) fail();
  }
  Image picture(const Image* base) {
    const auto header = read<Header>();
    if (header.channels == 0) return {};
    if (header.inBase) {
      if (!base) fail();
      return *base;
    }
    Image image(header.width, header.height, header.channels);
    const Values same = valuesOf(base, header);
    Values values(image.values().size());
    std::vector<std::uint8_t> bytes(2 * values.size());
    read(bytes.data(), bytes.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const int rest = bytes[i] | bytes[values.size() + i] << 8;
      values[i] = std::uint16_t(expected(values, same, i, header.channels) + rest);
    }
    std::transform(values.begin(), values.end(), image.values().begin(),
                   [](std::uint16_t value) { return float(value) / kSteps + kLow; });
    return image;
  }

private:
  [[noreturn]] void fail() const {
    throw UsageError(fmt::format("{} is missing or cut off: remove it", file_.string()));
  }

  const fs::path& file_;
  gzFile in_;
};

struct PassHeader {
  std::int32_t depth, mesh, octave, nth, stencil, width, height;
};

} // namespace

void save(const SceneViews& views, const SceneViews* base, const fs::path& file) {
  Writer out(file);
  out.write(std::uint32_t(views.passes.size()));
  out.write(std::uint32_t(views.windows.size()));
  out.write(views.width);
  out.write(views.height);
  for (const PassView& pass : views.passes) {
    const PassView* same = base ? base->find(pass.slot) : nullptr;
    out.write(PassHeader{pass.slot.depth, pass.slot.mesh, pass.slot.octave, pass.slot.nth,
                         pass.slot.stencil, pass.width, pass.height});
    out.picture(pass.picture, same ? &same->picture : nullptr);
  }
  for (std::size_t i = 0; i < views.windows.size(); ++i)
    out.picture(views.windows[i], base && i < base->windows.size() ? &base->windows[i] : nullptr);
  out.finish();
}

SceneViews load(const fs::path& file, const SceneViews* base) {
  Reader in(file);
  SceneViews views;
  const auto passes = in.read<std::uint32_t>(), windows = in.read<std::uint32_t>();
  views.width = in.read<std::int32_t>();
  views.height = in.read<std::int32_t>();
  for (std::uint32_t i = 0; i < passes; ++i) {
    const auto header = in.read<PassHeader>();
    PassView pass{
        {header.depth != 0, header.mesh != 0, header.octave, header.nth, header.stencil != 0},
        header.width,
        header.height,
        {}};
    const PassView* same = base ? base->find(pass.slot) : nullptr;
    pass.picture = in.picture(same ? &same->picture : nullptr);
    views.passes.push_back(std::move(pass));
  }
  for (std::uint32_t i = 0; i < windows; ++i)
    views.windows.push_back(
        in.picture(base && i < base->windows.size() ? &base->windows[i] : nullptr));
  return views;
}

} // namespace ggrade::diagnosis
