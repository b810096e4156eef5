#include "intake/class_archive.hpp"

#include "assignment/usage_error.hpp"
#include "intake/contents.hpp"
#include "intake/files.hpp"
#include "intake/layouts.hpp"
#include "intake/packed.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>

namespace ggrade::intake {

namespace fs = std::filesystem;

namespace {

/// Which attempt is the latest may hang on it.
void setModified(const fs::path& path, std::int64_t seconds) {
  const timespec times[2] = {{.tv_sec = 0, .tv_nsec = UTIME_OMIT},
                             {.tv_sec = seconds, .tv_nsec = 0}};
  utimensat(AT_FDCWD, path.c_str(), times, 0);
}

} // namespace

void unpackClass(const fs::path& archive, const fs::path& into, sandbox::Isolation isolation,
                 const std::atomic<bool>* cancel, std::vector<std::string>& remarks) {
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
  remarks.insert(remarks.end(), contents.refused().begin(), contents.refused().end());
  if (const std::string clutter = contents.clutterRemark(); !clutter.empty())
    remarks.push_back(clutter);
}

} // namespace ggrade::intake
