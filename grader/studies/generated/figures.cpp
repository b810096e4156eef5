#include "generated/figures.hpp"

#include "calibration/subject.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ggrade::generated {

using calibration::Section;
using nlohmann::json;

namespace {

/// Of the wrong ones that a scene shows: wanted are at least so many charged, and at most so many
/// charged too much.
constexpr double kKilled = 0.95, kChargedTooMuch = 0.05;
/// Of the wrong ones that were charged: wanted diagnoses that name the right step, and a wrong one.
constexpr double kToldRight = 0.85, kToldWrong = 0.01;

/// "12.3%", or "-" of nothing.
std::string share(std::size_t part, std::size_t all) {
  return all == 0 ? "-" : fmt::format("{:.1f}%", 100 * double(part) / double(all));
}

/// Of wrong programs that lost points, with this first diagnosis.
std::size_t countTold(const Figures& figures, Told told) {
  return std::size_t(std::ranges::count_if(figures.cases, [&](const Case& one) {
    return !one.isRight && one.lost - one.bonusLost > kFree && one.fate != Fate::notDrawn &&
           one.told == told;
  }));
}

/// For each gain item, how many of the mutants of its step that a scene shows took points from it.
std::string killsByItem(const Figures& figures, const Target& target) {
  std::string text;
  for (const ItemDeclaration& item : target.items()) {
    if (item.kind != results::ItemKind::gain) continue;
    std::size_t all = 0, killed = 0;
    for (const Case& one : figures.cases) {
      if (one.isRight || one.todo != item.step || one.shownIn.empty() || one.fate == Fate::notDrawn)
        continue;
      ++all;
      const auto earned = one.score.earned.find(item.id);
      killed += earned == one.score.earned.end() || earned->second < 0.99 * item.points;
    }
    if (all > 0)
      text += fmt::format("{}{} {} of {}", text.empty() ? "" : ", ", item.id, killed, all);
  }
  return text;
}

} // namespace

std::string_view name(Fate fate) {
  switch (fate) {
  case Fate::notDrawn:
    return "not drawn";
  case Fate::fair:
    return "fair";
  case Fate::tooLow:
    return "too low";
  case Fate::survived:
    return "survived";
  case Fate::equivalent:
    return "equivalent";
  case Fate::unseen:
    break;
  }
  return "charged unseen";
}

std::string_view name(Told told) {
  switch (told) {
  case Told::right:
    return "right";
  case Told::generic:
    return "generic";
  case Told::silent:
    return "silent";
  case Told::wrong:
    break;
  }
  return "wrong";
}

bool isDrawn(const Case& found) {
  return found.score.outcome == results::Outcome::graded ||
         found.score.outcome == results::Outcome::glError;
}

void settle(Case& found, double most, const std::string& heading) {
  found.lost = most - found.score.score + found.bonusLost;
  const bool isCharged = found.lost > kFree, isShown = !found.shownIn.empty();
  if (found.isRight)
    found.fate = isCharged || !isDrawn(found) ? Fate::tooLow : Fate::fair;
  else if (!isDrawn(found))
    found.fate = Fate::notDrawn;
  else if (!isShown)
    found.fate = isCharged ? Fate::unseen : Fate::equivalent;
  else if (!isCharged)
    found.fate = Fate::survived;
  else
    found.fate = found.lost > found.allowed ? Fate::tooLow : Fate::fair;
  if (found.step.empty())
    found.told = found.answer.empty() ? Told::silent : Told::generic;
  else
    found.told = found.step == heading ? Told::right : Told::wrong;
}

std::size_t Figures::count(bool isRight, Fate fate) const {
  return std::size_t(std::ranges::count_if(
      cases, [&](const Case& one) { return one.isRight == isRight && one.fate == fate; }));
}

double Figures::killed() const {
  const auto killed = double(count(false, Fate::fair) + count(false, Fate::tooLow));
  const double all = killed + double(count(false, Fate::survived));
  return all > 0 ? killed / all : 1;
}

double Figures::chargedTooMuch() const {
  const auto tooLow = double(count(false, Fate::tooLow));
  const double all = tooLow + double(count(false, Fate::fair) + count(false, Fate::survived));
  return all > 0 ? tooLow / all : 0;
}

