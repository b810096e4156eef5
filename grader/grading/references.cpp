#include "grading/references.hpp"

#include "grading/overlay.hpp"
#include "grading/toolchain.hpp"
#include "grading/workspace.hpp"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <atomic>

#include <unistd.h>

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;
using report::Outcome;
using sandbox::Isolation;

std::string hashOf(const std::string& text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

namespace {

/// A hash of every file in `folder`, not of folders in it.
std::string hashOfFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::string all;
  for (const fs::path& file : files)
    all += file.filename().string() + ' ' + hashOf(readFile(file)) + '\n';
  return hashOf(all);
}

/// A hash of what a program is built from and reads. How it is judged, and for how many points, is
/// no part of that: who works on a rubric doesn't wait for new pictures.
std::string hashOfProgram(const Assignment& assignment, const fs::path& sources) {
  json declared = readJson(assignment.folder / "assignment.json");
  for (json& part : declared.at("parts")) part.erase("items");
  std::string all = hashOf(declared.dump());
  const auto add = [&](const std::string& name, const fs::path& file) {
    all += name + ' ' + hashOf(readFile(file)) + '\n';
  };
  for (const std::string& name : assignment.dataFiles())
    if (name != "assignment.json") add(name, assignment.folder / name);
  for (const std::string& name : ownFiles(assignment, sources)) add(name, sources / name);
  for (const std::string& name : assignment.files) // the handed-out ones stand in
    if (!fs::exists(sources / name)) add(name, assignment.folder / name);
  return hashOf(all);
}

} // namespace

fs::path cacheFolder() {
  const char* named = std::getenv("GGRADE_CACHE");
  const fs::path folder =
      named && *named ? fs::path(named) : fs::path(toolchain::kBuildFolder) / "cache";
  // For its owner alone: pictures of hidden scenes lie in it.
  std::error_code error;
  if (fs::create_directories(folder, error)) fs::permissions(folder, fs::perms(0700), error);
  if (!error && access(folder.c_str(), R_OK | W_OK | X_OK) != 0)
    error = std::error_code(errno, std::generic_category());
  if (error)
    throw UsageError(fmt::format("can't use the cache {}: {}. Name a folder of your own in the "
                                 "environment variable GGRADE_CACHE",
                                 folder.string(), error.message()));
  return folder;
}

namespace {

/// One of our own programs: the reference or the stub.
struct Own {
  std::string what; ///< for messages
  fs::path sources;
  std::string key;
  fs::path folder; ///< where it is built
};

void requireGood(const Happened& happened, const std::string& what) {
  if (happened.outcome != Outcome::graded)
    throw std::runtime_error(fmt::format("{} can't be rendered ({}): {}\n{}", what,
                                         report::name(happened.outcome), happened.detail,
                                         happened.output));
}

/// Builds into the cache unless it is there.
void build(const Assignment& assignment, Own& own) {
  own.folder = cacheFolder() / "programs" / own.key;
  if (fs::exists(own.folder / assignment.id)) return;
  TemporaryFolder work(cacheFolder() / "programs");
  const fs::path program = work.makeVisible("program");
  overlay(assignment, own.sources, program);
  requireGood(buildProgram(assignment.id, program, isolation()), own.what);
  std::error_code raced; // somebody else may have built the same meanwhile
  fs::rename(program, own.folder, raced);
}

/// What tells one renderer from another without starting it: its files' sizes and times.
std::string rendererIdentity() {
  std::string text;
  const fs::path mesa = fs::canonical(toolchain::kOsMesa);
  std::vector<fs::path> files = {mesa};
  for (const fs::directory_entry& entry : fs::directory_iterator(mesa.parent_path()))
    if (entry.path().filename().string().starts_with("libLLVM")) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    text += fmt::format("{} {} {}\n", file.string(), fs::file_size(file),
                        fs::last_write_time(file).time_since_epoch().count());
  return text;
}

/// What tells one way to build and draw from another.
std::string toolKey() {
  return hashOf(toolchain::kVersion + hashOfFiles(fs::path(toolchain::kKitFolder) / "lib") +
                hashOfFiles(toolchain::kCaptureFolder) + toolchain::kCompilerVersion + pins() +
                rendererIdentity());
}

std::string programKey(const std::string& tool, const Assignment& assignment,
                       const fs::path& sources) {
  return hashOf(tool + assignment.id + hashOfProgram(assignment, sources));
}

/// What tells one way of recording from another.
std::string identity(const trace::Request& trace) {
  return fmt::format("{} {}", trace::kLayoutVersion,
                     std::string(reinterpret_cast<const char*>(&trace), sizeof trace));
}

/// Where the shaders are that one of our programs has compiled for the scenes of `target`.
fs::path shaderFolder(const Target& target, const Own& own) {
  return cacheFolder() / "shader-archives" / (own.key + '-' + target.id);
}

/// Draws every scene once unless that was done before: compiling shaders is most of a short run.
/// Only a run that can write to the host's folder does that: trusted, outside the sandbox.
void warmShaders(const Target& target, const Own& own, const ScenePlan& plan) {
  const fs::path folder = shaderFolder(target, own);
  if (fs::exists(folder)) return;
  TemporaryFolder work(folder.parent_path());
  const fs::path warm = work.makeVisible("shaders");
  for (const SceneCase& scene : plan.scenes)
    requireGood(
        renderScene(target.assignment.id, own.folder, scene.scene, {0}, {warm}, Isolation::none)
            .happened,
        own.what);
  std::error_code raced;
  fs::rename(warm, folder, raced);
}

} // namespace

