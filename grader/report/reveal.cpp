#include "report/reveal.hpp"

#include <algorithm>

namespace ggrade::report {
namespace {

// The end of a bracketed tuple of at least two numbers that starts at `at`; `at` when none does.
std::size_t tupleEnd(std::string_view text, std::size_t at) {
  if (text[at] != '(' && text[at] != '[') return at;
  const char close = text[at] == '(' ? ')' : ']';
  bool comma = false, digit = false;
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    const char c = text[i];
    if (c == close) return comma && digit ? i + 1 : at;
    comma = comma || c == ',';
    digit = digit || (c >= '0' && c <= '9');
    const bool part =
        (c >= '0' && c <= '9') || std::string_view(" ,.+-exy=").find(c) != std::string_view::npos;
    if (!part) return at;
  }
  return at;
}

bool isPublicScene(const Result& result, std::string_view name) {
  return std::any_of(result.scenes.begin(), result.scenes.end(),
                     [&](const Scene& s) { return s.isPublic && s.name == name; });
}

// Could what was seen have been seen in a hidden scene? Without credits nobody can tell.
bool speaksOfHiddenScene(const Result& result, const Item& item) {
  return item.credits.empty() ||
         std::any_of(item.credits.begin(), item.credits.end(), [&](const auto& credit) {
           return credit.second < 1 && !isPublicScene(result, credit.first);
         });
}

void reduce(Item& item, const Result& result, Reveal reveal) {
  if (reveal == Reveal::none) {
    for (std::string* text : {&item.message, &item.where, &item.cause, &item.step}) text->clear();
    item.credits.clear();
  } else if (reveal == Reveal::names && speaksOfHiddenScene(result, item)) {
    item.message = withholdPositions(item.message);
    item.where.clear();
  }
}

void reduceHidden(Scene& scene, Reveal reveal) {
  scene.output.clear();
  scene.seconds = 0;
  if (reveal == Reveal::details) return;
  scene.detail.clear();
  scene.messages.clear();
  scene.frames.clear();
}

// The evidence of a failed run may quote the program. It stays when the same happened in the public
// scene, or before any scene was drawn.
bool detailIsPublic(const Result& result) {
  if (result.outcome == Outcome::graded || result.outcome == Outcome::buildFailed) return true;
  return result.scenes.empty() ||
         std::any_of(result.scenes.begin(), result.scenes.end(), [&](const Scene& scene) {
           return scene.isPublic && scene.outcome == name(result.outcome);
         });
}

bool namesHiddenScene(const Result& result, std::string_view text) {
  return std::any_of(result.scenes.begin(), result.scenes.end(), [&](const Scene& scene) {
    return !scene.isPublic && !scene.name.empty() &&
           text.find(scene.name) != std::string_view::npos;
  });
}

} // namespace

std::optional<Reveal> parseReveal(std::string_view word) {
  if (word == "none") return Reveal::none;
  if (word == "names") return Reveal::names;
  if (word == "details") return Reveal::details;
  return std::nullopt;
}

std::string withholdPositions(std::string_view message) {
  std::string out;
  for (std::size_t i = 0; i < message.size();) {
    const std::size_t end = tupleEnd(message, i);
    if (end > i) {
      out += "(position withheld)";
      i = end;
    } else {
      out += message[i++];
    }
  }
  return out;
}

Result studentView(const Result& result, Reveal reveal) {
  Result view = result;
  view.seed = 0;
  view.timings.clear();
  for (Item& item : view.items) reduce(item, result, reveal);
  for (Scene& scene : view.scenes)
    if (!scene.isPublic) reduceHidden(scene, reveal);
  if (reveal == Reveal::none)
    std::erase_if(view.scenes, [](const Scene& scene) { return !scene.isPublic; });
  if (reveal != Reveal::details) {
    view.detail = withholdPositions(view.detail);
    const bool named = reveal == Reveal::none && namesHiddenScene(result, view.detail);
    if (named || !detailIsPublic(result)) {
      view.detail = "It went well in the public scene; this happened in a hidden one.";
    }
  }
  return view;
}

} // namespace ggrade::report
