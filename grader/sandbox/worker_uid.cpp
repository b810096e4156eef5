#include "worker_uid.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <pwd.h>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>

namespace ggrade::sandbox {
namespace {
constexpr uid_t kFirst = 60578;
constexpr uid_t kLast = 61183;

bool belongsToSomebody(uid_t uid) {
  passwd entry{};
  passwd* found = nullptr;
  std::array<char, 4096> buffer{};
  return getpwuid_r(uid, &entry, buffer.data(), buffer.size(), &found) == 0 && found;
}
} // namespace

WorkerUid::WorkerUid() {
  for (uid_ = kFirst; uid_ <= kLast; ++uid_) {
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
