#include "calibration/subject.hpp"

#include "grading/workspace.hpp"

#include <fmt/format.h>

#include <fstream>

namespace ggrade::calibration {

namespace fs = std::filesystem;
using nlohmann::json;

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
  if (!result.causes.empty())
    for (const results::Item& item : result.asDrawn) score.asDrawn[item.id] = item.earned;
  return score;
}

json toJson(const Score& score) {
  json measures = json::object();
  for (const auto& [name, error] : score.measures)
    measures[name] = {{"worst", error.worst}, {"ms", error.ms}};
  return {{"seed", score.seed},        {"outcome", results::name(score.outcome)},
          {"detail", score.detail},    {"score", score.score},
          {"bonus", score.bonus},      {"seconds", score.seconds},
          {"judge_ms", score.judgeMs}, {"earned", score.earned},
          {"as_drawn", score.asDrawn}, {"messages", score.messages},
          {"measures", measures}};
}

Score scoreFrom(const json& from) {
  Score score;
  score.seed = from.at("seed");
  score.detail = from.at("detail");
  score.score = from.at("score");
  score.bonus = from.at("bonus");
  score.seconds = from.at("seconds");
  score.judgeMs = from.at("judge_ms");
  for (const auto& [name, error] : from.at("measures").items())
    score.measures[name] = {error.at("worst"), error.at("ms")};
  score.earned = from.at("earned").get<std::map<std::string, double>>();
  score.asDrawn = from.at("as_drawn").get<std::map<std::string, double>>();
  score.messages = from.at("messages").get<std::map<std::string, std::string>>();
  score.outcome = results::parseOutcome(from.at("outcome").get<std::string>())
                      .value_or(results::Outcome::graded);
  return score;
}

std::optional<json> loadKept(const fs::path& file) {
  std::ifstream in(file);
  json read = json::parse(in, nullptr, false);
  if (!read.is_object()) return std::nullopt;
  return read;
}

void saveKept(const fs::path& file, const json& kept) {
  grading::TemporaryFolder work(file.parent_path());
  const fs::path whole = work.path() / "score.json";
  std::ofstream out(whole);
  if (!(out << kept.dump()) || !out.flush())
    throw UsageError(fmt::format("can't write {}: is the disk full?", file.string()));
  fs::rename(whole, file);
}

std::optional<Score> loadScore(const fs::path& file) {
  const std::optional<json> kept = loadKept(file);
  try {
    if (kept) return scoreFrom(*kept);
  } catch (const json::exception&) { // it isn't a score: as if it weren't there
  }
  return std::nullopt;
}

void saveScore(const fs::path& file, const Score& score) {
  saveKept(file, toJson(score));
}

} // namespace ggrade::calibration
