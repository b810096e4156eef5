#include "report_class_samples.hpp"

#include "report_samples.hpp"

#include "image/png.hpp"
#include "report/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace ggrade::report::samples {
namespace {

constexpr std::array kNames = {"Student", "学生", "がくせい", "학생",     "Étudiant",
                               "Студент", "طالب", "סטודנט",   "Φοιτητής", "นักเรียน"};

const std::array<ClassDiagnosis, 6> kDiagnoses = {
    {{"mirror_unlit", "The reflection is lit as if the objects stood above the floor. Mirror the "
                      "light and the normals with the same matrix."},
     {"mirror_viewport_kept",
      "The viewport of the mirror pass stays: set it back to the window's size before the floor."},
     {"mirror_cull", "A mirrored triangle turns the other way round. Look at glFrontFace."},
     {"shadow_no_bias", "Stripes on lit faces: the shadow map is compared without a depth bias."},
     {"shadow_behind", "Objects behind the light throw shadows too."},
     {"bloom_one_way", "The blur runs in one direction only. There must be a second pass."}}};

// Anything in 0 to 1 that looks like chance.
double chance(std::size_t i, double salt) {
  const double value = std::sin(double(i + 1) * 12.9898 + salt * 78.233) * 43758.5453;
  return value - std::floor(value);
}

results::Outcome outcomeOf(std::size_t i) {
  constexpr std::array kRare = {
      results::Outcome::buildFailed, results::Outcome::timeout,     results::Outcome::crash,
      results::Outcome::noFrame,     results::Outcome::shaderError, results::Outcome::glError,
      results::Outcome::outOfMemory, results::Outcome::badOutput,   results::Outcome::notGradable};
  return i % 6 == 5 ? kRare[i / 6 % kRare.size()] : results::Outcome::graded;
}

void judge(ClassRow& row, std::size_t i) {
  const double skill = std::sqrt(chance(i, 1));
  row.score = row.bonus = 0;
  for (ClassItem& item : row.items) {
    const double hard = .35 + .65 * chance(item.title.size(), 2);
    const double reached =
        std::clamp(skill + hard * (chance(i, double(item.title.size())) - .35), 0.0, 1.0);
    const double share = std::round(reached * 4) / 4;
    item.earned = item.kind == results::ItemKind::keep    ? (share < .5 ? -item.points / 2 : 0)
                  : item.kind == results::ItemKind::bonus ? (share > .9 ? item.points : 0)
                                                          : share * item.points;
    (item.kind == results::ItemKind::bonus ? row.bonus : row.score) += item.earned;
  }
  row.score = std::max(0.0, row.score);
  if (row.score > 95) {
    row.headline = "Complete: every item holds.", row.reason.clear();
    return;
  }
  row.headline = "2 of 5 items lost points.";
  if (i % 7 == 3) {
    row.diagnoses = {{"", "No known mistake looks like this."}};
    row.reason = "−12 The reflection touches its object: 31.4% of the pixels differ.";
  } else {
    row.diagnoses = {kDiagnoses[std::size_t(chance(i, 3) * chance(i, 4) * 6)]};
    row.reason = row.diagnoses[0].text;
  }
}

void decide(ClassRow& row, std::size_t i) {
  if (i % 23 == 4)
    row.adjustments = {{"mirror.position", row.items[2].earned, 20,
                        "drawn with another pivot, looked at together", "tutor1"}};
  if (i % 61 == 7) row.adjustments = {{"", row.score, 50, "shown in the exercise", "tutor2"}};
  row.penalty = i % 11 == 2 ? 10 : 0;
  double points = row.score + row.bonus;
  for (const Adjustment& adjustment : row.adjustments)
    points += adjustment.points - adjustment.machine;
  row.finalScore = std::max(0.0, points - row.penalty);
}

} // namespace

