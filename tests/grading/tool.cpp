#include "tool.hpp"

#include "authoring/solution_blocks.hpp"
#include "grading/recipe.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tool {

namespace {

using Clock = std::chrono::steady_clock;

Clock::time_point after(double seconds) {
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

void pause() {
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

std::string readWhatIsThere(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

Running::Running(const Arguments& words, const Environment& environment, const fs::path& folder) {
  const std::string out = files_.path() / "out", errors = files_.path() / "errors";
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error(std::string("fork: ") + std::strerror(errno));
  if (pid_ > 0) {
    setpgid(pid_, pid_); // here and there: whoever comes first
    return;
  }
  setpgid(0, 0);
  const auto to = [](const char* file, int descriptor, int flags) {
    const int opened = open(file, flags, 0644);
    if (opened < 0 || dup2(opened, descriptor) < 0) _exit(125);
  };
  to("/dev/null", 0, O_RDONLY);
  to(out.c_str(), 1, O_WRONLY | O_CREAT | O_TRUNC);
  to(errors.c_str(), 2, O_WRONLY | O_CREAT | O_TRUNC);
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  if (chdir(folder.c_str()) != 0) _exit(125);
  execv(argv[0], argv.data());
  _exit(125);
}

Running::~Running() {
  if (pid_ > 0) wait(0);
}

std::string Running::out() const {
  return readWhatIsThere(files_.path() / "out");
}

std::string Running::errors() const {
  return readWhatIsThere(files_.path() / "errors");
}

bool Running::says(const std::string& text, double seconds) const {
  for (const auto end = after(seconds); Clock::now() < end; pause())
    if (errors().find(text) != std::string::npos) return true;
  return false;
}

void Running::signalGroup(int signal) const {
  kill(-pid_, signal);
}

Ended Running::wait(double seconds) {
  Ended ended;
  int status = 0;
  const auto end = after(seconds);
  while (waitpid(pid_, &status, WNOHANG) == 0) {
    if (Clock::now() >= end) {
      ended.late = true;
      kill(-pid_, SIGKILL);
      waitpid(pid_, &status, 0);
      break;
    }
    pause();
  }
  pid_ = -1;
  if (WIFEXITED(status)) ended.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  ended.out = readWhatIsThere(files_.path() / "out");
  ended.errors = readWhatIsThere(files_.path() / "errors");
  return ended;
}

Arguments words(const Arguments& arguments) {
  Arguments all = {kBuild / "bin" / "ggrade"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}

Ended runTool(const Arguments& arguments, const Environment& environment, double seconds) {
  return Running(words(arguments), environment).wait(seconds);
}

Submission::Submission() : folder_(std::make_unique<TemporaryFolder>()) {
  fs::create_directory(path());
}

Submission Submission::solution() {
  Submission made;
  for (const std::string& file : ggrade::Assignment::load(kSource / "assignments/floor").files)
    fs::copy_file(kSource / "solutions/floor" / file, made.path() / file);
  return made;
}

Submission Submission::stub() {
  Submission made;
  for (const std::string& file : ggrade::Assignment::load(kSource / "assignments/floor").files)
    fs::copy_file(kSource / "assignments/floor" / file, made.path() / file);
  return made;
}

Submission Submission::example(const std::string& name) {
  Submission made;
  const fs::path solutions = kSource / "solutions/floor";
  ggrade::grading::writeFiles(ggrade::Assignment::load(kSource / "assignments/floor"),
                              {solutions, {solutions / "examples" / (name + ".patch")}},
                              made.path());
  return made;
}

Submission Submission::firstSteps(int count, const std::string& part) {
  Submission made;
  const Ended ended =
      runTool({"derive", part, "--done", std::to_string(count), "--out", made.path()});
  if (ended.exitCode != 0) throw std::runtime_error(ended.errors);
  return made;
}

Submission Submission::program(const std::string& text) {
  Submission made;
  made.write("floor.cpp", text);
  return made;
}

Submission& Submission::replace(const std::string& file, const std::string& from,
                                const std::string& to) {
  std::string text = read(path() / file);
  const std::size_t at = text.find(from);
  if (at == text.npos || text.find(from, at + 1) != text.npos)
    throw std::runtime_error(file + " must hold exactly once: " + from);
  return write(file, text.replace(at, from.size(), to));
}

Submission& Submission::write(const std::string& file, const std::string& text) {
  std::ofstream(path() / file, std::ios::binary) << text;
  return *this;
}

namespace {

const nlohmann::json& itemOf(const nlohmann::json& results, const std::string& id) {
  for (const auto& item : results.at("extra_data").at("items"))
    if (item.at("id") == id) return item;
  throw std::runtime_error("results.json has no item " + id);
}

} // namespace

std::string Graded::outcome() const {
  return results.at("extra_data").at("outcome");
}
std::string Graded::detail() const {
  return results.at("extra_data").at("detail");
}
double Graded::score() const {
  return results.at("extra_data").at("score_without_bonus");
}
double Graded::bonus() const {
  return results.at("extra_data").at("bonus");
}
double Graded::earned(const std::string& item) const {
  return itemOf(results, item).at("earned");
}
std::string Graded::message(const std::string& item) const {
  return itemOf(results, item).at("message");
}

std::vector<std::string> Graded::lost() const {
  std::vector<std::string> all;
  for (const auto& item : results.at("extra_data").at("items")) {
    const double full = item.at("kind") == "gain" ? item.at("points").get<double>() : 0;
    if (item.at("kind") != "bonus" && item.at("earned") < full) all.push_back(item.at("id"));
  }
  return all;
}

std::string Graded::text() const {
  std::ostringstream out;
  out << outcome() << ", " << score() << " + " << bonus() << "; " << detail();
  for (const auto& item : results.at("extra_data").at("items"))
    out << "\n    " << item.at("id").get<std::string>() << ' ' << item.at("earned") << "  "
        << item.at("message").get<std::string>();
  return out.str();
}

Graded gradePart(const std::string& part, const fs::path& folder, const Arguments& more,
                 const Environment& environment) {
  const TemporaryFolder results;
  // Most tests are about points; known mistakes need not be drawn for them.
  Arguments arguments = {"grade", part, folder, "--out", results.path() / "out", "--no-diagnosis"};
  const bool diagnosed = std::ranges::find(more, kDiagnosed) != more.end();
  if (diagnosed) arguments.pop_back();
  std::ranges::copy_if(more, std::back_inserter(arguments),
                       [](const std::string& one) { return one != kDiagnosed; });
  // The first diagnosis of a part draws all of its mistakes.
  Graded graded{runTool(arguments, environment, diagnosed ? 400 : 100), {}};
  EXPECT_FALSE(graded.ended.late);
  const fs::path file = results.path() / "out/results.json";
  if (!fs::exists(file)) throw std::runtime_error("no results.json: " + graded.ended.errors);
  graded.results = nlohmann::json::parse(read(file));
  std::cout << graded.text() << '\n'; // what the log of a failure needs
  return graded;
}

Graded gradePart(const std::string& part, const Submission& submission) {
  return gradePart(part, submission.path());
}

Graded grade(const fs::path& folder, const Arguments& more, const Environment& environment) {
  return gradePart("mirror", folder, more, environment);
}

Graded grade(const Submission& submission, const Arguments& more, const Environment& environment) {
  return grade(submission.path(), more, environment);
}

int expectNoSolutionIn(const ggrade::Assignment& assignment, const fs::path& folder,
                       bool wholeBlocks) {
  std::string handedOut;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() != ".png" &&
        entry.path().extension() != ".f32" && entry.path().extension() != ".views")
      handedOut += read(entry.path());
  if (!wholeBlocks) EXPECT_THAT(handedOut, testing::Not(testing::HasSubstr("SOLUTION(")));
  const fs::path solution = kSource / "solutions" / assignment.id;
  std::string around; // what stands outside of blocks in any file that is handed out
  for (const std::string& name : assignment.files)
    around += ggrade::authoring::withFilled(read(solution / name), name, {});
  int blocks = 0;
  for (const auto& entry : fs::directory_iterator(solution)) {
    const std::string name = entry.path().filename();
    if (!entry.is_regular_file() || name.starts_with("rubric")) continue;
    const std::string text = read(entry.path());
    for (const std::string& block : ggrade::authoring::blocks(text, name)) {
      ++blocks;
      const bool several = std::ranges::count(block, '\n') > 1;
      if (around.find(block) == around.npos && (several || !wholeBlocks)) {
        EXPECT_EQ(handedOut.find(block), handedOut.npos) << name << ":\n" << block;
      }
      std::istringstream in(wholeBlocks ? std::string() : block);
      for (std::string line; std::getline(in, line);) {
        line.erase(0, line.find_first_not_of(' '));
        // Shorter ones are no secret, nor what stands outside of blocks, too.
        if (line.size() < 30 || around.find(line) != around.npos) continue;
        EXPECT_EQ(handedOut.find(line), handedOut.npos) << name << ": " << line;
      }
    }
  }
  return blocks;
}

std::string read(const fs::path& file) {
  EXPECT_TRUE(fs::is_regular_file(file)) << file;
  return readWhatIsThere(file);
}

std::vector<std::string> names(const fs::path& folder) {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename() != ".ggrade-contents")
      all.push_back(entry.path().filename().string());
  std::sort(all.begin(), all.end());
  return all;
}

} // namespace tool
