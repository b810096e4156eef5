#include "trace/trace.hpp"

#include <charconv>
#include <cmath>

namespace ggrade::trace {

using nlohmann::json;

namespace {

/// A float with as few digits as tell it from its neighbours; null for NaN and Inf.
json number(float value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  double shortest = 0;
  if (!std::isfinite(value) || std::from_chars(text, end, shortest).ec != std::errc()) return {};
  return shortest;
}

template <std::size_t size> json numbers(const float (&values)[size]) {
  json list = json::array();
  for (const float value : values) list.push_back(number(value));
  return list;
}

json orNull(std::uint32_t value) {
  return value == kNone ? json() : json(value);
}

/// Null for 0, which says that the feature is off.
json nameOrNull(std::uint32_t value) {
  return value == 0 ? json() : json(glName(value));
}

json attachmentNames(std::uint32_t mask) {
  json names = json::array();
  for (std::uint32_t i = 0; i < kAttachments; ++i)
    if (mask >> i & 1U) names.push_back(attachmentName(i));
  return names;
}

const char* kindName(PassKind kind) {
  switch (kind) {
  case PassKind::draw:
    return "draw";
  case PassKind::blit:
    return "blit";
  case PassKind::copy:
    return "copy";
  case PassKind::mipmap:
    return "mipmap";
  case PassKind::imageStore:
    return "image_store";
  }
  return "";
}

const char* kindName(ImageKind kind) {
  switch (kind) {
  case ImageKind::none:
    return "none";
  case ImageKind::window:
    return "window";
  case ImageKind::texture:
    return "texture";
  case ImageKind::renderbuffer:
    return "renderbuffer";
  }
  return "";
}

json imageJson(const ImageRef& image) {
  return {{"kind", kindName(static_cast<ImageKind>(image.kind))},
          {"name", image.name},
          {"target", nameOrNull(image.target)},
          {"level", image.level},
          {"layer", orNull(image.layer)},
          {"format", nameOrNull(image.format)},
          {"width", image.width},
          {"height", image.height},
          {"samples", image.samples}};
}

json stencilJson(const StencilFace& face) {
  return {{"func", glName(face.func)},           {"ref", face.ref},
          {"value_mask", face.valueMask},        {"write_mask", face.writeMask},
          {"fail", glName(face.fail)},           {"depth_fail", glName(face.depthFail)},
          {"depth_pass", glName(face.depthPass)}};
}

json blendJson(const StepRecord& step) {
  if (!step.blend) return {};
  return {{"source", glName(step.blendSource)},
          {"destination", glName(step.blendDestination)},
          {"equation", glName(step.blendEquation)},
          {"source_alpha", glName(step.blendSourceAlpha)},
          {"destination_alpha", glName(step.blendDestinationAlpha)},
          {"equation_alpha", glName(step.blendEquationAlpha)},
          {"color", numbers(step.blendColor)}};
}

json sampleJson(const SampleRecord& sample) {
  return {{"uniform", sample.uniform},
          {"unit", sample.unit},
          {"image", imageJson(sample.image)},
          {"written_by", orNull(sample.writer)},
          {"feedback", sample.feedback != 0},
          {"incomplete", sample.incomplete != 0},
          {"sampler", sample.sampler},
          {"min_filter", nameOrNull(sample.minFilter)},
          {"mag_filter", nameOrNull(sample.magFilter)},
          {"wrap_s", nameOrNull(sample.wrapS)},
          {"wrap_t", nameOrNull(sample.wrapT)},
          {"compare", sample.compareMode ? nameOrNull(sample.compareFunc) : json()}};
}

std::string maskLetters(std::uint32_t mask) {
  std::string letters;
  for (std::uint32_t i = 0; i < 4; ++i)
    if (mask >> i & 1U) letters += "rgba"[i];
  return letters;
}

json stepJson(const Trace& trace, const StepRecord& step) {
  json clipDistances = json::array();
  for (std::uint32_t i = 0; i < 32; ++i)
    if (step.clipDistances >> i & 1U) clipDistances.push_back(i);
  json matrices = json::array(), samples = json::array();
  for (const MatrixRecord& matrix : trace.matricesOf(step))
    matrices.push_back(
        {{"draw", matrix.draw}, {"name", matrix.name}, {"values", numbers(matrix.values)}});
  for (const SampleRecord& sample : trace.samplesOf(step)) samples.push_back(sampleJson(sample));
  return {{"program", step.program},
          {"mode", modeName(step.mode)},
          {"draws", step.draws},
          {"vertices", step.vertices},
          {"viewport", step.viewport},
          {"cull_face", nameOrNull(step.cullFace)},
          {"front_face", nameOrNull(step.frontFace)},
          {"depth_test", nameOrNull(step.depthTest)},
          {"depth_write", step.depthWrite != 0},
          {"depth_clamp", step.depthClamp != 0},
          {"blend", blendJson(step)},
          {"stencil", step.stencilTest ? json{{"front", stencilJson(step.stencil[0])},
                                              {"back", stencilJson(step.stencil[1])}}
                                       : json()},
          {"color_mask", maskLetters(step.colorMask)},
          {"scissor", step.scissorTest ? json(step.scissor) : json()},
          {"clip_distances", clipDistances},
          {"polygon_offset", step.polygonOffset ? json{number(step.polygonOffsetFactor),
                                                       number(step.polygonOffsetUnits)}
                                                : json()},
          {"framebuffer_srgb", step.framebufferSrgb != 0},
          {"rasterizer_discard", step.rasterizerDiscard != 0},
          {"matrices", matrices},
          {"samples", samples}};
}

json copyJson(const Trace& trace, const CopyRecord& copy, const CopyFiles& files) {
  json one = {
      {"attachment", attachmentName(copy.attachment)},
      {"step", copy.step == kNone ? json() : json(copy.step - trace.passes[copy.pass].firstStep)},
      {"type", pixelTypeName(static_cast<PixelType>(copy.type))},
      {"width", copy.width},
      {"height", copy.height}};
  if (!files.image.empty()) {
    one["image"] = files.image;
    one["scale"] = files.scale;
    one["low"] = files.low;
    one["high"] = files.high;
  }
  if (!files.raw.empty()) one["raw"] = files.raw;
  return one;
}

json passJson(const Trace& trace, const PassRecord& pass) {
  json attachments = json::object();
  for (std::uint32_t i = 0; i < kAttachments; ++i)
    if (static_cast<ImageKind>(pass.images[i].kind) != ImageKind::none)
      attachments[attachmentName(i)] = imageJson(pass.images[i]);
  json steps = json::array();
  for (const StepRecord& step : trace.stepsOf(pass)) steps.push_back(stepJson(trace, step));
  json one = {{"index", trace.indexOf(pass)},
              {"frame", pass.frame},
              {"kind", kindName(static_cast<PassKind>(pass.kind))},
              {"framebuffer", orNull(pass.framebuffer)},
              {"status", nameOrNull(pass.status)},
              {"attachments", attachments},
              {"draw_buffers", attachmentNames(pass.drawBuffers)},
              {"cleared", attachmentNames(pass.cleared)},
              {"written", attachmentNames(pass.written)},
              {"viewport", pass.viewport},
              {"draws", pass.draws},
              {"vertices", pass.vertices},
              {"steps", steps},
              {"read_by", json::array()},
              {"copies", json::array()}};
  constexpr std::uint32_t kColorMask = (1U << kColors) - 1;
  if (pass.cleared & kColorMask) one["clear_color"] = numbers(pass.clearColor);
  if (pass.cleared >> kDepth & 1U) one["clear_depth"] = number(pass.clearDepth);
  if (pass.cleared >> kStencil & 1U) one["clear_stencil"] = pass.clearStencil;
  if (pass.seconds > 0) one["seconds"] = pass.seconds;
  return one;
}

} // namespace

json toJson(const Trace& trace, const std::vector<CopyFiles>& files) {
  json passes = json::array();
  for (const PassRecord& pass : trace.passes) passes.push_back(passJson(trace, pass));
  for (const PassRecord& pass : trace.passes)
    for (const StepRecord& step : trace.stepsOf(pass))
      for (const SampleRecord& sample : trace.samplesOf(step)) {
        if (sample.writer == kNone) continue;
        json& readers = passes[sample.writer]["read_by"];
        if (readers.empty() || readers.back() != trace.indexOf(pass))
          readers.push_back(trace.indexOf(pass));
      }
  for (std::size_t i = 0; i < trace.copies.size(); ++i)
    passes[trace.copies[i].pass]["copies"].push_back(
        copyJson(trace, trace.copies[i], i < files.size() ? files[i] : CopyFiles{}));
  return {{"passes", passes},
          {"lost",
           {{"passes", trace.passesLost},
            {"steps", trace.stepsLost},
            {"matrices", trace.matricesLost},
            {"samples", trace.samplesLost},
            {"copies", trace.copiesLost}}}};
}

} // namespace ggrade::trace
