// Submissions that attack the grader, one a folder with an attack.json:
//
//   harm      what it would do, in one sentence
//   part      the part that it is handed in for
//   outcome   how it must end; a list where the system decides
//   score     the most that it may get; "reference": exactly what the solution gets, bonus included
//   proof     what shows that it failed
//   message   (optional) a regular expression for the result's detail
//   tried     (optional) regular expressions for lines of the instructor's page: it was tried
//   fingerprint  (optional) regular expressions for what the result says that it was drawn with
//   student_lacks  (optional) texts that are none of the student's business
//   payloads  (optional) texts that no page may hold as they are
//   base      (optional) "stub": the handed-out files instead of the solution's
//   make      (optional) what git cannot hold: links, pipes, devices, folders, large files
//   name      (optional) of the folder that is handed in
//   alone     (optional) why it is graded by itself, with `ggrade grade`
//
// All others for part mirror are graded as one class, beside honest submissions.
//
// What it hands in is the base with attack.patch applied and the files of upload/ over it.
// attack.hpp and attack_channel.hpp come with it if it includes them. Nothing that an attack prints
// may hold ": succeeded".
#include "../grading/tool.hpp"

#include "grading/recipe.hpp"
#include "report/text.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace tool;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const fs::path kAttacks = kSource / "tests/hostile";
/// Largest page in bytes; one with all pictures has 3 MB.
constexpr std::uintmax_t kLargestPage = 8 << 20;

std::vector<std::string> attacks() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(kAttacks))
    if (fs::exists(entry.path() / "attack.json")) all.push_back(entry.path().filename().string());
  std::sort(all.begin(), all.end());
  return all;
}

fs::path cacheFolder() {
  const char* const named = std::getenv("GGRADE_CACHE");
  return named && *named ? fs::path(named) : kBuild / "cache";
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  ASSERT_TRUE(out << text) << file;
}

/// A secret in the cache, where it stays: several tests may run at a time.
std::string canary() {
  const fs::path file = cacheFolder() / "canary";
  if (!fs::exists(file)) {
    std::random_device random;
    std::ostringstream secret;
    secret << "canary-" << std::hex << random() << random();
    const fs::path own = file.string() + '.' + std::to_string(getpid());
    fs::create_directories(own.parent_path());
    write(own, secret.str());
    link(own.c_str(), file.c_str()); // whoever comes first
    fs::remove(own);
  }
  return read(file);
}

/// Contents of all regular files below a folder.
std::map<std::string, std::size_t> hashes(const fs::path& folder) {
  std::map<std::string, std::size_t> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      all[entry.path().string()] = std::hash<std::string>()(read(entry.path()));
  return all;
}

