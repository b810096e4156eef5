// A class in which one system call fails, or at which the parent or the worker is killed: at every
// call that the run makes, with every error that makes sense. Whatever fails, every student has a
// row or the command says why not and ends with a code that is not 0; no score is another than the
// one that was graded; and --resume ends the same as a run that nothing disturbed.
//
// The worker is canned_batch's: it publishes through the product's own code, but grades nothing.
//
// GGRADE_FAULTS, a regular expression such as "worker: write 7: EIO", names the faults of the long
// case; without it, it tries all.

#include "canned_batch.hpp"
#include "failing_calls.hpp"
#include "tool.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <csignal>
#include <cstring>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using failing_calls::Fault;
using nlohmann::json;

/// The faults that every run of the suite tries: every so-many-th of those that change the disk or
/// start something, and of those that only read, in the order of everyFault. Primes, so that they
/// meet all kinds of calls and errors.
constexpr std::size_t kSampled = 11, kSampledReads = 149;

/// What a fault led to.
enum class Led { completed, ungradable, refused, killed, unreached };
constexpr const char* kLed[] = {"completed", "row not gradable", "refused, with a message",
                                "killed", "not reached"};

/// Everything below a folder but what legitimately differs: which scores an earlier finished run
/// left (`before`), and no times, since canned gradings take the same time.
std::map<std::string, std::string> contentsOf(const fs::path& out) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    const std::string name = entry.path().lexically_relative(out);
    if (!entry.is_regular_file()) {
      all[name] = "folder";
      continue;
    }
    std::string text = tool::read(entry.path());
    if (name == ".ggrade-batch.json") {
      json state = json::parse(text);
      state.erase("before");
      text = state.dump();
    }
    all[name] = std::move(text);
  }
  return all;
}

/// Without the sandbox's version and what is said of an old one: where bubblewrap could not be
/// asked, its name stands alone.
std::string withoutVersion(const std::string& bytes) {
  static const std::regex version("bubblewrap [0-9.]+"),
      old("<dt>bubblewrap</dt><dd[^>]*>[^<]*</dd>");
  return std::regex_replace(std::regex_replace(bytes, version, "bubblewrap"), old, "");
}

std::string differences(const std::map<std::string, std::string>& a,
                        const std::map<std::string, std::string>& b) {
  std::string text;
  for (const auto& [name, bytes] : a)
    if (const auto other = b.find(name); other == b.end())
      text += name + " is missing; ";
    else if (const std::string one = withoutVersion(bytes), two = withoutVersion(other->second);
             one != two) {
      const auto at = std::size_t(std::ranges::mismatch(one, two).in1 - one.begin());
      const std::size_t from = at - std::min<std::size_t>(at, 60);
      text += fmt::format("{} differs: {}\nfrom {}; ", name, two.substr(from, 120),
                          one.substr(from, 120));
    }
  for (const auto& [name, bytes] : b)
    if (!a.contains(name)) text += name + " is too much; ";
  return text;
}

class FailingCalls : public testing::Test {
protected:
  static void SetUpTestSuite() {
    if (!failing_calls::possible()) return;
    class_ = std::make_unique<TemporaryFolder>();
    fs::create_directory(uploads());
    for (const canned::Upload& upload : canned::kUploads) {
      fs::create_directory(uploads() / upload.name);
      std::ofstream(uploads() / upload.name / "floor.cpp") << upload.name;
    }
    run("undisturbed"); // draws the references if nobody has yet
    fs::remove_all(out("undisturbed"));
    const failing_calls::Ended ended = run("undisturbed");
    ASSERT_EQ(ended.exitCode, 0) << ended.errors;
    counts_ = ended.counts;
    wanted_ = contentsOf(out("undisturbed"));
    ASSERT_TRUE(wanted_.contains("student3/record.json"));
  }
  static void TearDownTestSuite() { class_.reset(); }
  void SetUp() override {
    if (!class_) GTEST_SKIP() << "ptrace is needed, and x86-64";
  }

  static fs::path uploads() { return class_->path() / "uploads"; }
  static fs::path out(const std::string& name) { return class_->path() / name; }

  static failing_calls::Ended run(const std::string& name,
                                  const std::vector<std::string>& more = {},
                                  const std::optional<Fault>& fault = {}) {
    const fs::path temporary = class_->path() / "tmp";
    fs::create_directories(temporary);
    std::vector<std::string> words = {tool::kBuild / "bin/canned_batch",
                                      "batch",
                                      "mirror",
                                      uploads(),
                                      "--out",
                                      out(name),
                                      "--jobs",
                                      "1",
                                      "--sandbox",
                                      "none"};
    words.insert(words.end(), more.begin(), more.end());
    return failing_calls::run(words, {{"TMPDIR", temporary}}, fault);
  }

  /// Every call that an undisturbed run makes, with every error, and killed there.
  static std::vector<Fault> everyFault() {
    std::vector<Fault> all;
    for (const auto& [at, count] : counts_)
      for (std::size_t number = 1; number <= count; ++number) {
        for (const int error : failing_calls::errorsOf(at.second))
          all.push_back({at.first, at.second, number, error});
        all.push_back({at.first, at.second, number, failing_calls::kKilled});
        if (at.second == failing_calls::Call::write)
          all.push_back({at.first, at.second, number, ENOSPC, true});
      }
    return all;
  }

