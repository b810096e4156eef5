#include "calibration/measure.hpp"

#include "calibration/pictures.hpp"
#include "calibration/score_file.hpp"
#include "calibration/subject.hpp"
#include "grading/judge_server.hpp"

#include <fmt/format.h>

#include <mutex>

namespace ggrade::calibration {

namespace fs = std::filesystem;
using grading::References;
using grading::ScenePlan;

namespace {

class Measurement {
public:
  Measurement(const Target& target, const fs::path& solutionFolder,
              const std::vector<Program>& programs, const MeasureOptions& options)
      : target_(target), solutionFolder_(solutionFolder), options_(options),
        subjects_(subjectsOf(target, solutionFolder, programs, work_.path())),
        total_(programs.size() * options.seeds.size()) {}

  std::vector<Measured> run() {
    for (std::uint64_t seed : options_.seeds) gradeSeed(seed);
    std::vector<Measured> all;
    for (const auto& subject : subjects_) all.push_back(std::move(subject->measured));
    return all;
  }

private:
  void gradeSeed(std::uint64_t seed) {
    const std::string what = fmt::format("seed {}", seed);
    const ScenePlan plan = grading::drawScenes(target_, solutionFolder_, {seed, options_.quality});
    const std::string common = grading::gradingKey(target_, solutionFolder_, plan);
    std::vector<Subject*> missing;
    for (const auto& subject : subjects_) {
      if (!subject->measured.problem.empty()) {
        ++done_;
      } else if (const auto kept = loadScore(scoreFile(common + subject->key))) {
        subject->measured.scores.push_back(*kept);
        ++done_;
      } else {
        missing.push_back(subject.get());
      }
    }
    say(what);
    if (missing.empty()) return;

    const SeedPictures pictures(target_, solutionFolder_, plan);
    grading::JudgeServer server(target_, pictures.references.scenes);
    grading::inParallel(missing.size(), options_.jobs, [&](std::size_t i) {
      if (grading::interrupted) throw grading::Interrupted{};
      Subject& subject = *missing[i];
      const Program& program = subject.measured.program;
      Score score = grade(subject, plan, pictures.references, server);
      // A machine with much else to do may make a run miss its time limit.
      if (score.outcome == report::Outcome::timeout && program.outcome != report::Outcome::timeout)
        score = grade(subject, plan, pictures.references, server);
      if (score.outcome == report::Outcome::notGradable)
        throw std::runtime_error(fmt::format("{} could not be graded with seed {}: {}",
                                             program.name, seed, score.detail));
      saveScore(scoreFile(common + subject.key), score);
      const std::lock_guard lock(mutex_);
      subject.measured.scores.push_back(std::move(score));
      ++done_;
      say(what);
    });
  }

  Score grade(Subject& subject, const ScenePlan& plan, const References& references,
              grading::JudgeServer& server) {
    if (subject.measured.program.kind == Kind::pictures)
      return gradePictures(subject.measured.program.name, plan, references, server);
    grading::GradeOptions how;
    how.pictures = how.twice = false;
    how.threads = 1;
    how.judging = [&](const auto& scenes, const fs::path& work, std::string& problem,
                      const std::vector<std::string>& again) {
      return server.judge(scenes, work, problem, again);
    };
    return scoreOf(grading::gradeBuilt(target_, plan, references, subject.build(target_), how));
  }

  Score gradePictures(const std::string& kind, const ScenePlan& plan, const References& references,
                      grading::JudgeServer& server) {
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
    result.items = server.judge(folders, work.path(), result.detail);
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
  grading::TemporaryFolder work_;
  std::vector<std::unique_ptr<Subject>> subjects_;
  std::mutex mutex_;
  std::size_t done_ = 0, total_;
};

} // namespace

std::vector<Measured> measure(const Target& target, const fs::path& solutionFolder,
                              const std::vector<Program>& programs, const MeasureOptions& options) {
  return Measurement(target, solutionFolder, programs, options).run();
}

} // namespace ggrade::calibration
