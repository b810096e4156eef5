#include "grading/references.hpp"

#include "grading/judge.hpp"
#include "report/picture.hpp"
#include "report/write_file.hpp"

#include <fmt/format.h>

#include <atomic>
#include <fstream>
#include <set>

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;
using results::Outcome;
using sandbox::Isolation;

namespace {

/// One of our own programs: the reference or the stub.
struct Own {
  std::string what; ///< for messages
  Program program;
  Own(std::string what, const Assignment& assignment, const fs::path& sources)
      : what(std::move(what)), program(assignment, {sources}) {}
};

void requireGood(const Happened& happened, const std::string& what) {
  if (happened.outcome != Outcome::graded)
    throw std::runtime_error(fmt::format("{} can't be rendered ({}): {}\n{}", what,
                                         results::name(happened.outcome), happened.detail,
                                         happened.output));
}

/// Where the shaders are that one of our programs has compiled for the scenes of `target`.
fs::path shaderFolder(const Target& target, Own& own) {
  return cacheFolder() / "shader-archives" / (own.program.key() + '-' + target.id);
}

/// Which scenes an archive has the shaders of, a hash a line; none where that isn't known.
std::set<std::string> drawnFor(const fs::path& archive) {
  std::set<std::string> drawn;
  std::ifstream in(archive.string() + ".scenes");
  for (std::string line; std::getline(in, line);) drawn.insert(line);
  return drawn;
}

/// Draws the scenes once unless that was done before: compiling shaders is most of a short run.
/// What the same program has compiled for another target, of which this one is a part, isn't
/// compiled again. Only a run that can write to the host's folder does that: trusted, outside the
/// sandbox.
void warmShaders(const Target& target, Own& own, const ScenePlan& plan) {
  const fs::path folder = shaderFolder(target, own);
  if (fs::exists(folder)) return;
  TemporaryFolder work(folder.parent_path());
  const fs::path warm = work.makeVisible("shaders");
  std::set<std::string> drawn;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.parent_path()))
    if (entry.is_directory() && entry.path().filename().string().starts_with(own.program.key()))
      if (auto there = drawnFor(entry.path()); there.size() > drawn.size()) {
        fs::remove_all(warm);
        fs::copy(entry.path(), warm, fs::copy_options::recursive);
        drawn = std::move(there);
      }
  std::ofstream list(work.path() / "scenes");
  for (const SceneCase& scene : plan.scenes) {
    if (!scene.like.empty()) continue; // a change of numbers
    const std::string name = hashOf(scene.scene.dump());
    if (drawn.insert(name).second)
      requireGood(renderScene(target.assignment.id, own.program.folder(), scene.scene, {0}, {warm},
                              Isolation::none)
                      .happened,
                  own.what);
  }
  for (const std::string& name : drawn) list << name << '\n';
  // Mesa makes its folders for their owner alone from 24 on; the sandbox's user reads them, too.
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(warm))
    fs::permissions(entry.path(), entry.is_directory() ? fs::perms(0755) : fs::perms(0644));
  keep(warm, folder);
  if (list.flush()) keep(work.path() / "scenes", folder.string() + ".scenes");
}

/// In a folder of frames: what they were drawn with.
const char* const kRenderer = "renderer.json";

} // namespace

Renderer References::renderer() const {
  if (scenes.empty()) return {};
  const json kept = readJson(scenes.front().reference / kRenderer);
  return {kept.at("version"), kept.at("renderer")};
}

std::string referenceKey(const Target& target, const fs::path& solutionFolder) {
  return programKey(target.assignment, solutionFolder) +
         programKey(target.assignment, target.assignment.folder) + identity(gradingRequest());
}

const std::string& toolHash() {
  static const std::string hash = hashOf(readFile("/proc/self/exe"));
  return hash;
}

