#include "grading/diagnoser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace ggrade::grading {

namespace fs = std::filesystem;
using diagnosis::Generic;
using diagnosis::Identified;
using diagnosis::Likeness;
using diagnosis::Run;
using diagnosis::SceneViews;

namespace {

/// So many of the likeliest signatures are rendered in every scene...
constexpr std::size_t kFinalists = 8;
/// ... of those that are at least so like in the first.
constexpr double kFinalist = 0.5;

bool intersect(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return std::ranges::any_of(
      a, [&](const std::string& one) { return std::ranges::find(b, one) != b.end(); });
}

double best(const Likeness& like) {
  return std::max({like.all, like.windows, like.first});
}

const char* nameOf(Generic::Kind kind) {
  static constexpr std::array kNames = {"other_size",    "black",       "constant",
                                        "stub",          "last_frame",  "upside_down",
                                        "mirrored",      "turned",      "red_and_blue_swapped",
                                        "encoded_twice", "not_encoded", "shifted",
                                        "scaled"};
  return kNames.at(std::size_t(kind));
}

bool isOneColour(Generic::Kind kind) {
  return kind == Generic::Kind::black || kind == Generic::Kind::constant;
}

bool isStep(const std::string& name) {
  return name.starts_with("step.");
}

} // namespace

Diagnoser::Diagnoser(const Target& target, const Part& part, const fs::path& solutionFolder,
                     const References& references, Progress progress,
                     std::optional<std::set<std::string>> only)
    : target_(target), part_(part), solutionFolder_(solutionFolder), references_(references),
      progress_(std::move(progress)), only_(std::move(only)),
      catalogue_(loadCatalogue(target.assignment, part, solutionFolder, solutionFolder)) {}

const SceneViews& Diagnoser::reference(std::size_t scene) {
  const auto [entry, fresh] = referenceViews_.try_emplace(scene);
  if (fresh) entry->second = viewsIn(references_.scenes[scene].reference);
  return entry->second;
}

std::vector<std::size_t> Diagnoser::scenesOf(const std::vector<std::string>& items,
                                             bool changed) const {
  std::vector<std::size_t> scenes;
  for (std::size_t i = 0; i < references_.scenes.size(); ++i)
    if (references_.scenes[i].like.empty() != changed &&
        std::ranges::any_of(part_.items, [&](const ItemDeclaration& item) {
          return std::ranges::find(items, item.id) != items.end() &&
                 (item.scenes.empty() || intersect(item.scenes, references_.scenes[i].tags));
        }))
      scenes.push_back(i);
  return scenes;
}

std::vector<Candidate> Diagnoser::steps() const {
  std::vector<Candidate> all;
  std::set<std::string> filled;
  for (const Part& part : target_.assignment.parts)
    if (part.id != part_.id)
      for (const Todo& todo : part.todos) filled.insert(todo.id);
  for (std::size_t k = 0; k < part_.todos.size() && !part_.todos[k].bonus; ++k) {
    all.push_back({fmt::format("step.{}", k), "", {solutionFolder_, {}, filled}});
    filled.insert(part_.todos[k].id);
  }
  return all;
}

Candidate Diagnoser::candidateOf(const Mistake& mistake) const {
  return {mistake.name,
          mistake.same.empty() ? mistake.name : mistake.same,
          {solutionFolder_, {mistake.patch}}};
}

std::vector<Candidate> Diagnoser::suspects(const std::vector<std::string>& lost,
                                           const std::set<std::string>& leftOut) const {
  // The program up to each step: what isn't there yet is no mistake.
  std::vector<Candidate> all = steps();
  for (const Mistake& mistake : catalogue_.mistakes) {
    const bool shows =
        mistake.outcome == results::Outcome::graded || mistake.outcome == results::Outcome::glError;
    // A bonus is never lost, and yet a mistake in it may cost points elsewhere.
    const auto fails = std::ranges::find(part_.items, mistake.fails, &ItemDeclaration::id);
    const bool bonus = fails != part_.items.end() && fails->kind == results::ItemKind::bonus;
    if (shows && !leftOut.count(mistake.name) &&
        (bonus || std::ranges::find(lost, mistake.fails) != lost.end()))
      all.push_back(candidateOf(mistake));
  }
  if (only_) std::erase_if(all, [&](const Candidate& one) { return !only_->count(one.name); });
  return all;
}

std::vector<diagnosis::Signature> Diagnoser::signaturesOf(const std::vector<Candidate>& programs,
                                                          const std::vector<std::size_t>& scenes) {
  const auto views = [this](std::size_t scene) -> const SceneViews& { return reference(scene); };
  return renderSignatures(target_, solutionFolder_, programs, scenes, references_, views,
                          progress_);
}

bool Diagnoser::showTheSame(const std::string& a, const std::string& b,
                            const std::vector<std::string>& lost) {
  std::vector<Candidate> both;
  for (const std::string& name : {a, b}) {
    if (const Mistake* mistake = catalogue_.mistake(name)) both.push_back(candidateOf(*mistake));
    for (Candidate& step : steps())
      if (step.name == name) both.push_back(std::move(step));
  }
  if (both.size() != 2) return false;
  const std::vector<std::size_t> scenes = scenesOf(lost, false);
  Run right;
  for (const std::size_t scene : scenes) right.push_back(reference(scene));
  const auto signatures = signaturesOf(both, scenes);
  return likeness(signatures[0].run, signatures[1].run, right).all >= diagnosis::Thresholds{}.same;
}

