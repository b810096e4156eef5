#include "grading/drawing.hpp"

#include "assignment/usage_error.hpp"
#include "grading/toolchain.hpp"
#include "report/text.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/sandbox.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <fcntl.h>

namespace ggrade::grading {

namespace fs = std::filesystem;
using gg::say;

namespace {

constexpr const char* kVariable = "GGRADE_CONTEXT";

/// What a run reads beside libraries: where EGL finds Mesa.
constexpr const char* kVendor = "/usr/share/glvnd/egl_vendor.d/50_mesa.json";

sandbox::Result runProbe(const std::string& context) {
  sandbox::Command command;
  command.arguments = {toolchain::kProbe};
  command.environment = {
      {"LC_ALL", "C.UTF-8"},       {"GG_CAPTURE_CONTEXT", context},
      {"GG_CAPTURE_VERBOSE", "1"}, {"MESA_SHADER_CACHE_DISABLE", "true"},
      {"LP_NUM_THREADS", "0"},     {"LD_LIBRARY_PATH", toolchain::kCaptureFolder}};
  command.workingDirectory = "/";
  return sandbox::run(command, sandbox::Isolation::none);
}

Drawing readProbe(const std::string& context, const std::string& said) {
  Drawing all;
  all.context = context;
  const auto admit = [&](const fs::path& path) {
    all.files.push_back(fs::canonical(path.parent_path()) / path.filename());
    const sandbox::Descriptor file(open(all.files.back().c_str(), O_RDONLY | O_CLOEXEC));
    if (!file) throw std::system_error(errno, std::generic_category(), all.files.back().string());
    posix_fadvise(file.get(), 0, 0, POSIX_FADV_WILLNEED);
  };
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    const std::string what = line.substr(0, line.find(' '));
    const std::string value = line.substr(std::min(line.size(), what.size() + 1));
    if (what == "version") all.renderer.version = value;
    if (what == "renderer") all.renderer.name = value;
    if (what == "file" && fs::path(value).parent_path() != toolchain::kCaptureFolder) admit(value);
  }
  if (context == "egl" && fs::exists(kVendor)) admit(kVendor);
  return all;
}

/// Why it did not draw: the first line that the capture library said, or else anybody.
std::string reasonOf(const sandbox::Result& run) {
  constexpr std::string_view kOurs = "ggrade capture: ";
  const std::string& text = run.standardError;
  const std::size_t ours = text.find(kOurs);
  const std::size_t start = ours == text.npos ? 0 : ours + kOurs.size();
  const std::string said = report::sanitizeLine(text.substr(start, text.find('\n', start) - start));
  return said.empty() ? run.detail : said;
}

Drawing find() {
  const char* const chosen = std::getenv(kVariable);
  std::vector<std::string> tried = {"osmesa", "egl"};
  if (chosen && *chosen && std::string_view(chosen) != "auto") tried = {chosen};
  for (const std::string& context : tried)
    if (context != "osmesa" && context != "egl" && context != "gpu")
      throw UsageError("GGRADE_CONTEXT " + context + ": auto, osmesa, egl or gpu");
  std::string why;
  for (const std::string& context : tried) {
    const sandbox::Result run = runProbe(context);
    // That says nothing of the context: another one is no remedy.
    if (run.end == sandbox::End::setupFailed) throw std::runtime_error(run.detail);
    const auto refuse = [&](const std::string& reason) {
      why += (why.empty() ? "" : "; ") + context + ": " + reason;
    };
    if (run.end != sandbox::End::exited || run.exitCode != 0) {
      refuse(reasonOf(run));
      continue;
    }
    Drawing all = readProbe(context, run.standardOutput);
    if (context == "gpu" || all.renderer.name.starts_with("llvmpipe")) return all;
    refuse("draws with " + all.renderer.name + " instead of llvmpipe");
  }
  throw CannotDraw(
      "nothing to draw with (" + why +
      "). Remedy: apt-get install --reinstall libosmesa6, or libegl1 and libgl1-mesa-dri");
}

} // namespace

void chooseContext(const std::string& name) {
  setenv(kVariable, name.c_str(), 1);
}

std::string drawsNoMore() {
  const Drawing& before = drawing();
  const sandbox::Result run = runProbe(before.context);
  const auto nothing = [](const std::string& why) {
    return say("nothing draws here any more: {}", why);
  };
  if (run.end != sandbox::End::exited || run.exitCode != 0) return nothing(reasonOf(run));
  try {
    const std::string now = readProbe(before.context, run.standardOutput).renderer.version;
    if (now == before.renderer.version) return {};
    return say("what draws here was {} and is {} now", before.renderer.version, now);
  } catch (const std::exception& error) {
    return nothing(error.what());
  }
}

const Drawing& drawing() {
  static const Drawing found = [] {
    try {
      Drawing all = find();
      chooseContext(all.context); // workers draw as their parent does
      return all;
    } catch (const CannotDraw&) {
      throw;
    } catch (const UsageError&) {
      throw;
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format(
          "{} can't find out what draws here: {}. Mend that, then run the command again",
          toolchain::kProbe, error.what()));
    }
  }();
  return found;
}

} // namespace ggrade::grading
