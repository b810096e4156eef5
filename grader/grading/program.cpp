#include "grading/program.hpp"

#include "grading/toolchain.hpp"
#include "grading/workspace.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <span>
#include <sstream>

extern char** environ;

namespace ggrade::grading {

namespace fs = std::filesystem;
using gg::say;
using results::Outcome;
using sandbox::End;
using sandbox::Isolation;

namespace {

constexpr double kBuildSeconds = 30;

/// Settings that pixels depend on, the same for every run. Pinned CPU features make every x86-64
/// machine since 2011 draw the same: `avx` costs nothing against none pinned (22.6 and 22.4 ms a
/// frame of the floor), `sse4.1` 60% (35.8 ms). No thread of llvmpipe's own (0): a worker has one
/// core. Shaders are compiled without LLVM's optimisations (`nopt`): our scenes are small, and
/// compiling is most of a first run (0.27 instead of 0.39 s; later ones are as fast as before).
/// GGRADE_CPU_CAPS stands for another processor, to measure what that does.
const std::vector<std::pair<std::string, std::string>> kPins = [] {
  const char* const caps = std::getenv("GGRADE_CPU_CAPS");
  return std::vector<std::pair<std::string, std::string>>{
      {"LP_NUM_THREADS", "0"},
      {"GALLIUM_OVERRIDE_CPU_CAPS", caps ? caps : "avx"},
      {"GALLIVM_PERF", "nopt"}};
}();

/// Where things are seen from within a run: the host's own paths without a sandbox.
struct Places {
  fs::path kit, work, capture, shaders, scene;

