// What a program hands over through the shared memory: any bytes over a whole run's frames, passes
// and copies. What is taken must be possible, and then be read without harm by who looks at passes.
#include "../unit/channel_child.hpp"
#include "fuzz_look.hpp"

#include "diagnosis/views.hpp"
#include "image/image.hpp"

#include <GL/glcorearb.h>

#include <algorithm>
#include <cstdint>

using namespace ggrade;
using namespace ggrade::channel;
using namespace ggrade::trace;

namespace {

template <typename Enum> std::uint32_t number(Enum value) {
  return static_cast<std::uint32_t>(value);
}

constexpr std::uint32_t kSide = 4;

/// Two frames were planned and one came, with two passes; a third began after it.
void writeRun(ChildView& child) {
  Header& header = child.header();
  header.started = header.contextMade = header.framesDone = header.messageCount = 1;
  header.frames[0].written = 1;
  header.frames[0].width = header.frames[0].height = kSide;
  header.frames[0].passCount = 2;
  header.messages[0] = {1, 0, 1, 1, "GL_INVALID_ENUM in glEnable"};
  Tables& tables = child.tables();
  tables.counts = {3, 4, 3, 2, 3, 0, 0, 0, 0, 0, 160};
  for (std::uint32_t i = 0; i < 3; ++i) {
    PassRecord& pass = tables.passes[i];
    pass.frame = i / 2;
    pass.kind = number(PassKind::draw);
    pass.status = GL_FRAMEBUFFER_COMPLETE;
    const std::uint32_t texture = number(ImageKind::texture);
    pass.images[0] = {texture, 1, GL_TEXTURE_2D, 0, kNone, GL_RGBA8, kSide, kSide, 0};
    pass.images[kDepth] = {texture, 2, GL_TEXTURE_2D, 0, kNone, GL_DEPTH_COMPONENT24, kSide,
                           kSide,   0};
    pass.draws = 2;
    pass.vertices = 600;
    pass.firstStep = 2 * i;
    pass.stepCount = i < 2 ? 2 : 0;
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    StepRecord& step = tables.steps[i];
    step.pass = i / 2;
    step.cullFace = GL_BACK;
    step.depthTest = GL_LESS;
    step.firstMatrix = std::min(i, 2u);
    step.matrixCount = i < 3;
  }
  tables.steps[1].sampleCount = 1;
  tables.steps[3].firstSample = tables.steps[3].sampleCount = 1;
  std::strcpy(tables.matrices[0].name, "uProjection");
  std::strcpy(tables.samples[0].uniform, "uMap");
  tables.samples[0].writer = kNone;
  tables.samples[1].writer = 0;
  tables.copies[0] = {0, kNone, 0, number(PixelType::u8x4), kSide, kSide, 0, 64};
  tables.copies[1] = {0, 1, kDepth, number(PixelType::f32x1), kSide, kSide, 64, 64};
  tables.copies[2] = {1, kNone, kStencil, number(PixelType::u8x1), kSide, kSide, 128, 16};
}

/// Takes bytes off the front.
class Bytes {
public:
  Bytes(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  bool any() const { return at_ != end_; }
  std::uint8_t one() { return any() ? *at_++ : 0; }
  void into(unsigned char* to, std::size_t size) {
    for (std::size_t i = 0; i < size && any(); ++i) to[i] = *at_++;
  }

private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

/// Up to eight bytes into one of the first four of `records`.
template <typename Record> void strike(Bytes& bytes, Record* records) {
  auto* const record = reinterpret_cast<unsigned char*>(records + bytes.one() % 4);
  const std::size_t field = (bytes.one() | bytes.one() << 8) % sizeof(Record);
  bytes.into(record + field, std::min<std::size_t>(1 + bytes.one() % 8, sizeof(Record) - field));
}

void strikeAny(Bytes& bytes, ChildView& child, const Plan& plan) {
  Header& header = child.header();
  Tables& tables = child.tables();
  switch (bytes.one() % 11) {
  case 0: {
    auto* const own = reinterpret_cast<unsigned char*>(&header.started);
    const std::size_t room = reinterpret_cast<unsigned char*>(header.frames) - own;
    const std::size_t field = (bytes.one() | bytes.one() << 8) % room;
    return bytes.into(own + field, std::min<std::size_t>(1 + bytes.one() % 8, room - field));
  }
  case 1:
    return strike(bytes, header.frames);
  case 2:
    return strike(bytes, header.messages);
  case 3:
    return strike(bytes, header.replacements);
  case 4:
    return bytes.into(
        reinterpret_cast<unsigned char*>(&tables.counts) + bytes.one() % sizeof(Counts) / 4 * 4, 4);
  case 5:
    return strike(bytes, tables.passes);
  case 6:
    return strike(bytes, tables.steps);
  case 7:
    return strike(bytes, tables.matrices);
  case 8:
    return strike(bytes, tables.samples);
  case 9:
    return strike(bytes, tables.copies);
  default:
    return bytes.into(child.copies(plan) + bytes.one(), 16);
  }
}

/// As rubrics, reports and the diagnosis read it.
void lookAtRun(const Capture& capture) {
  std::vector<Image> frames;
  for (const CapturedFrame& frame : capture.frames) {
    require(!frame.written || frame.pixels.size() == 4u * frame.width * frame.height);
    if (frame.written)
      frames.push_back(Image::fromBytes(frame.pixels, int(frame.width), int(frame.height)));
  }
  const Trace& trace = capture.trace;
  require(trace.frames.size() == capture.frames.size());
  for (std::size_t i = 0; i < trace.frames.size(); ++i)
    for (const PassRecord& pass : trace.passesOf(i)) {
      require(pass.frame == i);
      for (const StepRecord& step : trace.stepsOf(pass)) require(step.pass == trace.indexOf(pass));
    }
  lookAt(trace);
  toJson(trace).dump(); // throws where a name is no UTF-8
  diagnosis::views(frames, trace);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Channel channel({{0, kSide, kSide}, {1, kSide, kSide}}, kDefaultMaxPixels,
                        everything(4096));
  ChildView child(channel);
  writeRun(child);
  for (Bytes bytes(data, size); bytes.any();) strikeAny(bytes, child, channel.plan());
  const Capture capture = channel.read();
  if (size == 0) require(capture.error.empty()); // or nothing below would ever be reached
  if (capture.error.empty())
    lookAtRun(capture);
  else
    require(capture.frames.empty() && capture.trace.passes.empty());
  return 0;
}
