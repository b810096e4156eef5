#include "grading/judge.hpp"

#include "grading/toolchain.hpp"

#include "rubric/rubric.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double kAnswerSeconds = 120;

std::string headingIn(const Target& target, const std::string& todo) {
  for (const Part& part : target.parts)
    if (std::string heading = stepHeading(part, todo); !heading.empty()) return heading;
  return todo;
}

/// The items of `target`, filled in from the lines that the judge wrote.
std::vector<results::Item> readItems(const Target& target, const std::string& lines) {
  std::map<std::string, json> judged;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    const json one = json::parse(line, nullptr, false);
    if (one.is_object()) judged[one.at("id")] = one;
  }
  std::vector<results::Item> items;
  for (const ItemDeclaration& declared : target.items()) {
    results::Item item = unjudgedItem(declared);
    if (const auto found = judged.find(declared.id); found != judged.end()) {
      item.judged = true;
      item.earned = found->second.at("earned");
      item.message = found->second.at("message");
      for (const json& credit : found->second.at("credits")) {
        item.credits.push_back({credit.at(0), credit.at(1), credit.at(2)});
        item.messages.push_back(credit.at(3));
      }
      for (const json& outputs : found->second.at("outputs")) {
        item.outputs.push_back({outputs.at("scene"), {}});
        for (const json& pair : outputs.at("pairs"))
          item.outputs.back().pairs.push_back({pair.at(0), pair.at(1), pair.at(2), pair.at(3)});
      }
      const bool full =
          item.kind == results::ItemKind::keep ? item.earned >= 0 : item.earned >= item.points;
      if (!full) {
        item.cause = declared.cause;
        item.step = headingIn(target, declared.step);
      }
    }
    items.push_back(std::move(item));
  }
  return items;
}

/// A filter or shard of whoever called us must not drop items.
std::vector<char*> withoutGoogleTest() {
  std::vector<char*> environment;
  for (char** variable = environ; *variable; ++variable)
    if (!std::string_view(*variable).starts_with("GTEST_")) environment.push_back(*variable);
  environment.push_back(nullptr);
  return environment;
}

} // namespace

std::string stepHeading(const Part& part, const std::string& todo) {
  for (std::size_t i = 0; i < part.todos.size(); ++i)
    if (part.todos[i].id == todo) return gg::say("Step {}: {}", i + 1, part.todos[i].title);
  return {};
}

results::Item unjudgedItem(const ItemDeclaration& declared) {
  results::Item item;
  item.id = declared.id;
  item.title = declared.title;
  item.looksAt = declared.looksAt;
  item.kind = declared.kind;
  item.points = declared.points;
  item.beyondLecture = declared.beyondLecture;
  return item;
}

void keepScenes(std::vector<results::Item>& items, const std::vector<std::string>& scenes) {
  for (results::Item& item : items) {
    if (!item.judged) continue;
    double worst = 1;
    std::string message = "no scene shows it";
    std::vector<results::SceneCredit> credits;
    std::vector<std::string> messages;
    for (std::size_t i = 0; i < item.credits.size(); ++i) {
      const auto& [scene, credit, isPublic] = item.credits[i];
      if (std::ranges::find(scenes, scene) == scenes.end()) continue;
      if (credits.empty() || credit < worst) {
        worst = credit;
        message = fmt::format("{}: {}", scene, item.messages[i]);
      }
      credits.push_back(item.credits[i]);
      messages.push_back(item.messages[i]);
    }
    item.credits = std::move(credits);
    item.messages = std::move(messages);
    item.message = message;
    item.earned =
        rubric::pointsOf(item.kind, item.points, results::creditOf(item.kind, item.credits));
  }
}

fs::path judgeProgram() {
  return fs::path(toolchain::kBuildFolder) / "bin" / "ggrade";
}