std::optional<Cause> Diagnoser::known(const std::vector<Candidate>& suspects,
                                      const std::vector<std::size_t>& scenes, const Run& student,
                                      double least) {
  // The scene in which most is wrong: the public one if it can, because it is the same with every
  // seed.
  std::size_t telling = 0;
  double most = 0;
  Run all;
  for (const std::size_t scene : scenes) all.push_back(reference(scene));
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto wrong = diagnosis::firstWrong({student[i]}, {all[i]}, least);
    if (wrong && references_.scenes[scenes[i]].isPublic) {
      telling = i;
      break;
    }
    if (wrong && wrong->share > most) {
      most = wrong->share;
      telling = i;
    }
  }
  std::vector<std::pair<double, std::size_t>> ranked;
  const auto first = signaturesOf(suspects, {scenes[telling]});
  for (std::size_t i = 0; i < first.size(); ++i)
    if (const double like = best(likeness({student[telling]}, first[i].run, {all[telling]}));
        like >= kFinalist)
      ranked.emplace_back(-like, i);
  std::ranges::sort(ranked);
  std::vector<Candidate> finalists;
  for (const auto& [like, i] : ranked) {
    // Those that are as like as the last one taken are not dropped by chance.
    if (finalists.size() >= kFinalists && like > ranked[kFinalists - 1].first + 0.01) break;
    finalists.push_back(suspects[i]);
  }
  if (finalists.empty()) return std::nullopt;
  diagnosis::KnownFaults faults{all, signaturesOf(finalists, scenes)};
  const auto found = faults.identify(student);
  if (!found) return std::nullopt;
  Cause cause;
  cause.id = faults.signatures[found->signature].name;
  for (const std::size_t i : found->alike) cause.alike.push_back(faults.signatures[i].name);
  // Where an unfinished program shows the very same, that is likelier than a mistake.
  if (!isStep(cause.id))
    if (const auto step = std::ranges::find_if(cause.alike, isStep); step != cause.alike.end())
      std::swap(*step, cause.id);
  cause.by = found->by;
  cause.confidence = found->confidence;
  return cause;
}

std::optional<Cause> Diagnoser::changed(const std::vector<std::size_t>& scenes, const Run& student,
                                        const Shown& shown,
                                        const std::optional<diagnosis::FirstWrong>& first) {
  Cause cause;
  if (first && first->slot && !first->missing) {
    std::vector<diagnosis::Pair> pairs;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const auto* ours = student[i].find(*first->slot);
      const auto* theirs = reference(scenes[i]).find(*first->slot);
      if (ours && theirs) pairs.push_back({&ours->picture, &theirs->picture, nullptr, nullptr});
    }
    // Sizes of passes are the program's own business.
    std::vector<Image> fitted;
    fitted.reserve(pairs.size());
    for (diagnosis::Pair& pair : pairs) {
      fitted.push_back(
          diagnosis::resized(*pair.student, pair.reference->width(), pair.reference->height()));
      pair.student = &fitted.back();
    }
    if (const auto change = diagnosis::generic(pairs);
        change && change->kind != Generic::Kind::shifted &&
        // A level that is black for a while may be cleared: another way to a right picture.
        (first->slot->mesh || !isOneColour(change->kind))) {
      cause.generic = change;
      cause.of = first->slot;
    }
  }
  if (!cause.generic) {
    std::vector<std::vector<Image>> ours, theirs, stubs;
    std::vector<diagnosis::Pair> pairs;
    for (const std::size_t scene : scenes) {
      ours.push_back(shown.frames(scene));
      theirs.push_back(framesIn(references_.scenes[scene].reference));
      stubs.push_back(framesIn(references_.scenes[scene].stub));
      for (std::size_t i = 0; i < theirs.back().size(); ++i) {
        if (i >= ours.back().size()) return std::nullopt;
        pairs.push_back({&ours.back()[i], &theirs.back()[i],
                         i > 0 ? &theirs.back()[i - 1] : nullptr,
                         i < stubs.back().size() ? &stubs.back()[i] : nullptr});
      }
    }
    cause.generic = diagnosis::generic(pairs);
  }
  if (!cause.generic) return std::nullopt;
  cause.id = nameOf(cause.generic->kind);
  cause.confidence = cause.generic->likeness;
  return cause;
}

Cause Diagnoser::causeOf(const std::vector<std::string>& lost, const Shown& shown,
                         const std::set<std::string>& leftOut) {
  Cause cause;
  // Scenes that are a change of another tell nothing new, unless only the change is wrong.
  for (const bool changes : {false, true}) {
    const std::vector<std::size_t> scenes = scenesOf(lost, changes);
    Run student, right;
    for (const std::size_t scene : scenes) {
      student.push_back(shown.views(scene));
      right.push_back(reference(scene));
    }
    // Where so little differs that it may be nothing, only what is known can be named.
    double least = diagnosis::kWrongShare;
    auto first = diagnosis::firstWrong(student, right, least);
    const bool faint = !first;
    if (faint) {
      least = diagnosis::kFaintShare;
      first = diagnosis::firstWrong(student, right, least);
    }
    if (!first) continue;
    if (auto found = known(suspects(lost, leftOut), scenes, student, least))
      cause = std::move(*found);
    else if (faint)
      continue;
    else if (auto change = changed(scenes, student, shown, first))
      cause = std::move(*change);
    first->scene = scenes[first->scene];
    // A place in the public scene helps more than one that nobody may see.
    for (std::size_t i = 0; i < scenes.size(); ++i)
      if (references_.scenes[scenes[i]].isPublic && first->scene != scenes[i])
        if (auto there = diagnosis::firstWrong({student[i]}, {right[i]});
            there && there->slot == first->slot) {
          first = there;
          first->scene = scenes[i];
        }
    cause.first = first;
    break;
  }
  return cause;
}

} // namespace ggrade::grading
