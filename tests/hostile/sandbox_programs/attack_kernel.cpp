// Doors into the kernel that no picture needs.
#include "attacker.hpp"

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fcntl.h>
#include <sched.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/personality.h>
#include <sys/ptrace.h>
#include <sys/reboot.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

namespace attacker {
namespace {

int socketAttack(const Arguments&) {
  Attempts attempts;
  const struct {
    const char* name;
    int family, type;
  } kinds[] = {{"TCP", AF_INET, SOCK_STREAM},
               {"UDP", AF_INET, SOCK_DGRAM},
               {"TCP over IPv6", AF_INET6, SOCK_STREAM},
               {"UNIX", AF_UNIX, SOCK_STREAM},
               {"netlink", AF_NETLINK, SOCK_RAW},
               {"packet", AF_PACKET, SOCK_RAW},
               {"vsock", AF_VSOCK, SOCK_STREAM},
               {"alg", AF_ALG, SOCK_SEQPACKET}};
  for (const auto& kind : kinds)
    attempts.add(std::string(kind.name) + " socket", socket(kind.family, kind.type, 0) >= 0);
  int pair[2];
  attempts.add("socketpair", socketpair(AF_UNIX, SOCK_STREAM, 0, pair) == 0);
  return attempts.outcome();
}

int traceAttack(const Arguments&) {
  Attempts attempts;
  attempts.add("attach to init", ptrace(PTRACE_ATTACH, 1, nullptr, nullptr) == 0);
  attempts.add("seize init", ptrace(PTRACE_SEIZE, 1, nullptr, nullptr) == 0);
  attempts.add("be traced", ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0);
  char byte = 0;
  iovec local{&byte, 1}, remote{&byte, 1};
  attempts.add("read init's memory", process_vm_readv(1, &local, 1, &remote, 1, 0) >= 0);
  attempts.add("read own memory", process_vm_readv(getpid(), &local, 1, &remote, 1, 0) >= 0);
  attempts.add("write memory", process_vm_writev(getpid(), &local, 1, &remote, 1, 0) >= 0);
  const auto init = static_cast<int>(syscall(SYS_pidfd_open, 1, 0));
  attempts.add("take init's descriptor", syscall(SYS_pidfd_getfd, init, 0, 0) >= 0);
  attempts.add("kcmp", syscall(SYS_kcmp, getpid(), 1, 0, 0, 0) >= 0);
  return attempts.outcome();
}

int namespaceAttack(const Arguments&) {
  Attempts attempts;
  const struct {
    const char* name;
    int flag;
  } kinds[] = {{"user", CLONE_NEWUSER},    {"mnt", CLONE_NEWNS},  {"pid", CLONE_NEWPID},
               {"net", CLONE_NEWNET},      {"ipc", CLONE_NEWIPC}, {"uts", CLONE_NEWUTS},
               {"cgroup", CLONE_NEWCGROUP}};
  for (const auto& kind : kinds) {
    const std::string name = kind.name;
    attempts.add("unshare " + name, unshare(kind.flag) == 0);
    attempts.add("unshare user and " + name, unshare(CLONE_NEWUSER | kind.flag) == 0);
    const long child = syscall(SYS_clone, kind.flag | SIGCHLD, nullptr, nullptr, nullptr, nullptr);
    if (child == 0) _exit(0);
    attempts.add("clone " + name, child > 0);
    const int file = open(("/proc/self/ns/" + name).c_str(), O_RDONLY | O_CLOEXEC);
    attempts.add("setns " + name, setns(file, 0) == 0);
  }
  std::uint64_t arguments[8] = {CLONE_NEWUSER, 0, 0, 0, SIGCHLD, 0, 0, 0};
  const long child = syscall(SYS_clone3, arguments, sizeof arguments);
  if (child == 0) _exit(0);
  attempts.add("clone3", child > 0);
  return attempts.outcome();
}

int kernelAttack(const Arguments&) {
  Attempts attempts;
  attempts.add("keyctl", syscall(SYS_keyctl, 0, -3, 0) >= 0);
  attempts.add("add_key", syscall(SYS_add_key, "user", "a", "b", 1, -2) >= 0);
  attempts.add("request_key", syscall(SYS_request_key, "user", "a", nullptr, -2) >= 0);
  char zeros[256] = {};
  attempts.add("bpf", syscall(SYS_bpf, 0, zeros, sizeof zeros) >= 0);
  attempts.add("perf_event_open", syscall(SYS_perf_event_open, zeros, 0, -1, -1, 0) >= 0);
  attempts.add("userfaultfd", syscall(SYS_userfaultfd, 1) >= 0);
  attempts.add("io_uring_setup", syscall(SYS_io_uring_setup, 4, zeros) >= 0);
  attempts.add("kexec_load", syscall(SYS_kexec_load, 0, 0, nullptr, 0) >= 0);
  attempts.add("reboot", reboot(RB_DISABLE_CAD) == 0);
  attempts.add("init_module", syscall(SYS_init_module, zeros, 1, "") >= 0);
  attempts.add("personality", personality(ADDR_NO_RANDOMIZE) >= 0);
  attempts.add("syslog", syscall(SYS_syslog, 10, nullptr, 0) >= 0);
  attempts.add("sethostname", sethostname("mine", 4) == 0);
  attempts.add("fanotify_init", syscall(SYS_fanotify_init, 0, 0) >= 0);
  attempts.add("open_by_handle_at", syscall(SYS_open_by_handle_at, AT_FDCWD, zeros, 0) >= 0);
  attempts.add("quotactl", syscall(SYS_quotactl, 0, nullptr, 0, nullptr) >= 0);
  attempts.add("acct", syscall(SYS_acct, "/scratch/acct") >= 0);
  attempts.add("a system call of the future", syscall(600) >= 0);
  char letter = 'x';
  attempts.add("TIOCSTI", ioctl(0, TIOCSTI, &letter) == 0);
  // The upper half of the request is ignored by the kernel and must not fool the filter.
  attempts.add("TIOCSTI in disguise",
               syscall(SYS_ioctl, 0, 0x100000000ull | TIOCSTI, &letter) == 0);
  // Whom the kernel ends first when memory runs out.
  const int badness = open("/proc/self/oom_score_adj", O_WRONLY);
  attempts.add("lower oom_score_adj", write(badness, "0", 1) == 1);
  attempts.add("run in real time", [] {
    const sched_param parameters{10};
    return sched_setscheduler(0, SCHED_FIFO, &parameters) == 0;
  }());
  return attempts.outcome();
}

/// What makes the kernel keep memory that belongs to no process: a million locks, watches, timers,
/// descriptors, mappings. Holds on for a moment, and prints how much of it there is.
int kernelMemoryAttack(const Arguments& arguments) {
  const int file = open(arguments.at(0).c_str(), O_RDONLY);
  int locks = 0, watches = 0, timers = 0, descriptors = 0, mappings = 0;
  for (int i = 0; i < 1000000; ++i) {
    struct flock lock {};
    lock.l_type = F_RDLCK;
    lock.l_start = 2 * i; // neighbours would become one
    lock.l_len = 1;
    if (fcntl(file, F_OFD_SETLK, &lock) != 0) break;
    ++locks;
  }
  std::vector<int> queues;
  for (int queue = 0; queues.size() < 100 && (queue = epoll_create1(0)) >= 0;)
    queues.push_back(queue);
  while (eventfd(0, 0) >= 0) ++descriptors;
  for (const int queue : queues)
    for (int watched = 0; watched < 256; ++watched) {
      epoll_event event{};
      watches += epoll_ctl(queue, EPOLL_CTL_ADD, watched, &event) == 0;
    }
  for (timer_t timer; timers < 100000 && timer_create(CLOCK_MONOTONIC, nullptr, &timer) == 0;)
    ++timers;
  // Protections that alternate keep the kernel from joining them.
  for (; mappings < 100000; ++mappings)
    if (mmap(nullptr, 4096, mappings % 2 ? PROT_READ : PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1,
             0) == MAP_FAILED)
      break;
  std::printf("%d locks, %zu queues, %d watches, %d timers, %d descriptors, %d mappings\n", locks,
              queues.size(), watches, timers, descriptors, mappings);
  std::fflush(stdout);
  usleep(500000);
  return kRefused;
}

/// Ways to leave a note on a file that every sandbox sees, or to read one: locks, leases, watches,
/// and which of its pages are in memory.
int blackboardAttack(const Arguments& arguments) {
  Attempts attempts;
  signal(SIGIO, SIG_IGN); // where a watch works it comes
  const char* const shared = arguments.at(0).c_str();
  const int file = open(shared, O_RDONLY), again = open(shared, O_RDONLY);
  attempts.add("the file is not there", file < 0 || again < 0);
  struct flock lock {};
  lock.l_type = F_RDLCK;
  lock.l_len = 1;
  for (const auto& [name, command] : {std::pair{"F_SETLK", F_SETLK},
                                      {"F_SETLKW", F_SETLKW},
                                      {"F_OFD_SETLK", F_OFD_SETLK},
                                      {"F_OFD_SETLKW", F_OFD_SETLKW},
                                      {"F_GETLK", F_GETLK},
                                      {"F_OFD_GETLK", F_OFD_GETLK}})
    attempts.add(name, fcntl(file, command, &lock) == 0);
  attempts.add("F_SETLEASE", fcntl(file, F_SETLEASE, F_RDLCK) == 0);
  attempts.add("F_GETLEASE", fcntl(file, F_GETLEASE) >= 0);
  attempts.add("F_NOTIFY", fcntl(open("/usr/bin", O_RDONLY), F_NOTIFY, DN_ACCESS) == 0);
  // The upper half of the command is ignored by the kernel and must not fool the filter.
  attempts.add("F_SETLK in disguise",
               syscall(SYS_fcntl, file, 0x100000000ull | F_SETLK, &lock) == 0);
  // What is said to be done and isn't: else the second lock would be refused...
  attempts.add("flock", flock(file, LOCK_EX) != 0 || flock(again, LOCK_EX | LOCK_NB) != 0);
  // ... and a pipe has no pages to speak of.
  int ends[2];
  attempts.add("no pipe", pipe(ends) != 0);
  attempts.add("fadvise64", syscall(SYS_fadvise64, ends[0], 0, 0, POSIX_FADV_DONTNEED) != 0);
  attempts.add("readahead", syscall(SYS_readahead, ends[0], 0, 4096) != 0);
  attempts.add("F_SETPIPE_SZ", fcntl(ends[0], F_SETPIPE_SZ, 1 << 20) >= 0);
  attempts.add("inotify_init", syscall(SYS_inotify_init1, 0) >= 0);
  attempts.add("sync_file_range", syscall(SYS_sync_file_range, file, 0, 0, 0) == 0);
  attempts.add("cachestat", syscall(451, file, 0, 0, 0) == 0);
  char byte = 0;
  iovec to{&byte, 1};
  attempts.add("RWF_NOWAIT", preadv2(file, &to, 1, 0, RWF_NOWAIT) >= 0 || errno == EAGAIN);
  attempts.add("preadv2 without flags must work", preadv2(file, &to, 1, 0, 0) != 1);
  void* const pages = mmap(nullptr, 4096, PROT_READ, MAP_SHARED, file, 0);
  attempts.add("no mapping", pages == MAP_FAILED);
  unsigned char resident = 0;
  attempts.add("mincore", mincore(pages, 4096, &resident) == 0);
  attempts.add("MADV_COLD", madvise(pages, 4096, 20) == 0);
  attempts.add("MADV_PAGEOUT", madvise(pages, 4096, 21) == 0);
  attempts.add("MADV_WILLNEED", madvise(pages, 4096, MADV_WILLNEED) == 0);
  attempts.add("MADV_DONTNEED must work", madvise(pages, 4096, MADV_DONTNEED) != 0);
  return attempts.outcome();
}

/// Prints the errno of calls that the filter refuses: it, and not the kernel, must be the one.
int filterAttack(const Arguments&) {
  const auto print = [](const char* name, long result) {
    std::printf("%s %d\n", name, result < 0 ? errno : 0);
  };
  print("keyctl", syscall(SYS_keyctl, 0, -3, 0));
  print("ptrace", syscall(SYS_ptrace, 0xffff, 0, 0, 0));
  print("socket", syscall(SYS_socket, -1, -1, -1));
  print("unshare", syscall(SYS_unshare, 0));
  print("mount", syscall(SYS_mount, nullptr, nullptr, nullptr, 0, nullptr));
  print("bpf", syscall(SYS_bpf, 9999, nullptr, 0));
  print("memfd_create", syscall(SYS_memfd_create, nullptr, 0xffff));
  print("clone3", syscall(SYS_clone3, nullptr, 0));
  return 0;
}

/// A 32-bit system call from a 64-bit program: its numbers mean other things.
int foreignAttack(const Arguments& arguments) {
#if defined(__x86_64__)
  if (arguments.at(0) == "i386") {
    long result = 20; // getpid
    __asm__ volatile("int $0x80" : "+a"(result) : : "memory");
  } else {
    syscall(0x40000000 + SYS_getpid); // x32
  }
  return kEscaped;
#else
  (void)arguments;
  raise(SIGSYS);
  return 0;
#endif
}

} // namespace

void addKernelAttacks(Attacks& attacks) {
  attacks.insert({{"socket", socketAttack},
                  {"trace", traceAttack},
                  {"namespace", namespaceAttack},
                  {"kernel", kernelAttack},
                  {"blackboard", blackboardAttack},
                  {"kernelMemory", kernelMemoryAttack},
                  {"filter", filterAttack},
                  {"foreign", foreignAttack}});
}

} // namespace attacker
