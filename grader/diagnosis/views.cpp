#include "diagnosis/views.hpp"

#include "trace/picture.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace ggrade::diagnosis {

using gg::say;

namespace {

float compressed(float value) {
  if (std::isnan(value)) return -1;
  if (value > 1) return std::min(17.0f, 1 + std::log2(value));
  return std::max(value, -1.0f);
}

/// The share of each source pixel in each of `to` equal parts of a side of `from` pixels.
struct Share {
  int first = 0;
  std::vector<float> weights;
};

std::vector<Share> shares(int from, int to) {
  std::vector<Share> all(static_cast<std::size_t>(to));
  for (int i = 0; i < to; ++i) {
    const double low = double(i) * from / to, high = double(i + 1) * from / to;
    Share& share = all[std::size_t(i)];
    share.first = int(low);
    for (int k = share.first; k < from && k < high; ++k)
      share.weights.push_back(
          float((std::min<double>(k + 1, high) - std::max<double>(k, low)) / (high - low)));
  }
  return all;
}

Image averaged(const Image& image, int width, int height) {
  const int channels = image.channels();
  const auto columns = shares(image.width(), width), rows = shares(image.height(), height);
  Image narrow(width, image.height(), channels);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < width; ++x) {
      const Share& share = columns[std::size_t(x)];
      for (std::size_t k = 0; k < share.weights.size(); ++k)
        for (int c = 0; c < channels; ++c)
          narrow.at(x, y, c) += share.weights[k] * image.at(share.first + int(k), y, c);
    }
  Image out(width, height, channels);
  for (int y = 0; y < height; ++y) {
    const Share& share = rows[std::size_t(y)];
    for (std::size_t k = 0; k < share.weights.size(); ++k)
      for (std::size_t i = 0; i < out.row(y).size(); ++i)
        out.row(y)[i] += share.weights[k] * narrow.row(share.first + int(k))[i];
  }
  return out;
}

/// Mean of a level's picture, see evened.
constexpr float kMean = 0.1f;

/// A constant factor of what is drawn at a fraction of the window's size is the program's own
/// choice: where light is weighed is a matter of taste. The picture with its mean at kMean; black
/// stays black.
Image evened(Image image) {
  double sum = 0;
  std::size_t count = 0;
  for (const float value : image.values())
    if (std::isfinite(value)) sum += double(value), ++count;
  const double mean = count ? sum / double(count) : 0;
  if (mean > 1e-6)
    for (float& value : image.values()) value = float(double(value) * kMean / mean);
  return image;
}

/// Was a mesh drawn into this, or into what it is a blit or copy of?
bool showsMesh(const trace::Trace& trace, const trace::PassRecord& pass) {
  if (pass.kind == std::uint32_t(trace::PassKind::draw)) return trace.drewObjects(pass);
  for (const trace::StepRecord& step : trace.stepsOf(pass))
    for (const trace::SampleRecord& sample : trace.samplesOf(step))
      if (sample.writer != trace::kNone && trace.drewObjects(trace.passes[sample.writer]))
        return true;
  return false;
}

/// Did this pass only clear what a later one draws into? When that happens is the program's affair.
bool isDrawnOver(std::span<const trace::PassRecord> passes, std::size_t pass, std::uint32_t a) {
  const trace::ImageRef& image = passes[pass].images[a];
  return passes[pass].kind == std::uint32_t(trace::PassKind::draw) && passes[pass].draws == 0 &&
         std::ranges::any_of(passes.subspan(pass + 1), [&](const trace::PassRecord& later) {
           return later.draws > 0 && sameImage(later.images[a], image);
         });
}

/// Was something drawn into this colour attachment, and nothing that the shaders write? What stands
/// there then is undefined.
bool isUndefined(const trace::Trace& trace, const trace::PassRecord& pass, std::uint32_t a) {
  if (pass.kind != std::uint32_t(trace::PassKind::draw) || a >= trace::kColors) return false;
  std::uint32_t outputs = 0; // that go there
  for (std::uint32_t i = 0; i < trace::kColors; ++i)
    if (pass.attachmentOfOutput[i] == a) outputs |= 1U << i;
  const auto steps = trace.stepsOf(pass);
  return outputs != 0 && !steps.empty() &&
         std::ranges::none_of(
             steps, [&](const trace::StepRecord& step) { return (step.outputs & outputs) != 0; });
}

std::string firstOf(const Slot& slot) {
  if (slot.stencil) return say("the stencil buffer");
  if (slot.depth && slot.mesh) return say("the depth texture that objects are drawn into");
  if (slot.mesh) return say("the texture that objects are drawn into");
  const std::string size =
      slot.octave > 0    ? say("1/{} of the window's size", 1 << std::min(slot.octave, 20))
      : slot.octave == 0 ? say("the window's size")
                         : say("about {} times the window's size", 1 << std::min(-slot.octave, 20));
  return slot.depth ? say("the depth texture without objects, at {}", size)
                    : say("the texture without objects, at {}", size);
}

} // namespace

