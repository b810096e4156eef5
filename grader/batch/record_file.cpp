#include "batch/record.hpp"

#include "assignment/assignment.hpp"
#include "report/write_file.hpp"

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
          {"given", row.given},        {"refused", row.refused},
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
  kept.at("given").get_to(row.given);
  kept.at("refused").get_to(row.refused);
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

void saveRecord(const fs::path& folder, const Record& record) {
  json kept = {
      {"row", toJson(record.row)},   {"target", record.target}, {"seed", record.seed},
      {"upload", record.upload},     {"grader", record.grader}, {"sandbox", record.sandbox},
      {"feedback", record.feedback}, {"run", record.run},       {"machine", record.machine}};
  for (const report::Adjustment& one : record.row.adjustments)
    kept["adjustments"].push_back({{"item", one.item},
                                   {"machine", one.machine},
                                   {"points", one.points},
                                   {"reason", one.reason},
                                   {"who", one.who},
                                   {"beyond", one.beyond}});
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
  record.machine = kept.value("machine", "");
  kept.at("feedback").get_to(record.feedback);
  kept.at("run").get_to(record.run);
  record.isAdjusted = kept.contains("adjustments");
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

} // namespace ggrade::batch
