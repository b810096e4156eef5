// The main of every test program: GoogleTest's, with what tests/run asks for in the environment:
//
//   GGRADE_TEST_RECORD   a folder: each program notes its cases there as they begin and end
//   GGRADE_TEST_NAME     in a file of this name
//   GGRADE_TEST_ONLY     a regular expression: only cases run in whose name it is found
//   GGRADE_TEST_EXCEPT   likewise: those don't
//   GGRADE_TEST_LONG     set: also those whose suite, or its parameters, are named Long...
//   GGRADE_TEST_LIST     set: the cases are noted as "case" and a name, and none runs
//   GGRADE_TEST_SECONDS  the longest that one case may take
//
// What a program notes are lines of fields between tabs: "cases" and how many it will run; "begun"
// and a name; "passed", "failed" or "skipped", the name, the seconds, and those of processors, its
// children's among them. A case that began and did not end has crashed, or took too long. "setting
// up" and "set up", with both kinds of seconds, are about what a suite's cases share; "broken",
// with a suite's name, says that this failed.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace {

std::string setting(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

std::string nameOf(const testing::TestInfo& test) {
  return std::string(test.test_suite_name()) + '.' + test.name();
}

/// Suites of parameters are called Parameters/Suite.
bool isLong(const testing::TestInfo& test) {
  const std::string suite = '/' + std::string(test.test_suite_name());
  return suite.find("/Long") != suite.npos;
}

/// The names of the cases that are asked for.
std::vector<std::string> chosen() {
  const std::string only = setting("GGRADE_TEST_ONLY"), except = setting("GGRADE_TEST_EXCEPT");
  const bool evenLong = !setting("GGRADE_TEST_LONG").empty();
  const std::regex wanted(only), unwanted(except);
  std::vector<std::string> names;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i)
    for (int j = 0; j < all.GetTestSuite(i)->total_test_count(); ++j) {
      const testing::TestInfo& test = *all.GetTestSuite(i)->GetTestInfo(j);
      const std::string name = nameOf(test);
      if ((evenLong || !isLong(test)) && std::regex_search(name, wanted) &&
          (except.empty() || !std::regex_search(name, unwanted)))
        names.push_back(name);
    }
  return names;
}

/// The same as a filter of GoogleTest's.
std::string filterOf(const std::vector<std::string>& names) {
  std::string filter;
  for (const std::string& name : names) filter += name + ':';
  return filter.empty() ? "-*" : filter;
}

/// Seconds of processors that this process and the children that it has waited for have used.
double processorSeconds() {
  double seconds = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used = {};
    getrusage(who, &used);
    for (const timeval& time : {used.ru_utime, used.ru_stime})
      seconds += double(time.tv_sec) + double(time.tv_usec) / 1e6;
  }
  return seconds;
}

/// What has passed since something began.
class Stopwatch {
public:
  /// The seconds, and those of processors, each after a tab.
  std::string read() const {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
    return '\t' + std::to_string(taken.count()) + '\t' +
           std::to_string(processorSeconds() - processors_);
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double processors_ = processorSeconds();
};

class Record : public testing::EmptyTestEventListener {
public:
  /// Notes nothing without a folder.
  Record(const std::string& folder, const std::string& program) {
    if (folder.empty()) return;
    const std::string path = folder + '/' + program;
    file_ = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0) throw std::runtime_error("can't write to " + path);
  }

  /// At once: the next case may end the process.
  void note(const std::string& text) {
    const std::string line = text + '\n';
    if (file_ >= 0 && write(file_, line.data(), line.size()) != ssize_t(line.size()))
      std::perror("tests/main.cpp: write");
  }

  void OnTestProgramStart(const testing::UnitTest& all) override {
    note("cases\t" + std::to_string(all.test_to_run_count()));
  }
  void OnTestSuiteStart(const testing::TestSuite& suite) override {
    note(std::string("setting up\t") + suite.name());
    isSetUp_ = false;
    watch_ = Stopwatch();
  }
  void OnTestStart(const testing::TestInfo& test) override {
    if (!std::exchange(isSetUp_, true))
      note(std::string("set up\t") + test.test_suite_name() + watch_.read());
    note("begun\t" + nameOf(test));
    watch_ = Stopwatch();
  }
  void OnTestEnd(const testing::TestInfo& test) override {
    const testing::TestResult& result = *test.result();
    const char* const how = result.Failed() ? "failed" : result.Skipped() ? "skipped" : "passed";
    note(how + ('\t' + nameOf(test)) + watch_.read());
  }
  void OnTestSuiteEnd(const testing::TestSuite& suite) override {
    if (suite.ad_hoc_test_result().Failed()) note(std::string("broken\t") + suite.name());
  }

private:
  int file_ = -1;
  bool isSetUp_ = false;
  Stopwatch watch_;
};

/// SIGALRM ends the process where a case takes too long.
class Limit : public testing::EmptyTestEventListener {
public:
  explicit Limit(unsigned seconds) : seconds_(seconds) {}

  void OnTestSuiteStart(const testing::TestSuite&) override { alarm(seconds_); }
  void OnTestStart(const testing::TestInfo&) override { alarm(seconds_); }
  void OnTestEnd(const testing::TestInfo&) override { alarm(seconds_); }
  void OnTestSuiteEnd(const testing::TestSuite&) override { alarm(0); }

private:
  unsigned seconds_;
};

/// Programs that a case starts, maybe this one again, are none of this run.
class OwnEnvironment : public testing::EmptyTestEventListener {
  void OnTestProgramStart(const testing::UnitTest&) override {
    for (const char* name :
         {"GGRADE_TEST_RECORD", "GGRADE_TEST_NAME", "GGRADE_TEST_ONLY", "GGRADE_TEST_EXCEPT",
          "GGRADE_TEST_LONG", "GGRADE_TEST_SECONDS", "GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX"})
      unsetenv(name);
  }
};

} // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  auto* const record = new Record(setting("GGRADE_TEST_RECORD"), setting("GGRADE_TEST_NAME"));
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  listeners.Append(record);
  if (!setting("GGRADE_TEST_LIST").empty()) {
    if (setting("GTEST_SHARD_INDEX").empty() || setting("GTEST_SHARD_INDEX") == "0")
      for (const std::string& name : chosen()) record->note("case\t" + name);
    return 0;
  }
  if (testing::GTEST_FLAG(filter) == "*") testing::GTEST_FLAG(filter) = filterOf(chosen());
  if (const std::string seconds = setting("GGRADE_TEST_SECONDS"); !seconds.empty())
    listeners.Append(new Limit(unsigned(std::stoul(seconds))));
  listeners.Append(new OwnEnvironment);
  return RUN_ALL_TESTS();
}
