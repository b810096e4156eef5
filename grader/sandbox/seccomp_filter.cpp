#include "seccomp_filter.hpp"

#include "descriptor.hpp"

#include <cerrno>
#include <fcntl.h>
#include <memory>
#include <sched.h>
#include <seccomp.h>
#include <stdexcept>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>

namespace ggrade::sandbox {
namespace {

/// What compilers, linkers, Mesa and ordinary single-machine programs use.
constexpr const char* kAllowed[] = {
    // files; fcntl and pread with flags have rules of their own
    "read", "write", "readv", "writev", "pread64", "pwrite64", "preadv", "pwritev", "open",
    "openat", "openat2", "creat", "close", "close_range", "stat", "fstat", "lstat", "newfstatat",
    "statx", "access", "faccessat", "faccessat2", "lseek", "dup", "dup2", "dup3", "rename",
    "renameat", "renameat2", "mkdir", "mkdirat", "rmdir", "unlink", "unlinkat", "link", "linkat",
    "symlink", "symlinkat", "readlink", "readlinkat", "chmod", "fchmod", "fchmodat", "chown",
    "fchown", "lchown", "fchownat", "umask", "truncate", "ftruncate", "fallocate", "fsync",
    "fdatasync", "getdents", "getdents64", "getcwd", "chdir", "fchdir", "utime", "utimes",
    "utimensat", "futimesat", "copy_file_range", "sendfile", "mknod", "mknodat", "getxattr",
    "lgetxattr", "fgetxattr", "listxattr", "llistxattr", "flistxattr",
    // waiting
    "select", "pselect6", "poll", "ppoll", "epoll_create", "epoll_create1", "epoll_ctl",
    "epoll_wait", "epoll_pwait", "epoll_pwait2", "eventfd", "eventfd2", "signalfd", "signalfd4",
    "timerfd_create", "timerfd_settime", "timerfd_gettime",
    // memory; mmap and madvise have rules of their own
    "mprotect", "munmap", "mremap", "brk", "msync", "mlock", "mlock2", "munlock", "membarrier",
    // processes and threads; clone has a rule of its own
    "fork", "vfork", "execve", "execveat", "exit", "exit_group", "wait4", "waitid", "getpid",
    "getppid", "gettid", "getpgid", "getpgrp", "setpgid", "getsid", "setsid", "kill", "tkill",
    "tgkill", "pidfd_open", "pidfd_send_signal", "set_tid_address", "set_robust_list",
    "get_robust_list", "futex", "futex_waitv", "rseq", "arch_prctl", "prctl", "getrlimit",
    "setrlimit", "prlimit64", "getrusage", "times", "sched_yield", "sched_getaffinity",
    "sched_setaffinity", "sched_getparam", "sched_setparam", "sched_getscheduler",
    "sched_setscheduler", "sched_get_priority_max", "sched_get_priority_min", "getpriority",
    "setpriority", "getcpu", "capget",
    // signals and time
    "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "rt_sigpending", "rt_sigsuspend",
    "rt_sigtimedwait", "rt_sigqueueinfo", "rt_tgsigqueueinfo", "sigaltstack", "restart_syscall",
    "pause", "nanosleep", "clock_nanosleep", "clock_gettime", "clock_getres", "gettimeofday",
    "time", "getitimer", "setitimer", "alarm", "timer_create", "timer_settime", "timer_gettime",
    "timer_getoverrun", "timer_delete",
    // who and where am I
    "getuid", "geteuid", "getgid", "getegid", "getresuid", "getresgid", "getgroups", "uname",
    "getrandom"};

/// Commands of fcntl that concern the program's own descriptors alone.
constexpr int kDescriptorCommands[] = {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD,      F_SETFD,
                                       F_GETFL, F_SETFL,         F_GETPIPE_SZ, F_GET_SEALS};
/// Those that leave something on the file for others to find, or make the kernel keep memory that
/// nobody counts.
constexpr int kFileCommands[] = {F_GETLK,      F_SETLK,      F_SETLKW,   F_OFD_GETLK, F_OFD_SETLK,
                                 F_OFD_SETLKW, F_SETLEASE,   F_GETLEASE, F_NOTIFY,    F_SETOWN,
                                 F_SETSIG,     F_SETPIPE_SZ, F_ADD_SEALS};
/// Advice about a program's own address space; the rest of it moves pages of files that others see.
constexpr int kMemoryAdvice[] = {MADV_NORMAL,     MADV_RANDOM,   MADV_SEQUENTIAL, MADV_DONTNEED,
                                 MADV_FREE,       MADV_DONTFORK, MADV_DOFORK,     MADV_HUGEPAGE,
                                 MADV_NOHUGEPAGE, MADV_DONTDUMP, MADV_DODUMP};

/// Refused by name, so that a program's message is "Operation not permitted".
constexpr const char* kRefused[] = {
    // memory and messages that outlive or evade the accounting of a process
    "memfd_create", "memfd_secret", "shmget", "shmat", "shmctl", "shmdt", "msgget", "msgsnd",
    "msgrcv", "msgctl", "semget", "semop", "semctl", "semtimedop", "mq_open", "mq_unlink",
    "remap_file_pages", "vmsplice", "userfaultfd",
    // what two sandboxes could tell each other by, through the system's files that both see: who
    // watches them, and which of their pages are in memory
    "inotify_init", "inotify_init1", "inotify_add_watch", "inotify_rm_watch", "mincore",
    "sync_file_range", "cachestat",
    // the host's load, memory and free space
    "sysinfo", "statfs", "fstatfs", "ustat",
    // other processes
    "ptrace", "process_vm_readv", "process_vm_writev", "process_madvise", "kcmp", "pidfd_getfd",
    "perf_event_open",
    // the network
    "socket", "socketpair", "connect", "bind", "listen", "accept", "accept4",
    // namespaces, mounts, root
    "unshare", "setns", "mount", "umount", "umount2", "pivot_root", "chroot", "open_tree",
    "move_mount", "fsopen", "fsconfig", "fsmount", "fspick", "mount_setattr", "swapon", "swapoff",
    "name_to_handle_at", "open_by_handle_at", "fanotify_init", "quotactl", "quotactl_fd", "acct",
    "setuid", "setgid", "setreuid", "setregid", "setresuid", "setresgid", "setfsuid", "setfsgid",
    "setgroups", "capset", "personality",
    // the kernel itself
    "keyctl", "add_key", "request_key", "bpf", "seccomp", "io_uring_setup", "io_uring_enter",
    "io_uring_register", "kexec_load", "kexec_file_load", "reboot", "init_module", "finit_module",
    "delete_module", "iopl", "ioperm", "modify_ldt", "syslog", "sethostname", "setdomainname",
    "settimeofday", "clock_settime", "clock_adjtime", "adjtimex", "vhangup"};

class Filter {
public:
  Filter() : context_(seccomp_init(SCMP_ACT_ERRNO(ENOSYS)), seccomp_release) {
    if (!context_) throw std::runtime_error("seccomp: cannot make a filter");
  }
  scmp_filter_ctx get() const { return context_.get(); }

