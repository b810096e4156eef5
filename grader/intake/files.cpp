#include "intake/files.hpp"

#include "assignment/usage_error.hpp"
#include "sandbox/descriptor.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

namespace ggrade::intake {

namespace fs = std::filesystem;
using sandbox::Descriptor;

Kind kindAt(const fs::path& path) {
  switch (fs::symlink_status(path).type()) {
  case fs::file_type::regular:
    return Kind::file;
  case fs::file_type::directory:
    return Kind::folder;
  case fs::file_type::symlink:
    return Kind::symbolicLink;
  case fs::file_type::fifo:
    return Kind::fifo;
  case fs::file_type::socket:
    return Kind::socket;
  case fs::file_type::not_found:
    throw std::runtime_error(path.string() + " is not there");
  default:
    return Kind::device;
  }
}

ReadFile readRegular(const fs::path& path, std::uint64_t limit) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  const auto unreadable = [&] {
    throw std::system_error(errno, std::generic_category(),
                            gg::say("can't read {}", path.string()));
  };
  if (!file && errno == ELOOP) throw std::runtime_error("is a symbolic link");
  struct stat status = {};
  if (!file || fstat(file.get(), &status) != 0) unreadable();
  if (!S_ISREG(status.st_mode)) throw std::runtime_error("is not a regular file");
  ReadFile result;
  result.modified = status.st_mtim.tv_sec;
  const auto tooLarge = [&] {
    throw std::runtime_error(fmt::format("has more than {} MiB", limit >> 20));
  };
  if (std::uint64_t(status.st_size) > limit) tooLarge();
  result.bytes.resize(std::size_t(status.st_size) + 1); // one more, to see a file that grows
  std::size_t length = 0;
  while (length < result.bytes.size()) {
    const ssize_t count =
        read(file.get(), result.bytes.data() + length, result.bytes.size() - length);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) unreadable();
    if (count == 0) break;
    length += std::size_t(count);
  }
  if (length > std::size_t(status.st_size)) throw std::runtime_error("changes while it is read");
  result.bytes.resize(length);
  return result;
}

void writeNew(const fs::path& path, std::string_view bytes) {
  const auto fail = [&] {
    throw UsageError(fmt::format("can't write {}: {}", path.string(), std::strerror(errno)));
  };
  Descriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644));
  if (!file || fchmod(file.get(), 0644) != 0) fail(); // the mode, whatever the umask
  while (!bytes.empty()) {
    const ssize_t count = write(file.get(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    bytes.remove_prefix(std::size_t(count));
  }
}

} // namespace ggrade::intake
