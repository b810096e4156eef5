#include "rubric/rubric.hpp"

#include "image/image.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ggrade::rubric {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::size_t kLogBytes = 2000; ///< of what a judging wrote, where it went wrong

/// Everything that is the same for all submissions.
struct Common {
  Evidence evidence;
  std::vector<ItemDeclaration> items;
  Floors floors;
};

/// A process of its own, which doesn't outlive this one.
pid_t forkBound() {
  const pid_t parent = getpid(), pid = fork();
  if (pid != 0) return pid;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  return 0;
}

/// Judges one submission.
int answer(Common& common, const json& request) {
  const json& folders = request.at("students");
  for (std::size_t i = 0; i < common.evidence.scenes.size(); ++i)
    if (folders.at(i) != "")
      readStudent(common.evidence.scenes[i], folders.at(i).get<std::string>());
  common.evidence.again = request.at("again").get<std::vector<std::string>>();
  // What the stub has of one frame is another matter than what it has of all.
  const bool again = !common.evidence.again.empty();
  if (again) keepFirstFrames(common.evidence);
  return judgeItems(common.evidence, common.items, again ? nullptr : &common.floors,
                    request.at("results").get<std::string>(),
                    request.at("arguments").get<std::vector<std::string>>());
}

/// What became of the process that answers; kJudged if all is well.
std::string waitFor(pid_t pid, const fs::path& log) {
  int status = 0;
  if (pid < 0) return fmt::format("the judge could not fork: {}", std::strerror(errno));
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) return fmt::format("the judge died of signal {}", WTERMSIG(status));
  if (WEXITSTATUS(status) == 0) return kJudged;
  std::string text = readFile(log);
  if (text.size() > kLogBytes) text = "..." + text.substr(text.size() - kLogBytes);
  return fmt::format("the judge ended with code {}:\n{}", WEXITSTATUS(status), text);
}

/// Makes `done` in one step. What can't be written is no answer: an empty file, or none.
void tell(const fs::path& done, const std::string& answer) {
  const fs::path file = done.string() + ".answer";
  std::ofstream(file) << answer << std::flush;
  fs::rename(file, done);
}

[[noreturn]] void handle(Common& common, const json& request) {
  const fs::path done = request.at("done").get<std::string>(), log = done.string() + ".log";
  const pid_t pid = forkBound();
  if (pid == 0) {
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file >= 0) {
      dup2(file, 1);
      dup2(file, 2);
    }
    int code = 1;
    try {
      code = answer(common, request);
    } catch (const std::exception& error) {
      std::cerr << error.what() << std::endl;
    }
    std::cout.flush();
    std::fflush(stdout);
    _exit(code);
  }
  try {
    tell(done, waitFor(pid, log));
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    _exit(1);
  }
  _exit(0);
}

} // namespace

int serveJudge(const fs::path& evidenceFile, bool many) {
  keepFreedMemory();
  Common common;
  common.evidence = readEvidence(evidenceFile);
  common.items = targetOf(common.evidence).items();
  const auto warmAll = [&] {
    for (const ItemDeclaration& item : common.items)
      warm(item, judgeOf(item.id), common.evidence, common.floors);
  };
  if (many) warmAll();
  for (std::string line; std::getline(std::cin, line);) {
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    const json request = json::parse(line);
    if (request.contains("warm")) {
      warmAll();
      continue;
    }
    const pid_t pid = forkBound();
    if (pid == 0) handle(common, request);
    if (pid < 0) tell(request.at("done").get<std::string>(), waitFor(pid, {}));
  }
  while (wait(nullptr) > 0) {
  }
  return 0;
}

} // namespace ggrade::rubric
