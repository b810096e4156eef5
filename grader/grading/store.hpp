#pragma once
/// \file
/// Programs that are made of recipes: written, built and rendered once, and kept in the cache.

#include "grading/overlay.hpp"
#include "grading/program.hpp"
#include "grading/recipe.hpp"
#include "grading/workspace.hpp"

#include <mutex>

namespace ggrade::grading {

/// Where pictures of hidden scenes may be kept: private to this user. Throws UsageError.
std::filesystem::path cacheFolder();

/// A hash of `text`, as file names in the cache are made of.
std::string hashOf(const std::string& text);

/// What tells one way to build and draw from another: tool, compiler, renderer and their settings.
std::string toolKey();

/// What tells one way of recording from another.
std::string identity(const trace::Request& trace);

/// What tells a program of the files in `sources` from programs that draw something else: the tool,
/// these files and what else it reads.
std::string programKey(const Assignment& assignment, const std::filesystem::path& sources);

/// The same without the tool: equal on every machine.
std::string sourcesKey(const Assignment& assignment, const std::filesystem::path& sources);

/// A hash of the files in a folder and in those in it, by name.
std::string hashOfFolder(const std::filesystem::path& folder);

/// Puts `made` (a file or a folder) where the cache keeps it, in one step. Who has made the same
/// meanwhile is as right, and a cache without room costs time, no result.
void keep(const std::filesystem::path& made, const std::filesystem::path& kept);

/// The file of a lock (FileLock) that is held while something is made for the cache, so that no two
/// make the same; who comes second looks again what is missing.
/// \param what the same for all that might make the same
std::filesystem::path lockOf(const std::string& what);

/// A program that a recipe makes. It lies in a temporary folder of its own, goes when this goes,
/// and is built when it is first asked for. Several threads may ask.
/// \code
/// Program program(assignment, {solutions, {mistake.patch}});
/// if (program.build().ok()) program.render(scene, {0.0}, shaders);
/// \endcode
class Program {
public:
  /// `once`: an upload, which nobody will build again; else what was compiled from the same text by
  /// the same tools, in whatever process, is taken from the cache. Throws UsageError where the
  /// recipe's files can't be made.
  enum class Use { often, once };
  Program(const Assignment& assignment, const Recipe& recipe,
          sandbox::Isolation isolation = grading::isolation(), Use use = Use::often);

  /// See programKey.
  const std::string& key();
  /// What of the recipe's folder was taken. Throws like `overlay`.
  const Overlay& files();
  /// The outcome is `graded`, `buildFailed` or `notGradable`. Throws Interrupted.
  const Happened& build();
  /// Its files, and once it was built the program; the sandbox can see them.
  const std::filesystem::path& folder() const { return folder_; }

  /// As renderScene; builds it first. A program that doesn't build draws nothing, see `happened`.
  Rendering render(const nlohmann::json& scene, const Moments& times, const ShaderCache& shaders,
                   const trace::Request& trace = {},
                   const std::vector<channel::PassPixels>& replacements = {});

private:
  const Assignment assignment_;
  const sandbox::Isolation isolation_;
  const Use use_;
  TemporaryFolder work_;
  std::filesystem::path sources_, folder_;
  std::once_flag hashed_, laid_, made_;
  std::string key_;
  Overlay files_;
  Happened built_;
};

} // namespace ggrade::grading
