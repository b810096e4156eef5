#include "diagnosis/views.hpp"

#include "assignment/usage_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

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

class Writer {
public:
  explicit Writer(const fs::path& file) : file_(file), out_(file, std::ios::binary) {}
  template <typename Value> void write(const Value& value) { write(&value, sizeof value); }
  void write(const void* data, std::size_t size) {
    if (!out_.write(static_cast<const char*>(data), std::streamsize(size))) fail();
  }
  void picture(const Image& image, const Image* base) {
    std::vector<std::uint16_t> values, same;
    for (const float value : image.values()) values.push_back(packed(value));
    if (base && sameSize(*base, image) && base->channels() == image.channels())
      for (const float value : base->values()) same.push_back(packed(value));
    const bool known = !values.empty() && values == same;
    write(Header{image.width(), image.height(), image.channels(), known});
    if (!known) write(values.data(), values.size() * sizeof values[0]);
  }
  void finish() {
    if (!out_.flush()) fail();
  }

private:
  [[noreturn]] void fail() const {
    throw UsageError(fmt::format("can't write {}: is the disk full?", file_.string()));
  }

  const fs::path& file_;
  std::ofstream out_;
};

class Reader {
public:
  explicit Reader(const fs::path& file) : file_(file), in_(file, std::ios::binary) {}
  template <typename Value> Value read() {
    Value value{};
    read(&value, sizeof value);
    return value;
  }
  void read(void* data, std::size_t size) {
    if (!in_.read(static_cast<char*>(data), std::streamsize(size))) fail();
  }
  Image picture(const Image* base) {
    const auto header = read<Header>();
    if (header.channels == 0) return {};
    if (header.inBase) {
      if (!base) fail();
      return *base;
    }
    Image image(header.width, header.height, header.channels);
    std::vector<std::uint16_t> values(image.values().size());
    read(values.data(), values.size() * sizeof values[0]);
    std::transform(values.begin(), values.end(), image.values().begin(),
                   [](std::uint16_t value) { return float(value) / kSteps + kLow; });
    return image;
  }

private:
  [[noreturn]] void fail() const {
    throw UsageError(fmt::format("{} is cut off: remove it", file_.string()));
  }

  const fs::path& file_;
  std::ifstream in_;
};

struct PassHeader {
  std::int32_t depth, mesh, octave, nth, width, height;
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
                         pass.width, pass.height});
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
    PassView pass{{header.depth != 0, header.mesh != 0, header.octave, header.nth},
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
