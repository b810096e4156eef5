#include "batch/publish.hpp"

#include "batch/record.hpp"
#include "grading/workspace.hpp"
#include "report/reports.hpp"

namespace ggrade::batch {

void publish(report::Result result, const Job& job, const Destination& destination) {
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
