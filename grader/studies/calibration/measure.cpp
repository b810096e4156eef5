#include "calibration/measure.hpp"

#include "calibration/subject.hpp"
#include "calibration/whole_image.hpp"
#include "report/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace ggrade::calibration {

namespace fs = std::filesystem;
using grading::ScenePlan;
using nlohmann::json;

std::string nameOf(const Look& look) {
  std::string text = grading::nameOf(look.quality);
  if (look.scale != 1) text += fmt::format(", windows x {}", report::number(look.scale));
  if (look.hidden)
    text += fmt::format(", {} hidden scene{}", *look.hidden, *look.hidden == 1 ? "" : "s");
  return text;
}

void scaleWindows(grading::ScenePlan& plan, double scale) {
  const auto apply = [&](json& scene, const std::string& name) {
    if (!scene.contains("size"))
      throw UsageError(fmt::format("scene \"{}\" has no size that could be scaled", name));
    for (json& side : scene["size"]) side = std::max(1L, std::lround(side.get<double>() * scale));
  };
  for (grading::SceneCase& one : plan.scenes) {
    if (one.isPublic) continue;
    apply(one.scene, one.name);
    for (auto& [probe, scene] : one.probes) apply(scene, one.name);
  }
}

std::size_t scenesUpTo(const grading::ScenePlan& plan, std::size_t hidden) {
  std::size_t count = 0;
  for (; count < plan.scenes.size(); ++count)
    if (!plan.scenes[count].isPublic && hidden-- == 0) break;
  return count;
}

namespace {

/// What all gradings in the scenes of one plan share.
struct Prepared {
  std::string plan; ///< as text
  SeedPictures pictures;
  grading::Grader grader;

  Prepared(const Target& target, const fs::path& solutionFolder, const ScenePlan& drawn, bool twice)
      : plan(grading::describe(drawn)), pictures(target, solutionFolder, drawn),
        grader(target, solutionFolder, drawn, graderOptions(twice), pictures.references) {}
};

class Measurement {
public:
  Measurement(const Target& target, const fs::path& solutionFolder,
              const std::vector<KnownAnswer>& programs, const MeasureOptions& options)
      : target_(target), solutionFolder_(solutionFolder), options_(options),
        subjects_(subjectsOf(target, programs)),
        total_(programs.size() * options.seeds.size() * options.looks.size()) {}

