#include "batch/worker.hpp"

#include "batch/publish.hpp"
#include "grading/grade.hpp"
#include "grading/judge_server.hpp"
#include "grading/overlay.hpp"
#include "image/memory.hpp"
#include "intake/unpack.hpp"
#include "report/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <iostream>

#include <sys/prctl.h>
#include <unistd.h>

namespace ggrade::batch {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

class Worker {
public:
  Worker(const Target& target, const fs::path& solutionFolder, const WorkerOptions& options)
      : target_(target), options_(options),
        plan_(grading::drawScenes(target, solutionFolder, options.draw)),
        references_(grading::prepareReferences(target, solutionFolder, plan_, quiet)),
        judge_(target, references_.scenes), grader_(graderOf(target, solutionFolder, plan_)) {
    how_.threads = 1;
    how_.referencePictures = std::make_shared<grading::ReferencePictures>();
    how_.judging = [this](const auto& scenes, const fs::path& work, std::string& problem,
                          const std::vector<std::string>& again) {
      return judge_.judge(scenes, work, problem, again);
    };
    if (options.diagnosis) how_.examining = grading::diagnosing(target, solutionFolder, quiet);
  }

  /// Grades and publishes.
  Answer grade(const Job& job) {
    const auto start = std::chrono::steady_clock::now();
    grading::TemporaryFolder unpacked;
    report::Result result = gradeUpload(job.upload, unpacked.path() / "upload");
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    result.timings.push_back({"total", passed.count()});
    Answer answer{{},
                  std::string(report::name(result.outcome)),
                  result.score + result.bonus,
                  result.maxScore,
                  passed.count()};
    publish(std::move(result), job, {options_.out, options_.reveal, grader_, options_.run});
    return answer;
  }

private:
  static void quiet(const std::string&, std::size_t, std::size_t) {}

  report::Result gradeUpload(const intake::Upload& upload, const fs::path& folder) {
    const intake::Unpacked unpacked = intake::unpack(upload, target_.assignment.files, folder,
                                                     grading::isolation(), &grading::interrupted);
    report::Result result;
    if (!unpacked.problem.empty()) {
      result = grading::ungraded(target_, report::Outcome::buildFailed, unpacked.problem);
    } else {
      grading::GradeOptions how = how_;
      how.upload = folder;
      try {
        const grading::Built built = grading::buildSubmission(target_, how);
        result = grading::gradeBuilt(target_, plan_, references_, built, how);
      } catch (const grading::NothingToGrade& error) {
        result = grading::ungraded(target_, report::Outcome::buildFailed, error.what());
      }
    }
    grading::nameScenes(plan_, result);
    for (const auto* list : {&unpacked.refused, &unpacked.remarks})
      result.unusedFiles.insert(result.unusedFiles.end(), list->begin(), list->end());
    return result;
  }

  const Target& target_;
  const WorkerOptions& options_;
  const grading::ScenePlan plan_;
  const grading::References references_;
  grading::JudgeServer judge_;
  const std::string grader_;
  grading::GradeOptions how_;
};

/// A worker whose parent was killed must not go on beside the next run's.
void endWithParent() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() == 1) _exit(1);
}

} // namespace

void work(const Target& target, const fs::path& solutionFolder, const WorkerOptions& options) {
  endWithParent();
  keepFreedMemory();
  Worker worker(target, solutionFolder, options);
  std::cout << "ready" << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    Answer answer;
    try {
      answer = worker.grade(jobFrom(json::parse(line)));
    } catch (const std::exception& error) {
      answer.problem = report::sanitizeLine(error.what());
      if (answer.problem.empty()) answer.problem = "an error without words";
    }
    std::cout << toJson(answer).dump() << std::endl;
  }
}

} // namespace ggrade::batch
