#include "grading/store.hpp"

#include "grading/drawing.hpp"
#include "grading/toolchain.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace ggrade::grading {

namespace fs = std::filesystem;
using nlohmann::json;
using results::Outcome;
using sandbox::Isolation;

std::string hashOf(const std::string& text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

namespace {

/// A hash of these files, by name.
std::string hashOfFiles(std::vector<fs::path> files) {
  std::sort(files.begin(), files.end());
  std::string all;
  for (const fs::path& file : files)
    all += file.filename().string() + ' ' + hashOf(readFile(file)) + '\n';
  return hashOf(all);
}

/// The files in a folder and, if so wanted, in folders in it.
template <class Iterator> std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  try {
    for (const fs::directory_entry& entry : Iterator(folder))
      if (entry.is_regular_file()) files.push_back(entry.path());
  } catch (const fs::filesystem_error& error) { // while it goes on, it doesn't name the folder
    throw std::system_error(error.code(), gg::say("can't read {}", folder.string()));
  }
  return files;
}

/// What tells one renderer from another: its files' sizes and times.
std::string rendererIdentity() {
  std::string text = drawing().context + '\n';
  for (const fs::path& file : drawing().files)
    text += fmt::format("{} {} {}\n", file.string(), fs::file_size(file),
                        fs::last_write_time(file).time_since_epoch().count());
  return text;
}

/// What compilers read and link besides a program's own files.
const std::string& compilerKey() {
  static const std::string key =
      toolKey() + hashOfFolder(fs::path(toolchain::kKitFolder) / "include");
  return key;
}

/// Where what the compiler makes of these files is kept: the program and the compiler's words.
/// Programs that differ in shaders only share it.
fs::path compiledFolder(const Assignment& assignment, const fs::path& files, Isolation isolation) {
  std::string all = compilerKey() + assignment.id + (isolation == Isolation::none ? " none" : "");
  for (const std::string& file : ownFiles(assignment, files))
    if (isCompiled(file)) all += '\n' + file + ' ' + hashOf(readFile(files / file));
  return cacheFolder() / "compiled" / hashOf(all);
}

const char* const kWords = "compiler.txt";

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

std::string toolKey() {
  static const std::string key = [] {
    const auto hashIn = [](const fs::path& folder) {
      return hashOfFiles(filesIn<fs::directory_iterator>(folder));
    };
    return hashOf(toolchain::kVersion + hashIn(fs::path(toolchain::kKitFolder) / "lib") +
                  hashIn(toolchain::kCaptureFolder) + toolchain::kCompilerVersion + pins() +
                  rendererIdentity());
  }();
  return key;
}

std::string identity(const trace::Request& trace) {
  return fmt::format("{} {}", trace::kLayoutVersion,
                     std::string(reinterpret_cast<const char*>(&trace), sizeof trace));
}

void keep(const fs::path& made, const fs::path& kept) {
  std::error_code lost;
  fs::rename(made, kept, lost);
}

fs::path lockOf(const std::string& what) {
  const fs::path folder = cacheFolder() / "locks";
  std::error_code none;
  fs::create_directory(folder, none);
  return folder / hashOf(what);
}

std::string hashOfFolder(const fs::path& folder) {
  return hashOfFiles(filesIn<fs::recursive_directory_iterator>(folder));
}

/// How it is judged, and for how many points, is no part of that: who works on a rubric doesn't
/// wait for new pictures.
std::string sourcesKey(const Assignment& assignment, const fs::path& sources) {
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

std::string programKey(const Assignment& assignment, const fs::path& sources) {
  return hashOf(toolKey() + assignment.id + sourcesKey(assignment, sources));
}

Program::Program(const Assignment& assignment, const Recipe& recipe, Isolation isolation, Use use)
    : assignment_(assignment), isolation_(isolation), use_(use), sources_(recipe.folder),
      folder_(work_.makeVisible("program")) {
  if (recipe.isFolder()) return;
  sources_ = work_.path() / "sources";
  writeFiles(assignment, recipe, sources_);
}

const std::string& Program::key() {
  std::call_once(hashed_, [&] { key_ = programKey(assignment_, sources_); });
  return key_;
}

const Overlay& Program::files() {
  std::call_once(laid_, [&] { files_ = overlay(assignment_, sources_, folder_); });
  return files_;
}

const Happened& Program::build() {
  files();
  std::call_once(made_, [&] {
    const fs::path program = folder_ / assignment_.id;
    fs::path kept;
    if (use_ == Use::often) {
      kept = compiledFolder(assignment_, folder_, isolation_);
      std::error_code none;
      if (fs::copy_file(kept / assignment_.id, program, none)) {
        built_.outcome = Outcome::graded;
        built_.output = readFile(kept / kWords);
        return;
      }
    }
    built_ = buildProgram(assignment_.id, folder_, isolation_);
    if (kept.empty() || built_.outcome != Outcome::graded) return;
    try {
      TemporaryFolder made(kept.parent_path());
      fs::copy_file(program, made.path() / assignment_.id);
      if (std::ofstream(made.path() / kWords, std::ios::binary) << built_.output << std::flush)
        keep(made.path(), kept);
    } catch (const std::exception&) {
      // No room in the cache: it is compiled again next time.
    }
  });
  return built_;
}

Rendering Program::render(const json& scene, const Moments& times, const ShaderCache& shaders,
                          const trace::Request& trace,
                          const std::vector<channel::PassPixels>& replacements) {
  if (!build().ok()) return {built_, {}};
  return renderScene(assignment_.id, folder_, scene, times, shaders, isolation_, trace,
                     replacements);
}

} // namespace ggrade::grading