  /// Adds one rule; names that this processor does not have are passed over.
  template <class... Conditions>
  void add(std::uint32_t action, const char* name, Conditions... conditions) {
    const int number = seccomp_syscall_resolve_name(name);
    if (number == __NR_SCMP_ERROR) return;
    if (const int error =
            seccomp_rule_add(get(), action, number, sizeof...(conditions), conditions...))
      throw std::runtime_error(std::string("seccomp: rule for ") + name + ": error " +
                               std::to_string(-error));
  }

private:
  std::unique_ptr<void, void (*)(scmp_filter_ctx)> context_;
};

scmp_arg_cmp argument(unsigned index, std::uint64_t mask, std::uint64_t value) {
  return scmp_arg_cmp{index, SCMP_CMP_MASKED_EQ, mask, value};
}

std::string makeFilter(bool pipes) {
  const std::uint32_t refuse = SCMP_ACT_ERRNO(EPERM);
  Filter filter;
  for (const char* name : kAllowed) filter.add(SCMP_ACT_ALLOW, name);
  for (const char* name : kRefused) filter.add(refuse, name);
  for (const char* name : {"pipe", "pipe2"}) filter.add(pipes ? SCMP_ACT_ALLOW : refuse, name);

  // No namespaces. clone3 hides its flags in memory: with ENOSYS, the default, glibc takes clone.
  constexpr std::uint64_t namespaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC |
                                       CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;
  filter.add(SCMP_ACT_ALLOW, "clone", argument(0, namespaces, 0));

  // Shared anonymous and huge pages can be kept without being resident anywhere, so the supervisor
  // could not count them. Files and private memory remain.
  constexpr std::uint64_t type = 0x0f;
  filter.add(SCMP_ACT_ALLOW, "mmap", argument(3, MAP_ANONYMOUS | MAP_HUGETLB, 0));
  filter.add(SCMP_ACT_ALLOW, "mmap",
             argument(3, MAP_ANONYMOUS | MAP_HUGETLB | type, MAP_ANONYMOUS | MAP_PRIVATE));

  // Locks, leases and notices stay on a file that every sandbox sees. Compilers and Mesa lock files
  // of their own with flock: to them it is said to be done.
  for (const int command : kDescriptorCommands)
    filter.add(SCMP_ACT_ALLOW, "fcntl", argument(1, 0xffffffff, std::uint64_t(command)));
  for (const int command : kFileCommands)
    filter.add(refuse, "fcntl", argument(1, 0xffffffff, std::uint64_t(command)));
  const std::uint32_t ignore = SCMP_ACT_ERRNO(0);
  for (const char* name : {"flock", "fadvise64", "readahead"}) filter.add(ignore, name);
  // RWF_NOWAIT tells whether a page of a file is in memory.
  for (const char* name : {"preadv2", "pwritev2"})
    filter.add(SCMP_ACT_ALLOW, name, argument(5, 0xffffffff, 0));
  for (const int advice : kMemoryAdvice)
    filter.add(SCMP_ACT_ALLOW, "madvise", argument(2, 0xffffffff, std::uint64_t(advice)));

  // Terminals: only questions. TIOCSTI and TIOCLINUX type into one.
  for (const std::uint64_t request :
       {TCGETS, TIOCGWINSZ, TIOCGPGRP, FIONREAD, FIONBIO, FIOCLEX, FIONCLEX})
    filter.add(SCMP_ACT_ALLOW, "ioctl", argument(1, 0xffffffff, request));

  // A tree of comparisons instead of a list of 200.
  seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2);
  const Descriptor file(memfd_create("seccomp", MFD_CLOEXEC));
  struct stat status {};
  if (!file || seccomp_export_bpf(filter.get(), file.get()) != 0 || fstat(file.get(), &status) != 0)
    throw std::runtime_error("seccomp: cannot write the filter");
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  if (pread(file.get(), bytes.data(), bytes.size(), 0) != status.st_size)
    throw std::runtime_error("seccomp: cannot read the filter back");
  return bytes;
}

} // namespace

const std::string& seccompFilter(bool pipes) {
  static const std::string with = makeFilter(true), without = makeFilter(false);
  return pipes ? with : without;
}

} // namespace ggrade::sandbox
