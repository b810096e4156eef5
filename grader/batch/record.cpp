#include "batch/record.hpp"

#include "grading/workspace.hpp"
#include "image/png.hpp"
#include "report/reports.hpp"
#include "report/summary.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

namespace ggrade::batch {

namespace fs = std::filesystem;
using report::ClassRow;

namespace {

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
  for (const std::string& one : result.refused) row.refused.push_back(report::sanitizeLine(one));
  if (!summary.thumbnail.empty()) {
    const auto bytes = encodePng(summary.thumbnail);
    row.thumbnail.assign(bytes.begin(), bytes.end());
  }
  record.seed = result.seed;
  record.target = result.part;
  record.sandbox = result.sandbox == "none" ? "none" : sandbox::version();
  for (const char* name : {"processor", "gl_renderer", "gl_version", "context"})
    for (const auto& [key, text] : result.fingerprint)
      if (key == name)
        record.machine += (record.machine.empty() ? "" : ", ") + report::sanitizeLine(text);
  record.feedback = feedbackOf(result, reveal);
  return record;
}

void publish(results::Result result, const Job& job, const Destination& destination) {
  const intake::Upload& upload = job.upload;
  result.submission = upload.name;
  Record record = recordOf(result, destination.reveal);
  record.row.folder = upload.folder;
  record.row.student = upload.student;
  record.row.given = upload.given;
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
