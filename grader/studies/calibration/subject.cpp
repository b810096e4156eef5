#include "calibration/subject.hpp"

namespace ggrade::calibration {

namespace fs = std::filesystem;

const grading::Built& Subject::build(grading::Grader& grader) {
  std::call_once(once, [&] { built = grader.build(program, true); });
  return built;
}

std::vector<std::unique_ptr<Subject>> subjectsOf(const Target& target,
                                                 const std::vector<KnownAnswer>& programs) {
  std::vector<std::unique_ptr<Subject>> all;
  for (const KnownAnswer& program : programs) {
    all.push_back(std::make_unique<Subject>());
    Subject& subject = *all.back();
    subject.measured.program = program;
    if (program.kind == Kind::pictures) {
      subject.key = "pictures " + program.name;
      continue;
    }
    try {
      subject.program = std::make_shared<grading::Program>(target.assignment, program.recipe);
      subject.key = subject.program->key();
    } catch (const UsageError& error) {
      subject.measured.problem = error.what();
    }
  }
  return all;
}

grading::GraderOptions graderOptions(bool twice) {
  grading::GraderOptions how;
  how.pictures = how.diagnosis = false;
  how.twice = twice;
  how.many = true;
  how.threads = 1;
  return how;
}

fs::path scoreFile(const std::string& key) {
  const fs::path folder = grading::cacheFolder() / "scores";
  fs::create_directories(folder);
  return folder / (grading::hashOf(key) + ".json");
}

namespace {

grading::References prepare(const Target& target, const fs::path& solutionFolder,
                            const grading::ScenePlan& plan, const fs::path& folder) {
  const auto quiet = [](const auto&, auto, auto) {};
  const grading::ScenePlan usual =
      grading::drawScenes(target, solutionFolder, {std::nullopt, plan.quality});
  grading::References own = grading::prepareReferences(target, solutionFolder, usual, quiet);
  grading::References all =
      grading::describe(plan) == grading::describe(usual)
          ? std::move(own)
          : grading::prepareReferences(target, solutionFolder, plan, quiet, folder);
  // Most programs of the catalogue share most shaders with the reference: half of a run's time.
  all.shaders = all.ownShaders;
  return all;
}

} // namespace

SeedPictures::SeedPictures(const Target& target, const fs::path& solutionFolder,
                           const grading::ScenePlan& plan)
    : folder_(grading::cacheFolder()),
      references(prepare(target, solutionFolder, plan, folder_.path())) {}

Score scoreOf(const results::Result& result) {
  Score score;
  score.seed = result.seed;
  score.outcome = result.outcome;
  score.detail = result.detail;
  score.score = result.score;
  score.bonus = result.bonus;
  for (const results::Timing& timing : result.timings)
    if (timing.what != "build" && timing.what != "diagnose") score.seconds += timing.seconds;
  for (const results::Item& item : result.items) {
    score.earned[item.id] = item.earned;
    const double full = item.kind == results::ItemKind::keep ? 0 : item.points;
    if (item.earned < full) score.messages[item.id] = item.message;
  }
  return score;
}

} // namespace ggrade::calibration
