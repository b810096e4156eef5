#include "batch/worker.hpp"

#include "batch/record.hpp"
#include "grading/grade.hpp"
#include "image/image.hpp"
#include "report/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <iostream>
#include <system_error>

#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace ggrade::batch {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Whoever waits for a line that can't be written sees the end of this process instead.
void tell(const std::string& line) {
  if (!(std::cout << line << std::endl))
    throw std::system_error(errno, std::generic_category(), "a worker can't answer");
}

class Worker {
public:
  Worker(const Target& target, const fs::path& solutionFolder, const WorkerOptions& options)
      : options_(options),
        grader_(target, solutionFolder, grading::drawScenes(target, solutionFolder, options.draw),
                how()),
        key_(graderOf(target, solutionFolder, grader_.plan())) {
    grader_.prepare();
  }

  /// Grades and publishes.
  Reply grade(const Job& job) {
    const auto start = std::chrono::steady_clock::now();
    results::Result result = grader_.gradeUpload(job.upload);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    result.timings.push_back({"total", passed.count()});
    Reply reply{{},
                std::string(results::name(result.outcome)),
                result.score + result.bonus,
                result.maxScore,
                passed.count()};
    publish(std::move(result), job, {options_.out, options_.reveal, key_, options_.run});
    return reply;
  }

private:
  grading::GraderOptions how() const {
    grading::GraderOptions how;
    how.diagnosis = options_.diagnosis;
    how.many = true;
    how.threads = 1; // a worker keeps to its own core
    how.begins = [](grading::Runs kind) {
      tell(batch::toJson(kind).dump());
      std::string go;
      if (kind != grading::Runs::none && !std::getline(std::cin, go)) throw grading::Interrupted{};
    };
    return how;
  }

  const WorkerOptions& options_;
  grading::Grader grader_;
  const std::string key_; ///< see graderOf
};

} // namespace

void endWithParent() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // It may have died before that: then nobody holds the other end of the jobs. Whose child this is
  // now doesn't tell: a container's first process, whose number is 1, may be the parent.
  pollfd jobs{STDIN_FILENO, 0, 0};
  if (poll(&jobs, 1, 0) > 0 && (jobs.revents & POLLHUP)) _exit(1);
}

void answerJobs(const std::function<Reply(const Job&)>& grade) {
  tell("ready");
  for (std::string line; std::getline(std::cin, line);) {
    Reply reply;
    try {
      Job job = jobFrom(json::parse(line));
      if (job.key.empty()) job.key = keyOf(job.upload);
      reply = grade(job);
    } catch (const std::exception& error) {
      reply.problem = report::sanitizeLine(error.what());
      if (reply.problem.empty()) reply.problem = "an error without words";
    }
    tell(toJson(reply).dump());
  }
}

void work(const Target& target, const fs::path& solutionFolder, const WorkerOptions& options) {
  endWithParent();
  keepFreedMemory();
  Worker worker(target, solutionFolder, options);
  answerJobs([&](const Job& job) { return worker.grade(job); });
}

} // namespace ggrade::batch
