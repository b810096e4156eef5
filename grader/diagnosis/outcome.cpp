#include "diagnosis/outcome.hpp"

#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace ggrade::diagnosis {

using gg::say;
using results::Diagnosis;
using results::Outcome;

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
        say("The program crashes. Most often a GL name or a pointer is used that was never "
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
      found.id = "framebuffer_left_bound";
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

} // namespace ggrade::diagnosis
