#include "grading/judge_server.hpp"

#include "grading/judge_process.hpp"

#include <fmt/format.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double kAnswerSeconds = 120;

} // namespace

JudgeServer::JudgeServer(const Target& target, const std::vector<rubric::SceneFolders>& scenes,
                         const Tolerances* tolerances)
    : target_(target) {
  std::vector<rubric::SceneFolders> common = scenes;
  for (rubric::SceneFolders& scene : common) scene.student.clear();
  const fs::path evidence = folder_.path() / "evidence.json", log = folder_.path() / "judge.log";
  rubric::writeEvidence(evidence, target.assignment.folder, target.id, common);

  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("the judge could not be started");
  std::vector<std::string> words = {"ggrade", "judge", evidence.string()};
  if (tolerances) {
    words.insert(words.end(), {"--tolerance", fmt::format("{}", tolerances->tolerance), "--radius",
                               fmt::format("{}", tolerances->radius)});
  }
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  const int failed = posix_spawn(&pid_, "/proc/self/exe", &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  requests_ = ends[1];
  if (failed) {
    close(requests_);
    throw std::runtime_error("the judge could not be started");
  }
}

JudgeServer::~JudgeServer() {
  close(requests_); // the server ends with its input
  if (end_.empty()) waitpid(pid_, nullptr, 0);
}

std::string JudgeServer::gone() {
  const std::lock_guard lock(mutex_);
  int status = 0;
  if (end_.empty() && waitpid(pid_, &status, WNOHANG) == pid_)
    end_ =
        (WIFSIGNALED(status) ? fmt::format("the judge died of signal {}", WTERMSIG(status))
                             : fmt::format("the judge ended with code {}", WEXITSTATUS(status))) +
        ": " + readFile(folder_.path() / "judge.log");
  return end_;
}

std::vector<report::Item> JudgeServer::judge(const std::vector<rubric::SceneFolders>& scenes,
                                             const fs::path& work, std::string& problem,
                                             const std::vector<std::string>& again) {
  json students = json::array();
  for (const rubric::SceneFolders& scene : scenes) students.push_back(scene.student.string());
  fs::path results, done;
  {
    const std::lock_guard lock(mutex_);
    results = work / fmt::format("items-{}.jsonl", ++asked_);
    done = work / fmt::format("done-{}", asked_);
    const std::string line = json{{"students", students},
                                  {"again", again},
                                  {"results", results.string()},
                                  {"done", done.string()}}
                                 .dump() +
                             '\n';
    if (write(requests_, line.data(), line.size()) != ssize_t(line.size()))
      problem = "the judge takes no requests";
  }
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(kAnswerSeconds);
  while (problem.empty() && !fs::exists(done)) {
    if (interrupted) throw Interrupted{};
    problem = gone();
    if (Clock::now() > end) problem = fmt::format("the judge took more than {} s", kAnswerSeconds);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (problem.empty()) problem = readFile(done);
  return readItems(target_, results);
}

} // namespace ggrade::grading
