#include "failing_calls.hpp"

#include "../unit/framework_temporary_folder.hpp"

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

namespace failing_calls {

namespace {

constexpr unsigned kMostSeconds = 60; ///< then SIGALRM ends a run that hangs
constexpr char kBegun[] = "calls count";

#ifdef __x86_64__
const std::map<long, Call> kNumbers = {
    {SYS_open, Call::open},      {SYS_openat, Call::open},     {SYS_creat, Call::open},
    {SYS_read, Call::read},      {SYS_pread64, Call::read},    {SYS_readv, Call::read},
    {SYS_write, Call::write},    {SYS_pwrite64, Call::write},  {SYS_writev, Call::write},
    {SYS_rename, Call::rename},  {SYS_renameat, Call::rename}, {SYS_renameat2, Call::rename},
    {SYS_mkdir, Call::mkdir},    {SYS_mkdirat, Call::mkdir},   {SYS_fsync, Call::sync},
    {SYS_fdatasync, Call::sync}, {SYS_fork, Call::fork},       {SYS_vfork, Call::fork},
    {SYS_clone, Call::fork},     {SYS_clone3, Call::fork},     {SYS_mmap, Call::map}};

/// Lets the tracer look at every call of kNumbers, and at prctl, which beginHere uses.
void installFilter() {
  std::vector<sock_filter> code = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  std::vector<long> numbers = {SYS_prctl};
  for (const auto& [number, call] : kNumbers) numbers.push_back(number);
  for (const long number : numbers) {
    code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, unsigned(number), 0, 1));
    code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRACE));
  }
  code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  const sock_fprog program = {static_cast<unsigned short>(code.size()), code.data()};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
      prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
    _exit(125);
}
#endif

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const char* errorName(int error) {
  return error == kKilled ? "killed" : strerrorname_np(error);
}

} // namespace

const char* name(Role role) {
  return role == Role::parent ? "parent" : "worker";
}

const char* name(Call call) {
  constexpr const char* kNames[] = {"open",  "read", "write", "rename",
                                    "mkdir", "sync", "fork",  "mmap"};
  return kNames[static_cast<int>(call)];
}

std::vector<int> errorsOf(Call call) {
  switch (call) {
  case Call::open:
    return {ENOSPC, EIO, EMFILE, ENOMEM};
  case Call::read:
    return {EIO, EINTR};
  case Call::write:
    return {ENOSPC, EIO, EINTR};
  case Call::rename:
  case Call::mkdir:
  case Call::sync:
    return {ENOSPC, EIO};
  case Call::fork:
    return {ENOMEM, EAGAIN};
  case Call::map:
    return {ENOMEM};
  }
  return {};
}

std::string Fault::text() const {
  return std::string(name(role)) + ": " + name(call) + ' ' + std::to_string(number) + ": " +
         errorName(error) + (lasts ? " from then on" : "");
}

void beginHere() {
  prctl(PR_SET_NAME, kBegun);
}

#ifdef __x86_64__

namespace {

/// One traced tree of processes.
class Tracer {
public:
  Tracer(pid_t first, const std::optional<Fault>& fault, Ended& ended)
      : first_(first), fault_(fault), ended_(ended) {
    roles_[first] = Role::parent;
  }

  void follow() {
    int status = 0;
    for (pid_t pid = 0; (pid = waitpid(-1, &status, __WALL | __WNOTHREAD)) > 0 || errno == EINTR;) {
      if (pid <= 0) continue;
      if (WIFEXITED(status) || WIFSIGNALED(status)) {
        if (pid != first_) continue;
        if (WIFEXITED(status)) ended_.exitCode = WEXITSTATUS(status);
        if (WIFSIGNALED(status)) ended_.signal = WTERMSIG(status);
        continue;
      }
      ptrace(PTRACE_CONT, pid, nullptr, stopped(pid, status));
    }
  }

private:
  /// Returns the signal that the process is to get.
  int stopped(pid_t pid, int status) {
    const int event = status >> 16, signal = WSTOPSIG(status);
    unsigned long about = 0;
    switch (event) {
    case PTRACE_EVENT_SECCOMP:
      call(pid);
      return 0;
    case PTRACE_EVENT_CLONE: // a thread is its process
      ptrace(PTRACE_GETEVENTMSG, pid, nullptr, &about);
      processes_[pid_t(about)] = processOf(pid);
      return 0;
    case PTRACE_EVENT_EXEC:
      if (pid != first_) roles_[pid] = Role::worker;
      begun_.erase(pid);
      return 0;
    case 0:
      // A new child stops once for its tracer.
      return signal == SIGSTOP && seen_.insert(pid).second ? 0 : signal;
    default:
      return 0;
    }
  }

