#include "batch/pool.hpp"

#include "batch/turns.hpp"
#include "grading/workspace.hpp"
#include "sandbox/descriptor.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <deque>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace ggrade::batch {

using nlohmann::json;
using Clock = std::chrono::steady_clock;
using sandbox::Descriptor;

namespace {

constexpr int kAttempts = 2;
constexpr std::size_t kLongestAnswer = 1 << 20;
constexpr std::chrono::milliseconds kGrace{3000}; ///< for workers to stop what they run

struct Process {
  pid_t pid = -1;
  Descriptor to, from;
  std::string received;
  std::optional<std::size_t> job;
  Clock::time_point since = Clock::now();      ///< of its job, or its start
  std::optional<Clock::time_point> waitsSince; ///< for its turn
  bool isReady = false;                        ///< it has said so, its first line
};

/// Starts a worker; its standard error is ours.
Process start(const PoolOptions& options) {
  int jobs[2], answers[2];
  const auto refuse = [](int error) {
    throw std::system_error(error, std::generic_category(), "a worker can't be started");
  };
  if (pipe2(jobs, O_CLOEXEC) != 0) refuse(errno);
  Descriptor jobsRead(jobs[0]), jobsWrite(jobs[1]);
  if (pipe2(answers, O_CLOEXEC) != 0) refuse(errno);
  Descriptor answersRead(answers[0]), answersWrite(answers[1]);
  std::vector<std::string> words = options.worker, variables;
  std::vector<char*> argv, environment;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  for (char** variable = environ; *variable; ++variable)
    if (std::strncmp(*variable, "TMPDIR=", 7) != 0) variables.emplace_back(*variable);
  variables.push_back("TMPDIR=" + options.temporary);
  for (std::string& variable : variables) environment.push_back(variable.data());
  environment.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, jobsRead.get(), 0);
  posix_spawn_file_actions_adddup2(&actions, answersWrite.get(), 1);
  Process process;
  const int error = posix_spawn(&process.pid, options.program.c_str(), &actions, nullptr,
                                argv.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  if (error) refuse(error);
  process.to = std::move(jobsWrite);
  process.from = std::move(answersRead);
  return process;
}

class Pool {
public:
  Pool(const std::vector<Job>& jobs, const PoolOptions& options, const Replied& answered)
      : jobs_(jobs), options_(options), answered_(answered), attempts_(jobs.size()) {
    for (std::size_t i = 0; i < jobs.size(); ++i) waiting_.push_back(i);
  }
  ~Pool() { stop(); }

  void run() {
    for (;;) {
      if (grading::interrupted) throw grading::Interrupted{};
      while (processes_.size() < std::min<std::size_t>(options_.processes, open()))
        processes_.push_back(start(options_));
      for (Process& process : processes_)
        if (process.isReady && !process.job && !waiting_.empty()) give(process);
      takeTurns();
      if (open() == 0) return;
      listen();
      endTheStuck();
    }
  }

private:
  /// Jobs that have no last reply.
  std::size_t open() const {
    return waiting_.size() + std::size_t(std::ranges::count_if(processes_, [](const Process& one) {
             return one.job.has_value();
           }));
  }

  void give(Process& process) {
    const std::size_t job = waiting_.front();
    waiting_.pop_front();
    process.job = job;
    process.since = Clock::now();
    tell(process, toJson(jobs_[job]).dump());
  }

  void tell(Process& process, const std::string& text) {
    const std::string line = text + '\n';
    for (std::size_t done = 0; done < line.size();) {
      const ssize_t count = write(process.to.get(), line.data() + done, line.size() - done);
      if (count < 0 && errno == EINTR && !grading::interrupted) continue;
      if (count <= 0) {
        kill(process.pid, SIGKILL); // it would wait forever; now its answers end
        return;
      }
      done += std::size_t(count);
    }
  }

