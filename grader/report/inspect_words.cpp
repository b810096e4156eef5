#include "report/inspect_words.hpp"

#include <GL/glcorearb.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace ggrade::report {

using namespace trace;

namespace {

bool is(const ImageRef& image, ImageKind kind) {
  return image.kind == std::uint32_t(kind);
}

std::string_view kindWord(const ImageRef& image) {
  if (is(image, ImageKind::window)) return "window";
  return is(image, ImageKind::texture) ? "texture" : "renderbuffer";
}

std::string layerWords(const ImageRef& image) {
  static constexpr std::array kFaces = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  if (image.layer == kNone) return "";
  if (image.target == GL_TEXTURE_CUBE_MAP && image.layer < kFaces.size())
    return fmt::format("face {}", kFaces[image.layer]);
  return fmt::format("layer {}", image.layer);
}

/// "level 2, face +X of a texture", "a texture".
std::string place(const ImageRef& image) {
  if (is(image, ImageKind::window)) return "the window";
  std::string part = image.level > 0 ? fmt::format("level {}", image.level) : "";
  if (const std::string layer = layerWords(image); !layer.empty())
    part += (part.empty() ? "" : ", ") + layer;
  return fmt::format("{}{}a {}", part, part.empty() ? "" : " of ", kindWord(image));
}

std::string_view verb(const PassRecord& pass) {
  switch (static_cast<PassKind>(pass.kind)) {
  case PassKind::blit:
    return "blits into ";
  case PassKind::copy:
    return "copies into ";
  case PassKind::mipmap:
    return "makes the mipmaps of ";
  case PassKind::imageStore:
    return "stores from a shader into ";
  default:
    return pass.draws == 0 && pass.cleared != 0 ? "clears " : "draws into ";
  }
}

/// ", with depth renderbuffer and stencil renderbuffer"; one image that is both is named once.
std::string besides(const PassRecord& pass) {
  const ImageRef& depth = pass.images[kDepth];
  const ImageRef& stencil = pass.images[kStencil];
  const bool hasDepth = !is(depth, ImageKind::none), hasStencil = !is(stencil, ImageKind::none);
  if (hasDepth && hasStencil && sameImage(depth, stencil))
    return fmt::format(", with depth and stencil {}", kindWord(depth));
  std::string text;
  if (hasDepth) text = fmt::format(", with depth {}", kindWord(depth));
  if (hasStencil)
    text += fmt::format("{} stencil {}", hasDepth ? " and" : ", with", kindWord(stencil));
  return text;
}

std::string onOff(std::uint32_t value) {
  return value ? "on" : "off";
}

std::string blendWords(const StepRecord& step) {
  if (!step.blend) return "off";
  const auto equation = [](std::uint32_t source, std::uint32_t destination, std::uint32_t how) {
    return fmt::format("{} x source {} {} x destination", glName(source),
                       how == GL_FUNC_ADD ? "+" : glName(how), glName(destination));
  };
  std::string text = equation(step.blendSource, step.blendDestination, step.blendEquation);
  if (step.blendSource != step.blendSourceAlpha ||
      step.blendDestination != step.blendDestinationAlpha ||
      step.blendEquation != step.blendEquationAlpha)
    text += "; alpha: " +
            equation(step.blendSourceAlpha, step.blendDestinationAlpha, step.blendEquationAlpha);
  return text;
}

std::string faceWords(const StencilFace& face) {
  return fmt::format(
      "{} {}{}{}; fail {}, depth fail {}, pass {}", glName(face.func), face.ref,
      (face.valueMask & 0xff) == 0xff ? "" : fmt::format(" & 0x{:02x}", face.valueMask & 0xff),
      (face.writeMask & 0xff) == 0xff ? ""
                                      : fmt::format(", writes 0x{:02x}", face.writeMask & 0xff),
      glName(face.fail), glName(face.depthFail), glName(face.depthPass));
}

std::string stencilWords(const StepRecord& step) {
  if (!step.stencilTest) return "off";
  const std::string front = faceWords(step.stencil[0]), back = faceWords(step.stencil[1]);
  return front == back ? front : "front " + front + "; back " + back;
}

std::string rectangle(const std::int32_t (&box)[4]) {
  return fmt::format("{} x {} at ({}, {})", box[2], box[3], box[0], box[1]);
}

std::string clipWords(std::uint32_t mask) {
  std::string text;
  for (std::uint32_t i = 0; i < 32; ++i)
    if (mask >> i & 1) text += fmt::format("{}{}", text.empty() ? "" : ", ", i);
  return text.empty() ? "none" : text;
}

std::string maskWords(std::uint32_t mask) {
  std::string text;
  for (int i = 0; i < 4; ++i)
    if (mask >> i & 1) text += "RGBA"[i];
  return text.empty() ? "nothing" : text;
}

} // namespace

