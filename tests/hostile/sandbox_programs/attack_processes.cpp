// Processes: too many, too long, or where they should not be.
#include "attacker.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>

namespace attacker {
namespace {

[[noreturn]] void spin() {
  for (;;) __asm__ volatile("");
}

double now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Every child forks on. The first process counts its own children and reports once.
int forkAttack(const Arguments&) {
  int children = 0;
  double reported = now();
  for (;;) {
    const pid_t child = fork();
    if (child > 0) ++children;
    if (child < 0 && getppid() == 1 && now() - reported > 0.3) {
      std::printf("%d children\n", children);
      std::fflush(stdout);
      reported = now() + 1000;
    }
  }
}

int threadAttack(const Arguments&) {
  int threads = 0;
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, 64 << 10);
  pthread_t thread{};
  while (threads < 10000 && pthread_create(
                                &thread, &attributes,
                                [](void*) -> void* {
                                  for (;;) pause();
                                },
                                nullptr) == 0)
    ++threads;
  std::printf("%d threads\n", threads);
  return 0;
}

/// A daemon: new session, deaf to polite signals, with none of its parent's descriptors.
int outliveAttack(const Arguments& arguments) {
  if (fork() == 0) {
    setsid();
    for (const int number : {SIGTERM, SIGINT, SIGHUP, SIGQUIT}) std::signal(number, SIG_IGN);
    if (fork() != 0) _exit(0);
    for (int number = 0; number < 256; ++number) close(number);
    for (;;) sleep(60);
  }
  wait(nullptr);
  if (arguments.size() > 1 && arguments[1] == "stay")
    for (;;) sleep(60);
  return 3;
}

int deafAttack(const Arguments&) {
  for (int number = 1; number < 32; ++number) std::signal(number, SIG_IGN);
  for (;;) sleep(60);
}

int spinAttack(const Arguments& arguments) {
  for (int i = 1; i < std::stoi(arguments.at(0)); ++i)
    if (fork() == 0) spin();
  spin();
}

int killAllAttack(const Arguments&) {
  // From a child, so that the command itself is among the targets.
  if (fork() == 0) {
    kill(-1, SIGKILL);
    _exit(0);
  }
  for (;;) pause();
}

int killInitAttack(const Arguments&) {
  for (int number = 1; number < 65; ++number) kill(1, number);
  usleep(100'000);
  // Still alive, so init is too.
  return 5;
}

[[gnu::noinline]] int recurse(volatile char* above) {
  volatile char block[4096];
  block[0] = *above;
  return recurse(block) + block[0];
}

int signalAttack(const Arguments& arguments) {
  raise(std::stoi(arguments.at(0)));
  return 1;
}

int faultAttack(const Arguments& arguments) {
  const std::string& kind = arguments.at(0);
  volatile int zero = 0, number = 7;
  char start = 0;
  if (kind == "segv") *reinterpret_cast<volatile int*>(zero) = 1;
  if (kind == "stack") return recurse(&start);
  if (kind == "fpe") return number / zero;
  if (kind == "ill") __builtin_trap();
  if (kind == "abrt") std::abort();
  return 1;
}

int exitAttack(const Arguments& arguments) {
  return std::stoi(arguments.at(0));
}

int sleepAttack(const Arguments&) {
  for (;;) sleep(60);
}

} // namespace

void addProcessAttacks(Attacks& attacks) {
  attacks.insert({{"fork", forkAttack},
                  {"thread", threadAttack},
                  {"outlive", outliveAttack},
                  {"deaf", deafAttack},
                  {"spin", spinAttack},
                  {"killAll", killAllAttack},
                  {"killInit", killInitAttack},
                  {"signal", signalAttack},
                  {"fault", faultAttack},
                  {"exit", exitAttack},
                  {"sleep", sleepAttack}});
}

} // namespace attacker
