#include "report/summary.hpp"

#include "report/picture.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ggrade::report {

using gg::say;

namespace {

bool countsForScore(const results::Item& item) {
  return item.kind != results::ItemKind::bonus;
}

} // namespace

Standing standing(const results::Item& item) {
  if (!item.judged) return Standing::unjudged;
  const double missing = lost(item);
  if (missing <= kEpsilon) return Standing::full;
  return missing >= item.points - kEpsilon ? Standing::none : Standing::part;
}

double lost(const results::Item& item) {
  const double missing =
      item.kind == results::ItemKind::keep ? -item.earned : item.points - item.earned;
  return std::max(0.0, missing);
}

bool scored(results::Outcome outcome) {
  return outcome == results::Outcome::graded || outcome == results::Outcome::glError;
}

bool perfect(const results::Result& result) {
  return scored(result.outcome) && !result.items.empty() &&
         std::all_of(result.items.begin(), result.items.end(), [](const results::Item& item) {
           return !countsForScore(item) || standing(item) == Standing::full;
         });
}

std::string headline(const results::Result& result) {
  // Nothing was compiled, or the compiler never came to an end.
  if (result.outcome == results::Outcome::buildFailed && result.compilerOutput.empty())
    return say("There is no program to run, so nothing was drawn.");
  if (result.outcome != results::Outcome::graded) return std::string(explanation(result.outcome));
  if (perfect(result)) return say("Complete: every item holds.");
  const auto total = std::count_if(result.items.begin(), result.items.end(), countsForScore);
  const auto incomplete =
      std::count_if(result.items.begin(), result.items.end(), [](const results::Item& i) {
        return countsForScore(i) && standing(i) != Standing::full;
      });
  if (total == 0) return std::string(explanation(result.outcome));
  if (result.score <= 0) return say("It runs and draws, but no item has earned points yet.");
  return say("{} of {} items lost points.", incomplete, total);
}

namespace {

std::string listOf(const std::vector<std::string>& all) {
  std::string list = sanitizeLine(all[0]);
  for (std::size_t i = 1; i < all.size(); ++i) {
    const std::string next = sanitizeLine(all[i]);
    list = i + 1 < all.size() ? say("{}, {}", list, next) : say("{} and {}", list, next);
  }
  return list;
}

} // namespace

std::string carriedText(const results::Item& item) {
  if (!item.repaired.empty())
    return say("Judged as if this were right: {}.", listOf(item.repaired));
  if (item.carried.empty()) return "";
  return say("Judged with the reference's {} in place of yours.", listOf(item.carried));
}

std::string whatIsWrong(const results::Diagnosis& diagnosis) {
  std::string text = sanitizeLine(diagnosis.picture);
  if (text.empty()) return text;
  if (!diagnosis.amount.empty()) text = say("{}: {}", text, sanitizeLine(diagnosis.amount));
  if (!diagnosis.place.empty()) text = say("{}, {}", text, sanitizeLine(diagnosis.place));
  if (!diagnosis.scene.empty()) text += say(" (scene {})", sanitizeLine(diagnosis.scene));
  return text;
}

std::vector<const results::Item*> worstItems(const results::Result& result, std::size_t count) {
  std::vector<const results::Item*> worst;
  if (!scored(result.outcome)) return worst;
  for (const results::Item& item : result.items)
    if (countsForScore(item) && lost(item) > kEpsilon) worst.push_back(&item);
  std::stable_sort(worst.begin(), worst.end(), [](const results::Item* a, const results::Item* b) {
    return lost(*a) > lost(*b);
  });
  if (worst.size() > count) worst.resize(count);
  return worst;
}

const results::Scene* worstScene(const results::Result& result, const results::Item& item) {
  const results::Scene* worst = nullptr;
  double least = 1 - kEpsilon;
  for (const auto& [name, credit, isPublic] : item.credits) {
    if (credit >= least) continue;
    const auto scene = std::find_if(result.scenes.begin(), result.scenes.end(),
                                    [&](const results::Scene& s) { return s.name == name; });
    if (scene == result.scenes.end()) continue;
    worst = &*scene;
    least = credit;
  }
  return worst;
}

FrameIndex worstFrame(const results::Result& result) {
  FrameIndex worst;
  double share = -1;
  for (std::size_t s = 0; s < result.scenes.size(); ++s) {
    const auto& frames = result.scenes[s].frames;
    for (std::size_t f = 0; f < frames.size(); ++f) {
      if (frames[f].student.empty() || frames[f].wrongShare <= share) continue;
      worst = {s, f, true};
      share = frames[f].wrongShare;
    }
  }
  return worst;
}

namespace {

std::string reasonOf(const results::Result& result) {
  if (!scored(result.outcome)) return sanitizeLine(result.detail);
  for (const results::Diagnosis& diagnosis : result.diagnoses)
    if (diagnosis.confidence > 0) return sanitizeLine(diagnosis.text);
  if (!result.detail.empty()) return sanitizeLine(result.detail);
  const auto worst = worstItems(result, 1);
  if (worst.empty()) return "";
  const std::string message = sanitizeLine(worst[0]->message);
  return fmt::format("−{} {}{}{}", number(lost(*worst[0])), sanitizeLine(worst[0]->title),
                     message.empty() ? "" : ": ", message);
}

} // namespace

Summary summarize(const results::Result& result, const std::string& link) {
  Summary summary{sanitizeLine(result.submission),
                  result.outcome,
                  perfect(result),
                  headline(result),
                  reasonOf(result),
                  result.score,
                  result.bonus,
                  result.maxScore,
                  {},
                  link};
  const FrameIndex worst = worstFrame(result);
  if (worst.found)
    summary.thumbnail = thumbnail(result.scenes[worst.scene].frames[worst.frame].student, 224, 168);
  return summary;
}

std::string_view stateOf(const Summary& summary) {
  if (summary.outcome == results::Outcome::notGradable) return "unjudged";
  if (summary.perfect) return "full";
  return scored(summary.outcome) && summary.score > 0 ? "part" : "none";
}

std::string pointsText(const results::Item& item) {
  if (!item.judged) return say("not judged");
  switch (item.kind) {
  case results::ItemKind::keep:
    return lost(item) <= kEpsilon ? say("kept") : "−" + number(lost(item));
  case results::ItemKind::bonus:
    return fmt::format("+{} / {}", number(item.earned), number(item.points));
  case results::ItemKind::gain:
    break;
  }
  return fmt::format("{} / {}", number(item.earned), number(item.points));
}

double totalSeconds(const results::Result& result) {
  double sum = 0;
  for (const results::Timing& timing : result.timings) {
    if (timing.what == "total") return timing.seconds;
    sum += timing.seconds;
  }
  return sum;
}

} // namespace ggrade::report
