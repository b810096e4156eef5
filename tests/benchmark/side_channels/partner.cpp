// One of two programs that try to tell each other something through the machine that both run on:
//
//   partner send|receive CHANNEL START SLOT BITS PLACE
//
// Bit i belongs to the slot of SLOT microseconds that begins i slots after START (microseconds of
// the monotonic clock). The sender does something in the slots of its ones; the receiver prints a
// number a slot. Both know the bits, so that it can be counted how many came through. PLACE is a
// file or folder that both see. Knows nothing of ggrade.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysinfo.h>
#include <sys/vfs.h>
#include <unistd.h>

namespace {

using Micros = std::int64_t;

Micros now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return Micros(time.tv_sec) * 1000000 + time.tv_nsec / 1000;
}

std::int64_t nanoseconds() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t(time.tv_sec) * 1000000000 + time.tv_nsec;
}

void sleepUntil(Micros when) {
  const timespec time{time_t(when / 1000000), long(when % 1000000) * 1000};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr);
}

void pinTo(int core) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(core, &set);
  sched_setaffinity(0, sizeof set, &set);
}

std::vector<bool> message(int bits) {
  std::mt19937 random(1);
  std::vector<bool> all;
  for (int i = 0; i < bits; ++i) all.push_back(random() % 2);
  return all;
}

/// How often something can be done until a time.
template <class Work> double countUntil(Micros end, Work&& work) {
  double count = 0;
  for (; now() < end; ++count) work();
  return count;
}

class Run {
public:
  Run(std::string name, std::string where, bool sends)
      : channel(std::move(name)), place(std::move(where)) {
    pinTo(channel == "memory bus" && sends ? 1 : 0);
    buffer_.resize(channel == "memory bus" ? 32 << 20 : 1);
    if (channel == "pages") file_ = open(place.c_str(), O_RDONLY | O_CLOEXEC);
  }

  /// The sender's act for a one. `end`: of the slot.
  void send(int i, Micros end) {
    if (channel == "processor")
      countUntil(end, [] {});
    else if (channel == "memory bus")
      countUntil(end, [&] { stream(); });
    else if (channel == "memory") {
      void* const pages = mmap(nullptr, 16 << 20, PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
      sleepUntil(end);
      munmap(pages, 16 << 20);
    } else if (channel == "free space") {
      const std::string note = place + "/note";
      const int file = open(note.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
      (void)!posix_fallocate(file, 0, 16 << 20);
      sleepUntil(end);
      close(file);
      unlink(note.c_str());
    } else if (channel == "pages")
      read(i);
    else if (channel == "names")
      ask(i);
    else if (channel == "inode numbers")
      for (int n = 0; n < 2000; ++n) inode();
    else if (channel == "locks") {
      struct flock lock {};
      lock.l_type = F_RDLCK;
      lock.l_start = i;
      lock.l_len = 1;
      static const int file = open(place.c_str(), O_RDONLY | O_CLOEXEC);
      fcntl(file, F_OFD_SETLK, &lock);
    }
  }

  /// The receiver's number for a slot.
  double receive(int i, Micros end) {
    if (channel == "processor") return countUntil(end, [] {});
    if (channel == "memory bus") return countUntil(end, [&] { stream(); });
    if (channel == "pages") return timed([&] { read(i); });
    if (channel == "names") return timed([&] { ask(i); });
    if (channel == "inode numbers") {
      const double before = last_;
      last_ = inode();
      return last_ - before;
    }
    if (channel == "memory" || channel == "free space") {
      const double before = free();
      sleepUntil(end);
      return free() - before;
    }
    if (channel == "locks") {
      struct flock lock {};
      lock.l_type = F_WRLCK;
      lock.l_start = i;
      lock.l_len = 1;
      static const int file = open(place.c_str(), O_RDONLY | O_CLOEXEC);
      return fcntl(file, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
    }
    return 0;
  }

private:
  std::string channel, place;

  void stream() {
    for (std::size_t at = 0; at < buffer_.size(); at += 64) ++buffer_[at];
  }
  /// Pages far apart, so that reading one does not fetch another's.
  void read(int i) {
    char byte = 0;
    (void)!pread(file_, &byte, 1, off_t(i) * (1 << 20));
  }
  void ask(int i) {
    struct stat status {};
    stat((place + "/note-" + std::to_string(i)).c_str(), &status);
  }
  static double inode() {
    int ends[2];
    struct stat status {};
    if (pipe(ends) != 0) return 0;
    fstat(ends[0], &status);
    close(ends[0]);
    close(ends[1]);
    return double(status.st_ino);
  }
  /// Bytes or blocks; what isn't told is 0.
  double free() const {
    struct sysinfo memory {};
    if (channel == "memory") return sysinfo(&memory) == 0 ? double(memory.freeram) : 0;
    struct statfs disk {};
    return statfs(place.c_str(), &disk) == 0 ? double(disk.f_bfree) : 0;
  }
  template <class Work> static double timed(Work&& work) {
    const auto start = nanoseconds();
    work();
    return double(nanoseconds() - start);
  }

  std::vector<unsigned char> buffer_;
  int file_ = -1;
  double last_ = 0;
};

} // namespace

int main(int argc, char** argv) {
  if (argc != 7) return 2;
  const bool sends = std::strcmp(argv[1], "send") == 0;
  const Micros start = std::atoll(argv[3]), slot = std::atoll(argv[4]);
  const std::vector<bool> bits = message(std::atoi(argv[5]));
  Run run(argv[2], argv[6], sends);
  for (int i = 0; i < int(bits.size()); ++i) {
    const Micros begin = start + i * slot, end = begin + slot;
    sleepUntil(begin);
    if (sends && bits[i]) run.send(i, end);
    if (!sends) std::printf("%d %.0f\n", int(bits[i]), run.receive(i, end - slot / 10));
  }
}
