#include "image/temporary_file.hpp"

#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

namespace fs = std::filesystem;

namespace ggrade {
namespace {

[[noreturn]] void fail(const fs::path& target, const std::string& cause) {
  throw std::runtime_error("cannot write '" + target.string() + "': " + cause);
}

constexpr char kMark[] = ".tmp-";

fs::path nameBeside(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  const std::string unique = std::to_string(getpid()) + "-" + std::to_string(counter++);
  return target.parent_path() /
         ("." + target.stem().string() + kMark + unique + target.extension().string());
}

} // namespace

TemporaryFile::TemporaryFile(const fs::path& target) : target_(target) {
  std::error_code error;
  if (fs::is_symlink(target)) target_ = fs::weakly_canonical(target, error);
  if (error) fail(target, error.message());
  const auto status = fs::status(target_, error);
  if (fs::is_directory(status)) fail(target, "it is a folder; name a file in it");
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(target, "it is not a regular file");
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    fail(target, "there is no folder '" + folder.string() + "'; create it first");
  path_ = nameBeside(target_);
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove(path_, ignored);
}

bool TemporaryFile::isOne(const fs::path& path) {
  const std::string name = path.filename().string();
  const std::size_t mark = name.find(kMark);
  return name.starts_with(".") && mark != name.npos &&
         std::isdigit(static_cast<unsigned char>(name[mark + std::strlen(kMark)]));
}

void TemporaryFile::commit() {
  std::error_code error;
  fs::rename(path_, target_, error);
  if (error) fail(target_, error.message());
  path_.clear();
}

void writeWholeFile(const fs::path& target, std::span<const unsigned char> bytes) {
  TemporaryFile file(target);
  const int descriptor = open(file.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(target, std::strerror(errno));
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int cause = errno;
      close(descriptor);
      fail(target, std::strerror(cause));
    }
    bytes = bytes.subspan(std::size_t(written));
  }
  // Some file systems report a full disk only here.
  if (close(descriptor) != 0) fail(target, std::strerror(errno));
  file.commit();
}

} // namespace ggrade