  Places(Isolation isolation, const fs::path& folder, const fs::path& shaderFolder,
         const fs::path& sceneFolder) {
    const bool inside = isolation == Isolation::bwrap;
    kit = inside ? "/kit" : toolchain::kKitFolder;
    capture = inside ? "/capture" : toolchain::kCaptureFolder;
    work = inside ? fs::path("/submission") : folder;
    shaders = inside ? fs::path("/shaders") : shaderFolder;
    scene = inside ? fs::path("/scene") : sceneFolder;
  }
};

/// The line of a compiler's or driver's log that names the first error; the first line if none
/// does.
std::string firstError(const std::string& log) {
  const std::size_t error = log.find("error:");
  const std::size_t start = error == log.npos ? 0 : log.rfind('\n', error) + 1;
  return report::sanitizeLine(log.substr(start, log.find('\n', start) - start));
}

std::string lastLine(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  if (end == text.npos) return {};
  const std::size_t start = text.rfind('\n', end);
  return text.substr(start == text.npos ? 0 : start + 1,
                     end - (start == text.npos ? 0 : start + 1) + 1);
}

const channel::CapturedMessage* firstGlError(const channel::Capture& capture) {
  for (const channel::CapturedMessage& message : capture.messages)
    if (message.kind == channel::MessageKind::glError) return &message;
  return nullptr;
}

/// What a run that is over amounts to.
Happened classify(const sandbox::Result& run, const channel::Capture& capture,
                  std::size_t frameCount) {
  Happened happened;
  happened.seconds = run.wallSeconds;
  happened.signalled = run.end == End::signalled;
  happened.output = report::sanitize(run.standardOutput + run.standardError);
  const bool cameToNone = capture.frames.empty() && capture.unseenFrames == 0;
  const std::string progress = say("{} of {} frames came", capture.frames.size(), frameCount);
  const auto set = [&](Outcome outcome, std::string detail) {
    happened.outcome = outcome;
    happened.detail = std::move(detail);
  };
  // Ctrl-C reaches the whole group: the program may have died of it before the wait was broken off.
  if (run.end == End::interrupted || interrupted) throw Interrupted{};
  if (run.end == End::setupFailed) {
    set(Outcome::notGradable, say("the sandbox could not start: {}", run.detail));
  } else if (!capture.error.empty()) {
    set(Outcome::badOutput, say("what the program handed over makes no sense: {}", capture.error));
  } else if (run.end == End::memoryLimit) {
    set(Outcome::outOfMemory, fmt::format("{}; {}", run.detail, progress));
  } else if (run.end == End::timeLimit) {
    if (cameToNone && capture.contextMade)
      set(Outcome::noFrame,
          say("the program ran for {:.0f} s and never reached glfwSwapBuffers", run.wallSeconds));
    else
      set(Outcome::timeout, fmt::format("{}; {}", run.detail, progress));
  } else if (run.end == End::signalled) {
    set(Outcome::crash, fmt::format("{}; {}", run.detail, progress));
  } else if (capture.frames.size() == frameCount) {
    const channel::CapturedMessage* error = firstGlError(capture);
    set(error ? Outcome::glError : Outcome::graded,
        error ? say("frame {}: {}; {}", error->frame + 1, error->text, progress) : progress);
  } else if (capture.endedByCapture && cameToNone) {
    set(Outcome::noFrame,
        say("the program's loop went round and round without ever reaching glfwSwapBuffers"));
  } else if (run.exitCode == 3) {
    set(Outcome::shaderError, firstError(happened.output));
  } else if (run.exitCode != 0) {
    set(Outcome::crash, say("the program ended with code {}: {}; {}", run.exitCode,
                            report::sanitizeLine(lastLine(run.standardError)), progress));
  } else {
    set(Outcome::noFrame,
        say("the program ended before it had swapped the buffers often enough; {}", progress));
  }
  return happened;
}

#ifdef __SANITIZE_ADDRESS__
/// A sanitized build renders nothing but its own references, as sanitized as itself: they need the
/// settings that it has, terabytes of addresses for what is known of each byte, and time.
void admitSanitizers(sandbox::Command& command) {
  for (const char* name : {"ASAN_OPTIONS", "LSAN_OPTIONS", "UBSAN_OPTIONS"})
    if (const char* value = std::getenv(name)) command.environment.emplace_back(name, value);
  command.systemFiles.clear(); // their own libraries are not among them
  command.limits.addressSpaceBytes = std::numeric_limits<std::uint64_t>::max();
  command.limits.cpuSeconds *= 4;
  command.limits.wallSeconds *= 4;
}
#endif

/// Runs the command and reads what it handed over.
Rendering runCaptured(const sandbox::Command& command, Isolation isolation,
                      const channel::Channel& channel) {
  const std::span planned(channel.plan().frames, channel.plan().frameCount);
  const auto frameCount =
      std::size_t(std::ranges::count(planned, 0U, &channel::PlannedFrame::unseen));
  const sandbox::Result run = sandbox::run(command, isolation, &interrupted);
  channel::Capture capture = channel.read();
  Happened happened = classify(run, capture, frameCount);
  if (capture.frames.empty() && happened.outcome != Outcome::notGradable)
    if (std::string problem = drawsNoMore(); !problem.empty()) {
      happened.outcome = Outcome::notGradable;
      happened.detail = std::move(problem);
    }
  return {std::move(happened), std::move(capture)};
}

/// The files of a shader cache, to be collected as 0, 1, ... in `into`: Mesa's archive of shaders
/// and its index (MESA_DISK_CACHE_SINGLE_FILE).
std::vector<sandbox::Collect> cacheFiles(const fs::path& folder, const fs::path& inside,
                                         const fs::path& into) {
  std::vector<sandbox::Collect> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".foz")
      files.push_back(
          {inside / entry.path().lexically_relative(folder), into / std::to_string(files.size())});
  return files;
}

/// What the run left may be anything: no more than this of it goes into the next one's.
constexpr std::uintmax_t kCacheBytes = 8 << 20;

void keepCache(const ShaderCache& shaders, const std::vector<sandbox::Collect>& collected,
               const fs::path& inside) {
  fs::copy(shaders.folder, shaders.keep, fs::copy_options::recursive);
  std::uintmax_t bytes = 0;
  for (const sandbox::Collect& file : collected) {
    if (!fs::exists(file.into)) return;
    bytes += fs::file_size(file.into);
  }
  if (bytes > kCacheBytes) return;
  for (const sandbox::Collect& file : collected)
    fs::copy_file(file.into, shaders.keep / file.inside.lexically_relative(inside),
                  fs::copy_options::overwrite_existing);
}

} // namespace

sandbox::Isolation& isolation() {
  static Isolation chosen = Isolation::bwrap;
  return chosen;
}

bool& repairs() {
  static bool on = true;
  return on;
}

