#include "diagnosis/state.hpp"

#include "words/words.hpp"

#include <GL/glcorearb.h>

#include <algorithm>

namespace ggrade::diagnosis {

using gg::say;
using trace::PassRecord;
using trace::StepRecord;

namespace {

bool isWindow(const PassRecord& pass) {
  return pass.framebuffer == 0 && pass.kind == std::uint32_t(trace::PassKind::draw);
}

/// The steps that draw to the window.
std::vector<StepRecord> windowSteps(const trace::Trace& trace, std::size_t frame) {
  std::vector<StepRecord> steps;
  for (const PassRecord& pass : trace.passesOf(frame))
    if (isWindow(pass))
      for (const StepRecord& step : trace.stepsOf(pass))
        if (step.draws > 0) steps.push_back(step);
  return steps;
}

bool nothingPasses(const StepRecord& step) {
  return step.depthTest == GL_NEVER;
}

bool blendsToNothing(const StepRecord& step) {
  return step.blend && step.blendSource == GL_ZERO &&
         (step.blendDestination == GL_ZERO || step.blendDestination == GL_ONE);
}

bool isEmptyScissor(const StepRecord& step) {
  return step.scissorTest && (step.scissor[2] <= 0 || step.scissor[3] <= 0);
}

} // namespace

std::vector<std::string> stateFaults(const trace::Trace& trace) {
  std::vector<std::string> found;
  const auto add = [&](std::string text) {
    if (std::ranges::find(found, text) == found.end()) found.push_back(std::move(text));
  };
  for (std::size_t frame = 0; frame < trace.frames.size(); ++frame) {
    const std::vector<StepRecord> steps = windowSteps(trace, frame);
    const auto all = [&](auto holds) {
      return !steps.empty() && std::ranges::all_of(steps, holds);
    };
    const auto any = [&](auto holds) { return std::ranges::any_of(steps, holds); };
    if (any([](const StepRecord& step) { return step.program == 0; }))
      add(say("Something is drawn while no program is in use, which draws nothing: call use() (or "
              "glUseProgram) before it."));
    if (all([](const StepRecord& step) { return step.colorMask == 0; }))
      add(say(
          "No colour is written: glColorMask is closed while the window is drawn. Open it again "
          "with GL_TRUE."));
    if (any(isEmptyScissor))
      add(say("The scissor test is on and its rectangle is empty, so nothing is drawn: disable "
              "GL_SCISSOR_TEST."));
    if (any(nothingPasses))
      add(say(
          "The depth test lets nothing pass: glDepthFunc is GL_NEVER. The usual one is GL_LESS."));
    if (all(blendsToNothing))
      add(say(
          "Blending is on with a factor of GL_ZERO for what is drawn, so nothing of it arrives: "
          "disable GL_BLEND, or set glBlendFunc."));
    if (any([](const StepRecord& step) { return step.cullFace == GL_FRONT_AND_BACK; }))
      add(say("Front and back faces are culled, so no triangle is drawn: glCullFace(GL_BACK)."));
    if (any([](const StepRecord& step) { return step.viewport[2] <= 0 || step.viewport[3] <= 0; }))
      add(say("The viewport is empty: call glViewport with the window's size."));
    if (any([](const StepRecord& step) { return step.depthTest != 0; }) &&
        std::ranges::none_of(
            steps, [](const StepRecord& step) { return step.depthTest && step.depthWrite; }))
      add(say(
          "The depth test is on, but nothing writes depth: glDepthMask is GL_FALSE. Then what is "
          "drawn later hides what is nearer, and clearing the depth does nothing."));
    bool drawn = false;
    for (const PassRecord& pass : trace.passesOf(frame)) {
      if (!isWindow(pass)) continue;
      const bool depthCleared = pass.cleared >> trace::kDepth & 1;
      if (pass.draws > 0 && depthCleared && pass.clearDepth <= 0 && any([](const StepRecord& step) {
            return step.depthTest == GL_LESS || step.depthTest == GL_LEQUAL;
          }))
        add(say("The depth buffer is cleared to 0, the nearest there is, so everything lies behind "
                "it: glClearDepth(1)."));
      if (drawn && pass.draws == 0 && (pass.cleared & 1))
        add(say("The window is cleared after the last draw, so the picture is gone before it is "
                "shown: clear at the start of the frame."));
      drawn = drawn || pass.draws > 0;
    }
  }
  return found;
}

std::set<std::string> samplersWithTexture(const trace::Trace& trace) {
  std::set<std::string> names;
  if (trace.frames.empty()) return names;
  for (const PassRecord& pass : trace.passesOf(0))
    for (const StepRecord& step : trace.stepsOf(pass))
      for (const trace::SampleRecord& sample : trace.samplesOf(step))
        if (sample.image.name != 0) names.insert(sample.uniform);
  return names;
}

} // namespace ggrade::diagnosis