  void listen() {
    std::vector<pollfd> events;
    for (const Process& process : processes_) events.push_back({process.from.get(), POLLIN, 0});
    if (poll(events.data(), events.size(), 500) <= 0) return;
    for (std::size_t i = events.size(); i-- > 0;) {
      if (!events[i].revents) continue;
      Process& process = processes_[i];
      char block[4096];
      const ssize_t count = read(process.from.get(), block, sizeof block);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0 || process.received.size() > kLongestAnswer) {
        bury(i, count < 0 ? fmt::format("a worker can't be heard: {}", std::strerror(errno)) : "");
        continue;
      }
      process.received.append(block, std::size_t(count));
      try {
        for (std::size_t end; (end = process.received.find('\n')) != std::string::npos;) {
          const std::string line = process.received.substr(0, end);
          process.received.erase(0, end + 1);
          if (std::exchange(process.isReady, true)) hear(process, json::parse(line));
        }
      } catch (const json::exception&) {
        bury(i, "a worker gave an answer that makes no sense");
      }
    }
  }

  /// Before a job's reply come its wishes for runs.
  void hear(Process& process, const json& line) {
    if (!line.contains("runs")) return finish(process, replyFrom(line));
    const grading::Runs kind = runsFrom(line);
    turns_.ask(process.pid, kind);
    if (kind != grading::Runs::none) process.waitsSince = Clock::now();
  }

  void takeTurns() {
    for (const int pid : turns_.grant())
      for (Process& process : processes_)
        if (process.pid == pid) {
          process.since += Clock::now() - *process.waitsSince; // no time of its own
          process.waitsSince.reset();
          tell(process, "go");
        }
  }

  void finish(Process& process, const Reply& reply) {
    if (!process.job) return;
    const std::size_t job = *process.job;
    process.job.reset();
    process.waitsSince.reset();
    turns_.ask(process.pid, grading::Runs::none);
    const bool ours = !reply.problem.empty() || reply.outcome == "not_gradable";
    if (ours && ++attempts_[job] < kAttempts)
      waiting_.push_front(job);
    else
      answered_(job, reply);
  }

  void endTheStuck() {
    for (std::size_t i = processes_.size(); i-- > 0;)
      if ((processes_[i].job || !processes_[i].isReady) && !processes_[i].waitsSince &&
          Clock::now() - processes_[i].since > std::chrono::duration<double>(options_.seconds))
        bury(i, fmt::format("the grader itself was stuck for {:.0f} s", options_.seconds));
  }

  /// Ends a worker and answers for it.
  void bury(std::size_t index, std::string why) {
    Process process = std::move(processes_[index]);
    processes_.erase(processes_.begin() + std::ptrdiff_t(index));
    process.to.close();
    turns_.ask(process.pid, grading::Runs::none);
    if (!why.empty()) kill(process.pid, SIGKILL);
    int status = 0;
    while (waitpid(process.pid, &status, 0) < 0 && errno == EINTR) {
    }
    if (grading::interrupted) throw grading::Interrupted{};
    if (why.empty())
      why = WIFSIGNALED(status)
                ? fmt::format("the grader's own process died of signal {}", WTERMSIG(status))
                : fmt::format("the grader's own process ended with code {}", WEXITSTATUS(status));
    if (!process.isReady)
      throw std::runtime_error(
          why + " before it could grade anything. Mend that, then run the command again");
    Reply reply;
    reply.problem = why;
    finish(process, reply);
  }

  /// No worker is left: asked first, so that each can stop what it runs.
  void stop() {
    for (Process& process : processes_) {
      process.to.close();
      if (process.job) kill(process.pid, SIGTERM);
    }
    const auto end = Clock::now() + kGrace;
    for (Process& process : processes_) {
      while (waitpid(process.pid, nullptr, WNOHANG) == 0) {
        if (Clock::now() > end) kill(process.pid, SIGKILL);
        usleep(5000);
      }
    }
    processes_.clear();
  }

  const std::vector<Job>& jobs_;
  const PoolOptions& options_;
  const Replied& answered_;
  std::vector<int> attempts_; ///< that failed, by job
  std::deque<std::size_t> waiting_;
  std::vector<Process> processes_;
  Turns turns_; ///< by PID
};

} // namespace

void runJobs(const std::vector<Job>& jobs, const PoolOptions& options, const Replied& answered) {
  Pool(jobs, options, answered).run();
}

} // namespace ggrade::batch
