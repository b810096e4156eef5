#include "report/results_json.hpp"

#include "report/summary.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ggrade::report {

using gg::say;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kCompilerBytes = 16 << 10;

Json value(double number) {
  return std::isfinite(number) ? Json(number) : Json(nullptr);
}

std::string title(const results::Item& item) {
  const std::string plain = sanitizeLine(item.title);
  if (item.kind == results::ItemKind::bonus) return say("Bonus: {}", plain);
  if (item.kind == results::ItemKind::keep)
    return say("{} (takes away up to {})", plain, number(item.points));
  return plain;
}

std::string outputOf(const results::Item& item) {
  std::string text;
  const auto add = [&](const std::string& part) {
    if (!part.empty()) text += part + '\n';
  };
  add(item.judged ? sanitizeLine(item.message) : say("Not judged."));
  add(carriedText(item));
  if (!item.where.empty()) add(say("Where: {}", sanitizeLine(item.where)));
  if (!item.cause.empty()) add(say("Likely cause: {}", sanitizeLine(item.cause)));
  if (!item.step.empty()) add(say("Read again: {}", sanitizeLine(item.step)));
  return text;
}

Json testOf(const results::Item& item, std::size_t number) {
  Json tags = {name(item.kind)};
  if (item.beyondLecture) tags.push_back("beyond_lecture");
  return {{"score", value(item.earned)},
          {"max_score", item.kind == results::ItemKind::keep ? Json(0) : value(item.points)},
          {"status", standing(item) == Standing::full ? "passed" : "failed"},
          {"name", title(item)},
          {"name_format", "text"},
          {"number", std::to_string(number)},
          {"output", outputOf(item)},
          {"output_format", "text"},
          {"tags", tags},
          {"visibility", "visible"},
          {"extra_data",
           {{"id", sanitizeLine(item.id)}, {"kind", name(item.kind)}, {"judged", item.judged}}}};
}

std::string summary(const results::Result& view) {
  std::string text = headline(view) + "\n";
  if (!view.detail.empty()) text += sanitize(view.detail) + "\n";
  for (const results::Diagnosis& diagnosis : view.diagnoses) {
    text += '\n' + say("Diagnosis: {}", sanitizeLine(diagnosis.text, 800)) + '\n';
    if (const std::string seen = whatIsWrong(diagnosis); !seen.empty())
      text += say("First wrong: {}", seen) + '\n';
    if (!diagnosis.step.empty()) text += say("Read again: {}", sanitizeLine(diagnosis.step)) + '\n';
    for (const std::string& line : diagnosis.beside) text += sanitizeLine(line) + "\n";
  }
  for (const std::string& file : view.unusedFiles)
    text += say("Not used: {}", sanitizeLine(file)) + '\n';
  if (!view.compilerOutput.empty())
    text += '\n' + say("Compiler:") + '\n' + capped(sanitize(view.compilerOutput), kCompilerBytes);
  return text;
}

Json extraData(const results::Result& result) {
  Json data = {{"outcome", name(result.outcome)},
               {"detail", sanitize(result.detail)},
               {"assignment", sanitizeLine(result.assignment)},
               {"part", sanitizeLine(result.part)},
               {"submission", sanitizeLine(result.submission)},
               {"score_without_bonus", value(result.score)},
               {"bonus", value(result.bonus)},
               {"max_score", value(result.maxScore)},
               {"seed", result.seed},
               {"quality", result.quality},
               {"sandbox", sanitizeLine(result.sandbox)},
               {"fingerprint", Json::object()},
               {"thresholds", Json::object()},
               {"timings", Json::object()},
               {"diagnoses", Json::array()},
               {"items", Json::array()},
               {"scenes", Json::array()},
               {"unused_files", Json::array()}};
  for (const auto& [key, text] : result.fingerprint)
    data["fingerprint"][sanitizeLine(key)] = sanitizeLine(text);
  for (const auto& [key, number] : result.thresholds)
    data["thresholds"][sanitizeLine(key)] = value(number);
  for (const results::Timing& timing : result.timings)
    data["timings"][sanitizeLine(timing.what)] = value(timing.seconds);
  for (const results::Diagnosis& diagnosis : result.diagnoses)
    data["diagnoses"].push_back({{"part", sanitizeLine(diagnosis.part)},
                                 {"id", sanitizeLine(diagnosis.id)},
                                 {"confidence", value(diagnosis.confidence)},
                                 {"text", sanitizeLine(diagnosis.text, 800)},
                                 {"step", sanitizeLine(diagnosis.step)},
                                 {"picture", sanitizeLine(diagnosis.picture)},
                                 {"amount", sanitizeLine(diagnosis.amount)},
                                 {"scene", sanitizeLine(diagnosis.scene)},
                                 {"place", sanitizeLine(diagnosis.place)}});
  for (const results::ProvedCause& cause : result.causes)
    data["proved_causes"].push_back({{"passes", cause.passes},
                                     {"unit", sanitizeLine(cause.unit)},
                                     {"todos", cause.todos},
                                     {"own", cause.own}});
  if (!result.causesSought.empty()) data["causes_sought"] = sanitizeLine(result.causesSought, 400);
  for (const results::Item& item : result.items) {
    Json credits = Json::object();
    for (const results::SceneCredit& one : item.credits)
      credits[sanitizeLine(one.scene)] = value(one.credit);
    Json carried = Json::array();
    for (const std::string& output : item.carried) carried.push_back(sanitizeLine(output));
    data["items"].push_back({{"id", sanitizeLine(item.id)},
                             {"kind", name(item.kind)},
                             {"earned", value(item.earned)},
                             {"points", value(item.points)},
                             {"judged", item.judged},
                             {"message", sanitizeLine(item.message)},
                             {"where", sanitizeLine(item.where)},
                             {"credits", credits},
                             {"carried_forward", carried}});
  }
  for (const results::Scene& scene : result.scenes) {
    Json frames = Json::array();
    for (const results::Frame& frame : scene.frames)
      frames.push_back({{"time", value(frame.time)},
                        {"wrong_share", value(frame.wrongShare)},
                        {"flip", value(frame.flip)},
                        {"unsteady_share", value(frame.unsteadyShare)},
                        {"hash", sanitizeLine(frame.hash)}});
    data["scenes"].push_back({{"name", sanitizeLine(scene.name)},
                              {"public", scene.isPublic},
                              {"outcome", sanitizeLine(scene.outcome)},
                              {"detail", sanitizeLine(scene.detail)},
                              {"seconds", value(scene.seconds)},
                              {"frames", frames}});
  }
  for (const std::string& file : result.unusedFiles)
    data["unused_files"].push_back(sanitizeLine(file));
  return data;
}

} // namespace

std::string resultsJson(const results::Result& result, Reveal reveal) {
  const results::Result view = studentView(result, reveal, false);
  Json tests = Json::array();
  for (std::size_t i = 0; i < view.items.size(); ++i) tests.push_back(testOf(view.items[i], i + 1));
  const bool hasScore = result.outcome != results::Outcome::notGradable;
  const Json json = {{"score", hasScore ? value(result.score + result.bonus) : Json(nullptr)},
                     {"execution_time", value(totalSeconds(result))},
                     {"output", summary(view)},
                     {"output_format", "text"},
                     {"test_output_format", "text"},
                     {"test_name_format", "text"},
                     {"visibility", "visible"},
                     {"stdout_visibility", "hidden"},
                     {"extra_data", extraData(result)},
                     {"tests", tests},
                     {"leaderboard", Json::array()}};
  return json.dump(2) + "\n";
}

} // namespace ggrade::report
