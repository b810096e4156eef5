#include "helper.hpp"

#include <cstdio>
#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/socket.h>
#include <unistd.h>

namespace ggrade::sandbox::helper {

int probe() {
  int failures = 0;
  const auto mustFail = [&](bool succeeded, const char* what) {
    if (!succeeded) return;
    std::printf("%s\n", what);
    ++failures;
  };
  mustFail(mount(nullptr, "/usr", nullptr, MS_REMOUNT | MS_BIND, nullptr) == 0, "remounting /usr");
  mustFail(open("/usr/.ggrade-probe", O_CREAT | O_WRONLY | O_CLOEXEC, 0600) >= 0,
           "writing to /usr");
  mustFail(open("/.ggrade-probe", O_CREAT | O_WRONLY | O_CLOEXEC, 0600) >= 0, "writing to /");
  mustFail(open("/proc/1/environ", O_RDONLY | O_CLOEXEC) >= 0, "reading /proc/1/environ");
  mustFail(unshare(CLONE_NEWUSER) == 0, "making a user namespace");
  mustFail(socket(AF_INET, SOCK_STREAM, 0) >= 0, "opening a socket");
  mustFail(memfd_create("probe", 0) >= 0, "memfd_create");
  mustFail(geteuid() == 0, "being root");
  return failures ? 1 : 0;
}

} // namespace ggrade::sandbox::helper
