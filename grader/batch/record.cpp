#include "batch/record.hpp"

#include "assignment/assignment.hpp"
#include "grading/workspace.hpp"
#include "image/png.hpp"
#include "report/reports.hpp"
#include "report/summary.hpp"
#include "report/text.hpp"
#include "report/write_file.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <system_error>

namespace ggrade::batch {

namespace fs = std::filesystem;
using nlohmann::json;
using report::ClassRow;

namespace {

constexpr char kRecord[] = "record.json";
constexpr char kThumbnail[] = "thumbnail.png";
constexpr std::size_t kFeedbackBytes = 4000;

/// What a student can act on, without pages at hand.
std::string feedbackOf(const results::Result& result, report::Reveal reveal) {
  const results::Result view = report::studentView(result, reveal, false);
  std::string text = report::headline(view) + "\n";
  if (!view.detail.empty()) text += report::sanitizeLine(view.detail) + "\n";
  for (const results::Diagnosis& diagnosis : view.diagnoses) {
    text += report::sanitizeLine(diagnosis.text, 800) + "\n";
    if (!diagnosis.step.empty())
      text += gg::say("Read again: {}", report::sanitizeLine(diagnosis.step)) + '\n';
  }
  for (const results::Item* item : report::worstItems(view, 100))
    text += fmt::format("{}: {}. {}\n", report::sanitizeLine(item->title),
                        report::pointsText(*item), report::sanitizeLine(item->message));
  return report::capped(text, kFeedbackBytes);
}

json toJson(const ClassRow& row) {
  json items = json::array(), diagnoses = json::array();
  for (const report::ClassItem& item : row.items)
    items.push_back({{"id", item.id},
                     {"title", item.title},
                     {"kind", results::name(item.kind)},
                     {"earned", item.earned},
                     {"points", item.points},
                     {"judged", item.judged}});
  for (const report::ClassDiagnosis& diagnosis : row.diagnoses)
    diagnoses.push_back({{"id", diagnosis.id}, {"text", diagnosis.text}});
  return {{"folder", row.folder},      {"student", row.student},
          {"name", row.name},          {"outcome", results::name(row.outcome)},
          {"headline", row.headline},  {"reason", row.reason},
          {"score", row.score},        {"bonus", row.bonus},
          {"max_score", row.maxScore}, {"items", items},
          {"diagnoses", diagnoses},    {"remarks", row.remarks},
          {"seconds", row.seconds}};
}

ClassRow rowFrom(const json& kept) {
  ClassRow row;
  kept.at("folder").get_to(row.folder);
  kept.at("student").get_to(row.student);
  kept.at("name").get_to(row.name);
  row.outcome = results::parseOutcome(kept.at("outcome").get<std::string>()).value();
  kept.at("headline").get_to(row.headline);
  kept.at("reason").get_to(row.reason);
  kept.at("score").get_to(row.score);
  kept.at("bonus").get_to(row.bonus);
  kept.at("max_score").get_to(row.maxScore);
  for (const json& item : kept.at("items"))
    row.items.push_back({item.at("id"), item.at("title"),
                         results::parseItemKind(item.at("kind").get<std::string>()).value(),
                         item.at("earned"), item.at("points"), item.at("judged")});
  for (const json& diagnosis : kept.at("diagnoses"))
    row.diagnoses.push_back({diagnosis.at("id"), diagnosis.at("text")});
  kept.at("remarks").get_to(row.remarks);
  kept.at("seconds").get_to(row.seconds);
  return row;
}

} // namespace

Record recordOf(const results::Result& result, report::Reveal reveal) {
  const report::Summary summary = report::summarize(result);
  Record record;
  ClassRow& row = record.row;
  row.outcome = result.outcome;
  row.headline = report::sanitizeLine(summary.headline);
  row.reason = summary.reason == summary.headline ? "" : report::sanitizeLine(summary.reason, 400);
  row.score = result.score;
  row.bonus = result.bonus;
  row.maxScore = result.maxScore;
  for (const results::Item& item : result.items)
    row.items.push_back({item.id, report::sanitizeLine(item.title), item.kind, item.earned,
                         item.points, item.judged});
  for (const results::Diagnosis& diagnosis : result.diagnoses)
    row.diagnoses.push_back(
        {report::sanitizeLine(diagnosis.id), report::sanitizeLine(diagnosis.text, 800)});
  row.seconds = report::totalSeconds(result);
  if (!summary.thumbnail.empty()) {
    const auto bytes = encodePng(summary.thumbnail);
    row.thumbnail.assign(bytes.begin(), bytes.end());
  }
  record.seed = result.seed;
  record.target = result.part;
  record.sandbox = result.sandbox;
  record.feedback = feedbackOf(result, reveal);
  return record;
}

void saveRecord(const fs::path& folder, const Record& record) {
  const json kept = {{"row", toJson(record.row)},   {"target", record.target},
                     {"seed", record.seed},         {"upload", record.upload},
                     {"grader", record.grader},     {"sandbox", record.sandbox},
                     {"feedback", record.feedback}, {"run", record.run}};
  if (!record.row.thumbnail.empty()) report::writeFile(folder / kThumbnail, record.row.thumbnail);
  report::writeFile(folder / kRecord,
                    kept.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
}

std::optional<Record> loadRecord(const fs::path& folder) try {
  if (!fs::exists(folder / kRecord)) return std::nullopt;
  const json kept = json::parse(readFile(folder / kRecord));
  Record record;
  record.row = rowFrom(kept.at("row"));
  kept.at("target").get_to(record.target);
  kept.at("seed").get_to(record.seed);
  kept.at("upload").get_to(record.upload);
  kept.at("grader").get_to(record.grader);
  kept.at("sandbox").get_to(record.sandbox);
  kept.at("feedback").get_to(record.feedback);
  kept.at("run").get_to(record.run);
  if (record.row.folder != folder.filename().string()) return std::nullopt;
  if (fs::exists(folder / kThumbnail)) record.row.thumbnail = readFile(folder / kThumbnail);
  return record;
} catch (const std::system_error&) {
  throw; // it may well be good
} catch (const std::exception&) {
  return std::nullopt;
}

std::vector<Record> loadRecords(const fs::path& out, std::vector<std::string>* damaged) {
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(out))
    if (entry.is_directory() && !entry.path().filename().string().starts_with("."))
      folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  std::vector<Record> records;
  for (const fs::path& folder : folders)
    if (auto record = loadRecord(folder))
      records.push_back(std::move(*record));
    else if (damaged && (fs::exists(folder / kRecord) || fs::exists(folder / "results.json")))
      damaged->push_back(folder.filename().string());
  return records;
}

void publish(results::Result result, const Job& job, const Destination& destination) {
  const intake::Upload& upload = job.upload;
  result.submission = upload.name;
  Record record = recordOf(result, destination.reveal);
  record.row.folder = upload.folder;
  record.row.student = upload.student;
  record.row.name = upload.name;
  record.row.remarks = upload.remarks;
  record.upload = job.key;
  record.grader = destination.grader;
  record.run = destination.run;
  grading::TemporaryFolder written(destination.out);
  // A worker keeps to its own core.
  report::writeReports(written.path(), result, destination.reveal, std::launch::deferred);
  saveRecord(written.path(), record);
  written.publish(destination.out / upload.folder);
}

} // namespace ggrade::batch
