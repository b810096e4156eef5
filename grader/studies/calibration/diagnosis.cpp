#include "calibration/diagnosis.hpp"

#include "calibration/subject.hpp"
#include "grading/catalogue.hpp"
#include "grading/diagnose.hpp"
#include "report/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <mutex>

namespace ggrade::calibration {

namespace fs = std::filesystem;
using grading::Catalogue;
using grading::Mistake;

namespace {

/// A mistake in one of the programs that it is made in.
struct Made {
  const Mistake* mistake;
  std::string variant;
  grading::Recipe recipe;
};

/// Are these one diagnosis by name?
bool sameName(const Catalogue& catalogue, const std::string& a, const std::string& b) {
  const auto group = [&](const std::string& name) {
    const Mistake* mistake = catalogue.mistake(name);
    return mistake && !mistake->same.empty() ? mistake->same : name;
  };
  return group(a) == group(b);
}

class DiagnosisMeasurement {
public:
  DiagnosisMeasurement(const Target& target, const fs::path& solutionFolder,
                       const DiagnosisOptions& options)
      : target_(target), part_(target.parts.at(0)), solutionFolder_(solutionFolder),
        options_(options), catalogue_(grading::loadCatalogue(target.assignment, part_,
                                                             solutionFolder, solutionFolder)) {
    figures_.part = part_.id;
    figures_.seeds = options.seeds;
  }

  DiagnosisFigures run() {
    makeAll();
    total_ = made_.size() * options_.seeds.size();
    for (const std::uint64_t seed : options_.seeds) runSeed(seed);
    std::ranges::sort(figures_.cases, {}, [](const DiagnosisCase& one) {
      return std::tuple(one.mistake, one.variant, one.seed, one.leftOut);
    });
    return std::move(figures_);
  }

private:
  void makeAll() {
    std::size_t first = 0;
    for (const Mistake& mistake : catalogue_.mistakes) {
      if (!options_.only.empty() &&
          std::ranges::find(options_.only, mistake.name) == options_.only.end())
        continue;
      make(mistake, "", {mistake.patch});
      // Others each time, so that all of them have their turn.
      std::size_t applied = 0;
      const std::size_t count = catalogue_.variants.size();
      for (std::size_t i = 0; i < count && applied < options_.variants; ++i) {
        const auto& variant = catalogue_.variants[(first + i) % count];
        if (!variant.loses.empty()) continue; // it loses points of its own
        if (make(mistake, variant.name, {variant.patch, mistake.patch})) ++applied;
      }
      first += options_.variants;
      if (applied == 0) figures_.notApplied.push_back(mistake.name);
    }
  }

  bool make(const Mistake& mistake, const std::string& variant,
            const std::vector<fs::path>& patches) {
    const grading::Recipe recipe{solutionFolder_, patches};
    try {
      const grading::Program applies(target_.assignment, recipe);
    } catch (const UsageError&) {
      return false;
    }
    made_.push_back({&mistake, variant, recipe});
    return true;
  }

  void runSeed(std::uint64_t seed) {
    const grading::ScenePlan plan =
        grading::drawScenes(target_, solutionFolder_, {seed, options_.quality});
    const SeedPictures pictures(target_, solutionFolder_, plan);
    grading::Grader grader(target_, solutionFolder_, plan, graderOptions(), pictures.references);
    grader.prepare();
    grading::inParallel(made_.size(), options_.jobs, [&](std::size_t i) {
      if (grading::interrupted) throw grading::Interrupted{};
      examine(made_[i], grader);
      const std::lock_guard lock(mutex_);
      ++done_;
      if (options_.progress) options_.progress("diagnosis", done_, total_);
    });
  }

  void examine(const Made& made, grading::Grader& grader) {
    grading::Graded graded = grader.draw(
        grader.build(std::make_shared<grading::Program>(target_.assignment, made.recipe), true));
    if (graded.scenes.empty()) return; // not built
    grader.judge(graded);
    const results::Result& result = graded.result;
    const std::uint64_t seed = grader.plan().seed;
    if (const auto observed = diagnosis::outcomeDiagnosis(result, graded.facts);
        observed && observed->id != results::name(results::Outcome::glError)) {
      for (const bool leftOut : {false, true})
        add({made.mistake->name, made.variant, seed, leftOut, observed->id, 1, Answered::right});
      return;
    }
    const std::vector<std::string> lost = grading::lostItems(result, part_);
    if (!report::scored(result.outcome) || lost.empty()) return;
    const auto quiet = [](const auto&, auto, auto) {};
    grading::Diagnoser diagnoser(target_, part_, solutionFolder_, grader.references(), quiet);
    for (const bool leftOut : {false, true}) {
      // Were it not known, what it resembles and what can be proved would have to do.
      grader.diagnose(graded, leftOut ? std::set{made.mistake->name} : std::set<std::string>{});
      const results::Diagnosis told =
          result.diagnoses.empty() ? results::Diagnosis{} : result.diagnoses.front();
      add({made.mistake->name, made.variant, seed, leftOut, told.id, told.confidence,
           worth(*made.mistake, told, diagnoser, lost)});
    }
  }