  std::vector<std::vector<Measured>> run() {
    std::vector<Measured> unmeasured;
    for (const auto& subject : subjects_) unmeasured.push_back(subject->measured);
    std::vector<std::vector<Measured>> all(options_.looks.size(), unmeasured);
    for (std::uint64_t seed : options_.seeds)
      for (std::size_t i = 0; i < all.size(); ++i) gradeAll(seed, options_.looks[i], all[i]);
    return all;
  }

private:
  void gradeAll(std::uint64_t seed, const Look& look, std::vector<Measured>& all) {
    const std::string what = options_.looks.size() == 1
                                 ? fmt::format("seed {}", seed)
                                 : fmt::format("seed {}, {}", seed, nameOf(look));
    const ScenePlan whole = drawPlan(seed, look);
    ScenePlan plan = whole;
    if (look.hidden) plan.scenes.resize(scenesUpTo(plan, *look.hidden));
    const std::string common =
        fmt::format("{}{}{}", grading::gradingKey(target_, solutionFolder_, plan),
                    look.twice ? " twice" : "", look.measures ? " measures" : "");
    const auto fileOf = [&](std::size_t i) { return scoreFile(common + subjects_[i]->key); };
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i].problem.empty()) {
        ++done_;
      } else if (const auto kept = loadScore(fileOf(i))) {
        all[i].scores.push_back(*kept);
        ++done_;
      } else {
        missing.push_back(i);
      }
    }
    say(what);
    if (missing.empty()) return;

    if (!prepared_ || prepared_->plan != grading::describe(whole) || twice_ != look.twice) {
      prepared_.reset(); // one judge's memory at a time
      prepared_ = std::make_unique<Prepared>(target_, solutionFolder_, whole, look.twice);
      twice_ = look.twice;
    }
    grading::inParallel(missing.size(), options_.jobs, [&](std::size_t n) {
      if (grading::interrupted) throw grading::Interrupted{};
      const std::size_t i = missing[n];
      const KnownAnswer& program = all[i].program;
      Score score = grade(*subjects_[i], plan, look);
      // A machine with much else to do may make a run miss its time limit.
      if (score.outcome == results::Outcome::timeout &&
          program.outcome != results::Outcome::timeout)
        score = grade(*subjects_[i], plan, look);
      // In windows that no rubric was made for, that the judge sees nothing is a finding.
      const bool gradable = score.outcome != results::Outcome::notGradable;
      if (!gradable && look.scale == 1)
        throw std::runtime_error(
            fmt::format("{} could not be graded with {}: {}", program.name, what, score.detail));
      if (gradable) saveScore(fileOf(i), score);
      const std::lock_guard lock(mutex_);
      all[i].scores.push_back(std::move(score));
      ++done_;
      say(what);
    });
  }

  ScenePlan drawPlan(std::uint64_t seed, const Look& look) const {
    ScenePlan plan = grading::drawScenes(target_, solutionFolder_, {seed, look.quality});
    if (look.scale != 1) scaleWindows(plan, look.scale);
    return plan;
  }

  Score grade(Subject& subject, const ScenePlan& plan, const Look& look) {
    grading::Grader& grader = prepared_->grader;
    if (subject.measured.program.kind == Kind::pictures)
      return gradePictures(subject.measured.program.name, plan.scenes.size());
    grading::Graded graded = grader.draw(subject.build(grader), plan.scenes.size());
    grader.judge(graded);
    Score score = scoreOf(graded.result);
    if (look.measures)
      score.measures = measurePictures({graded.scenes.begin(), graded.scenes.end()});
    std::size_t pictures = 0;
    for (const grading::SceneCase& scene : plan.scenes) pictures += scene.times.shown.size();
    for (const results::Timing& timing : graded.result.timings)
      if (timing.what == "judge") score.judgeMs = 1e3 * timing.seconds / double(pictures);
    return score;
  }

  Score gradePictures(const std::string& kind, std::size_t count) {
    const auto& scenes = prepared_->pictures.references.scenes;
    std::vector<std::vector<rubric::RawFrame>> frames;
    std::vector<bool> isPublic;
    for (std::size_t i = 0; i < count; ++i) {
      frames.push_back(rubric::readFrames(scenes[i].reference));
      isPublic.push_back(scenes[i].isPublic);
    }
    grading::TemporaryFolder work;
    std::vector<fs::path> students;
    for (std::size_t i = 0; i < count; ++i) {
      students.push_back(work.path() / std::to_string(i));
      rubric::writeFrames(students[i], pictures(kind, frames, isPublic, i));
    }
    results::Result result;
    result.seed = prepared_->grader.plan().seed;
    result.outcome = results::Outcome::graded;
    result.items = prepared_->grader.theJudge().judge({students}, work.path(), result.detail);
    if (!result.detail.empty()) result.outcome = results::Outcome::notGradable;
    grading::addUp(result);
    return scoreOf(result);
  }

  void say(const std::string& what) {
    if (options_.progress) options_.progress(what, done_, total_);
  }

  const Target& target_;
  const fs::path& solutionFolder_;
  const MeasureOptions& options_;
  std::vector<std::unique_ptr<Subject>> subjects_;
  std::unique_ptr<Prepared> prepared_; ///< of the last plan
  bool twice_ = false;                 ///< as it was prepared
  std::mutex mutex_;
  std::size_t done_ = 0, total_;
};

} // namespace

std::vector<std::vector<Measured>> measure(const Target& target, const fs::path& solutionFolder,
                                           const std::vector<KnownAnswer>& programs,
                                           const MeasureOptions& options) {
  return Measurement(target, solutionFolder, programs, options).run();
}

} // namespace ggrade::calibration