Happened buildProgram(const std::string& id, const fs::path& folder, Isolation isolation) {
  const Places at(isolation, folder, {}, {});
  sandbox::Command command;
  const std::string scratch =
      isolation == Isolation::bwrap ? "/scratch/" + id : (folder / id).string();
  command.arguments = {toolchain::kCompiler};
  std::istringstream flags(toolchain::kCompileFlags);
  for (std::string flag; flags >> flag;) command.arguments.push_back(flag);
  const std::initializer_list<std::string> rest = {"-pipe",
                                                   "-fuse-ld=mold",
                                                   "-include",
                                                   (at.kit / "gg_pch.hpp").string(),
                                                   "-I",
                                                   (at.kit / "include").string(),
                                                   id + ".cpp",
                                                   "-o",
                                                   scratch,
                                                   "-L",
                                                   (at.kit / "lib").string()};
  command.arguments.insert(command.arguments.end(), rest);
  for (const char* library : {"gg", "gg_core", "gg_scene", "gg_words", "gg_glad"})
    command.arguments.push_back(std::string("-l") + library);
  std::istringstream libraries(toolchain::kLibraries);
  for (std::string library; std::getline(libraries, library, ';');)
    command.arguments.push_back("-l" + library);
  command.environment = {
      {"PATH", "/usr/bin:/bin"},
      {"LC_ALL", "C.UTF-8"},
      {"TMPDIR", isolation == Isolation::bwrap ? "/scratch" : fs::temp_directory_path().string()}};
  if (isolation == Isolation::bwrap) {
    command.mounts = {{toolchain::kKitFolder, "/kit"}, {folder, "/submission"}};
    command.collect = {{scratch, folder / id}};
  }
  command.workingDirectory = at.work;
  command.limits.cpuSeconds = kBuildSeconds;
  // mold 2.40 reserves 8 GiB of addresses; the memory in them is limited as ever.
  command.limits.addressSpaceBytes = std::uint64_t{16} << 30;
  command.limits.wallSeconds = kWallFactor * kBuildSeconds;
  const sandbox::Result run = sandbox::run(command, isolation, &interrupted);

  Happened happened;
  happened.seconds = run.wallSeconds;
  happened.output = report::sanitize(run.standardOutput + run.standardError);
  // Ctrl-C reaches the whole group: the program may have died of it before the wait was broken off.
  if (run.end == End::interrupted || interrupted) throw Interrupted{};
  if (run.end == End::setupFailed) {
    happened.outcome = Outcome::notGradable;
    happened.detail = say("the sandbox could not start: {}", run.detail);
  } else if (run.end == End::exited && run.exitCode == 0 &&
             (isolation == Isolation::none || run.collected)) {
    happened.outcome = Outcome::graded;
  } else if (run.collectIsOurs) {
    happened.outcome = Outcome::notGradable;
    happened.detail = say("the program could not be kept: {}", run.collectProblem);
  } else if (run.end == End::exited && run.exitCode == 0) {
    happened.outcome = Outcome::buildFailed;
    happened.detail = say("the compiler left no program: {}", run.collectProblem);
  } else {
    happened.outcome = Outcome::buildFailed;
    if (run.end == End::exited) {
      happened.detail = say("the compiler says: {}", firstError(happened.output));
    } else {
      happened.detail = say("the compiler was stopped: {}", run.detail);
    }
  }
  return happened;
}

trace::Request gradingRequest() {
  trace::Request request{};
  request.passes = 1;
  request.copies = trace::kAllAttachments;
  // The window's colours come with the frames; nobody asks for its depths.
  request.windowCopies = request.renderbufferCopies = 1U << trace::kStencil;
  request.copyFrames = 1;
  // What doesn't fit is left out and counted. Ten times what the largest reference needs, and yet
  // too little for a hostile program to fill a disk with.
  request.copyBytes = std::uint64_t{256} << 20;
  return request;
}

std::vector<channel::PlannedFrame> plannedFrames(const Moments& times, std::uint32_t width,
                                                 std::uint32_t height) {
  std::vector<channel::PlannedFrame> frames;
  for (const rubric::Moment& one : times.before) {
    const bool sized = one.width > 0;
    frames.push_back({times.shown.at(0) - one.earlier, sized ? one.width : width,
                      sized ? one.height : height, 1});
  }
  for (const double time : times.shown) frames.push_back({time, width, height});
  return frames;
}

