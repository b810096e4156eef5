#include "report/reveal.hpp"

#include "words/words.hpp"

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

bool isPublicScene(const results::Result& result, std::string_view name) {
  return std::any_of(result.scenes.begin(), result.scenes.end(),
                     [&](const results::Scene& s) { return s.isPublic && s.name == name; });
}

// Is the message about the public scene? It begins with the scene that lost most (see
// rubric::decide), and no message of a hidden scene begins with the public one's name.
bool speaksOfPublicScene(const results::Item& item) {
  return std::any_of(item.credits.begin(), item.credits.end(), [&](const auto& credit) {
    return credit.credit < 1 && credit.isPublic && item.message.starts_with(credit.scene + ": ");
  });
}

// Could what was seen have been seen in a hidden scene? Without credits nobody can tell.
bool speaksOfHiddenScene(const results::Item& item) {
  if (speaksOfPublicScene(item)) return false;
  return item.credits.empty() ||
         std::any_of(item.credits.begin(), item.credits.end(),
                     [&](const auto& credit) { return credit.credit < 1 && !credit.isPublic; });
}

// The name in the catalogue is the instructor's at every level.
results::Diagnosis reduced(results::Diagnosis diagnosis, const results::Result& result,
                           Reveal reveal) {
  diagnosis.id.clear();
  if (reveal != Reveal::details && !isPublicScene(result, diagnosis.scene)) diagnosis.place.clear();
  return diagnosis;
}

results::Item reduced(results::Item item, Reveal reveal) {
  if (reveal == Reveal::none) {
    for (std::string* text : {&item.message, &item.where, &item.cause, &item.step}) text->clear();
    item.credits.clear();
  } else if (reveal == Reveal::names && speaksOfHiddenScene(item)) {
    item.message = withholdPositions(item.message);
    item.where.clear();
  }
  return item;
}

results::Scene reduced(const results::Scene& scene, Reveal reveal, bool pictures) {
  results::Scene view;
  view.name = scene.name;
  view.isPublic = scene.isPublic;
  view.outcome = scene.outcome;
  if (scene.isPublic) view.output = scene.output;
  if (!scene.isPublic && reveal != Reveal::details) return view;
  view.detail = scene.detail;
  view.messages = scene.messages;
  if (pictures) view.frames = scene.frames;
  return view;
}

// The evidence of a failed run may quote the program. It stays when it comes from before any scene
// was drawn, or when the same happened in the public scene and no hidden scene's evidence stands in
// it.
bool detailIsPublic(const results::Result& result) {
  if (result.outcome == results::Outcome::graded || result.outcome == results::Outcome::buildFailed)
    return true;
  bool seenInPublic = result.scenes.empty();
  std::string shown;
  for (const results::Scene& scene : result.scenes) {
    if (!scene.isPublic) continue;
    seenInPublic = seenInPublic || scene.outcome == name(result.outcome);
    shown += scene.detail;
  }
  const bool quotesHidden = std::ranges::any_of(result.scenes, [&](const results::Scene& scene) {
    return !scene.isPublic && !scene.detail.empty() &&
           result.detail.find(scene.detail) != std::string::npos &&
           shown.find(scene.detail) == std::string::npos;
  });
  return seenInPublic && !quotesHidden;
}

bool namesHiddenScene(const results::Result& result, std::string_view text) {
  return std::any_of(result.scenes.begin(), result.scenes.end(), [&](const results::Scene& scene) {
    return !scene.isPublic && !scene.name.empty() &&
           text.find(scene.name) != std::string_view::npos;
  });
}

std::string shownDetail(const results::Result& result, Reveal reveal) {
  if (reveal == Reveal::details) return result.detail;
  const bool named = reveal == Reveal::none && namesHiddenScene(result, result.detail);
  if (named || !detailIsPublic(result)) return gg::say("This happened in a hidden scene.");
  return withholdPositions(result.detail);
}

} // namespace

std::string_view name(Reveal reveal) {
  switch (reveal) {
  case Reveal::none:
    return "none";
  case Reveal::names:
    return "names";
  case Reveal::details:
    break;
  }
  return "details";
}

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
      out += gg::words("(position withheld)");
      i = end;
    } else {
      out += message[i++];
    }
  }
  return out;
}

results::Result studentView(const results::Result& result, Reveal reveal, bool pictures) {
  // Field by field: what is added to Result later stays hidden until someone decides otherwise.
  results::Result view;
  view.assignment = result.assignment;
  view.part = result.part;
  view.title = result.title;
  view.submission = result.submission;
  view.outcome = result.outcome;
  view.detail = shownDetail(result, reveal);
  view.score = result.score;
  view.bonus = result.bonus;
  view.maxScore = result.maxScore;
  for (const results::Item& item : result.items) view.items.push_back(reduced(item, reveal));
  // Without a scene it says no more than the outcome.
  for (const results::Diagnosis& diagnosis : result.diagnoses)
    if (reveal != Reveal::none || diagnosis.scene.empty())
      view.diagnoses.push_back(reduced(diagnosis, result, reveal));
  for (const results::Scene& scene : result.scenes)
    if (scene.isPublic || reveal != Reveal::none)
      view.scenes.push_back(reduced(scene, reveal, pictures));
  view.compilerOutput = result.compilerOutput;
  view.unusedFiles = result.unusedFiles;
  view.thresholds = result.thresholds;
  view.sandbox = result.sandbox;
  view.fingerprint = result.fingerprint;
  return view;
}

} // namespace ggrade::report
