// ggrade-sandbox-helper outside|inside PLAN, or probe. Started by ggrade::sandbox::run, never by
// hand.
#include "helper.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace ggrade::sandbox::helper {

void report(const HelperPlan& plan, HelperReport::Kind kind, const std::string& text, int error,
            int value) {
  HelperReport message;
  message.kind = kind;
  message.value = value;
  const std::string full = error ? text + ": " + std::strerror(error) : text;
  std::snprintf(message.text, sizeof message.text, "%s", full.c_str());
  // A failed write means that nobody listens any more.
  (void)!write(static_cast<int>(plan.report), &message, sizeof message);
}

namespace {
HelperPlan readPlan(int descriptor) {
  std::string bytes;
  char block[4096];
  // Both stages read the same descriptor, so its offset is left alone.
  for (;;) {
    const ssize_t count = pread(descriptor, block, sizeof block, static_cast<off_t>(bytes.size()));
    if (count <= 0) break;
    bytes.append(block, static_cast<std::size_t>(count));
  }
  return decode(bytes);
}
} // namespace

} // namespace ggrade::sandbox::helper

int main(int argc, char** argv) {
  using namespace ggrade::sandbox::helper;
  const std::string stage = argc > 1 ? argv[1] : "";
  if (stage == "probe") return probe();
  if (argc == 3 && stage == "outside") return runOutside(readPlan(std::atoi(argv[2])));
  if (argc == 3 && stage == "inside") return runInside(readPlan(std::atoi(argv[2])));
  std::fputs("This program is part of ggrade's sandbox; ggrade starts it.\n", stderr);
  return 2;
}