Judge::Judge(const Target& target, std::vector<rubric::SceneFolders> scenes, bool many,
             const Tolerances* tolerances)
    : target_(target), scenes_(std::move(scenes)), warm_(many) {
  const fs::path evidence = folder_.path() / "evidence.json", log = folder_.path() / "judge.log";
  rubric::writeEvidence(evidence, target.assignment.folder, target.id, scenes_);

  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "the judge could not be started");
  std::vector<std::string> words = {"ggrade", "judge", evidence.string()};
  if (many) words.push_back("--many");
  if (tolerances)
    words.insert(words.end(), {"--tolerance", fmt::format("{}", tolerances->tolerance), "--radius",
                               fmt::format("{}", tolerances->radius)});
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  // A process group of its own, so that all of it can be ended at once.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int failed = posix_spawn(&pid_, judgeProgram().c_str(), &actions, &attributes, argv.data(),
                                 withoutGoogleTest().data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  requests_ = ends[1];
  if (failed) {
    close(requests_);
    throw std::system_error(failed, std::generic_category(), "the judge could not be started");
  }
}

Judge::~Judge() {
  close(requests_); // it ends with its input
  if (end_.empty()) waitpid(pid_, nullptr, 0);
}

void Judge::stop() {
  const std::lock_guard lock(mutex_);
  if (!end_.empty()) return;
  end_ = "the judge was stopped";
  // Without their parents those that it has forked become children of this process.
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  kill(-pid_, SIGKILL);
  while (waitpid(-pid_, nullptr, 0) > 0 || errno == EINTR) {
  }
}

std::string Judge::gone() {
  const std::lock_guard lock(mutex_);
  int status = 0;
  if (end_.empty() && waitpid(pid_, &status, WNOHANG) == pid_) {
    end_ = WIFSIGNALED(status) ? fmt::format("the judge died of signal {}", WTERMSIG(status))
                               : fmt::format("the judge ended with code {}", WEXITSTATUS(status));
    if (const std::string said = readFile(folder_.path() / "judge.log"); !said.empty())
      end_ += ": " + said;
  }
  return end_;
}

void Judge::warm() {
  const std::lock_guard lock(mutex_);
  if (warm_) return;
  warm_ = true;
  send({{"warm", true}});
}

bool Judge::send(const json& request) {
  const std::string line = request.dump() + '\n';
  return write(requests_, line.data(), line.size()) == ssize_t(line.size());
}

std::vector<results::Item> Judge::judge(const Request& request, const fs::path& work,
                                        std::string& problem) {
  json students = json::array();
  for (std::size_t i = 0; i < scenes_.size(); ++i)
    students.push_back(i < request.students.size() ? request.students[i].string() : "");
  fs::path results, done;
  bool sent = false;
  {
    const std::lock_guard lock(mutex_);
    results = work / fmt::format("items-{}.jsonl", ++asked_);
    done = work / fmt::format("done-{}", asked_);
    sent = send({{"students", students},
                 {"arguments", request.arguments},
                 {"again", request.again},
                 {"results", results.string()},
                 {"done", done.string()}});
  }
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(sent ? kAnswerSeconds : 1);
  while (problem.empty() && !fs::exists(done)) {
    if (interrupted) {
      stop(); // before the folder goes that it writes into
      throw Interrupted{};
    }
    problem = gone();
    if (problem.empty() && Clock::now() > end)
      problem = sent ? fmt::format("the judge took more than {} s", kAnswerSeconds)
                     : "the judge takes no requests";
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (problem.empty()) {
    const std::string answer = readFile(done);
    if (answer.empty())
      problem = fmt::format("the judge can't write {}: is the disk full?", done.string());
    else if (answer != rubric::kJudged)
      problem = answer;
  }
  const bool isThere = problem.empty() || fs::exists(results);
  std::vector<results::Item> items = readItems(target_, isThere ? readFile(results) : "");
  if (request.students.size() < scenes_.size()) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < request.students.size(); ++i) names.push_back(scenes_[i].name);
    keepScenes(items, names);
  }
  return items;
}

} // namespace ggrade::grading
