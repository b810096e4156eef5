#include "calibration/score_file.hpp"

#include "grading/workspace.hpp"

#include <fmt/format.h>

#include <fstream>

namespace ggrade::calibration {

namespace fs = std::filesystem;
using nlohmann::json;

json toJson(const Score& score) {
  json measures = json::object();
  for (const auto& [name, error] : score.measures)
    measures[name] = {{"worst", error.worst}, {"ms", error.ms}};
  return {{"seed", score.seed},         {"outcome", results::name(score.outcome)},
          {"detail", score.detail},     {"score", score.score},
          {"bonus", score.bonus},       {"seconds", score.seconds},
          {"judge_ms", score.judgeMs},  {"earned", score.earned},
          {"messages", score.messages}, {"measures", measures}};
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
  score.messages = from.at("messages").get<std::map<std::string, std::string>>();
  score.outcome = results::parseOutcome(from.at("outcome").get<std::string>())
                      .value_or(results::Outcome::graded);
  return score;
}

std::optional<Score> loadScore(const fs::path& file) {
  std::ifstream in(file);
  const json read = json::parse(in, nullptr, false);
  try {
    return scoreFrom(read);
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

void saveScore(const fs::path& file, const Score& score) {
  grading::TemporaryFolder work(file.parent_path());
  const fs::path whole = work.path() / "score.json";
  std::ofstream out(whole);
  if (!(out << toJson(score).dump()) || !out.flush())
    throw UsageError(fmt::format("can't write {}: is the disk full?", file.string()));
  fs::rename(whole, file);
}

} // namespace ggrade::calibration
