#include "tool.hpp"

#include "authoring/solution_blocks.hpp"
#include "calibration/measure.hpp"
#include "calibration/subject.hpp"
#include "calibration/verdicts.hpp"
#include "grading/recipe.hpp"
#include "report/results_json.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <iterator>
#include <list>
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

namespace {

/// The solution with the patch of this name in that folder of its assignment.
void writePatch(const std::string& folder, const std::string& name, const fs::path& into) {
  for (const auto& assignment : ggrade::loadAssignments(kSource / "assignments")) {
    const fs::path solutions = kSource / "solutions" / assignment.id;
    const fs::path patch = solutions / folder / (name + ".patch");
    if (fs::exists(patch))
      return ggrade::grading::writeFiles(assignment, {solutions, {patch}}, into);
  }
  throw std::runtime_error("there is no patch " + name + " in " + folder);
}

} // namespace

Submission Submission::example(const std::string& name) {
  Submission made;
  writePatch("examples", name, made.path());
  return made;
}

Submission Submission::mistake(const std::string& name) {
  Submission made;
  writePatch("mistakes", name, made.path());
  return made;
}

Submission Submission::variant(const std::string& name) {
  Submission made;
  writePatch("variants", name, made.path());
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

namespace grading = ggrade::grading;
namespace calibration = ggrade::calibration;

namespace {

/// As many as the floor has parts. A judge takes 200 MB.
constexpr std::size_t kMostKept = 3;

void quietly(const std::string&, std::size_t, std::size_t) {}

} // namespace

Grader& Grader::of(const std::string& id, const grading::Draw& draw) {
  struct Kept {
    std::string id;
    grading::Draw draw;
    std::unique_ptr<Grader> grader;
  };
  static std::list<Kept> kept; // the last one first
  const auto known =
      std::ranges::find_if(kept, [&](const Kept& one) { return one.id == id && one.draw == draw; });
  if (known != kept.end()) {
    kept.splice(kept.begin(), kept, known);
  } else {
    if (kept.size() == kMostKept) kept.pop_back();
    kept.push_front({id, draw, std::make_unique<Grader>(id, draw)});
  }
  return *kept.front().grader;
}

Grader::Grader(const std::string& id, const grading::Draw& draw)
    : target_(ggrade::findTarget(kSource / "assignments", id)),
      solutions_(kSource / "solutions" / target_.assignment.id),
      plan_(grading::drawScenes(target_, solutions_, draw)),
      references_(grading::prepareReferences(target_, solutions_, plan_, quietly)) {}

grading::Grader& Grader::grader(const How& how) {
  std::unique_ptr<grading::Grader>& kept = graders_[{how.pictures, how.repair}];
  if (!kept) {
    grading::GraderOptions options;
    options.pictures = options.twice = how.pictures;
    options.repair = how.repair;
    options.many = true;
    kept = std::make_unique<grading::Grader>(target_, solutions_, plan_, std::move(options),
                                             references_);
  }
  return *kept;
}

grading::Built Grader::build(const fs::path& folder, const How& how) {
  return grader(how).build(
      std::make_shared<grading::Program>(target_.assignment, grading::Recipe{folder}),
      how.solution);
}

Graded Grader::grade(const grading::Built& built, const How& how, std::size_t scenes) {
  grading::Graded whole = grader(how).draw(built, scenes);
  grader(how).judge(whole);
  if (how.diagnosis) grader(how).diagnose(whole);
  Graded graded;
  graded.result = std::move(whole.result);
  graded.results = nlohmann::json::parse(
      ggrade::report::resultsJson(graded.result, ggrade::report::Reveal::names));
  graded.result.scenes.clear();       // large, and in the JSON as far as tests look at it
  std::cout << graded.text() << '\n'; // what the log of a failure needs
  return graded;
}

const Graded& Grader::grade(const fs::path& folder, const How& how, std::size_t scenes) {
  std::string key = std::to_string(std::min(scenes, plan_.scenes.size()));
  for (const bool flag : {how.solution, how.pictures, how.diagnosis, how.repair})
    key += flag ? '1' : '0';
  for (const std::string& name : names(folder))
    key += name + ' ' +
           (fs::is_regular_file(folder / name) ? grading::hashOf(read(folder / name)) : "") + '\n';
  const auto known = graded_.find(key);
  if (known != graded_.end()) return known->second;
  return graded_.emplace(key, grade(build(folder, how), how, scenes)).first->second;
}

Graded gradePart(const std::string& part, const fs::path& folder, const How& how) {
  return Grader::of(part, how.draw).grade(folder, how);
}

Graded gradePart(const std::string& part, const Submission& submission, const How& how) {
  return gradePart(part, submission.path(), how);
}

Graded grade(const fs::path& folder, const How& how) {
  return gradePart("mirror", folder, how);
}

Graded grade(const Submission& submission, const How& how) {
  return grade(submission.path(), how);
}

Graded gradeByTool(const fs::path& folder, const Arguments& more, const Environment& environment) {
  const TemporaryFolder results;
  Arguments arguments = {"grade",         "mirror", folder, "--out", results.path() / "out",
                         "--no-diagnosis"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Graded graded;
  graded.ended = runTool(arguments, environment);
  EXPECT_FALSE(graded.ended.late);
  const fs::path file = results.path() / "out/results.json";
  if (!fs::exists(file)) throw std::runtime_error("no results.json: " + graded.ended.errors);
  graded.results = nlohmann::json::parse(read(file));
  std::cout << graded.text() << '\n'; // what the log of a failure needs
  return graded;
}

Graded gradeByTool(const Submission& submission, const Arguments& more,
                   const Environment& environment) {
  return gradeByTool(submission.path(), more, environment);
}

void PrintTo(const Catalogued& one, std::ostream* out) {
  *out << one.program.name;
}

std::vector<Catalogued> catalogue() {
  std::vector<Catalogued> all;
  // The folder as it was compiled in: kSource may not be there yet.
  const fs::path root = GGRADE_SOURCE_DIR;
  for (const auto& assignment : ggrade::loadAssignments(root / "assignments"))
    for (const ggrade::Part& part : assignment.parts) {
      const fs::path solutions = root / "solutions" / assignment.id;
      const auto known = grading::loadCatalogue(assignment, part, solutions, solutions);
      for (auto& program : calibration::programsOf(assignment, known, solutions, {})) {
        if (program.kind != calibration::Kind::mistake &&
            program.kind != calibration::Kind::variant)
          continue;
        const grading::Mistake* mistake = known.mistake(program.name);
        all.push_back({part.id, std::move(program), mistake ? mistake->shows : ""});
      }
    }
  return all;
}

Graded gradeCatalogued(const Catalogued& one, bool allScenes, const How& how) {
  Grader& grader = Grader::of(one.part);
  const auto& scenes = grader.plan().scenes;
  std::size_t count = scenes.size();
  if (!one.shows.empty() && !allScenes)
    while (count > 1 &&
           std::ranges::find(scenes[count - 1].tags, one.shows) == scenes[count - 1].tags.end())
      --count;
  const TemporaryFolder files;
  const fs::path upload = files.path() / one.program.name;
  grading::writeFiles(grader.target().assignment, one.program.recipe, upload);
  const Graded graded = grader.grade(upload, how, count);
  const auto verdicts =
      calibration::judge(one.part, grader.target().items(),
                         {{one.program, {calibration::scoreOf(graded.result)}, ""}});
  EXPECT_THAT(verdicts.failures(), testing::IsEmpty());
  return graded;
}

Graded gradeMistake(const std::string& name) {
  static const std::vector<Catalogued> all = catalogue();
  for (const Catalogued& one : all)
    if (one.program.name == name) return gradeCatalogued(one, true, {});
  throw std::runtime_error("there is no mistake " + name);
}

int expectNoSolutionIn(const ggrade::Assignment& assignment, const fs::path& folder,
                       bool wholeBlocks) {
  std::string handedOut;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() != ".png" &&
        entry.path().extension() != ".f32" && entry.path().extension() != ".views")
      handedOut += read(entry.path());
  if (!wholeBlocks) {
    EXPECT_THAT(handedOut, testing::Not(testing::HasSubstr("SOLUTION(")));
  }
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
