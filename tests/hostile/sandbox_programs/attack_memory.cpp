// Memory and space, in every way that a process can hold them.
#include "attacker.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <mqueue.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/msg.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace attacker {
namespace {

constexpr std::size_t kBlock = 1 << 20;

/// Takes `blocks` MB of private memory and touches every page.
void touch(std::size_t blocks) {
  for (std::size_t i = 0; i < blocks; ++i) {
    void* memory =
        mmap(nullptr, kBlock, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return;
    std::memset(memory, 1, kBlock);
  }
}

[[noreturn]] void hold() {
  for (;;) pause();
}

int plainAttack(const Arguments&) {
  touch(1 << 20);
  hold();
}

/// Many processes, each of them small.
int manyAttack(const Arguments& arguments) {
  for (int i = 0; i < std::stoi(arguments.at(0)); ++i) {
    if (fork() != 0) continue;
    touch(std::stoul(arguments.at(1)));
    hold();
  }
  hold();
}

/// The same, each started by a thread of its own.
int manyThreadsAttack(const Arguments& arguments) {
  std::vector<std::thread> threads;
  for (int i = 0; i < std::stoi(arguments.at(0)); ++i)
    threads.emplace_back([&] {
      if (fork() == 0) touch(std::stoul(arguments.at(1)));
      hold();
    });
  hold();
}

int addressSpaceAttack(const Arguments&) {
  Attempts attempts;
  void* memory = mmap(nullptr, 8ull << 30, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  attempts.add("8 GB of address space", memory != MAP_FAILED);
  return attempts.outcome();
}

/// Memory that would belong to no process, or to none that the supervisor counts.
int hiddenAttack(const Arguments&) {
  Attempts attempts;
  attempts.add("memfd_create", memfd_create("hidden", 0) >= 0);
  attempts.add("shared anonymous memory", mmap(nullptr, kBlock, PROT_READ | PROT_WRITE,
                                               MAP_SHARED | MAP_ANONYMOUS, -1, 0) != MAP_FAILED);
  const int zero = open("/dev/zero", O_RDWR | O_CLOEXEC);
  attempts.add("shared memory of /dev/zero",
               zero >= 0 && mmap(nullptr, kBlock, PROT_WRITE, MAP_SHARED, zero, 0) != MAP_FAILED);
  attempts.add("huge pages", mmap(nullptr, 2 << 20, PROT_WRITE,
                                  MAP_PRIVATE | MAP_ANONYMOUS | MAP_HUGETLB, -1, 0) != MAP_FAILED);
  attempts.add("shmget", shmget(IPC_PRIVATE, kBlock, IPC_CREAT | 0600) >= 0);
  attempts.add("semget", semget(IPC_PRIVATE, 1, IPC_CREAT | 0600) >= 0);
  attempts.add("msgget", msgget(IPC_PRIVATE, IPC_CREAT | 0600) >= 0);
  attempts.add("shm_open", shm_open("/hidden", O_CREAT | O_RDWR, 0600) >= 0);
  attempts.add("mq_open", mq_open("/hidden", O_CREAT | O_RDWR, 0600, nullptr) >= 0);
  return attempts.outcome();
}

/// Writes files of 1 MB into a folder until an error; prints how many MB went in. Then holds the
/// rest.
int fillAttack(const Arguments& arguments) {
  const std::string block(kBlock, 'f');
  std::size_t total = 0;
  for (int i = 0;; ++i) {
    const std::string path = arguments.at(0) + "/fill" + std::to_string(i);
    const int file = open(path.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
    if (file < 0) break;
    const ssize_t written = write(file, block.data(), block.size());
    close(file);
    total += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    if (written != static_cast<ssize_t>(block.size())) break;
    if (total > (1ull << 30)) return kEscaped;
  }
  std::printf("%zu %s\n", total, std::strerror(errno));
  if (arguments.size() < 2) return 0;
  touch(std::stoul(arguments[1]));
  hold();
}

/// Unlinked but open files, and empty files: both are memory that `du` does not show.
int emptyFilesAttack(const Arguments&) {
  for (long i = 0;; ++i) {
    const std::string path = "/scratch/empty" + std::to_string(i);
    const int file = open(path.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
    if (file < 0) break;
    close(file);
  }
  hold();
}

int largeFileAttack(const Arguments&) {
  const int file = open("/scratch/large", O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  const std::string block(kBlock, 'l');
  while (write(file, block.data(), block.size()) > 0) {
  }
  return kEscaped;
}

int sparseFileAttack(const Arguments&) {
  Attempts attempts;
  std::signal(SIGXFSZ, SIG_IGN);
  const int file = open("/scratch/sparse", O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  attempts.add("truncate to 1 TB", ftruncate(file, 1ll << 40) == 0);
  attempts.add("fallocate 1 GB", fallocate(file, 0, 0, 1 << 30) == 0);
  attempts.add("write at 1 TB", pwrite(file, "x", 1, 1ll << 40) == 1);
  return attempts.outcome();
}

/// Prints numbered lines, ARGUMENT MB of them.
int floodAttack(const Arguments& arguments) {
  const std::size_t bytes = std::stoul(arguments.at(0)) << 20;
  const std::string line = "0123456789abcde\n";
  for (std::size_t i = 0; i < bytes; i += line.size()) std::fputs(line.c_str(), stdout);
  std::fputs("last words\n", stderr);
  return 0;
}

} // namespace

void addMemoryAttacks(Attacks& attacks) {
  attacks.insert({{"plain", plainAttack},
                  {"many", manyAttack},
                  {"manyThreads", manyThreadsAttack},
                  {"addressSpace", addressSpaceAttack},
                  {"hidden", hiddenAttack},
                  {"fill", fillAttack},
                  {"emptyFiles", emptyFilesAttack},
                  {"largeFile", largeFileAttack},
                  {"sparseFile", sparseFileAttack},
                  {"flood", floodAttack}});
}

} // namespace attacker
