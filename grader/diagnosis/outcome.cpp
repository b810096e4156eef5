#include "diagnosis/outcome.hpp"

#include "diagnosis/views.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <GL/glcorearb.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace ggrade::diagnosis {

using gg::say;
using results::Diagnosis;
using results::Outcome;
using trace::PassRecord;
using trace::StepRecord;

namespace {

/// A warning and what it means in plain words.
struct Warning {
  std::string_view flag, meaning;
};

constexpr std::array kTelling = {
    Warning{"[-Wcomment]",
            gg::tag("a comment that ends in a backslash goes on in the next line: what "
                    "stands there is not executed")},
    Warning{"[-Wempty-body]",
            gg::tag("the semicolon ends the statement: what follows is not part of it")},
    Warning{"[-Wmisleading-indentation]",
            gg::tag("this line is not part of the statement above it")},
    Warning{"[-Wparentheses]", gg::tag("= where == may be meant, or a dangling else")},
    Warning{"[-Wunused-value]", gg::tag("this computes something and does nothing with it")},
    Warning{"[-Wunused-but-set-variable]", gg::tag("this is set and never used")},
    Warning{"[-Wunused-variable]", gg::tag("this is never used")},
    Warning{"[-Wuninitialized]", gg::tag("this is used before it has a value")},
    Warning{"[-Wmaybe-uninitialized]", gg::tag("this may be used before it has a value")},
    Warning{"[-Wreturn-type]", gg::tag("this function ends without its return value")},
    Warning{"[-Wimplicit-fallthrough=]", gg::tag("this case goes on into the next one")},
    Warning{"[-Wunreachable-code]", gg::tag("this is never reached")},
    Warning{"[-Wbool-compare]", gg::tag("this comparison is always true or always false")},
    Warning{"[-Wtype-limits]", gg::tag("this comparison is always true or always false")},
    Warning{"[-Woverflow]", gg::tag("this number doesn't fit into its type")},
    Warning{"[-Wdiv-by-zero]", gg::tag("this divides by zero")},
};

std::string trimmed(const std::string& line) {
  return report::sanitizeLine(line, 200);
}

bool all(const std::vector<FrameFacts>& frames, bool (*holds)(const FrameFacts&)) {
  return !frames.empty() && std::ranges::all_of(frames, holds);
}

/// A hidden run's messages are not for students.
std::string firstMessage(const results::Result& result) {
  for (const results::Scene& scene : result.scenes)
    if (scene.isPublic)
      for (const std::string& message : scene.messages)
        if (!message.empty()) return trimmed(message);
  return {};
}

bool has(const std::vector<std::string>& warnings, std::string_view flag) {
  return std::ranges::any_of(warnings, [&](const std::string& warning) {
    return warning.find(flag) != std::string::npos;
  });
}

} // namespace

std::vector<std::string> tellingWarnings(const std::string& compilerOutput, std::size_t most) {
  std::vector<std::string> lines, found;
  std::istringstream in(compilerOutput);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  for (const Warning& telling : kTelling) // the most telling ones first
    for (const std::string& line : lines) {
      if (line.find("warning:") == std::string::npos ||
          line.find(telling.flag) == std::string::npos)
        continue;
      const std::string one = fmt::format("{}: {}", trimmed(line), gg::words(telling.meaning));
      if (found.size() < most && std::ranges::find(found, one) == found.end()) found.push_back(one);
    }
  return found;
}