Rendering renderScene(const std::string& id, const fs::path& folder, const nlohmann::json& scene,
                      const Moments& times, const ShaderCache& shaders, Isolation isolation,
                      const trace::Request& trace,
                      const std::vector<channel::PassPixels>& replacements, bool doctor) {
  const auto size = scene.at("size").get<std::vector<std::uint32_t>>();
  return renderFrames(id, folder, scene, plannedFrames(times, size.at(0), size.at(1)), shaders,
                      isolation, trace, replacements, doctor);
}

Rendering renderFrames(const std::string& id, const fs::path& folder, const nlohmann::json& scene,
                       const std::vector<channel::PlannedFrame>& frames, const ShaderCache& shaders,
                       Isolation isolation, const trace::Request& trace,
                       const std::vector<channel::PassPixels>& replacements, bool doctor,
                       const std::vector<std::byte>& tape) {
  TemporaryFolder work;
  const fs::path sceneFolder = work.makeVisible("scene");
  const auto put = [&](const char* name, const char* bytes, std::size_t size) {
    std::ofstream out(sceneFolder / name, std::ios::binary);
    if (!out.write(bytes, std::streamsize(size)) || !out.flush())
      throw UsageError(fmt::format("can't write to {}: is the disk full?", sceneFolder.string()));
  };
  const std::string text = scene.dump(2) + '\n';
  put("scene.json", text.data(), text.size());
  if (!tape.empty()) put("tape", reinterpret_cast<const char*>(tape.data()), tape.size());
  const Places at(isolation, folder, shaders.folder, sceneFolder);
  channel::Channel channel(frames, channel::kDefaultMaxPixels, trace, replacements);

  sandbox::Command command;
  command.arguments = {(at.work / id).string(), "--scene", (at.scene / "scene.json").string()};
  command.environment = kPins;
  command.environment.emplace_back("GG_CAPTURE_CONTEXT", drawing().context);
  command.environment.emplace_back("GG_DOCTOR", doctor ? "1" : "0");
  command.environment.emplace_back("GG_LANG", gg::name(gg::language()));
  command.environment.emplace_back("LD_LIBRARY_PATH", at.capture.string());
  command.environment.emplace_back("LC_ALL", "C.UTF-8");
  command.environment.emplace_back(channel::kDescriptorVariable,
                                   std::to_string(channel.descriptor()));
  if (shaders.folder.empty())
    command.environment.emplace_back("MESA_SHADER_CACHE_DISABLE", "true");
  else
    command.environment.insert(
        command.environment.end(),
        {{"MESA_SHADER_CACHE_DIR", at.shaders.string()}, {"MESA_DISK_CACHE_SINGLE_FILE", "true"}});
  if (isolation == Isolation::bwrap) {
    // File by file: what one run asks for in a folder that others see as well, they could notice.
    command.systemFiles = drawing().files;
    command.mounts = {{folder, "/submission"}, {sceneFolder, "/scene"}};
    for (const fs::directory_entry& entry : fs::directory_iterator(toolchain::kCaptureFolder))
      command.mounts.push_back({entry.path(), at.capture / entry.path().filename()});
    if (!shaders.folder.empty()) command.privateCopies = {{shaders.folder, at.shaders}};
  }
  command.workingDirectory = isolation == Isolation::bwrap ? fs::path("/scratch") : sceneFolder;
  command.inheritedDescriptor = channel.descriptor();
  const double further = frames.size() > kFewFrames ? double(frames.size() - kFewFrames) : 0;
  command.limits.cpuSeconds = kRunSeconds + further * kFrameSeconds;
  command.limits.wallSeconds = kWallFactor * command.limits.cpuSeconds;
#ifdef __SANITIZE_ADDRESS__
  admitSanitizers(command);
#endif

  if (shaders.keep.empty()) return runCaptured(command, isolation, channel);

  command.collect = cacheFiles(shaders.folder, at.shaders, work.path());
  Rendering rendering = runCaptured(command, isolation, channel);
  keepCache(shaders, command.collect, at.shaders);
  return rendering;
}

