#include "diagnosis/proved.hpp"

#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

namespace ggrade::diagnosis {

using gg::say;

namespace {

/// What stands after the word, if the unit begins with it.
bool takes(const std::string& unit, const std::string& word, std::string& rest) {
  if (!unit.starts_with(word + ' ')) return false;
  rest = report::sanitizeLine(unit.substr(word.size() + 1), 80);
  return true;
}

std::string shaderOf(const std::string& stage) {
  return stage == "vertex" ? say("the vertex shader") : say("the fragment shader");
}

bool isShader(const std::string& unit) {
  return std::ranges::any_of(std::array{"function ", "lines ", "shader "},
                             [&](const char* kind) { return unit.starts_with(kind); });
}

/// "5, 6, 7": passes as they are counted for people.
std::string numbersOf(const std::set<std::size_t>& passes) {
  std::vector<std::size_t> numbers;
  for (const std::size_t pass : passes) numbers.push_back(pass + 1);
  return fmt::to_string(fmt::join(numbers, ", "));
}

} // namespace

std::string nameOf(const results::ProvedCause& cause) {
  const std::string& unit = cause.unit;
  std::string rest;
  if (takes(unit, "uniform", rest)) return say("the uniform {}", rest);
  if (takes(unit, "block", rest)) return say("what the uniform block {} holds", rest);
  if (takes(unit, "texture", rest)) return say("what the sampler {} reads", rest);
  if (takes(unit, "sampler", rest)) return say("how the sampler {} filters and wraps", rest);
  if (takes(unit, "attribute", rest)) return say("the vertices' {}", rest);
  if (takes(unit, "shader", rest)) return shaderOf(rest);
  if (takes(unit, "function", rest)) {
    const std::size_t in = rest.rfind(" in ");
    return say("{}() in {}", rest.substr(0, in), shaderOf(rest.substr(in + 4)));
  }
  if (takes(unit, "lines", rest)) {
    const std::size_t of = rest.find(" of "), in = rest.rfind(" in ");
    return say("what stands below TODO({}) in {}() of {}", rest.substr(0, of),
               rest.substr(of + 4, in - of - 4), shaderOf(rest.substr(in + 4)));
  }
  if (unit == "viewport") return say("the viewport");
  if (unit == "culling") return say("which faces are culled");
  if (unit.starts_with("clear")) return say("what is cleared, and to what");
  if (unit == "copy") return say("what is copied, and to where");
  if (unit == "depth") return say("the depth test");
  if (unit == "stencil") return say("the stencil test");
  if (unit == "stencil operations") return say("what is counted in the stencil buffer");
  if (unit == "blend" || unit == "blendColor") return say("the blending");
  if (unit == "colorMask") return say("the colour mask");
  if (unit == "scissor") return say("the scissor test");
  if (unit == "polygonOffset") return say("the polygon offset");
  if (unit == "mesh") return say("the mesh that is drawn");
  if (unit == "program") return say("which program draws");
  if (unit == "framebuffer") return say("which framebuffer is bound");
  if (unit == "attachments") return say("the images that are drawn into");
  if (unit == "storage") return say("the size or format of an image that is drawn into");
  if (unit == "draws") return cause.isUnseen ? say("what isn't drawn yet") : say("what is drawn");
  return unit.starts_with("clipDistance") ? say("the clipping") : say("OpenGL's state {}", unit);
}

namespace {

/// Is all of it work of which nothing is there yet?
bool isToDo(const results::ProvedCause& cause) {
  return !cause.todos.empty() && cause.todos == cause.notBegun;
}

std::string ownOf(const results::ProvedCause& cause) {
  if (cause.own == results::kNoTexture) return say("no texture");
  if (cause.own == results::kDrawnInto) return say("what the same pass draws into");
  return cause.own;
}

} // namespace

std::string sentenceOf(const std::vector<results::ProvedCause>& all) {
  // What is wrong comes before what isn't there.
  std::vector<results::ProvedCause> causes;
  std::set<std::string> toDo;
  std::ranges::copy_if(all, std::back_inserter(causes), std::not_fn(isToDo));
  for (const results::ProvedCause& cause : all)
    if (!causes.empty()) toDo.insert(cause.notBegun.begin(), cause.notBegun.end());
  if (causes.empty()) causes = all;
  // Passes are named once where all causes are in the same.
  const std::set<std::size_t>& passes = causes[0].passes;
  const bool together =
      !passes.empty() && std::ranges::all_of(causes, [&](const results::ProvedCause& cause) {
        return cause.passes == passes;
      });
  const auto named = [&](const results::ProvedCause& cause) {
    const std::string name =
        cause.own.empty() ? nameOf(cause) : say("{} (yours: {})", nameOf(cause), ownOf(cause));
    if (together || cause.passes.empty()) return name;
    return cause.passes.size() == 1 ? say("{} in pass {}", name, *cause.passes.begin() + 1)
                                    : say("{} in the passes {}", name, numbersOf(cause.passes));
  };
  std::vector<std::string> names; // what isn't drawn may be so in several places
  for (const results::ProvedCause& cause : causes)
    if (std::string name = named(cause); std::ranges::find(names, name) == names.end())
      names.push_back(std::move(name));
  std::string list = names[0];
  for (std::size_t i = 1; i < names.size(); ++i)
    list = i + 1 < names.size() ? say("{}, {}", list, names[i]) : say("{} and {}", list, names[i]);
  std::string text =
      !together
          ? say("Proved by drawing it again: with nothing changed but this, all is right: {}.",
                list)
      : passes.size() == 1 ? say("Proved by drawing it again: with nothing changed but this in "
                                 "pass {}, all is right: {}.",
                                 *passes.begin() + 1, list)
                           : say("Proved by drawing it again: with nothing changed but this in "
                                 "the passes {}, all is right: {}.",
                                 numbersOf(passes), list);
  if (std::ranges::all_of(causes, [](const auto& cause) { return cause.todos.empty(); }))
    text += ' ' + (isShader(causes[0].unit)
                       ? say("The handed-out program has it right: a line of it was changed.")
                       : say("The handed-out program has it right: a call of yours changes it, and "
                             "doesn't put it back."));
  if (!toDo.empty())
    text += ' ' + say("What isn't begun yet was put in for this: {}.", fmt::join(toDo, ", "));
  return text;
}

} // namespace ggrade::diagnosis
