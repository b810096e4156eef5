#include "calibration/measure.hpp"

#include "calibration/pictures.hpp"
#include "calibration/score_file.hpp"
#include "calibration/subject.hpp"
#include "calibration/whole_image.hpp"
#include "grading/judge_server.hpp"

#include <fmt/format.h>

#include <mutex>

namespace ggrade::calibration {

namespace fs = std::filesystem;
using grading::References;
using grading::ScenePlan;

namespace {

/// What all gradings in the scenes of one plan share.
struct Prepared {
  std::string plan; ///< as text
  SeedPictures pictures;
  grading::JudgeServer server;

  Prepared(const Target& target, const fs::path& solutionFolder, const ScenePlan& drawn)
      : plan(grading::describe(drawn)), pictures(target, solutionFolder, drawn),
        server(target, pictures.references.scenes) {}
};

class Measurement {
public:
  Measurement(const Target& target, const fs::path& solutionFolder,
              const std::vector<Program>& programs, const MeasureOptions& options)
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

    if (!prepared_ || prepared_->plan != grading::describe(whole)) {
      prepared_.reset(); // one judge's memory at a time
      prepared_ = std::make_unique<Prepared>(target_, solutionFolder_, whole);
    }
    grading::inParallel(missing.size(), options_.jobs, [&](std::size_t n) {
      if (grading::interrupted) throw grading::Interrupted{};
      const std::size_t i = missing[n];
      const Program& program = all[i].program;
      Score score = grade(*subjects_[i], plan, look);
      // A machine with much else to do may make a run miss its time limit.
      if (score.outcome == report::Outcome::timeout && program.outcome != report::Outcome::timeout)
        score = grade(*subjects_[i], plan, look);
      // In windows that no rubric was made for, that the judge sees nothing is a finding.
      const bool gradable = score.outcome != report::Outcome::notGradable;
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
    References references = prepared_->pictures.references;
    references.scenes.resize(plan.scenes.size());
    if (subject.measured.program.kind == Kind::pictures)
      return gradePictures(subject.measured.program.name, plan, references);
    grading::GradeOptions how;
    how.pictures = false;
    how.twice = look.twice;
    how.threads = 1;
    how.judging = [&](const auto& scenes, const fs::path& work, std::string& problem,
                      const std::vector<std::string>& again) {
      return judge(scenes, work, problem, again);
    };
    std::map<std::string, PictureError> measures;
    if (look.measures)
      how.examining = [&](const grading::Submitted& submitted, report::Result&) {
        std::vector<rubric::SceneFolders> scenes = references.scenes;
        for (std::size_t i = 0; i < scenes.size(); ++i) scenes[i].student = submitted.folders[i];
        measures = measurePictures(scenes);
      };
    const report::Result result =
        grading::gradeBuilt(target_, plan, references, subject.build(target_), how);
    Score score = scoreOf(result);
    score.measures = std::move(measures);
    std::size_t pictures = 0;
    for (const grading::SceneCase& scene : plan.scenes) pictures += scene.times.size();
    for (const report::Timing& timing : result.timings)
      if (timing.what == "judge") score.judgeMs = 1e3 * timing.seconds / double(pictures);
    return score;
  }

  /// Asks the judge of all the plan's scenes, of which a grading may have fewer.
  std::vector<report::Item> judge(std::vector<rubric::SceneFolders> scenes, const fs::path& work,
                                  std::string& problem, const std::vector<std::string>& again) {
    const auto& all = prepared_->pictures.references.scenes;
    if (scenes.size() == all.size()) return prepared_->server.judge(scenes, work, problem, again);
    std::vector<std::string> names;
    for (const rubric::SceneFolders& scene : scenes) names.push_back(scene.name);
    scenes.insert(scenes.end(), all.begin() + std::ptrdiff_t(scenes.size()), all.end());
    std::vector<report::Item> items = prepared_->server.judge(scenes, work, problem, again);
    keepScenes(items, names);
    return items;
  }

  Score gradePictures(const std::string& kind, const ScenePlan& plan,
                      const References& references) {
    std::vector<std::vector<rubric::RawFrame>> frames;
    std::vector<bool> isPublic;
    for (const rubric::SceneFolders& scene : references.scenes) {
      frames.push_back(rubric::readFrames(scene.reference));
      isPublic.push_back(scene.isPublic);
    }
    grading::TemporaryFolder work;
    std::vector<rubric::SceneFolders> folders = references.scenes;
    for (std::size_t i = 0; i < folders.size(); ++i) {
      folders[i].student = work.path() / std::to_string(i);
      rubric::writeFrames(folders[i].student, pictures(kind, frames, isPublic, i));
    }
    report::Result result;
    result.seed = plan.seed;
    result.outcome = report::Outcome::graded;
    result.items = judge(folders, work.path(), result.detail, {});
    if (!result.detail.empty()) result.outcome = report::Outcome::notGradable;
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
  std::mutex mutex_;
  std::size_t done_ = 0, total_;
};

} // namespace

std::vector<std::vector<Measured>> measure(const Target& target, const fs::path& solutionFolder,
                                           const std::vector<Program>& programs,
                                           const MeasureOptions& options) {
  return Measurement(target, solutionFolder, programs, options).run();
}

} // namespace ggrade::calibration
