#include "helper.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

namespace ggrade::sandbox::helper {
namespace {

double now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool limit(__rlimit_resource resource, std::uint64_t soft, std::uint64_t hard) {
  // A caller whose own hard limit is lower keeps the lower one.
  rlimit current{};
  getrlimit(resource, &current);
  const rlimit wanted{std::min<rlim_t>(soft, current.rlim_max),
                      std::min<rlim_t>(hard, current.rlim_max)};
  return setrlimit(resource, &wanted) == 0;
}

bool setLimits(const HelperPlan& plan) {
  const auto both = [](__rlimit_resource resource, std::uint64_t value) {
    return limit(resource, value, value);
  };
  // A core limit of 1 also stops handlers that core_pattern pipes to; 0 does not (core(5)).
  return both(RLIMIT_CORE, 1) && both(RLIMIT_FSIZE, plan.fileBytes) &&
         both(RLIMIT_AS, plan.addressSpaceBytes) && both(RLIMIT_NOFILE, 256) &&
         /* g++ raises its own */ limit(RLIMIT_STACK, 8 << 20, 64 << 20) &&
         both(RLIMIT_MEMLOCK, 64 << 10) && both(RLIMIT_MSGQUEUE, 0) &&
         both(RLIMIT_SIGPENDING, 256) &&
         // In case the supervisor, which ends all of them together, gets no turn.
         limit(RLIMIT_CPU, plan.cpuSeconds + 1, plan.cpuSeconds + 2) &&
         (plan.processes == 0 || both(RLIMIT_NPROC, plan.processes));
}

std::vector<char*> pointers(const std::vector<std::string>& strings) {
  std::vector<char*> list;
  for (const std::string& string : strings) list.push_back(const_cast<char*>(string.c_str()));
  list.push_back(nullptr);
  return list;
}

/// Why a child did not become the command: which step failed (-1: none), and its errno.
struct Failure {
  volatile int step = -1, error = 0;
};

/// A program that somebody still has open for writing is tried so often, with so many microseconds
/// between.
constexpr int kMostTries = 100;
constexpr useconds_t kBetweenTries = 20000;

/// In a child of vfork, whose memory is ours: becomes the command, or says why not.
[[noreturn]] void becomeCommand(const HelperPlan& plan, Failure& failure) {
  const auto fail = [&](int step) {
    failure.error = errno;
    failure.step = step;
    _exit(127);
  };
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (chdir(plan.workingDirectory.c_str()) != 0) fail(0);
  // Every descriptor of ours closes at exec; only the inherited one is exempt.
  close_range(3, ~0u, CLOSE_RANGE_CLOEXEC);
  if (plan.inherited >= 0) fcntl(static_cast<int>(plan.inherited), F_SETFD, 0);
  if (!setLimits(plan)) fail(1);
  const auto arguments = pointers(plan.arguments), environment = pointers(plan.environment);
  // Who has just written the program has closed it; a process that was started meanwhile by another
  // thread holds what it inherited until it becomes a program itself.
  for (int tries = 0; tries < kMostTries; ++tries) {
    execve(plan.arguments[0].c_str(), arguments.data(), environment.data());
    if (errno != ETXTBSY) break;
    usleep(kBetweenTries);
  }
  // A missing interpreter gives ENOENT too, but then the file itself is there.
  const int error = errno;
  const int step = access(plan.arguments[0].c_str(), F_OK) == 0 ? 3 : 2;
  errno = error;
  fail(step);
  _exit(127);
}

/// Kills the helper's children; orphans of the command are among them, since the helper is either
/// the namespace's init or a subreaper.
void killChildren() {
  if (getpid() == 1) {
    kill(-1, SIGKILL);
    return;
  }
  const std::string self = std::to_string(getpid());
  const std::string path = "/proc/self/task/" + self + "/children";
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  char text[4096] = {};
  if (file < 0 || read(file, text, sizeof text - 1) < 0) text[0] = 0;
  close(file);
  for (char* at = text; *at;) {
    char* end = nullptr;
    const long child = std::strtol(at, &end, 10);
    if (end == at) break;
    if (child > 1) kill(static_cast<pid_t>(child), SIGKILL);
    at = end;
  }
}

void endEverything() {
  // Killed children hand their own children over, so it takes as many rounds as the tree is deep.
  for (;;) {
    killChildren();
    if (waitpid(-1, nullptr, 0) < 0 && errno == ECHILD) return;
  }
}

/// Waits for the command and reaps orphans meanwhile. False when the lifeline was cut.
bool waitFor(pid_t command, int lifeline, int signals, int& status) {
  for (;;) {
    pollfd events[2] = {{signals, POLLIN, 0}, {lifeline, POLLIN, 0}};
    poll(events, 2, -1);
    if (events[1].revents) return false;
    signalfd_siginfo info{};
    (void)!read(signals, &info, sizeof info);
    for (pid_t ended = 0; (ended = waitpid(-1, &status, WNOHANG)) > 0;)
      if (ended == command) return true;
  }
}

/// Reports why `becomeCommand` failed; false when it did not.
bool reportFailedStart(const HelperPlan& plan, const Failure& failure) {
  const int step = failure.step, error = failure.error;
  if (step < 0) return false;
  const std::string& program = plan.arguments[0];
  if (step == 0)
    report(plan, HelperReport::Kind::failed, "cannot enter " + plan.workingDirectory, error);
  if (step == 1) report(plan, HelperReport::Kind::failed, "cannot set the limits", error);
  if (step == 2) report(plan, HelperReport::Kind::failed, "cannot start " + program, error);
  if (step == 3) report(plan, HelperReport::Kind::unrunnable, "cannot execute " + program, error);
  return true;
}

} // namespace

int runInside(const HelperPlan& plan) {
  using Kind = HelperReport::Kind;
  // Not dumpable: the command runs under the same uid and must not reach us through /proc/1.
  prctl(PR_SET_DUMPABLE, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  close_range(3, ~0u, CLOSE_RANGE_CLOEXEC);
  for (std::size_t i = 0; i + 1 < plan.copies.size(); i += 2) {
    const std::string error = copyTree(plan.copies[i], plan.copies[i + 1]);
    if (!error.empty()) return report(plan, Kind::failed, error), 1;
  }
  sigset_t children;
  sigemptyset(&children);
  sigaddset(&children, SIGCHLD);
  sigprocmask(SIG_BLOCK, &children, nullptr);
  const int signals = signalfd(-1, &children, SFD_CLOEXEC | SFD_NONBLOCK);
  if (signals < 0) return report(plan, Kind::failed, "cannot prepare the start", errno), 1;
  const double start = now();
  Failure failure;
  // Goes on here once the child is the command, or has failed.
  const pid_t command = vfork();
  if (command == 0) becomeCommand(plan, failure);
  if (command < 0) return report(plan, Kind::failed, "cannot fork", errno), 1;
  if (reportFailedStart(plan, failure)) return 1;
  report(plan, Kind::started, "");

  int status = 0;
  const bool ended = waitFor(command, static_cast<int>(plan.lifeline), signals, status);
  const double wall = now() - start;
  endEverything();
  if (!ended) return 1;
  if (!plan.collect.empty() && WIFEXITED(status) && WEXITSTATUS(status) == 0) collect(plan);
  HelperReport message;
  message.kind = WIFEXITED(status) ? Kind::exited : Kind::signalled;
  message.value = WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status);
  message.wallSeconds = wall;
  (void)!write(static_cast<int>(plan.report), &message, sizeof message);
  return 0;
}

} // namespace ggrade::sandbox::helper