  pid_t processOf(pid_t thread) const {
    const auto known = processes_.find(thread);
    return known == processes_.end() ? thread : known->second;
  }

  void call(pid_t thread) {
    const pid_t pid = processOf(thread);
    user_regs_struct registers{};
    if (ptrace(PTRACE_GETREGS, thread, nullptr, &registers) != 0) return;
    const long number = long(registers.orig_rax);
    if (number == SYS_prctl) {
      if (registers.rdi == PR_SET_NAME) begun_.insert(pid);
      return;
    }
    const auto role = roles_.find(pid);
    if (role == roles_.end() || !begun_.contains(pid)) return;
    const Call kind = kNumbers.at(number);
    const std::size_t count = ++ended_.counts[{role->second, kind}];
    if (!fault_ || fault_->role != role->second || fault_->call != kind) return;
    const bool isStandard = kind == Call::write && registers.rdi <= 2;
    if (fault_->lasts ? count < fault_->number || isStandard
                      : count != fault_->number || ended_.struck)
      return;
    ended_.struck = true;
    if (fault_->error == kKilled) {
      kill(pid, SIGKILL);
      return;
    }
    registers.orig_rax = static_cast<unsigned long>(-1); // no call at all
    registers.rax = static_cast<unsigned long>(-fault_->error);
    ptrace(PTRACE_SETREGS, thread, nullptr, &registers);
  }

  const pid_t first_;
  const std::optional<Fault>& fault_;
  Ended& ended_;
  std::map<pid_t, Role> roles_;
  std::map<pid_t, pid_t> processes_; ///< of threads
  std::set<pid_t> begun_, seen_;
};

} // namespace

Ended run(const std::vector<std::string>& arguments,
          const std::vector<std::pair<std::string, std::string>>& environment,
          const std::optional<Fault>& fault) {
  const TemporaryFolder files;
  const std::string out = files.path() / "out", errors = files.path() / "errors";
  std::vector<char*> argv;
  for (const std::string& word : arguments) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const pid_t pid = fork();
  if (pid < 0) throw std::runtime_error("can't fork");
  if (pid == 0) {
    const auto to = [](const char* file, int descriptor, int flags) {
      const int opened = open(file, flags, 0644);
      if (opened < 0 || dup2(opened, descriptor) < 0) _exit(125);
      close(opened);
    };
    to("/dev/null", 0, O_RDONLY);
    to(out.c_str(), 1, O_WRONLY | O_CREAT | O_TRUNC);
    to(errors.c_str(), 2, O_WRONLY | O_CREAT | O_TRUNC);
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(125);
    alarm(kMostSeconds);
    raise(SIGSTOP); // until the tracer has said what it wants to see
    installFilter();
    execv(argv[0], argv.data());
    _exit(125);
  }
  int status = 0;
  waitpid(pid, &status, 0);
  Ended ended;
  if (WIFSTOPPED(status)) {
    ptrace(PTRACE_SETOPTIONS, pid, nullptr,
           PTRACE_O_TRACESECCOMP | PTRACE_O_TRACEFORK | PTRACE_O_TRACEVFORK | PTRACE_O_TRACECLONE |
               PTRACE_O_TRACEEXEC | PTRACE_O_EXITKILL);
    ptrace(PTRACE_CONT, pid, nullptr, 0);
    Tracer(pid, fault, ended).follow();
  } else {
    ended.exitCode = WEXITSTATUS(status);
  }
  ended.out = contents(out);
  ended.errors = contents(errors);
  return ended;
}

bool possible() {
  return run({"/bin/true"}, {}).exitCode == 0;
}

#else

Ended run(const std::vector<std::string>&, const std::vector<std::pair<std::string, std::string>>&,
          const std::optional<Fault>&) {
  return {};
}

bool possible() {
  return false;
}

#endif

} // namespace failing_calls