std::string replaceAll(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// The machine as an attacker finds it: another student's upload and results.
class Surroundings {
public:
  explicit Surroundings(const std::string& secret) {
    fs::create_directories(uploads() / "student2");
    fs::create_directories(results());
    write(uploads() / "student2/floor.cpp", "// " + secret + "\n");
    write(results() / "results.json",
          "{\"submission\": \"student2\", \"note\": \"" + secret + "\"}");
    write(folder_.path() / "outside", secret);
  }
  fs::path uploads() const { return folder_.path() / "uploads"; }
  fs::path results() const { return folder_.path() / "results/student2"; }
  fs::path out() const { return folder_.path() / "results/attacker"; }

  /// With the places that an attack aims at.
  std::string aimed(std::string text) const {
    for (const auto& [mark, place] : std::map<std::string, fs::path>{{"@SOURCE@", kSource},
                                                                     {"@CACHE@", cacheFolder()},
                                                                     {"@UPLOADS@", uploads()},
                                                                     {"@RESULTS@", results()}})
      text = replaceAll(text, mark, place.string());
    return text;
  }
  /// Everything that no submission may change.
  std::map<std::string, std::size_t> state() const {
    std::map<std::string, std::size_t> all;
    for (const fs::path& folder :
         {kSource / "solutions", kSource / "assignments", uploads() / "student2", results()})
      all.merge(hashes(folder));
    all[(folder_.path() / "outside").string()] =
        std::hash<std::string>()(read(folder_.path() / "outside"));
    return all;
  }

private:
  TemporaryFolder folder_;
};

/// A name that may be no UTF-8, in JSON as hexadecimal bytes.
std::string bytesOf(const std::string& hex) {
  std::istringstream in(hex);
  std::string bytes;
  for (unsigned byte; in >> std::hex >> byte;) bytes.push_back(static_cast<char>(byte));
  return bytes;
}

/// Makes what git cannot hold. False: only root can.
bool make(const json& what, const fs::path& upload, const Surroundings& around) {
  const auto at = [&](const char* kind) {
    const fs::path path = upload / what.at(kind).get<std::string>();
    fs::remove(path);
    return path;
  };
  if (what.contains("link")) {
    fs::create_symlink(around.aimed(what.at("to")), at("link"));
  } else if (what.contains("fifo")) {
    EXPECT_EQ(mkfifo(at("fifo").c_str(), 0666), 0);
  } else if (what.contains("device")) {
    return mknod(at("device").c_str(), S_IFCHR | 0666, makedev(1, 5)) == 0; // /dev/zero
  } else if (what.contains("folder")) {
    fs::create_directory(at("folder"));
  } else if (what.contains("hex")) {
    write(upload / bytesOf(what.at("hex")), "x");
  } else {
    const std::string name = what.at("file");
    for (int i = 0; i < what.value("count", 1); ++i) {
      const fs::path file = upload / (what.contains("count") ? std::to_string(i) + name : name);
      write(file, "");
      fs::resize_file(file, what.at("bytes").get<std::uintmax_t>());
    }
  }
  return true;
}

/// Writes the folder that is handed in. False: only root can make it.
bool handIn(const std::string& name, const json& attack, const fs::path& upload,
            const Surroundings& around) {
  const ggrade::Assignment assignment = ggrade::Assignment::load(kSource / "assignments/floor");
  const fs::path folder = kAttacks / name;
  const bool stub = attack.value("base", "") == "stub";
  const fs::path base = kSource / (stub ? "assignments" : "solutions") / "floor";
  const fs::path patch = folder / "attack.patch";
  ggrade::grading::writeFiles(
      assignment, {base, fs::exists(patch) ? std::vector{patch} : std::vector<fs::path>{}}, upload);
  if (fs::exists(folder / "upload"))
    fs::copy(folder / "upload", upload,
             fs::copy_options::overwrite_existing | fs::copy_options::recursive);
  const std::string program = read(upload / "floor.cpp");
  write(upload / "floor.cpp", around.aimed(program));
  if (program.find("attack_channel.hpp") != program.npos) {
    // The grader's own description of the channel is no secret.
    fs::copy_file(kAttacks / "attack_channel.hpp", upload / "attack_channel.hpp");
    fs::copy_file(kSource / "grader/trace/records.hpp", upload / "records.hpp");
    write(upload / "channel.hpp", replaceAll(read(kSource / "grader/capture/channel.hpp"),
                                             "trace/records.hpp", "records.hpp"));
  }
  if (program.find("#include \"attack") != program.npos)
    write(upload / "attack.hpp", around.aimed(read(kAttacks / "attack.hpp")));
  for (const json& what : attack.value("make", json::array()))
    if (!make(what, upload, around)) return false;
  return true;
}

/// Processes that the tool has left behind: they are ours now, see main.
std::vector<std::string> leftOver() {
  std::vector<std::string> left;
  for (int tries = 0; tries < 100; ++tries) {
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    const std::string self = std::to_string(getpid());
    std::istringstream children([&] {
      std::ifstream in("/proc/self/task/" + self + "/children");
      return std::string(std::istreambuf_iterator<char>(in), {});
    }());
    left.assign(std::istream_iterator<std::string>(children), {});
    if (left.empty()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return left;
}

/// A page as its reader sees it, without markup's escapes, and with a line an entry.
std::string unescaped(std::string page) {
  for (const auto& [from, to] : {std::pair{"<li>", "\n"},
                                 {"&lt;", "<"},
                                 {"&gt;", ">"},
                                 {"&quot;", "\""},
                                 {"&#39;", "'"},
                                 {"&amp;", "&"}})
    page = replaceAll(page, from, to);
  return page;
}

/// Does a line of the text match? Lines with pictures are passed over.
bool anyLine(const std::string& text, const std::string& expression) {
  const std::regex wanted(expression);
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (line.size() < 4000 && std::regex_search(line, wanted)) return true;
  return false;
}

/// What the log of a failure needs.
void printAttempts(const std::string& text) {
  std::istringstream in(text);
  int left = 40;
  for (std::string line; left > 0 && std::getline(in, line);)
    if (line.size() < 400 && line.find("attack: ") != line.npos && left-- > 0)
      std::cout << ggrade::report::sanitizeLine(line) << '\n';
}

void expectOutcome(const json& attack, const json& results) {
  const json& extra = results.at("extra_data");
  const json& wanted = attack.at("outcome");
  const json outcomes = wanted.is_array() ? wanted : json::array({wanted});
  EXPECT_TRUE(std::ranges::find(outcomes, extra.at("outcome")) != outcomes.end())
      << extra.at("outcome") << " is not " << wanted;
  const std::string detail = replaceAll(extra.at("detail"), "\n", " ").substr(0, 4000);
  EXPECT_TRUE(std::regex_search(detail, std::regex(attack.value("message", "")))) << detail;
  const json drawnWith = attack.value("fingerprint", json::object());
  for (const auto& [key, text] : drawnWith.items())
    EXPECT_TRUE(std::regex_search(extra.at("fingerprint").value(key, ""),
                                  std::regex(text.get<std::string>())))
        << key << ": " << extra.at("fingerprint");
  if (attack.at("score").is_number()) {
    EXPECT_LE(results.at("score").get<double>(), attack.at("score").get<double>());
    return;
  }
  ASSERT_EQ(attack.at("score"), "reference");
  for (const json& item : extra.at("items")) {
    const double full = item.at("kind") == "keep" ? 0 : item.at("points").get<double>();
    EXPECT_EQ(item.at("earned").get<double>(), full) << item;
  }
}

void expectClean(const std::string& page, const json& attack, const std::string& secret,
                 const char* name) {
  EXPECT_LT(page.size(), kLargestPage) << name;
  EXPECT_EQ(page.find(secret), page.npos) << name << " tells the secret";
  EXPECT_TRUE(page == ggrade::report::sanitize(page)) << name << " holds control characters";
  for (const json& payload : attack.value("payloads", json::array()))
    EXPECT_EQ(page.find(payload.get<std::string>()), page.npos)
        << name << " holds " << payload << " as it is";
}

/// The attack.json of a folder.
json attackOf(const std::string& name) {
  return json::parse(read(kAttacks / name / "attack.json"));
}

bool isInClass(const json& attack) {
  return attack.at("part") == "mirror" && !attack.contains("alone");
}

/// A run of the tool, and what was found after it.
struct Run {
  Ended ended;
  std::vector<std::string> leftOver;
  std::map<std::string, std::size_t> before, after; ///< see Surroundings::state
};

Run runAmid(const Surroundings& around, const Arguments& arguments, const std::string& secret,
            double seconds) {
  Run run;
  run.before = around.state();
  // Orphans of the tool become our children.
  if (prctl(PR_SET_CHILD_SUBREAPER, 1) != 0) throw std::runtime_error("prctl");
  run.ended = runTool(arguments, {{"GGRADE_CANARY", secret}}, seconds);
  std::cout << run.ended.out << run.ended.errors;
  run.leftOver = leftOver();
  run.after = around.state();
  return run;
}

void expectUnharmed(const Run& run) {
  EXPECT_EQ(run.ended.exitCode, 0) << "graded, whatever the score";
  EXPECT_THAT(run.leftOver, IsEmpty());
  EXPECT_EQ(run.before, run.after) << "files of the grader or of others have changed";
  EXPECT_THAT(run.ended.out, Not(HasSubstr("\033")));
  EXPECT_THAT(run.ended.errors, Not(HasSubstr("\033")));
}

/// Is a case of these parameters about to run? `name` as GoogleTest has it, without parameters.
bool isChosen(const std::string& suite, const std::string& name) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i)
    for (int j = 0; j < all.GetTestSuite(i)->total_test_count(); ++j)
      if (const testing::TestInfo& test = *all.GetTestSuite(i)->GetTestInfo(j);
          suite == test.test_suite_name() && name == test.name())
        return test.should_run();
  throw std::logic_error("there is no case " + suite + "." + name);
}

/// The attackers' class with its honest students, graded once. Who isn't looked at afterwards isn't
/// handed in.
class Class {
public:
  static const Class& graded() {
    static const Class made;
    return made;
  }

  /// Names of honest submissions and where they are.
  const std::map<std::string, fs::path>& honest() const { return honest_; }
  const Run& run() const { return run_; }
  const std::string& secret() const { return secret_; }
  /// The folder with a submission's results.
  fs::path results(const std::string& name) const { return out() / name; }
  /// Could it be handed in? Some only by root.
  bool has(const std::string& attack) const { return handedIn_.contains(attack); }

private:
  Class() {
    dark_.replace("tile.frag", "* reflected", "* reflected * 0.3");
    const bool beside = isChosen("HostileNeighbours", "ChangeNobodysResult");
    for (const std::string& name : attacks()) {
      const json attack = attackOf(name);
      if (!isInClass(attack) || !(beside || isChosen("Attacks/HostileSubmission", "Fails/" + name)))
        continue;
      if (handIn(name, attack, uploads() / name, around_))
        handedIn_.insert(name);
      else
        fs::remove_all(uploads() / name);
    }
    if (beside)
      for (const auto& [name, source] : honest_)
        fs::copy(source, uploads() / name, fs::copy_options::recursive);
    run_ = runAmid(around_,
                   {"batch", "mirror", uploads(), "--quality", "fast", "--jobs", "3",
                    "--no-diagnosis", "--out", out()},
                   secret_, 1000);
  }

  fs::path uploads() const { return around_.uploads().parent_path() / "class-uploads"; }
  fs::path out() const { return around_.results().parent_path() / "class"; }

  const std::string secret_ = canary();
  const Surroundings around_{secret_};
  tool::Submission dark_ = tool::Submission::solution();
  const std::map<std::string, fs::path> honest_ = {{"dark", dark_.path()},
                                                   {"right", kSource / "solutions/floor"},
                                                   {"stub", kSource / "assignments/floor"}};
  std::set<std::string> handedIn_;
  Run run_;
};

/// What an attack got is what its attack.json says, and nobody reads what they should not.
void expectHarmless(const json& attack, const fs::path& out, const std::string& secret) {
  const std::string results = read(out / "results.json");
  expectOutcome(attack, json::parse(results));
  const std::string index = read(out / "index.html");
  const std::string student = read(out / "student.html");
  for (const auto& [page, name] : {std::pair{index, "index.html"}, {student, "student.html"}})
    expectClean(page, attack, secret, name);
  for (const json& withheld : attack.value("student_lacks", json::array()))
    EXPECT_EQ(student.find(withheld.get<std::string>()), student.npos) << withheld;
  for (const char* name : {"results.json", "junit.xml"})
    EXPECT_EQ(read(out / name).find(secret), std::string::npos) << name;
  const std::string seen = unescaped(index);
  printAttempts(seen);
  EXPECT_FALSE(anyLine(seen, "attack: .*: succeeded"));
  for (const json& tried : attack.value("tried", json::array()))
    EXPECT_TRUE(anyLine(seen, tried)) << "not tried: " << tried;
}

class HostileSubmission : public testing::TestWithParam<std::string> {};

TEST_P(HostileSubmission, Fails) {
  const json attack = attackOf(GetParam());
  for (const char* key : {"harm", "proof"}) EXPECT_FALSE(attack.at(key).get<std::string>().empty());
  const char* const rootOnly = "only root can hand this in";
  if (isInClass(attack)) {
    const Class& together = Class::graded();
    if (!together.has(GetParam())) GTEST_SKIP() << rootOnly;
    expectUnharmed(together.run());
    expectHarmless(attack, together.results(GetParam()), together.secret());
    return;
  }
  const std::string secret = canary();
  const Surroundings around(secret);
  const fs::path upload = around.uploads() / attack.value("name", "student1");
  if (!handIn(GetParam(), attack, upload, around)) GTEST_SKIP() << rootOnly;
  expectUnharmed(
      runAmid(around, {"grade", attack.at("part"), upload, "--no-diagnosis", "--out", around.out()},
              secret, 250));
  expectHarmless(attack, around.out(), secret);
}

/// What a student gets, without times.
std::map<std::string, std::string> handedBack(const fs::path& folder) {
  json results = json::parse(read(folder / "results.json"));
  results.erase("execution_time");
  results.at("extra_data").erase("timings");
  for (json& scene : results.at("extra_data").at("scenes")) scene.erase("seconds");
  const std::regex times(" time=\"[0-9.]*\"");
  return {{"results.json", results.dump()},
          {"student.html", read(folder / "student.html")},
          {"junit.xml", std::regex_replace(read(folder / "junit.xml"), times, "")}};
}

TEST(HostileNeighbours, ChangeNobodysResult) {
  const Class& together = Class::graded();
  expectUnharmed(together.run());
  TemporaryFolder folder;
  const fs::path uploads = folder.path() / "uploads", alone = folder.path() / "alone";
  fs::create_directories(uploads);
  for (const auto& [name, source] : together.honest())
    fs::copy(source, uploads / name, fs::copy_options::recursive);
  const Ended ended = runTool({"batch", "mirror", uploads, "--quality", "fast", "--jobs", "2",
                               "--no-diagnosis", "--out", alone},
                              {{"GGRADE_CANARY", together.secret()}}, 280);
  ASSERT_EQ(ended.exitCode, 0) << ended.out << ended.errors;
  for (const auto& [name, source] : together.honest())
    for (const auto& [file, text] : handedBack(alone / name))
      EXPECT_TRUE(handedBack(together.results(name)).at(file) == text)
          << name << '/' << file << " differs";
  EXPECT_EQ(json::parse(read(together.results("right") / "results.json")).at("score"), 110);
}

/// Bytes of all files below a folder that changes meanwhile.
std::uintmax_t bytesBelow(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  std::error_code gone;
  for (fs::recursive_directory_iterator entry(folder, gone), end; !gone && entry != end;
       entry.increment(gone)) {
    std::error_code none;
    const std::uintmax_t size = entry->is_regular_file(none) ? entry->file_size(none) : 0;
    if (!none) bytes += size;
  }
  return bytes;
}

// With a quarter of a gigabyte a scene it was 1.7 GB.
TEST(HostileSpace, OneSubmissionTakesAGigabyteAtMost) {
  const Surroundings around(canary());
  const fs::path upload = around.uploads() / "student1", temporary = around.uploads() / "tmp";
  ASSERT_TRUE(handIn("disk_of_passes", attackOf("disk_of_passes"), upload, around));
  fs::create_directory(temporary);
  Running running(words({"grade", "mirror", upload, "--no-diagnosis", "--out", around.out()}),
                  {{"TMPDIR", temporary}});
  std::uintmax_t most = 0;
  while (!running.says("grading student1: judging", 0.01))
    most = std::max(most, bytesBelow(temporary));
  const Ended ended = running.wait(100);
  most = std::max(most, bytesBelow(temporary));
  EXPECT_EQ(ended.exitCode, 0) << ended.errors;
  std::cout << "at most " << (most >> 20) << " MiB\n";
  EXPECT_LT(most, std::uintmax_t{1} << 30);
  EXPECT_GT(most, std::uintmax_t{500} << 20) << "it was not tried";
  EXPECT_EQ(bytesBelow(temporary), 0U);
}

INSTANTIATE_TEST_SUITE_P(Attacks, HostileSubmission, testing::ValuesIn(attacks()),
                         [](const auto& info) { return info.param; });

} // namespace
