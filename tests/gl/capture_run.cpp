#include "capture_run.hpp"

#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ggrade::test {
namespace {

constexpr unsigned kDeadlineSeconds = 60;

std::string contents(int descriptor) {
  std::ifstream in("/proc/self/fd/" + std::to_string(descriptor), std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  close(descriptor);
  return std::move(text).str();
}

[[noreturn]] void become(const std::string& program, int descriptor, const CaptureOptions& options,
                         int output, int errors) {
  setenv("LD_LIBRARY_PATH", GGRADE_CAPTURE_FOLDER, 1);
  setenv("LP_NUM_THREADS", "1", 1);
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  // Mesa and LLVM keep memory until the end; only what the library does to a program's memory
  // matters here.
  setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
  unsetenv("DISPLAY");
  if (descriptor >= 0) {
    fcntl(descriptor, F_SETFD, 0);
    setenv(channel::kDescriptorVariable, std::to_string(descriptor).c_str(), 1);
  }
  for (const auto& [name, value] : options.environment) setenv(name.c_str(), value.c_str(), 1);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  alarm(kDeadlineSeconds);
  std::string path = program.starts_with('/')
                         ? program
                         : std::string(GGRADE_CAPTURE_PROGRAMS) + "/capture_" + program;
  std::vector<char*> arguments{path.data()};
  for (const std::string& argument : options.arguments) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  execv(path.c_str(), arguments.data());
  _exit(126);
}

} // namespace

CaptureRun runWithDescriptor(const std::string& program, int descriptor,
                             const CaptureOptions& options) {
  const int output = memfd_create("output", MFD_CLOEXEC);
  const int errors = memfd_create("errors", MFD_CLOEXEC);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) become(program, descriptor, options, output, errors);
  int status = 0;
  waitpid(child, &status, 0);
  CaptureRun run;
  if (WIFEXITED(status)) run.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
  run.output = contents(output);
  run.errors = contents(errors);
  return run;
}

CaptureRun runCaptured(const std::string& program, const std::vector<channel::PlannedFrame>& frames,
                       const CaptureOptions& options) {
  const channel::Channel channel(frames, channel::kDefaultMaxPixels, options.trace,
                                 options.replacements);
  CaptureRun run = runWithDescriptor(program, channel.descriptor(), options);
  run.capture = channel.read();
  return run;
}

std::vector<int> pixel(const channel::CapturedFrame& frame, std::uint32_t x, std::uint32_t y) {
  const std::size_t at = 4 * (std::size_t{y} * frame.width + x);
  if (at + 4 > frame.pixels.size()) return {};
  return {frame.pixels.begin() + static_cast<std::ptrdiff_t>(at),
          frame.pixels.begin() + static_cast<std::ptrdiff_t>(at + 4)};
}

std::vector<std::string> texts(const channel::Capture& capture, channel::MessageKind kind) {
  std::vector<std::string> found;
  for (const channel::CapturedMessage& message : capture.messages) {
    if (message.kind == kind) found.push_back(message.text);
  }
  return found;
}

} // namespace ggrade::test
