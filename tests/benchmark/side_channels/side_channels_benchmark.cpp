// What two colluding programs can tell each other through the machine, in bits a second, as
// Markdown:
//   ninja -C build/release side_channels_benchmark
//   build/release/bin/side_channels_benchmark [CHANNEL...]
// Without a sandbox, in two sandboxes side by side (as two hidden runs of a class may go), and in
// two, one after the other (as a public run may follow another student's hidden run). The machine
// must be idle, and have two cores. Capacities are those of a binary symmetric channel with the
// error rate that was found, over the best length of a slot; below 10% of a bit a slot counts as 0.
#include "grading/libraries.hpp"
#include "sandbox/sandbox.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <future>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using namespace ggrade;

constexpr int kBits = 200;

struct Channel {
  std::string name, place, placeOutside;
  std::vector<int> slots; ///< microseconds
  bool late;              ///< is it noticed in the middle of a slot, not while it is done?
};

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t(time.tv_sec) * 1000000 + time.tv_nsec / 1000;
}

std::string runPartner(const char* role, const Channel& channel, std::int64_t start, int slot,
                       sandbox::Isolation isolation) {
  const fs::path partner =
      fs::read_symlink("/proc/self/exe").parent_path() / "side_channels_partner";
  const bool inside = isolation == sandbox::Isolation::bwrap;
  sandbox::Command command;
  command.arguments = {inside ? "/partner" : partner.string(),
                       role,
                       channel.name,
                       std::to_string(start),
                       std::to_string(slot),
                       std::to_string(kBits),
                       inside ? channel.place : channel.placeOutside};
  if (inside) {
    command.systemFiles = grading::programLibraries();
    command.mounts = {{partner, "/partner"}};
  } else {
    command.workingDirectory = "/tmp";
  }
  command.limits.wallSeconds = 60;
  const sandbox::Result run = sandbox::run(command, isolation);
  if (run.exitCode != 0) fmt::print(stderr, "{} {}: {}\n", role, channel.name, run.detail);
  return run.standardOutput;
}

/// The threshold and its direction are learnt from the first half, the errors counted in the
/// second.
double errorRate(const std::string& output) {
  std::vector<std::pair<int, double>> all;
  std::istringstream in(output);
  for (int bit = 0; in >> bit;) in >> all.emplace_back(bit, 0).second;
  const std::size_t half = all.size() / 2;
  if (half < 10) return 0.5;
  double best = 1, threshold = 0;
  int sign = 1;
  const auto errors = [&](std::size_t from, std::size_t to, double limit, int direction) {
    double wrong = 0;
    for (std::size_t i = from; i < to; ++i)
      wrong += (direction * (all[i].second - limit) > 0) != (all[i].first == 1);
    return wrong / double(to - from);
  };
  for (std::size_t i = 0; i < half; ++i)
    for (const int direction : {-1, 1})
      if (const double rate = errors(0, half, all[i].second, direction); rate < best)
        best = rate, threshold = all[i].second, sign = direction;
  return errors(half, all.size(), threshold, sign);
}

double capacity(double errors) {
  errors = std::min(errors, 1 - errors);
  if (errors <= 0) return 1;
  return 1 + errors * std::log2(errors) + (1 - errors) * std::log2(1 - errors);
}

double bitsPerSecond(const Channel& channel, sandbox::Isolation isolation, bool together) {
  double best = 0;
  for (const int slot : channel.slots) {
    if (const int file = open(channel.placeOutside.c_str(), O_RDONLY | O_CLOEXEC); file >= 0) {
      if (isolation == sandbox::Isolation::none) posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
      close(file);
    }
    const auto start = now() + 400000;
    auto sender =
        std::async(std::launch::async, runPartner, "send", channel, start, slot, isolation);
    if (!together) sender.get();
    const std::string heard = runPartner(
        "receive", channel, together ? start + (channel.late ? slot / 2 : 0) : now() + 400000, slot,
        isolation);
    if (together) sender.get();
    const double bits = capacity(errorRate(heard));
    if (bits > 0.1) best = std::max(best, bits * 1e6 / slot);
  }
  return best;
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> wanted(argv + 1, argv + argc);
  const auto& libraries = grading::programLibraries();
  const std::string largest = *std::ranges::max_element(
      libraries, {}, [](const fs::path& file) { return fs::file_size(file); });
  const std::string scratch = fs::current_path() / "side_channels.tmp";
  {
    std::ofstream out(scratch, std::ios::binary);
    const std::string block(1 << 20, 'x');
    for (int i = 0; i < kBits + 1; ++i) out << block;
    out.flush();
    sync();
  }
  const std::vector<int> fast{200, 1000, 5000}, slow{1000, 2000, 5000, 10000, 20000};
  const std::vector<Channel> channels = {{"processor", "", "", slow, false},
                                         {"memory bus", "", "", slow, false},
                                         {"memory", "", "", {20000, 50000, 100000}, false},
                                         {"free space", "/tmp", "/tmp", slow, false},
                                         {"locks", largest, largest, fast, false},
                                         {"inode numbers", "", "", slow, true},
                                         {"pages", largest, scratch, fast, true},
                                         {"names", "/usr/lib", "/usr/lib", fast, true}};
  fmt::print("| through | no sandbox | sandboxes side by side | one after the other |\n"
             "| --- | ---: | ---: | ---: |\n");
  for (const Channel& channel : channels) {
    if (!wanted.empty() && std::ranges::find(wanted, channel.name) == wanted.end()) continue;
    const double outside = bitsPerSecond(channel, sandbox::Isolation::none, true);
    const double beside = bitsPerSecond(channel, sandbox::Isolation::bwrap, true);
    const double after = bitsPerSecond(channel, sandbox::Isolation::bwrap, false);
    fmt::print("| {} | {:.0f} | {:.0f} | {:.0f} |\n", channel.name, outside, beside, after);
    std::fflush(stdout);
  }
  fs::remove(scratch);
}