std::string shortest(float value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string byteWords(std::uint64_t bytes) {
  if (bytes < 1000) return fmt::format("{} bytes", bytes);
  if (bytes < 1000'000) return fmt::format("{:.1f} kB", double(bytes) / 1e3);
  return fmt::format("{:.1f} MB", double(bytes) / 1e6);
}

std::string grouped(std::uint64_t value) {
  std::string text = std::to_string(value);
  for (int at = int(text.size()) - 3; at > 0; at -= 3) text.insert(std::size_t(at), ",");
  return text;
}

std::string counted(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", grouped(count), noun, count == 1 ? "" : "s");
}

std::string attachmentWords(const PassRecord& pass, std::uint32_t attachment) {
  if (attachment == kNone) return "picture";
  const auto colours = std::count_if(pass.images, pass.images + kColors, [](const ImageRef& image) {
    return !is(image, ImageKind::none);
  });
  if (attachment >= kColors) return attachmentName(attachment);
  return colours == 1 ? "colour" : fmt::format("colour {}", attachment);
}

std::string imageWords(const ImageRef& image) {
  if (is(image, ImageKind::none)) return "nothing";
  if (is(image, ImageKind::window)) return "window";
  std::string text = fmt::format("{} {}", kindWord(image), image.name);
  if (image.level > 0) text += fmt::format(", level {}", image.level);
  if (const std::string layer = layerWords(image); !layer.empty()) text += ", " + layer;
  return text;
}

std::string sizeWords(const ImageRef& image) {
  std::string text = fmt::format("{} x {}", image.width, image.height);
  if (image.samples > 1) text += fmt::format(", {} samples", image.samples);
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
    return "tries to draw into an incomplete framebuffer";
  const std::vector<std::uint32_t> targets = mainAttachments(pass);
  if (targets.empty()) return std::string(verb(pass)) + "nothing";
  const ImageRef& image = pass.images[targets[0]];
  if (targets[0] >= kColors) {
    const bool both = targets.size() > 1;
    return fmt::format("{}{}, {} only, {} {}", verb(pass), place(image),
                       both ? "depth and stencil" : attachmentName(targets[0]), sizeWords(image),
                       glName(image.format));
  }
  std::string text(verb(pass));
  const bool same = std::ranges::all_of(
      targets, [&](std::uint32_t target) { return pass.images[target].format == image.format; });
  if (targets.size() == 1) {
    text += place(image);
  } else {
    text += fmt::format("{} images", targets.size());
  }
  text += ", " + sizeWords(image);
  if (!is(image, ImageKind::window)) text += same ? " " + glName(image.format) : ", formats differ";
  return is(image, ImageKind::window) ? text : text + besides(pass);
}

std::string statusMeaning(std::uint32_t status) {
  switch (status) {
  case GL_FRAMEBUFFER_COMPLETE:
    return "";
  case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
    return "An attachment can't be drawn into: its image was deleted, has no size, or has a format "
           "that doesn't suit the attachment point (a colour format as depth, for example).";
  case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
    return "Nothing is attached to the framebuffer.";
  case GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER:
    return "glDrawBuffers names a colour attachment that has no image.";
  case GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER:
    return "glReadBuffer names a colour attachment that has no image: for a framebuffer without "
           "colour, call glReadBuffer(GL_NONE).";
  case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
    return "The attachments have different numbers of samples.";
  case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
    return "Some attachments are layered and others are not.";
  case GL_FRAMEBUFFER_UNSUPPORTED:
    return "This combination of formats isn't supported by the renderer.";
  default:
    return "Every draw into it is an error and has no effect.";
  }
}

std::vector<StateWord> stateWords(const StepRecord& step) {
  return {
      {"program", step.program ? std::to_string(step.program) : "none"},
      {"viewport", rectangle(step.viewport)},
      {"depth test", step.depthTest ? glName(step.depthTest) : "off"},
      {"depth write", step.depthTest ? onOff(step.depthWrite)
                                     : onOff(step.depthWrite) + " (no effect: the test is off)"},
      {"depth clamp", onOff(step.depthClamp)},
      {"polygon offset",
       step.polygonOffset ? fmt::format("factor {}, units {}", shortest(step.polygonOffsetFactor),
                                        shortest(step.polygonOffsetUnits))
                          : "off"},
      {"culling", step.cullFace ? fmt::format("{} faces, front is {}", glName(step.cullFace),
                                              glName(step.frontFace))
                                : "off"},
      {"blending", blendWords(step)},
      {"stencil test", stencilWords(step)},
      {"colour mask", maskWords(step.colorMask)},
      {"scissor", step.scissorTest ? rectangle(step.scissor) : "off"},
      {"clip distances", clipWords(step.clipDistances)},
      {"sRGB encoding", onOff(step.framebufferSrgb)},
      {"rasterizer", step.rasterizerDiscard ? "discards everything" : "on"},
  };
}

std::string samplerWords(const SampleRecord& sample) {
  std::string text =
      sample.minFilter == sample.magFilter
          ? glName(sample.magFilter)
          : fmt::format("{} (far {})", glName(sample.magFilter), glName(sample.minFilter));
  text += ", " + glName(sample.wrapS);
  if (sample.wrapT != sample.wrapS) text += " / " + glName(sample.wrapT);
  if (sample.compareMode == GL_COMPARE_REF_TO_TEXTURE)
    text += ", compares " + glName(sample.compareFunc);
  if (sample.sampler) text += fmt::format(", by sampler object {}", sample.sampler);
  return text;
}

std::string readWords(const FrameGraph& graph, const PassRead& read) {
  return fmt::format("pass {}'s {}", graph.number(read.writer),
                     attachmentWords(graph.pass(read.writer), read.attachment));
}

} // namespace ggrade::report
