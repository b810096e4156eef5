#include "rubric/rubric.hpp"

#include "image/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>

#include <sys/wait.h>
#include <unistd.h>

namespace ggrade::rubric {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Everything that is the same for all submissions.
struct Common {
  Evidence evidence;
  std::vector<ItemDeclaration> items;
  Floors floors;
};

/// Judges one submission; runs in a process of its own.
void answer(Common& common, const json& request) {
  const json& folders = request.at("students");
  for (std::size_t i = 0; i < common.evidence.scenes.size(); ++i)
    if (folders.at(i) != "")
      readStudent(common.evidence.scenes[i], folders.at(i).get<std::string>());
  common.evidence.again = request.at("again").get<std::vector<std::string>>();
  const bool again = !common.evidence.again.empty();
  if (again) keepFirstFrames(common.evidence);
  std::ofstream out(request.at("results").get<std::string>(), std::ios::app);
  for (const ItemDeclaration& item : common.items) {
    if (again && std::find(common.evidence.again.begin(), common.evidence.again.end(), item.id) ==
                     common.evidence.again.end())
      continue;
    // What the stub has of one frame is another matter than what it has of all.
    const Decision decision =
        decide(item, judgeOf(item.id), common.evidence, again ? nullptr : &common.floors);
    json line = lineOf(item, decision);
    line["outputs"] = outputsOf(item, common.items, decision, common.evidence);
    out << line.dump() << std::endl;
  }
}

/// What became of the process that answers; "" if all is well.
std::string waitFor(pid_t pid) {
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) return fmt::format("the judge died of signal {}", WTERMSIG(status));
  return WEXITSTATUS(status) == 0
             ? std::string()
             : fmt::format("the judge ended with code {}", WEXITSTATUS(status));
}

[[noreturn]] void handle(Common& common, const std::string& line) {
  const json request = json::parse(line);
  const fs::path done = request.at("done").get<std::string>();
  const fs::path problem = done.string() + ".problem";
  std::ofstream(problem).flush();
  const pid_t pid = fork();
  if (pid == 0) {
    try {
      answer(common, request);
      _exit(0);
    } catch (const std::exception& error) {
      std::ofstream(problem) << error.what();
      _exit(1);
    }
  }
  if (const std::string end = waitFor(pid); !end.empty())
    std::ofstream(problem, std::ios::app) << (fs::file_size(problem) ? ": " : "") << end;
  fs::rename(problem, done);
  _exit(0);
}

} // namespace

int serveJudge(const fs::path& evidenceFile) {
  keepFreedMemory();
  Common common;
  common.evidence = readEvidence(evidenceFile);
  common.items = targetOf(common.evidence).items();
  for (const ItemDeclaration& item : common.items)
    warm(item, judgeOf(item.id), common.evidence, common.floors);
  for (std::string line; std::getline(std::cin, line);) {
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    if (fork() == 0) handle(common, line);
  }
  while (wait(nullptr) > 0) {
  }
  return 0;
}

} // namespace ggrade::rubric
