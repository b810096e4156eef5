#include "report/inspect_notes.hpp"

#include "report/inspect_words.hpp"
#include "words/words.hpp"

#include <GL/glcorearb.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace ggrade::report {

using namespace trace;
using gg::say;

namespace {

bool isThere(const ImageRef& image) {
  return image.kind != std::uint32_t(ImageKind::none);
}

bool isDraw(const PassRecord& pass) {
  return pass.kind == std::uint32_t(PassKind::draw);
}

/// Collects notes, each text once.
class Notes {
public:
  void add(Note::Kind kind, std::string text) {
    if (said_.insert(text).second) list_.push_back({kind, std::move(text)});
  }
  void wrong(std::string text) { add(Note::Kind::wrong, std::move(text)); }
  void odd(std::string text) { add(Note::Kind::odd, std::move(text)); }
  void fact(std::string text) { add(Note::Kind::fact, std::move(text)); }
  std::vector<Note> take() { return std::move(list_); }

private:
  std::vector<Note> list_;
  std::set<std::string> said_;
};

void noteViewport(const PassRecord& pass, const std::int32_t (&viewport)[4], Notes& notes) {
  const auto targets = mainAttachments(pass);
  if (targets.empty()) return;
  const ImageRef& image = pass.images[targets[0]];
  const auto [x, y, width, height] = viewport;
  if (x == 0 && y == 0 && std::uint32_t(width) == image.width &&
      std::uint32_t(height) == image.height)
    return;
  notes.odd(say("The viewport is {} x {} at ({}, {}), but what is drawn into is {} x {}: "
                "glViewport wasn't set to the size of this attachment.",
                width, height, x, y, image.width, image.height));
}

void noteState(const PassRecord& pass, const StepRecord& step, bool hasMatrices, Notes& notes) {
  const bool depth = isThere(pass.images[kDepth]);
  constexpr std::uint64_t kQuad = 6; // vertices that a full-screen pass needs at most
  if (step.depthTest && !depth && step.vertices > kQuad)
    notes.odd(
        say("The depth test is on, but there is no depth attachment: nothing is hidden, what is "
            "drawn last wins."));
  if (step.depthTest && depth && step.vertices > 0 && step.vertices <= kQuad && !hasMatrices)
    notes.odd(say("The depth test is on while {} vertices are drawn without any matrix, as for a "
                  "full-screen pass: they can be hidden by what is in the depth buffer.",
                  step.vertices));
  if (step.stencilTest && !isThere(pass.images[kStencil]))
    notes.odd(say("The stencil test is on, but there is no stencil attachment: it always passes."));
  if (step.rasterizerDiscard)
    notes.odd(say("GL_RASTERIZER_DISCARD is on: nothing reaches the framebuffer."));
  if (step.colorMask == 0 && !(step.depthTest && step.depthWrite) && !step.stencilTest)
    notes.odd(say("glColorMask lets nothing through, and neither depth nor stencil is written."));
  for (std::uint32_t i = 0; i < 8; ++i)
    if (step.clipDistances >> i & 1)
      notes.fact(say("GL_CLIP_DISTANCE{0} is on: every vertex shader used here must write "
                     "gl_ClipDistance[{0}].",
                     i));
}

void noteTextures(const FrameGraph& graph, const StepRecord& step, Notes& notes) {
  for (const SampleRecord& sample : graph.trace().samplesOf(step)) {
    const std::string name = sample.uniform[0] ? fmt::format("{} ", sample.uniform) : "";
    if (!isThere(sample.image))
      notes.fact(say("{}(unit {}): no texture is bound there. A shader that reads it gets "
                     "black.",
                     name, sample.unit));
    else if (sample.incomplete && sample.image.width == 0)
      notes.fact(say("{}(unit {}): the texture that is bound there has no image. A shader "
                     "that reads it gets black.",
                     name, sample.unit));
    else if (sample.incomplete)
      notes.odd(say("{}(unit {}): the texture is incomplete: a shader that reads it gets "
                    "black. Mostly GL_TEXTURE_MIN_FILTER asks for mipmaps that aren't "
                    "there.",
                    name, sample.unit));
    if (sample.feedback)
      notes.wrong(say("{}(unit {}): the texture is read and drawn into in the same pass (a "
                      "feedback loop), which OpenGL leaves undefined.",
                      name, sample.unit));
    if (sample.writer != kNone && sample.writer < graph.first())
      notes.odd(say("{}(unit {}): no pass of this frame draws this texture; it holds what "
                    "an earlier frame left.",
                    name, sample.unit));
  }
}

} // namespace

std::vector<Note> frameNotes(const InspectedFrame& frame) {
  Notes notes;
  const Trace& trace = frame.trace;
  if (!frame.problem.empty()) notes.wrong(frame.problem);
  if (frame.boundFramebuffer)
    notes.wrong(say("Framebuffer {} was bound when the buffers were swapped. Only what is "
                    "drawn with framebuffer 0 bound is seen in the window: call "
                    "glBindFramebuffer(GL_FRAMEBUFFER, 0).",
                    frame.boundFramebuffer));
  if (frame.windowSrgb)
    notes.odd(
        say("GL_FRAMEBUFFER_SRGB was on for the window. The window here is linear, so it has no "
            "effect; elsewhere it may brighten the picture."));
  const auto lost = [&](std::uint32_t count, std::string_view what) {
    if (count)
      notes.odd(say("The recorder's room was used up. Left out of this page: {} ({})",
                    gg::words(what), grouped(count)));
  };
  lost(trace.passesLost, gg::tag("passes"));
  lost(trace.stepsLost, gg::tag("steps"));
  lost(trace.matricesLost, gg::tag("matrix uniforms"));
  lost(trace.samplesLost, gg::tag("uses of textures"));
  lost(trace.copiesLost, gg::tag("pictures"));
  lost(frame.messagesLost, gg::tag("messages"));
  return notes.take();
}

std::vector<Note> passNotes(const FrameGraph& graph, std::uint32_t index) {
  const PassRecord& pass = graph.pass(index);
  Notes notes;
  const bool incomplete = pass.framebuffer != kNone && pass.status != GL_FRAMEBUFFER_COMPLETE;
  if (incomplete)
    notes.wrong(say("The framebuffer is not complete ({}), so nothing is drawn. {}",
                    glName(pass.status), statusMeaning(pass.status)));
  for (const StepRecord& step : graph.trace().stepsOf(pass)) noteTextures(graph, step, notes);
  if (!isDraw(pass) || incomplete) return notes.take();

  const bool drawnOver = graph.isDrawnOver(index);
  if (pass.draws == 0 && pass.cleared && !drawnOver)
    notes.odd(say("It is cleared, but nothing is drawn into it."));
  if (!drawsToWindow(pass) && !drawnOver && graph.readersOf(index).empty())
    notes.odd(
        say("Nobody reads this pass: no later pass of this frame samples, copies or draws over "
            "what it drew, and it isn't the window."));
  if (pass.draws) noteViewport(pass, pass.viewport, notes);
  for (const StepRecord& step : graph.trace().stepsOf(pass)) {
    noteViewport(pass, step.viewport, notes);
    noteState(pass, step, !graph.trace().matricesOf(step).empty(), notes);
  }
  return notes.take();
}

} // namespace ggrade::report