  /// The scores that stand in what a run has left; fails where one is wrong.
  static std::size_t requireNoWrongScore(const fs::path& folder, std::size_t& ungradable) {
    std::size_t rows = 0;
    for (const canned::Upload& upload : canned::kUploads) {
      const fs::path file = folder / upload.name / "record.json";
      if (!fs::exists(file)) continue;
      const json row = json::parse(tool::read(file)).at("row");
      ++rows;
      if (row.at("outcome") == "not_gradable") {
        ++ungradable;
        EXPECT_NE(row.at("headline"), "");
        EXPECT_NE(row.at("reason"), "");
        EXPECT_EQ(row.at("score"), 0);
      } else {
        EXPECT_EQ(row.at("outcome"), upload.outcome);
        EXPECT_EQ(row.at("score"), upload.score);
      }
    }
    if (!fs::exists(folder / "gradebook.csv")) return rows;
    std::istringstream book(tool::read(folder / "gradebook.csv"));
    std::string line;
    for (std::getline(book, line); std::getline(book, line);) {
      std::vector<std::string> cells;
      std::istringstream in(line);
      for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
      for (const canned::Upload& upload : canned::kUploads)
        if (cells.at(3) == upload.name && cells.size() > 9 && !cells.at(9).empty()) {
          EXPECT_EQ(std::stod(cells.at(9)), upload.score) << line;
        }
    }
    return rows;
  }

  /// Does a message say what failed, why, and what to do?
  static void requireClear(const Fault& fault, const failing_calls::Ended& ended) {
    const std::string said = ended.out + ended.errors;
    const std::string reason = std::strerror(fault.error);
    EXPECT_THAT(said, testing::AnyOf(testing::HasSubstr(reason),
                                     testing::HasSubstr("the grader's own process")));
    EXPECT_THAT(said, testing::ContainsRegex("/|a worker|what the command prints"));
    EXPECT_THAT(said, testing::ContainsRegex("--resume|Mend that|choose a folder|Name a"));
  }

  /// One run with the fault, and one that resumes it.
  static Led strike(const Fault& fault) {
    SCOPED_TRACE(fault.text());
    fs::remove_all(out("struck"));
    fs::remove_all(class_->path() / "tmp");
    const failing_calls::Ended ended = run("struck", {}, fault);
    SCOPED_TRACE(fmt::format("code {}, signal {}\n{}{}", ended.exitCode, ended.signal, ended.out,
                             ended.errors));
    if (!ended.struck) return Led::unreached;
    const bool killed = ended.signal == SIGKILL;
    EXPECT_NE(ended.signal, SIGALRM) << "it hangs";
    EXPECT_TRUE(!killed || fault.error == failing_calls::kKilled);
    std::size_t ungradable = 0;
    const fs::path folder = out("struck");
    const std::size_t rows = requireNoWrongScore(folder, ungradable);
    Led led = Led::completed;
    if (killed) {
      led = Led::killed;
    } else if (ended.exitCode != 0) {
      led = ungradable > 0 && fs::exists(folder / "index.html") ? Led::ungradable : Led::refused;
      if (fault.error != failing_calls::kKilled) requireClear(fault, ended);
    } else {
      EXPECT_EQ(rows, std::size(canned::kUploads)) << "a row is lost, and the code is 0";
      EXPECT_EQ(ungradable, 0U) << "not gradable, and the code is 0";
      EXPECT_EQ(differences(wanted_, contentsOf(folder)), "") << "the code is 0";
    }
    const failing_calls::Ended resumed = run("struck", {"--resume"});
    EXPECT_EQ(resumed.exitCode, 0) << resumed.out << resumed.errors;
    EXPECT_EQ(differences(wanted_, contentsOf(folder)), "") << "after --resume";
    return led;
  }

  /// All of them, and a table of what came of it.
  static void strikeAll(const std::vector<Fault>& faults) {
    std::map<std::string, std::map<Led, std::size_t>> table;
    for (const Fault& fault : faults)
      ++table[fmt::format("{} | {}", name(fault.role), name(fault.call))][strike(fault)];
    std::cout << "| process | call | calls | faults |";
    for (const char* led : kLed) std::cout << ' ' << led << " |";
    std::cout << "\n| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (const auto role : failing_calls::kRoles)
      for (const auto call : failing_calls::kCalls) {
        const auto row = table.find(fmt::format("{} | {}", name(role), name(call)));
        const auto count = counts_.find({role, call});
        std::size_t sum = 0;
        std::string cells;
        for (std::size_t i = 0; i < std::size(kLed); ++i) {
          const std::size_t led = row == table.end() ? 0 : row->second[Led(i)];
          sum += led;
          cells += fmt::format(" {} |", led);
        }
        std::cout << fmt::format("| {} | {} | {} | {} |{}\n", name(role), name(call),
                                 count == counts_.end() ? 0 : count->second, sum, cells);
      }
  }

private:
  static inline std::unique_ptr<TemporaryFolder> class_;
  static inline std::map<std::pair<failing_calls::Role, failing_calls::Call>, std::size_t> counts_;
  static inline std::map<std::string, std::string> wanted_;
};

TEST_F(FailingCalls, ASampleLosesNothing) {
  const std::vector<Fault> all = everyFault();
  std::vector<Fault> sample;
  std::size_t reads = 0, others = 0;
  for (const Fault& fault : all)
    if (fault.call == failing_calls::Call::open || fault.call == failing_calls::Call::read
            ? reads++ % kSampledReads == 0
            : others++ % kSampled == 0)
      sample.push_back(fault);
  EXPECT_GT(sample.size(), 20U);
  strikeAll(sample);
}

class LongFailingCalls : public FailingCalls {};

TEST_F(LongFailingCalls, NoneLosesAnything) {
  const char* const named = std::getenv("GGRADE_FAULTS");
  const std::regex wanted(named ? named : "");
  std::vector<Fault> faults = everyFault();
  std::erase_if(faults, [&](const Fault& one) { return !std::regex_search(one.text(), wanted); });
  strikeAll(faults);
}

} // namespace