std::optional<Diagnosis> outcomeDiagnosis(const results::Result& result, const Facts& facts) {
  Diagnosis found;
  found.id = results::name(result.outcome);
  found.confidence = 1;
  found.beside = tellingWarnings(result.compilerOutput);
  switch (result.outcome) {
  case Outcome::notGradable:
    return std::nullopt;
  case Outcome::buildFailed:
    found.text =
        say("The program doesn't compile. Begin with the first error: later ones often follow "
            "from it.");
    found.beside.clear();
    return found;
  case Outcome::shaderError:
    found.text =
        say("A shader doesn't compile or link, so nothing can be drawn with it. The line and "
            "the column stand in the message above.");
    return found;
  case Outcome::noFrame:
    found.text = has(found.beside, "-Wcomment")
                     ? say("The program never shows a frame: window.swapBuffers() is not reached, "
                           "and the compiler says that a comment swallows the line after it.")
                     : say("The program never shows a frame: window.swapBuffers() is not reached. "
                           "Look at what ends or skips the loop before it.");
    return found;
  case Outcome::timeout:
    found.text =
        say("The program takes too long. Most often a loop never ends, or something is made "
            "anew in every frame or for every object that should be made once.");
    return found;
  case Outcome::crash:
    found.text =
        facts.endedItself
            ? say("The program ends itself: by an exception that nobody catches, or an exit. What "
                  "it said stands in the message above; look for where that is thrown.")
            : say("The program crashes. Most often a GL name or a pointer is used that was never "
                  "made, or an index lies outside of its array.");
    return found;
  case Outcome::outOfMemory:
    found.text =
        say("The program runs out of memory. Most often textures or buffers are made in every "
            "frame and never deleted, or a size has one digit too many.");
    return found;
  case Outcome::badOutput:
    return std::nullopt;
  case Outcome::graded:
  case Outcome::glError:
    break;
  }
  if (all(facts.frames, [](const FrameFacts& f) { return f.windowDraws == 0; })) {
    found.id = "nothing_drawn_to_the_window";
    if (all(facts.frames, [](const FrameFacts& f) { return f.boundFramebuffer != 0; })) {
      found.id = kLeftBound;
      found.text = say(
          "Nothing reaches the window: framebuffer object {} is still bound where the picture is "
          "drawn and shown. Bind 0 again at the end of the pass that bound it.",
          facts.frames.front().boundFramebuffer);
    } else {
      found.text =
          say("Nothing is drawn to the window: everything goes into framebuffer objects, or "
              "no draw call is reached.");
    }
    return found;
  }
  if (!facts.incomplete.empty()) {
    found.id = "framebuffer_incomplete";
    found.text = say("A framebuffer object is drawn into that is not complete ({}), so "
                     "everything drawn into it is lost. Check glCheckFramebufferStatus "
                     "after you have attached its textures.",
                     facts.incomplete.front());
    return found;
  }
  if (result.outcome != Outcome::glError) return std::nullopt;
  const std::string message = firstMessage(result);
  found.text =
      say("OpenGL reports errors: a call that fails does nothing, so look at the first one.");
  if (!message.empty()) found.beside.insert(found.beside.begin(), message);
  return found;
}

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

/// The steps of a pass that draw more than a quad.
std::vector<StepRecord> meshSteps(const trace::Trace& trace, const PassRecord& pass) {
  std::vector<StepRecord> steps;
  for (const StepRecord& step : trace.stepsOf(pass))
    if (trace::drawsMesh(step)) steps.push_back(step);
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
    for (const PassRecord& pass : trace.passesOf(frame)) {
      const std::vector<StepRecord> meshes = meshSteps(trace, pass);
      if (isWindow(pass) || meshes.empty()) continue;
      const auto depth = trace::ImageKind(pass.images[trace::kDepth].kind);
      if (depth != trace::ImageKind::none &&
          std::ranges::none_of(meshes, [](const StepRecord& step) { return step.depthTest != 0; }))
        add(say("Objects are drawn into framebuffer object {} while the depth test is off: its "
                "depths are neither compared nor written. glEnable(GL_DEPTH_TEST).",
                pass.framebuffer));
      if (std::ranges::all_of(
              meshes, [](const StepRecord& step) { return step.cullFace == GL_FRONT_AND_BACK; }))
        add(say("Front and back faces are culled, so no triangle is drawn: "
                "glCullFace(GL_BACK)."));
    }
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

std::map<std::string, Sampled> sampledTextures(const trace::Trace& trace) {
  std::map<std::string, Sampled> textures;
  if (trace.frames.empty()) return textures;
  for (const PassRecord& pass : trace.passesOf(0))
    for (const StepRecord& step : trace.stepsOf(pass))
      for (const trace::SampleRecord& sample : trace.samplesOf(step))
        if (sample.image.name != 0)
          textures[sample.uniform] = {trace::glName(sample.image.format).starts_with("DEPTH"),
                                      sample.image.width, sample.image.height, sample.sampler != 0,
                                      sample.incomplete == 0};
  return textures;
}

} // namespace ggrade::diagnosis
