#include "cli/drift.hpp"

#include "assignment/assignment.hpp"
#include "calibration/drift.hpp"
#include "cli/commands.hpp"
#include "grading/drawing.hpp"
#include "grading/workspace.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <cstring>
#include <iostream>
#include <utility>

#include <spawn.h>
#include <sys/wait.h>

extern char** environ;

namespace ggrade::cli {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct Way {
  const char *name, *context, *processor;
  double limit; ///< a score may move by so much
};

// One thing is changed at a time. Every grade is made with AVX's code paths of llvmpipe's
// (GALLIUM_OVERRIDE_CPU_CAPS): what a processor without AVX, which is refused, or all that this one
// has (AVX2, FMA, AVX-512) would do says how far a score hangs on rounding errors.
constexpr Way kWays[] = {
    {"osmesa, avx (usual)", "osmesa", "avx", 0},
    {"egl, avx", "egl", "avx", calibration::kDriftOfScore},
    {"osmesa, sse4.1 (refused)", "osmesa", "sse4.1", calibration::kNoLimit},
    {"osmesa, all of the processor", "osmesa", "", calibration::kDriftOfScore},
};

/// Runs this program again with these words and that way of drawing. Its exit code; Ctrl-C reaches
/// it, too.
int again(const std::vector<std::string>& words, const Way& way) {
  setenv("GGRADE_CONTEXT", way.context, 1);
  setenv("GGRADE_CPU_CAPS", way.processor, 1);
  const std::string self = fs::read_symlink("/proc/self/exe");
  std::vector<char*> arguments = {const_cast<char*>("ggrade")};
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t pid = -1;
  if (const int error =
          posix_spawn(&pid, self.c_str(), nullptr, nullptr, arguments.data(), environ))
    throw std::runtime_error(fmt::format("can't start {}: {}", self, std::strerror(error)));
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) continue;
  if (grading::interrupted || !WIFEXITED(status)) throw grading::Interrupted{};
  return WEXITSTATUS(status);
}

} // namespace

void drift(const std::vector<std::string>& words, const fs::path& out, bool asJson) {
  grading::TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  std::vector<calibration::Drift> drifts;
  json usual;
  for (const Way& way : kWays) {
    const std::string folder =
        fmt::format("{}-{}", way.context, *way.processor ? way.processor : "all");
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--out", work.path() / folder});
    std::cerr << "ggrade: " << way.name << '\n';
    // 1: right and wrong don't separate, which the comparison tells more closely.
    if (const int code = again(all, way); code == kNoSandbox && usual.is_object()) {
      std::cerr << "ggrade: left out\n";
      continue;
    } else if (code != kDone && code != kNotGradable) {
      exitCode = code;
      return;
    }
    const json calibration = json::parse(readFile(work.path() / folder / "calibration.json"));
    if (usual.is_null())
      usual = calibration;
    else
      drifts.push_back(calibration::driftOf(way.name, usual, calibration, way.limit));
  }
  const json result = {{"usual", kWays[0].name}, {"drift", calibration::toJson(drifts)}};
  report::writeFile(work.path() / "drift.json", result.dump(1) + '\n');
  work.publish(out);
  if (asJson)
    std::cout << result.dump(2) << '\n';
  else
    std::cout << calibration::tableOf(drifts) << (out / "drift.json").string() << '\n';
  std::cout.flush();
  for (const calibration::Drift& one : drifts)
    for (const std::string& failure : one.failures) {
      std::cerr << one.variant << ": " << failure << '\n';
      exitCode = kNotGradable;
    }
}

} // namespace ggrade::cli
