#include "calibration/score_file.hpp"
#include "calibration/subject.hpp"
#include "calibration/tolerances.hpp"
#include "grading/judge_server.hpp"

#include <fmt/format.h>

#include <mutex>

namespace ggrade::calibration {

namespace fs = std::filesystem;
using grading::ScenePlan;

namespace {

/// What a program drew with one seed, kept while every setting judges it.
struct Drawn {
  report::Result result;
  std::vector<rubric::SceneFolders> scenes; ///< empty if it never came to be judged
};

class Trials {
public:
  Trials(const Target& target, const fs::path& solutionFolder, const std::vector<Program>& programs,
         grading::Quality quality, unsigned jobs)
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
    std::vector<Drawn> drawn;
    grading::TemporaryFolder kept;
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
          drawn = drawAll(plan, pictures->references, kept.path());
        }
        const Tolerances tolerances{float(trial.setting.steps / 255), trial.setting.radius};
        grading::JudgeServer server(target_, pictures->references.scenes, &tolerances);
        grading::inParallel(missing.size(), jobs_, [&](std::size_t n) {
          if (grading::interrupted) throw grading::Interrupted{};
          const std::size_t i = missing[n];
          grading::TemporaryFolder answers;
          report::Result result = drawn[i].result;
          std::string problem;
          if (!drawn[i].scenes.empty())
            result.items = server.judge(drawn[i].scenes, answers.path(), problem);
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
  std::vector<Drawn> drawAll(const ScenePlan& plan, const grading::References& references,
                             const fs::path& kept) {
    std::vector<Drawn> all(subjects_.size());
    grading::inParallel(subjects_.size(), jobs_, [&](std::size_t i) {
      if (grading::interrupted) throw grading::Interrupted{};
      if (!subjects_[i]->measured.problem.empty()) return;
      grading::GradeOptions how;
      how.pictures = how.twice = false;
      how.threads = 1;
      how.judging = [&](const std::vector<rubric::SceneFolders>& scenes, const fs::path&,
                        std::string&, const std::vector<std::string>&) {
        all[i].scenes = scenes;
        for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
          const fs::path to = kept / fmt::format("{}-{}", i, scene);
          fs::rename(scenes[scene].student, to);
          all[i].scenes[scene].student = to;
        }
        return std::vector<report::Item>();
      };
      all[i].result =
          grading::gradeBuilt(target_, plan, references, subjects_[i]->build(target_), how);
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
                                 const std::vector<Program>& programs,
                                 const std::vector<std::uint64_t>& seeds, grading::Quality quality,
                                 unsigned jobs, const grading::Progress& progress) {
  Trials trials(target, solutionFolder, programs, quality, jobs);
  std::size_t done = 0;
  for (std::uint64_t seed : seeds)
    trials.trySeed(seed, [&] { progress("tolerances", ++done, seeds.size() * settings().size()); });
  return std::move(trials.trials_);
}

} // namespace ggrade::calibration