std::string failuresOf(const Figures& figures) {
  std::string failures;
  const auto add = [&](const std::string& what) {
    failures += fmt::format("{}: {}\n", figures.part, what);
  };
  if (const std::size_t charged = figures.count(true, Fate::tooLow); charged > 0)
    add(fmt::format("{} right programs lose more than {} points", charged, kFree));
  if (figures.killed() < kKilled)
    add(fmt::format("only {:.1f}% of the wrong programs are found", 100 * figures.killed()));
  if (figures.chargedTooMuch() > kChargedTooMuch)
    add(fmt::format("{:.1f}% of the wrong programs lose more than their step's points and {}",
                    100 * figures.chargedTooMuch(), kBeyondStep));
  const std::size_t right = countTold(figures, Told::right),
                    wrong = countTold(figures, Told::wrong);
  const std::size_t all =
      right + wrong + countTold(figures, Told::generic) + countTold(figures, Told::silent);
  if (double(right) < kToldRight * double(all))
    add(fmt::format("the first diagnosis names the right step in only {}", share(right, all)));
  if (double(wrong) > kToldWrong * double(all))
    add(fmt::format("the first diagnosis names a wrong step in {}", share(wrong, all)));
  return failures;
}

Section sectionOf(const Figures& figures, const Target& target) {
  const auto of = [&](bool isRight, Fate fate) { return figures.count(isRight, fate); };
  const std::size_t shown =
      of(false, Fate::fair) + of(false, Fate::tooLow) + of(false, Fate::survived);
  std::size_t told = 0;
  std::vector<std::string> tells;
  for (const Told one : {Told::right, Told::generic, Told::silent, Told::wrong})
    told += countTold(figures, one);
  for (const Told one : {Told::right, Told::generic, Told::silent, Told::wrong})
    tells.push_back(fmt::format("{} {} ({})", countTold(figures, one), name(one),
                                share(countTold(figures, one), told)));
  std::vector<std::string> areas;
  for (const auto& [measure, area] : figures.areas)
    areas.push_back(fmt::format("{} {:.3f}", measure, area));
  Section section;
  section.title = "Generated programs";
  section.text = fmt::format(
      "Drawn with seed {}. Right programs, which are known ones with changes that keep what they "
      "mean: {} of {} lose more than {} points. Wrong programs, of one changed line: {} that don't "
      "compile or end themselves and {} that none of up to {} scenes shows are left out; of the "
      "other {}, {:.1f}% lose more than {} points (wanted: {:.0f}%), and {:.1f}% lose more than "
      "the points of the step whose line it is and {} (at most {:.0f}%). {} more lose points "
      "although "
      "no scene shows them. By item, of the wrong ones of its step: {}. First diagnoses of those "
      "that lose points: {}. Area under the ROC curve of right against wrong: {}. Below: what "
      "isn't "
      "as it should be.",
      figures.seed, of(true, Fate::tooLow), of(true, Fate::fair) + of(true, Fate::tooLow), kFree,
      of(false, Fate::notDrawn), of(false, Fate::equivalent), figures.scenes, shown,
      100 * figures.killed(), kFree, 100 * kKilled, 100 * figures.chargedTooMuch(), kBeyondStep,
      100 * kChargedTooMuch, of(false, Fate::unseen), killsByItem(figures, target),
      fmt::join(tells, ", "), fmt::join(areas, ", "));
  section.columns = {"program", "made from", "step",     "change",   "lost",
                     "allowed", "fate",      "shown in", "diagnosis"};
  for (const Case& one : figures.cases) {
    const bool isTold = one.isRight || one.lost <= kFree || one.told != Told::wrong;
    if ((one.fate == Fate::fair && isTold) || one.fate == Fate::equivalent ||
        one.fate == Fate::notDrawn)
      continue;
    section.rows.push_back(
        {one.name, one.program, one.todo, one.change, fmt::format("{:.1f}", one.lost),
         fmt::format("{:.1f}", one.allowed), std::string(name(one.fate)), one.shownIn,
         one.isRight ? "" : fmt::format("{}: {} {}", name(one.told), one.answer, one.step)});
  }
  return section;
}

json toJson(const Figures& figures) {
  json cases = json::array();
  for (const Case& one : figures.cases)
    cases.push_back({{"name", one.name},
                     {"right", one.isRight},
                     {"made_from", one.program},
                     {"change", one.change},
                     {"todo", one.todo},
                     {"lost", one.lost},
                     {"allowed", one.allowed},
                     {"shown_in", one.shownIn},
                     {"answer", one.answer},
                     {"step", one.step},
                     {"fate", name(one.fate)},
                     {"told", name(one.told)},
                     {"score", calibration::toJson(one.score)}});
  json areas = json::object();
  for (const auto& [measure, area] : figures.areas) areas[measure] = area;
  return {{"seed", figures.seed},
          {"killed", figures.killed()},
          {"charged_too_much", figures.chargedTooMuch()},
          {"right_charged", figures.count(true, Fate::tooLow)},
          {"areas", areas},
          {"cases", cases}};
}

} // namespace ggrade::generated