std::string referenceKey(const Target& target, const fs::path& solutionFolder) {
  const std::string tool = toolKey();
  return programKey(tool, target.assignment, solutionFolder) +
         programKey(tool, target.assignment, target.assignment.folder) + identity(gradingRequest());
}

std::string gradingKey(const Target& target, const fs::path& solutionFolder,
                       const ScenePlan& plan) {
  static const std::string tool = hashOf(readFile("/proc/self/exe"));
  return tool + target.id + readJson(target.assignment.folder / "assignment.json").dump() +
         referenceKey(target, solutionFolder) + describe(plan);
}

std::string wordsKey(const Assignment& assignment, const fs::path& solutionFolder) {
  std::string all;
  for (const fs::path& folder : {assignment.folder, solutionFolder})
    if (const fs::path table = folder / "words.ja.json"; fs::exists(table))
      all += hashOf(readFile(table)) + ' ';
  return all;
}

References prepareReferences(const Target& target, const fs::path& solutionFolder,
                             const ScenePlan& plan, const Progress& progress,
                             const fs::path& elsewhere) {
  const fs::path cache = cacheFolder();
  const Assignment& assignment = target.assignment;
  Own reference{"the reference " + solutionFolder.string(), solutionFolder, {}, {}};
  Own stub{"the stub " + assignment.folder.string(), assignment.folder, {}, {}};
  const std::string tool = toolKey();
  for (Own* own : {&reference, &stub}) own->key = programKey(tool, assignment, own->sources);

  struct Job {
    const Own* own;
    const json* scene;
    const std::vector<double>* times;
    fs::path folder;
    trace::Request trace;
  };
  const trace::Request everything = gradingRequest(), nothing{};
  std::vector<Job> jobs;
  References all;
  for (const SceneCase& scene : plan.scenes) {
    const auto add = [&](const Own& own, const json& content, const trace::Request& trace) {
      const std::string name =
          hashOf(own.key + content.dump() + json(scene.times).dump() + identity(trace));
      fs::path folder = cache / "frames" / name;
      if (!elsewhere.empty() && !fs::exists(folder / "frames.json")) folder = elsewhere / name;
      if (!fs::exists(folder / "frames.json"))
        jobs.push_back({&own, &content, &scene.times, folder, trace});
      return folder;
    };
    rubric::SceneFolders folders{scene.name,
                                 scene.isPublic,
                                 scene.tags,
                                 scene.scene,
                                 scene.times.size(),
                                 {},
                                 add(reference, scene.scene, everything),
                                 add(stub, scene.scene, everything),
                                 {},
                                 scene.like};
    for (const auto& [name, probe] : scene.probes)
      folders.probes[name] = add(reference, probe, nothing);
    all.scenes.push_back(std::move(folders));
  }

  // The cache holds hidden scenes and the reference: nobody else's business. Every submission can
  // read its copy of the shaders that the stub has warmed, never of the reference's.
  all.shaders.folder = shaderFolder(target, stub);
  all.ownShaders.folder = shaderFolder(target, reference);
  const bool warm = fs::exists(all.shaders.folder) && fs::exists(all.ownShaders.folder);
  if (jobs.empty() && warm) return all;
  progress("building the reference and the stub", 0, jobs.size() + 1);
  build(assignment, reference);
  build(assignment, stub);
  for (const Own* own : {&reference, &stub}) warmShaders(target, *own, plan);
  std::atomic<std::size_t> done{1};
  inParallel(jobs.size(), workers(), [&](std::size_t i) {
    const Job& job = jobs[i];
    const Rendering rendering = renderScene(assignment.id, job.own->folder, *job.scene, *job.times,
                                            all.ownShaders, isolation(), job.trace);
    requireGood(rendering.happened, job.own->what);
    TemporaryFolder work(job.folder.parent_path());
    if (job.trace.passes) trace::save(rendering.capture.trace, work.path());
    rubric::writeFrames(work.path(), rawFrames(rendering.capture));
    std::error_code raced;
    fs::rename(work.path(), job.folder, raced);
    progress("rendering the reference", ++done, jobs.size() + 1);
  });
  return all;
}

} // namespace ggrade::grading