Rendering renderProgram(const std::vector<std::string>& arguments, const Moments& times,
                        std::uint32_t width, std::uint32_t height, const trace::Request& trace) {
  channel::Channel channel(plannedFrames(times, width, height), channel::kDefaultMaxPixels, trace);
  sandbox::Command command;
  command.arguments = arguments;
  for (char** variable = environ; *variable; ++variable) {
    const std::string text = *variable;
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    if (name == "LD_LIBRARY_PATH" || name == channel::kDescriptorVariable) continue;
    command.environment.emplace_back(name, text.substr(equals + 1));
  }
  const char* before = std::getenv("LD_LIBRARY_PATH");
  command.environment.emplace_back("LD_LIBRARY_PATH",
                                   std::string(toolchain::kCaptureFolder) +
                                       (before ? std::string(":") + before : ""));
  command.environment.insert(command.environment.end(), kPins.begin(), kPins.end());
  command.environment.emplace_back("GG_CAPTURE_CONTEXT", drawing().context);
  command.environment.emplace_back("GG_DOCTOR", "0");
  command.environment.emplace_back(channel::kDescriptorVariable,
                                   std::to_string(channel.descriptor()));
  command.workingDirectory = fs::current_path();
  command.inheritedDescriptor = channel.descriptor();
  command.limits.wallSeconds = command.limits.cpuSeconds = 60;

  return runCaptured(command, Isolation::none, channel);
}

std::vector<rubric::RawFrame> rawFrames(const channel::Capture& capture) {
  std::vector<rubric::RawFrame> frames;
  for (const channel::CapturedFrame& frame : capture.frames)
    if (frame.written) frames.push_back({frame.time, frame.width, frame.height, frame.pixels});
  return frames;
}

diagnosis::Facts factsOf(const channel::Capture& capture, const trace::Trace& trace) {
  diagnosis::Facts facts;
  for (const channel::CapturedFrame& frame : capture.frames)
    facts.frames.push_back({frame.windowDraws, frame.boundFramebuffer});
  for (const trace::PassRecord& pass : trace.passes) {
    if (pass.framebuffer == 0 || pass.framebuffer == trace::kNone ||
        pass.kind != std::uint32_t(trace::PassKind::draw))
      continue;
    const std::string status = trace::glName(pass.status);
    if (status != "FRAMEBUFFER_COMPLETE" &&
        std::ranges::find(facts.incomplete, status) == facts.incomplete.end())
      facts.incomplete.push_back(status);
  }
  return facts;
}

const std::vector<std::pair<std::string, std::string>>& rendererPins() {
  return kPins;
}

std::string pins() {
  std::string text = toolchain::kCompileFlags;
  for (const auto& [name, value] : kPins) text += ' ' + name + '=' + value;
  return text;
}

namespace {

/// Vendor and model, as the kernel names them.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  std::string vendor, model;
  for (std::string line; std::getline(file, line) && (vendor.empty() || model.empty());) {
    const std::size_t colon = line.find(": ");
    if (colon == line.npos) continue;
    if (line.starts_with("vendor_id")) vendor = line.substr(colon + 2);
    if (line.starts_with("model name")) model = line.substr(colon + 2);
  }
  return vendor + (vendor.empty() || model.empty() ? "" : " ") + model;
}

} // namespace

std::vector<std::pair<std::string, std::string>> fingerprint(const Renderer& renderer,
                                                             const Renderer& claim) {
  std::vector<std::pair<std::string, std::string>> all = {
      {"ggrade", toolchain::kVersion},  {"compiler", toolchain::kCompilerVersion},
      {"context", drawing().context},   {"processor", processor()},
      {"gl_version", renderer.version}, {"gl_renderer", renderer.name}};
  all.insert(all.end(), kPins.begin(), kPins.end());
  const auto addClaim = [&](const char* what, const std::string& claimed,
                            const std::string& known) {
    if (!claimed.empty() && claimed != known)
      all.emplace_back(std::string("the program's claim: ") + what, claimed);
  };
  addClaim("gl_version", claim.version, renderer.version);
  addClaim("gl_renderer", claim.name, renderer.name);
  return all;
}

} // namespace ggrade::grading