std::string gradingKey(const Target& target, const fs::path& solutionFolder,
                       const ScenePlan& plan) {
  static const std::string tools = toolHash() + hashOf(readFile(judgeProgram()));
  return tools + target.id + readJson(target.assignment.folder / "assignment.json").dump() +
         referenceKey(target, solutionFolder) + describe(plan) + (repairs() ? " repairs" : "");
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
  Own reference("the reference " + solutionFolder.string(), assignment, solutionFolder);
  Own stub("the stub " + assignment.folder.string(), assignment, assignment.folder);

  struct Job {
    Own* own;
    const json* scene;
    const Moments* times;
    fs::path folder;
    trace::Request trace;
  };
  const trace::Request everything = gradingRequest(), nothing{};
  std::vector<Job> jobs;
  References all;
  for (const SceneCase& scene : plan.scenes) {
    const auto add = [&](Own& own, const json& content, const trace::Request& trace) {
      const std::string name = hashOf(own.program.key() + content.dump() +
                                      json(scene.times).dump() + identity(trace) + kRenderer);
      fs::path folder = cache / "frames" / name;
      if (!elsewhere.empty() && !fs::exists(folder / "frames.json")) folder = elsewhere / name;
      jobs.push_back({&own, &content, &scene.times, folder, trace});
      return folder;
    };
    rubric::SceneFolders folders{scene, {}, {}, {}, {}};
    folders.reference = add(reference, scene.scene, everything);
    folders.stub = add(stub, scene.scene, everything);
    for (const auto& [name, probe] : scene.probes)
      folders.probeFolders[name] = add(reference, probe, nothing);
    all.scenes.push_back(std::move(folders));
  }

  // The cache holds hidden scenes and the reference: nobody else's business. Every submission can
  // read its copy of the shaders that the stub has warmed, never of the reference's.
  all.shaders.folder = shaderFolder(target, stub);
  all.ownShaders.folder = shaderFolder(target, reference);
  const auto ready = [&] {
    std::erase_if(jobs, [](const Job& job) { return fs::exists(job.folder / "frames.json"); });
    return jobs.empty() && fs::exists(all.shaders.folder) && fs::exists(all.ownShaders.folder);
  };
  if (ready()) return all;
  const FileLock making(lockOf(referenceKey(target, solutionFolder)));
  if (ready()) return all;
  progress("building the reference and the stub", 0, jobs.size() + 1);
  Own* const both[] = {&reference, &stub};
  inParallel(2, workers(), [&](std::size_t i) {
    requireGood(both[i]->program.build(), both[i]->what);
    warmShaders(target, *both[i], plan);
  });
  std::atomic<std::size_t> done{1};
  inParallel(jobs.size(), workers(), [&](std::size_t i) {
    const Job& job = jobs[i];
    const Rendering rendering = job.own->program.render(
        *job.scene, *job.times, job.own == &stub ? all.shaders : all.ownShaders, job.trace);
    requireGood(rendering.happened, job.own->what);
    TemporaryFolder work(job.folder.parent_path());
    if (job.trace.passes) trace::save(rendering.capture.trace, work.path());
    rubric::writeFrames(work.path(), rawFrames(rendering.capture));
    report::writeFile(work.path() / kRenderer, json{{"version", rendering.capture.glVersion},
                                                    {"renderer", rendering.capture.glRenderer}}
                                                   .dump());
    keep(work.path(), job.folder);
    progress("rendering the reference", ++done, jobs.size() + 1);
  });
  return all;
}

const std::vector<ReferencePictures::Frame>&
ReferencePictures::of(const std::filesystem::path& folder) {
  const std::lock_guard lock(mutex_);
  const auto [entry, fresh] = known_.try_emplace(folder);
  if (fresh)
    for (rubric::RawFrame& raw : rubric::readFrames(folder)) {
      Image image = rubric::toImage(raw);
      std::string png = report::pngDataUri(image);
      entry->second.push_back({std::move(raw), std::move(image), std::move(png)});
    }
  return entry->second;
}

} // namespace ggrade::grading
