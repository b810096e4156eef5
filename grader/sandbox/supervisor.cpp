#include "supervisor.hpp"

#include "words/words.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>

namespace ggrade::sandbox {

using gg::say;

namespace {
using namespace std::chrono_literals;

constexpr auto kMeasureEvery = 20ms;
/// Once half of the memory is taken, a burst could overshoot the limit far within 20 ms.
constexpr auto kMeasureWhenHigh = 5ms;
/// Longest time for bwrap and the helper to start the command, on a machine under load.
constexpr double kSetupSeconds = 20;
/// Read from one stream in one go, so that a flood of output cannot keep the limits from being
/// checked.
constexpr std::size_t kReadAtOnce = 1u << 20;

std::string megabytes(std::uint64_t bytes) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f MB", static_cast<double>(bytes) / (1 << 20));
  return text.data();
}

std::string seconds(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", value);
  return text.data();
}

/// Moves what is there into `kept`, up to `cap` bytes in all. True when something was dropped.
bool drain(Descriptor& stream, std::string& kept, std::uint64_t cap) {
  bool dropped = false;
  std::array<char, 1 << 16> block; // NOLINT: filled by read
  for (std::size_t total = 0; stream && total < kReadAtOnce;) {
    const ssize_t count = read(stream.get(), block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count == 0) stream.close();
    if (count <= 0) break;
    const auto size = static_cast<std::uint64_t>(count);
    const std::uint64_t room = std::min(size, cap - std::min<std::uint64_t>(cap, kept.size()));
    kept.append(block.data(), room);
    dropped = dropped || room < size;
    total += size;
  }
  return dropped;
}

std::string firstLines(const std::string& text) {
  std::string line = text.substr(0, 400);
  while (!line.empty() && line.back() == '\n') line.pop_back();
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

std::string describeSignal(int number) {
  const char* name = sigabbrev_np(number);
  return name ? say("signal {} (SIG{})", number, name) : say("signal {}", number);
}

/// A descriptor that becomes readable when the process ends.
Descriptor openPid(pid_t pid) {
  return Descriptor(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
}

bool killThrough(const Descriptor& process) {
  return process && syscall(SYS_pidfd_send_signal, process.get(), SIGKILL, nullptr, 0) == 0;
}

} // namespace

Supervisor::Supervisor(const Limits& limits, Connections connections, pid_t helper,
                       bool inNamespace, std::vector<std::string> writableFolders)
    : limits_(limits), connections_(std::move(connections)), helper_(helper),
      inNamespace_(inNamespace), writableFolders_(std::move(writableFolders)),
      helperEnd_(openPid(helper)) {
  if (!inNamespace_) tree_.openDescendants(helper_);
}

double Supervisor::secondsSince(Clock::time_point start) const {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Result Supervisor::watch(const std::atomic<bool>* cancel) {
  while (!helperIsGone()) {
    const bool high = last_.memoryBytes > limits_.memoryBytes / 2;
    wait(high ? kMeasureWhenHigh : kMeasureEvery);
    checkLimits(cancel);
  }
  // The namespace is empty now and its pipes are at their end.
  for (int rest = 0; rest < 1000 && (connections_.standardOutput || connections_.standardError);
       ++rest) {
    const std::size_t before = result_.standardOutput.size() + result_.standardError.size();
    wait(0ms);
    if (before == result_.standardOutput.size() + result_.standardError.size() && rest > 1) break;
  }
  wait(0ms);
  conclude();
  return std::move(result_);
}

void Supervisor::wait(std::chrono::milliseconds longest) {
  pollfd events[] = {{connections_.standardOutput.get(), POLLIN, 0},
                     {connections_.standardError.get(), POLLIN, 0},
                     {connections_.reports.get(), POLLIN, 0},
                     {connections_.info.get(), POLLIN, 0},
                     {helperEnd_.get(), POLLIN, 0}};
  poll(events, std::size(events), static_cast<int>(longest.count()));
  const bool lostOut =
      drain(connections_.standardOutput, result_.standardOutput, limits_.outputBytes);
  const bool lostErr =
      drain(connections_.standardError, result_.standardError, limits_.outputBytes);
  result_.outputTruncated = result_.outputTruncated || lostOut || lostErr;
  readInfo();
  readReports();
}

void Supervisor::readInfo() {
  // Read on to its end also when all is known: an unread end of a pipe wakes poll() again and
  // again.
  drain(connections_.info, info_, 4096);
  if (init_) return;
  const std::string key = "\"child-pid\":";
  const std::size_t at = info_.find(key);
  // The comma behind the number shows that all of it is there.
  if (at == std::string::npos || info_.find(',', at) == std::string::npos) return;
  initPid_ = static_cast<pid_t>(std::strtol(info_.c_str() + at + key.size(), nullptr, 10));
  init_ = openPid(initPid_);
}

void Supervisor::readReports() {
  HelperReport report;
  while (connections_.reports) {
    const ssize_t count = read(connections_.reports.get(), &report, sizeof report);
    if (count == 0) connections_.reports.close();
    if (count != static_cast<ssize_t>(sizeof report)) return;
    report.text[sizeof report.text - 1] = 0;
    reports_.push_back(report);
    if (report.kind != HelperReport::Kind::started) continue;
    begun_ = true;
    started_ = Clock::now();
  }
}

void Supervisor::checkLimits(const std::atomic<bool>* cancel) {
  if (stopping_) {
    killNamespace();
    // The end is under way; if it does not come, the helper's own death takes the rest with it.
    if (secondsSince(stopped_) > 2) kill(helper_, SIGKILL);
    return;
  }
  if (cancel && *cancel) return stop(End::interrupted, "interrupted");
  if (!begun_) {
    if (secondsSince(spawned_) > kSetupSeconds)
      stop(End::setupFailed, "the sandbox did not start within " + seconds(kSetupSeconds));
    return;
  }
  const double wall = secondsSince(started_);
  if (wall > limits_.wallSeconds)
    return stop(End::timeLimit,
                say("wall time: {}, limit {}", seconds(wall), seconds(limits_.wallSeconds)));
  if (inNamespace_ && !measurable_) measurable_ = tree_.openNamespace(initPid_, writableFolders_);
  // A command that is over already cannot be measured either, so there is a moment of grace.
  if (inNamespace_ && !measurable_ && wall > 1)
    return stop(End::setupFailed, "cannot see the sandbox's processes from outside");
  const bool high = last_.memoryBytes > limits_.memoryBytes / 2;
  if (Clock::now() - measured_ < (high ? kMeasureWhenHigh : kMeasureEvery)) return;
  measured_ = Clock::now();
  last_ = tree_.measure();
  result_.peakMemoryBytes = std::max(result_.peakMemoryBytes, last_.memoryBytes);
  result_.cpuSeconds = std::max(result_.cpuSeconds, last_.cpuSeconds);
  if (last_.memoryBytes > limits_.memoryBytes)
    return stop(End::memoryLimit,
                say("memory: {} in {} processes, limit {}", megabytes(last_.memoryBytes),
                    last_.processes, megabytes(limits_.memoryBytes)));
  if (last_.cpuSeconds > limits_.cpuSeconds)
    stop(End::timeLimit,
         say("processor time: {} in {} processes, limit {}", seconds(last_.cpuSeconds),
             last_.processes, seconds(limits_.cpuSeconds)));
}

void Supervisor::stop(End end, std::string detail) {
  stopping_ = true;
  stopped_ = Clock::now();
  result_.end = end;
  result_.detail = std::move(detail);
  result_.wallSeconds = begun_ ? secondsSince(started_) : 0;
  connections_.lifeline.close();
  killNamespace();
}

// Killing the namespace's init kills every member; bwrap waits for it, and we for bwrap. A bwrap
// that has not named its child yet will, and is not killed before: the child waits for its word,
// and would for ever.
void Supervisor::killNamespace() const {
  if (inNamespace_) killThrough(init_);
}

bool Supervisor::helperIsGone() {
  rusage used{};
  if (wait4(helper_, &helperStatus_, WNOHANG, &used) != helper_) return false;
  const auto inSeconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  helperCpuSeconds_ = inSeconds(used.ru_utime) + inSeconds(used.ru_stime);
  return true;
}

void Supervisor::conclude() {
  using Kind = HelperReport::Kind;
  // If bwrap died before its child, wait until the child's namespace is empty too.
  if (pollfd event{init_.get(), POLLIN, 0}; init_) {
    killThrough(init_);
    poll(&event, 1, 5000);
  }
  result_.cpuSeconds = std::max(result_.cpuSeconds, helperCpuSeconds_);
  if (stopping_) return;
  result_.detail = "the sandbox ended without a word: " + describeSignal(WTERMSIG(helperStatus_));
  if (WIFEXITED(helperStatus_))
    result_.detail = "the sandbox could not start: " + firstLines(result_.standardError);
  for (const HelperReport& report : reports_) {
    switch (report.kind) {
    case Kind::started:
      break;
    case Kind::failed:
      result_.detail = report.text;
      break;
    case Kind::unrunnable:
      result_.end = End::exited;
      result_.exitCode = 126;
      result_.detail = report.text;
      break;
    case Kind::exited:
      result_.end = End::exited;
      result_.exitCode = report.value;
      result_.wallSeconds = report.wallSeconds;
      result_.detail = "exit code " + std::to_string(report.value);
      break;
    case Kind::signalled:
      result_.end = End::signalled;
      result_.signal = report.value;
      result_.wallSeconds = report.wallSeconds;
      result_.detail = describeSignal(report.value);
      if (report.value == SIGXCPU) result_.end = End::timeLimit; // its own limit, see inside.cpp
      if (report.value == SIGXFSZ)
        result_.detail = say("{}: a file beyond {}", result_.detail, megabytes(limits_.fileBytes));
      break;
    case Kind::collected:
      result_.collected = true;
      executables_ = static_cast<std::uint32_t>(report.value);
      break;
    case Kind::notCollected:
      result_.collectProblem = report.text;
      result_.collectIsOurs = report.value != 0;
      break;
    }
  }
  // On a busy machine a process may reach its own limit, a second above that of all, between two
  // looks. What it ran for outlives it and says something else: g++ ends with code 1.
  if (begun_ && result_.cpuSeconds > limits_.cpuSeconds) {
    result_.end = End::timeLimit;
    result_.detail = say("processor time: {} in all, limit {}", seconds(result_.cpuSeconds),
                         seconds(limits_.cpuSeconds));
  }
}

} // namespace ggrade::sandbox