  /// Of what the report says first.
  Answered worth(const Mistake& mistake, const results::Diagnosis& told,
                 grading::Diagnoser& diagnoser, const std::vector<std::string>& lost) {
    if (told.id.empty()) return Answered::unknown;
    if (told.id == "proved") {
      // What was right from the start and is left changed is no step's.
      if (told.step.empty()) return Answered::generic;
      return told.step == grading::stepHeading(part_, mistake.step) ? Answered::right
                                                                    : Answered::wrong;
    }
    const bool isStep = told.id.starts_with("step.");
    if (!isStep && !catalogue_.mistake(told.id)) return Answered::generic;
    if (sameName(catalogue_, told.id, mistake.name)) return Answered::right;
    // "Step 5 can't be seen yet" is true of a mistake in step 5.
    if (isStep && part_.todos.at(std::stoul(told.id.substr(5))).id == mistake.step)
      return Answered::right;
    // That the picture is still the handed-out one is seen, and true of what can't be seen.
    if (told.id == "step.0") return Answered::generic;
    // What shows the same can't be told apart: with both known they are one diagnosis.
    return diagnoser.showTheSame(mistake.name, told.id, lost) ? Answered::right : Answered::wrong;
  }

  void add(DiagnosisCase one) {
    const std::lock_guard lock(mutex_);
    figures_.cases.push_back(std::move(one));
  }

  const Target& target_;
  const Part& part_;
  const fs::path& solutionFolder_;
  const DiagnosisOptions& options_;
  Catalogue catalogue_;
  std::vector<Made> made_;
  std::mutex mutex_;
  std::size_t done_ = 0, total_ = 0;
  DiagnosisFigures figures_;
};

} // namespace

std::string_view name(Answered answered) {
  switch (answered) {
  case Answered::right:
    return "right";
  case Answered::generic:
    return "generic";
  case Answered::unknown:
    return "unknown";
  case Answered::wrong:
    break;
  }
  return "wrong";
}

std::array<std::size_t, 4> DiagnosisFigures::counts(bool leftOut) const {
  std::array<std::size_t, 4> all{};
  for (const DiagnosisCase& one : cases)
    if (one.leftOut == leftOut) ++all[std::size_t(one.worth)];
  return all;
}

std::optional<double> DiagnosisFigures::rightShare(bool elsewhere) const {
  std::size_t right = 0, all = 0;
  for (const DiagnosisCase& one : cases) {
    if (one.leftOut || one.variant.empty() == elsewhere) continue;
    ++all;
    if (one.worth == Answered::right) ++right;
  }
  if (all == 0) return {};
  return double(right) / double(all);
}

double DiagnosisFigures::wrongShare() const {
  const auto all = counts(true);
  const std::size_t sum = all[0] + all[1] + all[2] + all[3];
  return sum ? double(all[std::size_t(Answered::wrong)]) / double(sum) : 0;
}

DiagnosisFigures measureDiagnosis(const Target& target, const fs::path& solutionFolder,
                                  const DiagnosisOptions& options) {
  return DiagnosisMeasurement(target, solutionFolder, options).run();
}

Section sectionOf(const DiagnosisFigures& figures) {
  const auto known = figures.counts(false), leftOut = figures.counts(true);
  const auto text = [](const std::array<std::size_t, 4>& counts) {
    return fmt::format("{} right, {} generic, {} unknown, {} wrong", counts[0], counts[1],
                       counts[2], counts[3]);
  };
  const auto share = [](const std::optional<double>& right) {
    return right ? fmt::format("in {:.1f}%", 100 * *right) : "in none, for none could be made";
  };
  Section section;
  section.title = "Diagnosis";
  section.text = fmt::format(
      "Every mistake was made in the reference and in right answers written in another way, with "
      "seeds {}, which the thresholds were not chosen on. In the reference its first diagnosis was "
      "right {} (wanted: at least {:.0f}%), elsewhere {} (at least {:.0f}%: with "
      "another filter or frustum a mistake may look like nothing that is known); all: {}. With its "
      "own signature left out it was given a wrong name in {:.1f}% (wanted: at most {:.0f}%): {}. "
      "Right is also a mistake that shows the same in every pass, and what was observed without "
      "pictures. Generic is a change of the picture that was measured, such as a scale. Below: "
      "what wasn't right.",
      fmt::join(figures.seeds, ", "), share(figures.rightShare(false)), 100 * kRightAnswers,
      share(figures.rightShare(true)), 100 * kRightElsewhere, text(known),
      100 * figures.wrongShare(), 100 * kWrongAnswers, text(leftOut));
  section.columns = {"mistake", "made in", "seed", "its signature", "answer", "confidence", ""};
  for (const DiagnosisCase& one : figures.cases) {
    // An unknown mistake is rightly called unknown.
    const bool asItShould =
        one.worth == Answered::right || (one.leftOut && one.worth != Answered::wrong);
    if (asItShould) continue;
    section.rows.push_back({one.mistake, one.variant.empty() ? "the reference" : one.variant,
                            std::to_string(one.seed), one.leftOut ? "left out" : "known",
                            one.answer.empty() ? "unknown" : one.answer,
                            fmt::format("{:.2f}", one.confidence), std::string(name(one.worth))});
  }
  return section;
}

nlohmann::json toJson(const DiagnosisFigures& figures) {
  nlohmann::json cases = nlohmann::json::array();
  for (const DiagnosisCase& one : figures.cases)
    cases.push_back({{"mistake", one.mistake},
                     {"variant", one.variant},
                     {"seed", one.seed},
                     {"left_out", one.leftOut},
                     {"answer", one.answer},
                     {"confidence", one.confidence},
                     {"worth", name(one.worth)}});
  const auto orNull = [](const std::optional<double>& share) {
    return share ? nlohmann::json(*share) : nlohmann::json();
  };
  return {{"seeds", figures.seeds},
          {"right_share", orNull(figures.rightShare(false))},
          {"right_share_elsewhere", orNull(figures.rightShare(true))},
          {"wrong_share", figures.wrongShare()},
          {"not_applied", figures.notApplied},
          {"cases", cases}};
}

} // namespace ggrade::calibration
