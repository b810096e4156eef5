#include "intake/packed.hpp"

#include "assignment/usage_error.hpp"
#include "intake/contents.hpp"
#include "intake/files.hpp"
#include "intake/layouts.hpp"
#include "report/text.hpp"

#include <fmt/format.h>

#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

namespace ggrade::intake {

namespace fs = std::filesystem;
using sandbox::End;
using sandbox::Isolation;

namespace {

/// It is built next to the program that starts it.
fs::path unpackProgram() {
  static const fs::path path = fs::read_symlink("/proc/self/exe").parent_path() / "ggrade-unpack";
  if (!fs::exists(path))
    throw std::runtime_error(path.string() + " is missing: build ggrade again");
  return path;
}

/// The archive's copy and the bundle, gone at the end.
struct Places {
  fs::path archive, bundle;
  explicit Places(const fs::path& folder)
      : archive(folder / ".ggrade-archive"), bundle(folder / ".ggrade-bundle") {}
  Places(const Places&) = delete;
  Places& operator=(const Places&) = delete;
  ~Places() {
    std::error_code none;
    fs::remove(archive, none);
    fs::remove(bundle, none);
  }
};

/// The largest bundle within the limits; clutter has short names.
std::uint64_t bundleBytes(const Limits& limits) {
  return limits.bytes + limits.entries * (kLongestPath + 32) + limits.clutter * 64;
}

std::string readUpload(const fs::path& path, std::uint64_t limit) {
  try {
    return readRegular(path, limit).bytes;
  } catch (const std::system_error&) {
    throw; // no fault of the archive's
  } catch (const std::runtime_error& error) {
    throw UploadProblem(error.what());
  }
}

sandbox::Command commandFor(const Places& at, const fs::path& folder, const Limits& limits,
                            Isolation isolation) {
  const bool inside = isolation == Isolation::bwrap;
  const fs::path program = inside ? "/unpack/ggrade-unpack" : unpackProgram();
  const fs::path archive = inside ? fs::path("/upload/archive") : at.archive;
  const fs::path bundle = inside ? fs::path("/scratch/bundle") : at.bundle;
  sandbox::Command command;
  command.arguments = {program.string(),
                       archive.string(),
                       bundle.string(),
                       std::to_string(limits.entries),
                       std::to_string(limits.clutter),
                       std::to_string(limits.bytes),
                       std::to_string(limits.fileBytes),
                       std::to_string(limits.expandedBytes)};
  if (inside) {
    command.mounts = {{unpackProgram(), program}, {at.archive, archive}};
    command.collect = {{bundle, at.bundle}};
  }
  command.workingDirectory = inside ? fs::path("/scratch") : folder;
  command.limits.cpuSeconds = limits.cpuSeconds;
  command.limits.wallSeconds = 3 * limits.cpuSeconds;
  command.limits.fileBytes = bundleBytes(limits);
  command.limits.scratchBytes = command.limits.fileBytes;
  // The bundle stands in memory; xz may ask for a dictionary of 64 MiB, more is not needed.
  command.limits.memoryBytes = command.limits.fileBytes + (256ull << 20);
  command.limits.processes = 8;
  command.limits.outputBytes = 4096;
  return command;
}

} // namespace

std::string bundleOf(const fs::path& path, const fs::path& folder, const Limits& limits,
                     Isolation isolation, const std::atomic<bool>* cancel) {
  const Places at(fs::absolute(folder));
  // A copy: the sandbox's user may not read the upload, and nobody may change it under us.
  {
    const std::string archive = readUpload(path, limits.archiveBytes);
    if (archive.empty()) throw UploadProblem("is empty");
    writeNew(at.archive, archive);
  }
  const sandbox::Result run =
      sandbox::run(commandFor(at, fs::absolute(folder), limits, isolation), isolation, cancel);
  if (run.end == End::setupFailed)
    throw std::runtime_error("the sandbox could not start: " + run.detail);
  // Said of the upload it would be a score of zero, which --resume would keep.
  if (run.end == End::interrupted) throw std::runtime_error("interrupted");
  if (run.end != End::exited)
    throw UploadProblem("can't be unpacked: " + report::sanitizeLine(run.detail));
  if (run.exitCode == 1) throw UploadProblem(report::sanitizeLine(run.standardError));
  if (run.exitCode != 0 || !fs::exists(at.bundle))
    throw std::runtime_error(fmt::format("ggrade-unpack failed with code {}: {} {}", run.exitCode,
                                         report::sanitizeLine(run.standardError),
                                         run.collectProblem));
  return readRegular(at.bundle, bundleBytes(limits)).bytes;
}

std::vector<Entry> entriesOf(std::string_view bundle, const Limits& limits) {
  try {
    return readBundle(bundle, limits);
  } catch (const std::exception& error) {
    throw UploadProblem(std::string("made the unpacker hand over what makes no sense: ") +
                        error.what());
  }
}

namespace {

/// Which attempt is the latest may hang on it.
void setModified(const fs::path& path, std::int64_t seconds) {
  const timespec times[2] = {{.tv_sec = 0, .tv_nsec = UTIME_OMIT},
                             {.tv_sec = seconds, .tv_nsec = 0}};
  utimensat(AT_FDCWD, path.c_str(), times, 0);
}

} // namespace

void unpackClass(const fs::path& archive, const fs::path& into, sandbox::Isolation isolation,
                 const std::atomic<bool>* cancel, std::vector<std::string>& refused,
                 std::vector<std::string>& remarks) {
  if (archiveSuffix(archive.filename().string()).empty())
    throw UsageError(fmt::format("{} is neither a folder nor a zip or tar file: name the folder of "
                                 "uploads, or the archive of all",
                                 archive.string()));
  fs::create_directory(into);
  Contents contents(kClassLimits, Case::kept); // Ada and ada are two students
  try {
    const std::string bundle =
        bundleOf(fs::canonical(archive), into, kClassLimits, isolation, cancel);
    for (const Entry& entry : entriesOf(bundle, kClassLimits)) contents.add(entry);
  } catch (const UploadProblem& problem) {
    throw UsageError(fmt::format("{} {}. Unpack it yourself and name the folder", archive.string(),
                                 problem.what()));
  }
  for (const File& file : contents.files()) {
    const fs::path path = into / file.path;
    fs::create_directories(path.parent_path());
    writeNew(path, file.bytes);
    setModified(path, file.modified);
  }
  refused.insert(refused.end(), contents.refused().begin(), contents.refused().end());
  if (const std::string clutter = contents.clutterRemark(); !clutter.empty())
    remarks.push_back(clutter);
}

} // namespace ggrade::intake
