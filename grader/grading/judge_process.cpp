#include "grading/judge_process.hpp"

#include "grading/workspace.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <string_view>
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

constexpr double kJudgeSeconds = 120;

/// Runs this same tool as `ggrade judge ...`; its output goes to `log`. Returns what went wrong, or
/// "".
std::string runJudgeProcess(std::vector<std::string> words, const fs::path& log) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  // A filter or shard of whoever called us must not drop items.
  std::vector<char*> environment;
  for (char** variable = environ; *variable; ++variable)
    if (std::string_view(*variable).substr(0, 6) != "GTEST_") environment.push_back(*variable);
  environment.push_back(nullptr);
  pid_t pid = 0;
  const int failed =
      posix_spawn(&pid, "/proc/self/exe", &actions, nullptr, argv.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed) return "the judge could not be started";

  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(kJudgeSeconds);
  int status = 0;
  while (waitpid(pid, &status, WNOHANG) == 0) {
    if (interrupted || Clock::now() > end) {
      kill(pid, SIGKILL);
      waitpid(pid, &status, 0);
      if (interrupted) throw Interrupted{};
      return fmt::format("the judge took more than {} s", kJudgeSeconds);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (WIFSIGNALED(status)) return fmt::format("the judge died of signal {}", WTERMSIG(status));
  if (WEXITSTATUS(status) == 0) return {};
  std::string text = readFile(log);
  if (text.size() > 2000) text = "..." + text.substr(text.size() - 2000);
  return fmt::format("the judge ended with code {}:\n{}", WEXITSTATUS(status), text);
}

std::string stepTitle(const Target& target, const std::string& todo) {
  for (const Part& part : target.parts)
    for (std::size_t i = 0; i < part.todos.size(); ++i)
      if (part.todos[i].id == todo) return gg::say("Step {}: {}", i + 1, part.todos[i].title);
  return todo;
}

} // namespace

report::Item unjudgedItem(const ItemDeclaration& declared) {
  report::Item item;
  item.id = declared.id;
  item.title = declared.title;
  item.looksAt = declared.looksAt;
  item.kind = declared.kind;
  item.points = declared.points;
  item.beyondLecture = declared.beyondLecture;
  return item;
}

std::vector<report::Item> readItems(const Target& target, const fs::path& results) {
  std::map<std::string, json> judged;
  std::ifstream in(results);
  for (std::string line; std::getline(in, line);) {
    const json one = json::parse(line, nullptr, false);
    if (one.is_object()) judged[one.at("id")] = one;
  }
  std::vector<report::Item> items;
  for (const ItemDeclaration& declared : target.items()) {
    report::Item item = unjudgedItem(declared);
    if (const auto found = judged.find(declared.id); found != judged.end()) {
      item.judged = true;
      item.earned = found->second.at("earned");
      item.message = found->second.at("message");
      for (const json& credit : found->second.at("credits")) {
        item.credits.emplace_back(credit.at(0), credit.at(1));
        item.messages.push_back(credit.at(2));
      }
      for (const json& outputs : found->second.at("outputs")) {
        item.outputs.push_back({outputs.at("scene"), {}});
        for (const json& pair : outputs.at("pairs"))
          item.outputs.back().pairs.push_back({pair.at(0), pair.at(1), pair.at(2), pair.at(3)});
      }
      const bool full =
          item.kind == report::ItemKind::keep ? item.earned >= 0 : item.earned >= item.points;
      if (!full) {
        item.cause = declared.cause;
        item.step = stepTitle(target, declared.step);
      }
    }
    items.push_back(std::move(item));
  }
  return items;
}

std::vector<report::Item> judge(const Target& target, const fs::path& evidence,
                                const fs::path& work, const std::vector<std::string>& arguments,
                                std::string& problem) {
  const fs::path results = work / "items.jsonl";
  std::vector<std::string> words = {"ggrade", "judge", evidence.string(), results.string(), "--"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  problem = runJudgeProcess(std::move(words), work / "judge.log");
  return readItems(target, results);
}

} // namespace ggrade::grading
