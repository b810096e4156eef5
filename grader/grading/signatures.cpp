#include "grading/signatures.hpp"

#include "authoring/solution_blocks.hpp"
#include "grading/overlay.hpp"
#include "grading/patched.hpp"
#include "grading/workspace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <fstream>

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Raise it when views or their files change, so that what was kept is made again.
constexpr int kLayout = 5;

/// Programs that differ in shaders only are compiled once: hash of what the compiler reads.
std::string compiledKey(const Assignment& assignment, const fs::path& sources,
                        const std::string& reference) {
  std::string all;
  for (const std::string& file : ownFiles(assignment, sources))
    if (isCompiled(file)) all += file + ' ' + hashOf(readFile(sources / file)) + '\n';
  return hashOf(reference + all);
}

/// Builds into `folder` (with all that a run needs), or takes the program from the cache. False:
/// it doesn't build.
bool build(const Assignment& assignment, const fs::path& sources, const fs::path& folder,
           const std::string& reference) {
  overlay(assignment, sources, folder);
  const fs::path kept =
      cacheFolder() / "signatures" / "programs" / compiledKey(assignment, sources, reference);
  if (!fs::exists(kept)) {
    if (!buildProgram(assignment.id, folder, isolation()).ok()) return false;
    TemporaryFolder work(cacheFolder() / "signatures" / "programs");
    fs::copy_file(folder / assignment.id, work.path() / assignment.id);
    fs::rename(work.path() / assignment.id, kept); // whoever keeps the same meanwhile is as right
    return true;
  }
  fs::copy_file(kept, folder / assignment.id, fs::copy_options::overwrite_existing);
  return true;
}

} // namespace

void writeFaulty(const Assignment& assignment, const fs::path& solutionFolder, const Faulty& faulty,
                 const fs::path& into) {
  writePatched(assignment, solutionFolder, faulty.patches, into);
  if (!faulty.filled) return;
  for (const std::string& file : assignment.files) {
    const std::string text =
        authoring::withFilled(readFile(into / file), (into / file).string(), *faulty.filled);
    if (!(std::ofstream(into / file, std::ios::binary) << text).flush())
      throw UsageError(fmt::format("can't write {}: is the disk full?", (into / file).string()));
  }
}

std::vector<Image> framesIn(const fs::path& folder) {
  return rubric::toImages(rubric::readFrames(folder));
}

diagnosis::SceneViews viewsIn(const fs::path& folder) {
  return diagnosis::views(framesIn(folder), trace::load(folder));
}

std::vector<diagnosis::Signature>
renderSignatures(const Target& target, const fs::path& solutionFolder,
                 const std::vector<Faulty>& programs, const ScenePlan& plan,
                 const std::vector<std::size_t>& scenes, const References& references,
                 const ReferenceViews& reference, const Progress& progress) {
  const Assignment& assignment = target.assignment;
  const std::string solution = referenceKey(target, solutionFolder);
  const trace::Request request = gradingRequest();
  for (const std::size_t scene : scenes) reference(scene); // no thread below is the first to ask
  const auto fileOf = [&](const Faulty& faulty, std::size_t scene) {
    std::string key = fmt::format("{} {} {} {}", kLayout, diagnosis::kSide, solution,
                                  faulty.filled ? "filled" : "");
    for (const fs::path& patch : faulty.patches) key += ' ' + hashOf(readFile(patch));
    if (faulty.filled)
      for (const std::string& todo : *faulty.filled) key += ' ' + todo;
    key += references.scenes[scene].reference.filename().string() +
           plan.scenes[scene].scene.dump() + json(plan.scenes[scene].times).dump();
    return cacheFolder() / "signatures" / (hashOf(key) + ".views");
  };

  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < programs.size(); ++i)
    if (!std::ranges::all_of(
            scenes, [&](std::size_t scene) { return fs::exists(fileOf(programs[i], scene)); }))
      missing.push_back(i);
  if (!missing.empty()) {
    fs::create_directories(cacheFolder() / "signatures" / "programs");
    std::atomic<std::size_t> done{0};
    progress("preparing the diagnosis", 0, missing.size());
    inParallel(missing.size(), workers(), [&](std::size_t m) {
      const Faulty& faulty = programs[missing[m]];
      TemporaryFolder work(cacheFolder() / "signatures");
      const fs::path sources = work.path() / "sources", program = work.makeVisible("program");
      ShaderCache shaders{references.shaders.folder, work.makeVisible("shaders")};
      bool good = false;
      try {
        writeFaulty(assignment, solutionFolder, faulty, sources);
        good = build(assignment, sources, program, solution);
      } catch (const UsageError&) {
      }
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        const fs::path file = fileOf(faulty, scenes[i]);
        if (fs::exists(file)) continue;
        diagnosis::SceneViews seen;
        if (good) {
          const SceneCase& scene = plan.scenes[scenes[i]];
          const Rendering rendering = renderScene(assignment.id, program, scene.scene, scene.times,
                                                  shaders, isolation(), request);
          if (!shaders.keep.empty()) shaders = {shaders.keep};
          // Our own machine's fault must not be kept as if the program showed nothing.
          if (rendering.happened.outcome == report::Outcome::notGradable)
            throw std::runtime_error(faulty.name + ": " + rendering.happened.detail);
          seen = diagnosis::views(rubric::toImages(rawFrames(rendering.capture)),
                                  rendering.capture.trace);
        }
        const fs::path written = work.path() / "views";
        diagnosis::save(seen, &reference(scenes[i]), written);
        fs::rename(written, file);
      }
      progress("preparing the diagnosis", ++done, missing.size());
    });
  }

  std::vector<diagnosis::Signature> signatures;
  for (const Faulty& faulty : programs) {
    diagnosis::Signature signature{faulty.name, faulty.group, {}, faulty.filled.has_value()};
    for (const std::size_t scene : scenes)
      signature.run.push_back(diagnosis::load(fileOf(faulty, scene), &reference(scene)));
    signatures.push_back(std::move(signature));
  }
  return signatures;
}

} // namespace ggrade::grading