std::string describe(const Slot& slot) {
  const std::string first = firstOf(slot);
  return slot.nth > 0 ? say("{}, number {} of those", first, slot.nth + 1) : first;
}

const PassView* SceneViews::find(const Slot& slot) const {
  const auto found = std::find_if(passes.begin(), passes.end(),
                                  [&](const PassView& pass) { return pass.slot == slot; });
  return found == passes.end() ? nullptr : &*found;
}

Image resized(const Image& image, int width, int height) {
  return image.width() == width && image.height() == height ? image
                                                            : averaged(image, width, height);
}

Image reduced(const Image& image, int channels) {
  Image seen = image.channels() == channels ? image : firstChannels(image, channels);
  for (float& value : seen.values()) value = compressed(value);
  const int longer = std::max(seen.width(), seen.height());
  if (longer <= kSide) return seen;
  const auto shorter = [&](int side) {
    return std::max(1, int(std::lround(double(side) * kSide / longer)));
  };
  return averaged(seen, shorter(seen.width()), shorter(seen.height()));
}

Image stretchedDepth(const Image& depth) {
  Image out = depth;
  for (float& value : out.values())
    value = std::isfinite(value) ? float(trace::evenDepth(value)) : -1.0f;
  return out;
}

namespace {

/// Colours in the order of the fragment shader's outputs, wherever these are attached; then what no
/// output goes to; then depth.
std::vector<std::uint32_t> inOrder(const trace::PassRecord& pass) {
  std::vector<std::uint32_t> order;
  const auto add = [&](std::uint32_t attachment) {
    if (attachment < trace::kColors && std::ranges::find(order, attachment) == order.end())
      order.push_back(attachment);
  };
  if (pass.kind == std::uint32_t(trace::PassKind::draw))
    for (const std::uint8_t attachment : pass.attachmentOfOutput) add(attachment);
  for (std::uint32_t i = 0; i < trace::kColors; ++i) add(i);
  order.push_back(trace::kDepth);
  return order;
}

/// What the stencil buffer holds at the end of the first frame; nothing where that is 0.
std::optional<PassView> stencilView(const trace::Trace& trace) {
  const auto passes = trace.passesOf(0);
  for (auto pass = passes.rbegin(); pass != passes.rend(); ++pass) {
    const trace::CopyRecord* copy = trace.copyOf(trace.indexOf(*pass), trace::kStencil);
    if (!copy) continue;
    Image counts = trace.image(*copy);
    const auto values = counts.values();
    if (std::ranges::all_of(values, [](float value) { return value == 0; })) return std::nullopt;
    for (float& value : counts.values())
      value = std::clamp(0.5f + (value > 127 ? value - 256 : value) / 32, 0.0f, 1.0f);
    PassView view;
    view.slot.stencil = true;
    view.width = std::int32_t(copy->width);
    view.height = std::int32_t(copy->height);
    view.picture = reduced(counts, 1);
    return view;
  }
  return std::nullopt;
}

} // namespace

SceneViews views(const std::vector<Image>& frames, const trace::Trace& trace, bool stencil) {
  SceneViews views;
  for (const Image& frame : frames) views.windows.push_back(reduced(frame, 3));
  if (frames.empty()) return views;
  views.width = frames[0].width();
  views.height = frames[0].height();
  if (trace.frames.empty()) return views;
  std::map<Slot, std::int32_t> seen;
  const auto passes = trace.passesOf(0);
  for (std::size_t i = 0; i < passes.size(); ++i)
    for (const std::uint32_t a : inOrder(passes[i])) {
      const trace::ImageRef& image = passes[i].images[a];
      if (image.kind != std::uint32_t(trace::ImageKind::texture) || isDrawnOver(passes, i, a))
        continue;
      const trace::CopyRecord* copy = trace.copyOf(trace.indexOf(passes[i]), a);
      if (!copy) continue;
      PassView view;
      view.pass = trace.indexOf(passes[i]);
      view.attachment = a;
      view.slot.depth = a == trace::kDepth;
      view.slot.mesh = showsMesh(trace, passes[i]);
      view.width = std::int32_t(copy->width);
      view.height = std::int32_t(copy->height);
      if (!view.slot.mesh)
        view.slot.octave =
            std::int32_t(std::lround(std::log2(double(frames[0].height()) / double(copy->height))));
      view.slot.nth = seen[view.slot]++;
      if (isUndefined(trace, passes[i], a)) continue;
      Image pixels = trace.image(*copy);
      if (!view.slot.mesh && !view.slot.depth && view.slot.octave > 0)
        pixels = evened(firstChannels(pixels, std::min(pixels.channels(), 3)));
      view.picture = view.slot.depth ? reduced(stretchedDepth(pixels), 1)
                                     : reduced(pixels, std::min(pixels.channels(), 3));
      views.passes.push_back(std::move(view));
    }
  if (stencil)
    if (auto view = stencilView(trace)) views.passes.push_back(std::move(*view));
  return views;
}

} // namespace ggrade::diagnosis
