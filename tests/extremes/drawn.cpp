#include "drawn.hpp"

#include "grading/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace extremes {

namespace fs = std::filesystem;
using namespace ggrade;

namespace {

grading::Rendering render(const std::string& id, const json& scene,
                          const std::vector<double>& times,
                          const std::vector<channel::PassPixels>& replacements) {
  trace::Request request = grading::gradingRequest();
  request.copyFrames = channel::kMaxFrames;
  // Compiling the shaders would be most of a case's time; Mesa finds them by what they say.
  const fs::path build = GGRADE_BUILD_DIR, shaders = build / "tests/extremes/shaders";
  fs::create_directories(shaders);
  const auto run = [&] {
    return grading::renderScene(id, build / "solutions" / id, scene, times, {shaders},
                                sandbox::Isolation::none, request, replacements);
  };
  grading::Rendering rendering = run();
  // No solution hangs: the machine was busy for a while.
  if (rendering.happened.outcome == results::Outcome::timeout) rendering = run();
  return rendering;
}

bool isReplaced(const trace::CopyRecord& copy,
                const std::vector<channel::PassPixels>& replacements) {
  return std::any_of(replacements.begin(), replacements.end(), [&](const auto& replacement) {
    return replacement.pass == copy.pass && replacement.attachment == copy.attachment;
  });
}

void expectFinite(const Image& image, const std::string& what) {
  if (const auto found = findNonFinite(image))
    ADD_FAILURE() << what << ": " << found->text(image.channels());
}

constexpr std::uint32_t kDepthComponent24 = 0x81A6; // GL_DEPTH_COMPONENT24

/// Was everything that a pass wrote copied? The window's bytes and renderbuffers of whole numbers,
/// which can hold neither NaN nor infinity, need not be.
void expectAllCopied(const trace::Trace& trace) {
  EXPECT_EQ(trace.passesLost, 0u);
  EXPECT_EQ(trace.copiesLost, 0u);
  for (const trace::PassRecord& pass : trace.passes)
    for (std::uint32_t attachment = 0; attachment < trace::kAttachments; ++attachment) {
      const trace::ImageRef& image = pass.images[attachment];
      const auto kind = trace::ImageKind(image.kind);
      if ((pass.written >> attachment & 1) == 0 || kind == trace::ImageKind::none ||
          kind == trace::ImageKind::window)
        continue;
      if (kind == trace::ImageKind::renderbuffer && image.format == kDepthComponent24) continue;
      EXPECT_NE(trace.copyOf(trace.indexOf(pass), attachment), nullptr)
          << "pass " << trace.indexOf(pass) << ", " << trace::attachmentName(attachment)
          << " was not looked at";
    }
}

} // namespace

json sceneOf(const std::string& assignment, std::vector<std::string> parts, const json& patch) {
  const Assignment declared =
      Assignment::load(fs::path(GGRADE_SOURCE_DIR) / "assignments" / assignment);
  if (parts.empty())
    for (const Part& part : declared.parts) parts.push_back(part.id);
  json scene = grading::partScene(declared, parts);
  scene.merge_patch(patch);
  return scene;
}

std::vector<std::uint32_t> Drawn::sampling(const std::string& uniform) const {
  std::vector<std::uint32_t> found;
  for (const trace::PassRecord& pass : trace.passesOf(0)) {
    const auto steps = trace.stepsOf(pass);
    const bool samples = std::any_of(steps.begin(), steps.end(), [&](const auto& step) {
      const auto of = trace.samplesOf(step);
      return std::any_of(of.begin(), of.end(),
                         [&](const auto& sample) { return sample.uniform == uniform; });
    });
    if (samples) found.push_back(trace.indexOf(pass));
  }
  return found;
}

std::uint32_t Drawn::writerOf(const std::string& uniform) const {
  for (const trace::PassRecord& pass : trace.passesOf(0))
    for (const trace::StepRecord& step : trace.stepsOf(pass))
      for (const trace::SampleRecord& sample : trace.samplesOf(step))
        if (sample.uniform == uniform && sample.writer != trace::kNone) return sample.writer;
  throw std::runtime_error("no pass drew what is sampled through " + uniform);
}

Image Drawn::leftBy(std::uint32_t pass) const {
  const trace::CopyRecord* copy = trace.copyOf(pass, 0);
  if (copy == nullptr) copy = trace.copyOf(pass, trace::kDepth);
  if (copy == nullptr)
    throw std::runtime_error("pass " + std::to_string(pass) + " left nothing in a texture");
  return trace.image(*copy);
}

Drawn draw(const std::string& assignment, const json& scene, const std::vector<double>& times,
           const std::vector<channel::PassPixels>& replacements,
           const testing::Matcher<std::string>& prints) {
  grading::Rendering rendering = render(assignment, scene, times, replacements);
  const channel::Capture& capture = rendering.capture;
  EXPECT_EQ(rendering.happened.outcome, results::Outcome::graded) << rendering.happened.detail;
  for (const channel::CapturedMessage& message : capture.messages)
    if (message.kind != channel::MessageKind::capture) ADD_FAILURE() << message.text;
  EXPECT_THAT(rendering.happened.output, prints);
  expectAllCopied(capture.trace);

  Drawn drawn;
  for (const channel::CapturedFrame& frame : capture.frames) {
    EXPECT_TRUE(frame.written);
    drawn.frames.push_back(Image::fromBytes(frame.pixels, int(frame.width), int(frame.height)));
  }
  for (const trace::CopyRecord& copy : capture.trace.copies)
    if (!isReplaced(copy, replacements))
      expectFinite(capture.trace.image(copy), "pass " + std::to_string(copy.pass) + ", " +
                                                  trace::attachmentName(copy.attachment));
  drawn.trace = std::move(rendering.capture.trace);
  drawn.replacements = capture.replacements;
  if (drawn.frames.size() != times.size())
    throw std::runtime_error(std::to_string(drawn.frames.size()) + " frames came");
  return drawn;
}

std::string refusal(const std::string& assignment, const json& scene) {
  const grading::Rendering rendering = render(assignment, scene, {0.21}, {});
  EXPECT_TRUE(rendering.capture.frames.empty());
  return rendering.happened.detail;
}

channel::PassPixels colors(std::uint32_t pass, std::uint32_t format, const Image& values) {
  channel::PassPixels pixels{pass,
                             0,
                             trace::PixelType::f32x4,
                             format,
                             std::uint32_t(values.width()),
                             std::uint32_t(values.height()),
                             std::vector<std::byte>(values.values().size_bytes())};
  std::memcpy(pixels.pixels.data(), values.values().data(), pixels.pixels.size());
  return pixels;
}

float distance(std::span<const float> a, std::span<const float> b) {
  float most = 0;
  for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a[c] - b[c]));
  return most;
}

double differing(const Image& a, const Image& b, float by) {
  if (!sameSize(a, b)) return 1;
  std::size_t count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (distance(a.pixel(x, y), b.pixel(x, y)) > by) ++count;
  return double(count) / double(a.pixelCount());
}

} // namespace extremes