ClassRow student(const std::string& name, double finalScore) {
  ClassRow row;
  row.folder = row.student = row.name = name;
  row.outcome = results::Outcome::graded;
  row.headline = "1 of 3 items lost points.";
  row.score = row.finalScore = finalScore, row.maxScore = 100, row.seconds = 2.5;
  row.items = {
      {"mirror.where", "The reflection is where it must be", results::ItemKind::gain, 40, 40, true},
      {"mirror.shading", "The reflection is lit", results::ItemKind::gain, 20, 60, true},
      {"mirror.keep", "Everything else stays", results::ItemKind::keep, 0, 30, true},
      {"mirror.blur", "The reflection is blurred", results::ItemKind::bonus, 0, 10, true}};
  return row;
}

ClassPage wholeClass(std::size_t students) {
  ClassPage page;
  page.title = "Mirror reflection through a framebuffer object";
  page.intro = "Every submission of the class, graded with the same hidden scenes.";
  for (std::size_t i = 0; i < students; ++i) {
    ClassRow row = student(fmt::format("{} {}", kNames[i % kNames.size()], i + 1));
    row.student = std::to_string(20260001 + i);
    row.folder = "student" + std::to_string(i + 1);
    row.outcome = outcomeOf(i);
    row.items = {
        {"mirror.where", "The reflection is where it must be", results::ItemKind::gain, 0, 35,
         true},
        {"mirror.shading", "The reflection is lit from the right side", results::ItemKind::gain, 0,
         30, true},
        {"mirror.position", "The reflection touches its object", results::ItemKind::gain, 0, 20,
         true},
        {"mirror.hidden", "Objects hide what is behind them", results::ItemKind::gain, 0, 15, true},
        {"mirror.keep", "Everything else stays", results::ItemKind::keep, 0, 30, true},
        {"mirror.blur", "The reflection is blurred", results::ItemKind::bonus, 0, 10, true}};
    if (row.outcome == results::Outcome::graded || row.outcome == results::Outcome::glError) {
      judge(row, i);
    } else {
      for (ClassItem& item : row.items) item.judged = false;
      row.score = 0;
      row.headline = explanation(row.outcome);
      row.reason = "floor.cpp:42:5: error: 'mirrorFramebuffer' was not declared in this scope";
    }
    decide(row, i);
    row.submitted = fmt::format("2026-11-{:02}T{:02}:{:02}+09:00", 10 + i % 11, i % 24, i * 7 % 60);
    row.seconds = 1.5 + 4 * chance(i, 6);
    if (i % 17 == 0)
      row.remarks = {"3 attempts: attempt 3 counts", "notes.pdf: not a file of this assignment"};
    if (i % 29 == 0)
      page.changes.push_back({row.name, row.folder, row.score + (i % 58 ? 6 : -8), row.score});
    page.rows.push_back(std::move(row));
  }
  page.remarks = {"__MACOSX: passed over, it is no submission"};
  page.refused = {"student7.lnk: a symbolic link is not followed"};
  page.selfTested = true;
  page.protections = {{"sandbox", "bubblewrap 0.8.0"},
                      {"system calls", "a seccomp filter that allows a list and refuses all else"}};
  page.facts = {{"seed", "8131"},
                {"ggrade", "0.1.0"},
                {"late rule", "10% per day, at most 50%, 15 min grace"}};
  return page;
}

void addThumbnails(ClassPage& page) {
  constexpr std::array kFaults = {Fault::none, Fault::noReflection, Fault::flatReflection,
                                  Fault::shiftedReflection};
  std::vector<std::string> pictures;
  for (std::size_t i = 0; i < kFaults.size(); ++i) {
    const auto png = encodePng(thumbnail(picture(kFaults[i], double(i), .2, 320, 240), 176, 132),
                               PngEffort::fast);
    pictures.emplace_back(png.begin(), png.end());
  }
  for (std::size_t i = 0; i < page.rows.size(); ++i)
    if (page.rows[i].outcome == results::Outcome::graded)
      page.rows[i].thumbnail = pictures[i % pictures.size()];
}

} // namespace ggrade::report::samples
