#include "report/inspect_words.hpp"

#include "words/words.hpp"

#include <GL/glcorearb.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

namespace ggrade::report {

using namespace trace;
using gg::say;

namespace {

bool is(const ImageRef& image, ImageKind kind) {
  return image.kind == std::uint32_t(kind);
}

std::string_view kindWord(const ImageRef& image) {
  if (is(image, ImageKind::window)) return gg::words("window");
  return is(image, ImageKind::texture) ? gg::words("texture") : gg::words("renderbuffer");
}

std::string layerWords(const ImageRef& image) {
  static constexpr std::array kFaces = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  if (image.layer == kNone) return "";
  if (image.target == GL_TEXTURE_CUBE_MAP && image.layer < kFaces.size())
    return say("face {}", kFaces[image.layer]);
  return say("layer {}", image.layer);
}

/// "level 2, face +X of a texture", "a texture".
std::string place(const ImageRef& image) {
  if (is(image, ImageKind::window)) return say("the window");
  std::string part = image.level > 0 ? say("level {}", image.level) : "";
  if (const std::string layer = layerWords(image); !layer.empty())
    part += (part.empty() ? "" : ", ") + layer;
  const bool texture = is(image, ImageKind::texture);
  if (part.empty()) return texture ? say("a texture") : say("a renderbuffer");
  return texture ? say("{} of a texture", part) : say("{} of a renderbuffer", part);
}

/// What the pass does with `images`.
std::string doing(const PassRecord& pass, const std::string& images) {
  switch (static_cast<PassKind>(pass.kind)) {
  case PassKind::blit:
    return say("blits into {}", images);
  case PassKind::copy:
    return say("copies into {}", images);
  case PassKind::mipmap:
    return say("makes the mipmaps of {}", images);
  case PassKind::imageStore:
    return say("stores from a shader into {}", images);
  default:
    return pass.draws == 0 && pass.cleared != 0 ? say("clears {}", images)
                                                : say("draws into {}", images);
  }
}

/// ", with depth renderbuffer and stencil renderbuffer"; one image that is both is named once.
std::string besides(const PassRecord& pass) {
  const ImageRef& depth = pass.images[kDepth];
  const ImageRef& stencil = pass.images[kStencil];
  const bool hasDepth = !is(depth, ImageKind::none), hasStencil = !is(stencil, ImageKind::none);
  if (hasDepth && hasStencil && sameImage(depth, stencil))
    return say(", with depth and stencil {}", kindWord(depth));
  if (hasDepth && hasStencil)
    return say(", with depth {} and stencil {}", kindWord(depth), kindWord(stencil));
  if (hasDepth) return say(", with depth {}", kindWord(depth));
  return hasStencil ? say(", with stencil {}", kindWord(stencil)) : "";
}

std::string blendWords(const StepRecord& step) {
  const auto equation = [](std::uint32_t source, std::uint32_t destination, std::uint32_t how) {
    return say("{} x source {} {} x destination", glName(source),
               how == GL_FUNC_ADD ? "+" : glName(how), glName(destination));
  };
  std::string text = equation(step.blendSource, step.blendDestination, step.blendEquation);
  if (step.blendSource != step.blendSourceAlpha ||
      step.blendDestination != step.blendDestinationAlpha ||
      step.blendEquation != step.blendEquationAlpha)
    text += say("; alpha: {}", equation(step.blendSourceAlpha, step.blendDestinationAlpha,
                                        step.blendEquationAlpha));
  return text;
}

std::string faceWords(const StencilFace& face) {
  return say("{} {}{}{}; fail {}, depth fail {}, pass {}", glName(face.func), face.ref,
             (face.valueMask & 0xff) == 0xff ? ""
                                             : fmt::format(" & 0x{:02x}", face.valueMask & 0xff),
             (face.writeMask & 0xff) == 0xff ? "" : say(", writes 0x{:02x}", face.writeMask & 0xff),
             glName(face.fail), glName(face.depthFail), glName(face.depthPass));
}

std::string stencilWords(const StepRecord& step) {
  const std::string front = faceWords(step.stencil[0]), back = faceWords(step.stencil[1]);
  return front == back ? front : say("front {}; back {}", front, back);
}

std::string clipWords(std::uint32_t mask) {
  std::string text;
  for (std::uint32_t i = 0; i < 32; ++i)
    if (mask >> i & 1) text += fmt::format("{}{}", text.empty() ? "" : ", ", i);
  return text.empty() ? say("none") : text;
}

std::string maskWords(std::uint32_t mask) {
  std::string text;
  for (int i = 0; i < 4; ++i)
    if (mask >> i & 1) text += "RGBA"[i];
  return text.empty() ? say("no channel") : text;
}

} // namespace

std::string shortest(float value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string byteWords(std::uint64_t bytes) {
  if (bytes < 1000) return say("{} bytes", bytes);
  if (bytes < 1000'000) return fmt::format("{:.1f} kB", double(bytes) / 1e3);
  return fmt::format("{:.1f} MB", double(bytes) / 1e6);
}

std::string grouped(std::uint64_t value) {
  std::string text = std::to_string(value);
  for (int at = int(text.size()) - 3; at > 0; at -= 3) text.insert(std::size_t(at), ",");
  return text;
}

std::string rectangle(const std::int32_t (&box)[4]) {
  return say("{} x {} at ({}, {})", box[2], box[3], box[0], box[1]);
}

std::string drawCount(std::uint64_t draws) {
  return draws == 1 ? say("1 draw") : say("{} draws", grouped(draws));
}

std::string attachmentWords(const PassRecord& pass, std::uint32_t attachment) {
  if (attachment == kNone) return say("picture");
  const auto colours = std::count_if(pass.images, pass.images + kColors, [](const ImageRef& image) {
    return !is(image, ImageKind::none);
  });
  if (attachment == kDepth) return say("depth");
  if (attachment == kStencil) return say("stencil");
  return colours == 1 ? say("colour") : say("colour {}", attachment);
}

std::string imageWords(const ImageRef& image) {
  if (is(image, ImageKind::none)) return say("nothing");
  if (is(image, ImageKind::window)) return say("window");
  std::string text = fmt::format("{} {}", kindWord(image), image.name);
  if (image.level > 0) text += ", " + say("level {}", image.level);
  if (const std::string layer = layerWords(image); !layer.empty()) text += ", " + layer;
  return text;
}

std::string sizeWords(const ImageRef& image) {
  std::string text = fmt::format("{} x {}", image.width, image.height);
  if (image.samples > 1) text += say(", {} samples", image.samples);
  return text;
}

std::vector<std::uint32_t> mainAttachments(const PassRecord& pass) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < kColors; ++i)
    if ((pass.drawBuffers >> i & 1) && !is(pass.images[i], ImageKind::none)) found.push_back(i);
  if (!found.empty()) return found;
  for (std::uint32_t i = 0; i < kAttachments; ++i)
    if (!is(pass.images[i], ImageKind::none)) found.push_back(i);
  return found;
}

std::string passTitle(const PassRecord& pass) {
  if (pass.status != GL_FRAMEBUFFER_COMPLETE && pass.framebuffer != kNone)
    return say("tries to draw into an incomplete framebuffer");
  const std::vector<std::uint32_t> targets = mainAttachments(pass);
  if (targets.empty()) return doing(pass, say("nothing"));
  const ImageRef& image = pass.images[targets[0]];
  if (targets[0] >= kColors) {
    const bool both = targets.size() > 1;
    return doing(pass, place(image)) +
           (both                   ? say(", depth and stencil only")
            : targets[0] == kDepth ? say(", depth only")
                                   : say(", stencil only")) +
           fmt::format(", {} {}", sizeWords(image), glName(image.format));
  }
  const bool same = std::ranges::all_of(
      targets, [&](std::uint32_t target) { return pass.images[target].format == image.format; });
  const std::string text =
      doing(pass, targets.size() == 1 ? place(image) : say("{} images", targets.size())) + ", " +
      sizeWords(image);
  if (is(image, ImageKind::window)) return text;
  return text + (same ? " " + glName(image.format) : say(", formats differ")) + besides(pass);
}

std::string statusMeaning(std::uint32_t status) {
  switch (status) {
  case GL_FRAMEBUFFER_COMPLETE:
    return "";
  case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
    return say(
        "An attachment can't be drawn into: its image was deleted, has no size, or has a format "
        "that doesn't suit the attachment point (a colour format as depth, for example).");
  case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
    return say("Nothing is attached to the framebuffer.");
  case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER:
    return say("glDrawBuffers names a colour attachment that has no image.");
  case GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER:
    return say(
        "glReadBuffer names a colour attachment that has no image: for a framebuffer without "
        "colour, call glReadBuffer(GL_NONE).");
  case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
    return say("The attachments have different numbers of samples.");
  case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
    return say("Some attachments are layered and others are not.");
  case GL_FRAMEBUFFER_UNSUPPORTED:
    return say("This combination of formats isn't supported by the renderer.");
  default:
    return say("Every draw into it is an error and has no effect.");
  }
}

std::vector<StateWord> stateWords(const StepRecord& step) {
  const auto ifOn = [](std::string label, bool on, std::string value) {
    return StateWord{std::move(label), on ? std::move(value) : say("off"), !on};
  };
  StateWord depthWrite = ifOn(say("depth write"), step.depthWrite, say("on"));
  if (!step.depthTest) depthWrite.value += say(" (no effect: the test is off)");
  return {
      {say("program"), step.program ? std::to_string(step.program) : say("none"), !step.program},
      {say("viewport"), rectangle(step.viewport), false},
      ifOn(say("depth test"), step.depthTest, glName(step.depthTest)),
      depthWrite,
      ifOn(say("depth clamp"), step.depthClamp, say("on")),
      ifOn(say("polygon offset"), step.polygonOffset,
           say("factor {}, units {}", shortest(step.polygonOffsetFactor),
               shortest(step.polygonOffsetUnits))),
      ifOn(say("culling"), step.cullFace,
           say("{} faces, front is {}", glName(step.cullFace), glName(step.frontFace))),
      ifOn(say("blending"), step.blend, blendWords(step)),
      ifOn(say("stencil test"), step.stencilTest, stencilWords(step)),
      {say("colour mask"), maskWords(step.colorMask), false},
      ifOn(say("scissor"), step.scissorTest, rectangle(step.scissor)),
      {say("clip distances"), clipWords(step.clipDistances), !step.clipDistances},
      ifOn(say("sRGB encoding"), step.framebufferSrgb, say("on")),
      {say("rasterizer"), step.rasterizerDiscard ? say("discards everything") : say("on"), false},
  };
}

std::string samplerWords(const SampleRecord& sample) {
  std::string text = sample.minFilter == sample.magFilter
                         ? glName(sample.magFilter)
                         : say("{} (far {})", glName(sample.magFilter), glName(sample.minFilter));
  text += ", " + glName(sample.wrapS);
  if (sample.wrapT != sample.wrapS) text += " / " + glName(sample.wrapT);
  if (sample.compareMode == GL_COMPARE_REF_TO_TEXTURE)
    text += say(", compares {}", glName(sample.compareFunc));
  if (sample.sampler) text += say(", by sampler object {}", sample.sampler);
  return text;
}

std::string readWords(const FrameGraph& graph, const PassRead& read) {
  return say("pass {}'s {}", graph.number(read.writer),
             attachmentWords(graph.pass(read.writer), read.attachment));
}

// Notes.

namespace {

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
  const bool depth = !is(pass.images[kDepth], ImageKind::none);
  constexpr std::uint64_t kQuad = 6; // vertices that a full-screen pass needs at most
  if (step.depthTest && !depth && step.vertices > kQuad)
    notes.odd(
        say("The depth test is on, but there is no depth attachment: nothing is hidden, what is "
            "drawn last wins."));
  if (step.depthTest && depth && step.vertices > 0 && step.vertices <= kQuad && !hasMatrices)
    notes.odd(say("The depth test is on while {} vertices are drawn without any matrix, as for a "
                  "full-screen pass: they can be hidden by what is in the depth buffer.",
                  step.vertices));
  if (step.stencilTest && is(pass.images[kStencil], ImageKind::none))
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
    if (is(sample.image, ImageKind::none))
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
