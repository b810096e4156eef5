#include "worker_uid.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <pwd.h>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

namespace ggrade::sandbox {
namespace {
constexpr uid_t kFirst = 60578;
constexpr uid_t kCount = 606;

/// Abstract names are known in one network namespace only. A ggrade in another one, in a container
/// that runs as root, begins elsewhere and so is next to never met.
uid_t firstTried() {
  struct stat status {};
  if (stat("/proc/thread-self/ns/net", &status) != 0) return 0;
  // Namespaces are numbered one after the other; this spreads them (Knuth's multiplicative hash).
  return static_cast<uid_t>((static_cast<std::uint32_t>(status.st_ino) * 2654435761U >> 16) %
                            kCount);
}

bool belongsToSomebody(uid_t uid) {
  passwd entry{};
  passwd* found = nullptr;
  std::array<char, 4096> buffer{};
  return getpwuid_r(uid, &entry, buffer.data(), buffer.size(), &found) == 0 && found;
}
} // namespace

WorkerUid::WorkerUid() {
  const uid_t first = firstTried();
  for (uid_t n = 0; n < kCount; ++n) {
    uid_ = kFirst + (first + n) % kCount;
    claim_ = Descriptor(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    // The leading NUL makes the name abstract: no file is left behind.
    const std::string name = std::string(1, '\0') + "ggrade-worker-" + std::to_string(uid_);
    std::memcpy(address.sun_path, name.data(), name.size());
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    if (bind(claim_.get(), reinterpret_cast<const sockaddr*>(&address), size) != 0) {
      if (errno == EADDRINUSE) continue;
      throw std::runtime_error(std::string("cannot claim a uid: ") + std::strerror(errno));
    }
    if (!belongsToSomebody(uid_)) return;
  }
  throw std::runtime_error("no unused uid is left between 60578 and 61183");
}

} // namespace ggrade::sandbox
