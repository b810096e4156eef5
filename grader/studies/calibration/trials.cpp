#include "calibration/subject.hpp"
#include "calibration/tolerances.hpp"

#include <fmt/format.h>

#include <mutex>

namespace ggrade::calibration {

namespace fs = std::filesystem;
using grading::ScenePlan;

namespace {

class Trials {
public:
  Trials(const Target& target, const fs::path& solutionFolder,
         const std::vector<KnownAnswer>& programs, grading::Quality quality, unsigned jobs)
      : target_(target), solutionFolder_(solutionFolder), quality_(quality), jobs_(jobs),
        subjects_(subjectsOf(target, programs)) {
    for (const Setting& setting : settings()) {
      trials_.push_back({setting, {}});
      for (const auto& subject : subjects_) trials_.back().measured.push_back(subject->measured);
    }
  }

  void trySeed(std::uint64_t seed, const std::function<void()>& step) {
    const ScenePlan plan = grading::drawScenes(target_, solutionFolder_, {seed, quality_});
    const std::string common = "trial " + grading::gradingKey(target_, solutionFolder_, plan);
    const auto fileOf = [&](const Trial& trial, const Subject& subject) {
      return scoreFile(fmt::format("{} {} {} {}", common, trial.setting.steps, trial.setting.radius,
                                   subject.key));
    };
    std::unique_ptr<SeedPictures> pictures;
    std::vector<grading::Graded> drawn; // kept while every setting judges it
    for (Trial& trial : trials_) {
      std::vector<std::size_t> missing;
      for (std::size_t i = 0; i < subjects_.size(); ++i) {
        if (!subjects_[i]->measured.problem.empty()) continue;
        if (const auto score = loadScore(fileOf(trial, *subjects_[i])))
          trial.measured[i].scores.push_back(*score);
        else
          missing.push_back(i);
      }
      if (!missing.empty()) {
        if (!pictures) {
          pictures = std::make_unique<SeedPictures>(target_, solutionFolder_, plan);
          drawn = drawAll(plan, pictures->references);
        }
        const Tolerances tolerances{float(trial.setting.steps / 255), trial.setting.radius};
        grading::Judge judge(target_, pictures->references.scenes, true, &tolerances);
        grading::inParallel(missing.size(), jobs_, [&](std::size_t n) {
          if (grading::interrupted) throw grading::Interrupted{};
          const std::size_t i = missing[n];
          grading::TemporaryFolder answers;
          results::Result result = drawn[i].result;
          std::string problem;
          if (!drawn[i].scenes.empty())
            result.items = judge.judge({drawn[i].students()}, answers.path(), problem);
          if (!problem.empty())
            throw std::runtime_error(
                fmt::format("{}: {}", trial.measured[i].program.name, problem));
          grading::addUp(result);
          const Score score = scoreOf(result);
          saveScore(fileOf(trial, *subjects_[i]), score);
          const std::lock_guard lock(mutex_);
          trial.measured[i].scores.push_back(score);
        });
      }
      step();
    }
  }

  std::vector<Trial> trials_;

private:
  std::vector<grading::Graded> drawAll(const ScenePlan& plan,
                                       const grading::References& references) {
    grading::Grader grader(target_, solutionFolder_, plan, graderOptions(), references);
    std::vector<grading::Graded> all(subjects_.size());
    grading::inParallel(subjects_.size(), jobs_, [&](std::size_t i) {
      if (grading::interrupted) throw grading::Interrupted{};
      if (!subjects_[i]->measured.problem.empty()) return;
      all[i] = grader.draw(subjects_[i]->build(grader));
      for (grading::GradedScene& scene : all[i].scenes) scene.rendering = {}; // memory
    });
    return all;
  }

  const Target& target_;
  const fs::path& solutionFolder_;
  grading::Quality quality_;
  unsigned jobs_;
  std::vector<std::unique_ptr<Subject>> subjects_;
  std::mutex mutex_;
};

} // namespace

std::vector<Trial> tryTolerances(const Target& target, const fs::path& solutionFolder,
                                 const std::vector<KnownAnswer>& programs,
                                 const std::vector<std::uint64_t>& seeds, grading::Quality quality,
                                 unsigned jobs, const grading::Progress& progress) {
  Trials trials(target, solutionFolder, programs, quality, jobs);
  std::size_t done = 0;
  for (std::uint64_t seed : seeds)
    trials.trySeed(seed, [&] { progress("tolerances", ++done, seeds.size() * settings().size()); });
  return std::move(trials.trials_);
}

} // namespace ggrade::calibration
