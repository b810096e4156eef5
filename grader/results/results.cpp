#include "results/results.hpp"

#include "words/words.hpp"

#include <algorithm>

namespace ggrade::results {
namespace {

template <class Enum> std::optional<Enum> byName(std::string_view word, Enum last) {
  for (int i = 0; i <= int(last); ++i)
    if (name(Enum(i)) == word) return Enum(i);
  return std::nullopt;
}

} // namespace

std::string_view name(Outcome outcome) {
  switch (outcome) {
  case Outcome::graded:
    return "graded";
  case Outcome::buildFailed:
    return "build_failed";
  case Outcome::shaderError:
    return "shader_error";
  case Outcome::glError:
    return "gl_error";
  case Outcome::noFrame:
    return "no_frame";
  case Outcome::timeout:
    return "timeout";
  case Outcome::crash:
    return "crash";
  case Outcome::outOfMemory:
    return "out_of_memory";
  case Outcome::badOutput:
    return "bad_output";
  case Outcome::notGradable:
    return "not_gradable";
  }
  return "not_gradable";
}

std::optional<Outcome> parseOutcome(std::string_view word) {
  return byName(word, Outcome::notGradable);
}

std::string_view name(ItemKind kind) {
  switch (kind) {
  case ItemKind::keep:
    return "keep";
  case ItemKind::bonus:
    return "bonus";
  case ItemKind::gain:
    break;
  }
  return "gain";
}

std::optional<ItemKind> parseItemKind(std::string_view word) {
  return byName(word, ItemKind::bonus);
}

std::string_view explanation(Outcome outcome) {
  switch (outcome) {
  case Outcome::graded:
    return gg::words("Every scene was drawn and judged.");
  case Outcome::buildFailed:
    return gg::words("The program did not compile, so nothing was drawn.");
  case Outcome::shaderError:
    return gg::words("A shader did not compile or link, so its picture is missing.");
  case Outcome::glError:
    return gg::words("Frames came and were scored, but OpenGL reported errors.");
  case Outcome::noFrame:
    return gg::words("The program drew no frame: glfwSwapBuffers was never reached.");
  case Outcome::timeout:
    return gg::words("The program was stopped at its time limit.");
  case Outcome::crash:
    return gg::words("The program crashed.");
  case Outcome::outOfMemory:
    return gg::words("The program was stopped at its memory limit.");
  case Outcome::badOutput:
    return gg::words("The frames that came out cannot be used.");
  case Outcome::notGradable:
    return gg::words(
        "The grader failed, not the submission: no score is given and no attempt is lost.");
  }
  return "";
}

double creditOf(ItemKind kind, const std::vector<SceneCredit>& credits) {
  double worstOfAll = 1, worst = 1, sum = 0;
  std::size_t hidden = 0;
  const bool isShown = !std::ranges::all_of(credits, &SceneCredit::isPublic);
  for (const auto& [scene, credit, isPublic] : credits) {
    worstOfAll = std::min(worstOfAll, credit);
    if (isPublic && isShown) continue;
    worst = std::min(worst, credit);
    sum += credit;
    ++hidden;
  }
  if (hidden == 0 || kind == ItemKind::keep) return worstOfAll;
  return std::min(sum / double(hidden), (1 + worst) / 2);
}

} // namespace ggrade::results
