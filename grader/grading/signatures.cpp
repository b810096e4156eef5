#include "grading/signatures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Raise it when views or their files change, so that what was kept is made again.
constexpr int kLayout = 6;

/// Our own machine's fault must not be kept as if the program showed nothing.
void requireMachine(const Happened& happened, const std::string& name) {
  if (happened.outcome == results::Outcome::notGradable)
    throw std::runtime_error(name + ": " + happened.detail);
}

} // namespace

std::vector<Image> framesIn(const fs::path& folder) {
  return rubric::toImages(rubric::readFrames(folder));
}

diagnosis::SceneViews viewsIn(const fs::path& folder, bool stencil) {
  return diagnosis::views(framesIn(folder), trace::load(folder), stencil);
}

std::vector<diagnosis::Signature>
renderSignatures(const Target& target, const fs::path& solutionFolder,
                 const std::vector<Candidate>& candidates, const std::vector<std::size_t>& scenes,
                 const References& references, const ReferenceViews& reference,
                 const Progress& progress, bool stencil) {
  const Assignment& assignment = target.assignment;
  const std::string solution = referenceKey(target, solutionFolder);
  const trace::Request request = gradingRequest();
  for (const std::size_t scene : scenes) reference(scene); // no thread below is the first to ask
  const auto fileOf = [&](const Candidate& candidate, std::size_t scene) {
    std::string key = fmt::format("{} {} {} {} {}", kLayout, diagnosis::kSide, stencil, solution,
                                  candidate.recipe.filled ? "filled" : "");
    for (const fs::path& patch : candidate.recipe.patches) key += ' ' + hashOf(readFile(patch));
    if (candidate.recipe.filled)
      for (const std::string& todo : *candidate.recipe.filled) key += ' ' + todo;
    key += references.scenes[scene].reference.filename().string() +
           references.scenes[scene].scene.dump() + json(references.scenes[scene].times).dump();
    return cacheFolder() / "signatures" / (hashOf(key) + ".views");
  };

  const auto missingNow = [&] {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (!std::ranges::all_of(
              scenes, [&](std::size_t scene) { return fs::exists(fileOf(candidates[i], scene)); }))
        missing.push_back(i);
    return missing;
  };
  std::vector<std::size_t> missing = missingNow();
  if (!missing.empty()) {
    const FileLock making(lockOf("signatures " + solution));
    missing = missingNow();
    fs::create_directories(cacheFolder() / "signatures");
    std::atomic<std::size_t> done{0};
    progress("preparing the diagnosis", 0, missing.size());
    inParallel(missing.size(), workers(), [&](std::size_t m) {
      const Candidate& candidate = candidates[missing[m]];
      TemporaryFolder work(cacheFolder() / "signatures");
      // Its words reach no student, and it shares most shaders with the reference.
      ShaderCache shaders{references.ownShaders.folder, work.makeVisible("shaders")};
      std::optional<Program> program;
      try {
        program.emplace(assignment, candidate.recipe);
      } catch (const UsageError&) {
      }
      if (program && !program->build().ok()) {
        requireMachine(program->build(), candidate.name);
        program.reset();
      }
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        const fs::path file = fileOf(candidate, scenes[i]);
        if (fs::exists(file)) continue;
        diagnosis::SceneViews seen;
        if (program) {
          const SceneCase& scene = references.scenes[scenes[i]];
          Rendering rendering = program->render(scene.scene, scene.times, shaders, request);
          // A busy machine may have taken its time away, and what is kept is kept for good.
          if (rendering.happened.outcome == results::Outcome::timeout)
            rendering = program->render(scene.scene, scene.times, shaders, request);
          if (!shaders.keep.empty()) shaders = {shaders.keep};
          requireMachine(rendering.happened, candidate.name);
          seen = diagnosis::views(rubric::toImages(rawFrames(rendering.capture)),
                                  rendering.capture.trace, stencil);
        }
        const fs::path written = work.path() / "views";
        diagnosis::save(seen, &reference(scenes[i]), written);
        fs::rename(written, file);
      }
      progress("preparing the diagnosis", ++done, missing.size());
    });
  }

  std::vector<diagnosis::Signature> signatures;
  for (const Candidate& candidate : candidates) {
    diagnosis::Signature signature{
        candidate.name, candidate.group, {}, candidate.recipe.filled.has_value()};
    for (const std::size_t scene : scenes)
      signature.run.push_back(diagnosis::load(fileOf(candidate, scene), &reference(scene)));
    signatures.push_back(std::move(signature));
  }
  return signatures;
}

} // namespace ggrade::grading
