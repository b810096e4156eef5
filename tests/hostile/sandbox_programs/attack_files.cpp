// Reading and writing what belongs to the host.
#include "attacker.hpp"

#include <cstdio>
#include <dirent.h>
#include <fcntl.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <sys/sysinfo.h>
#include <sys/sysmacros.h>
#include <sys/vfs.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace attacker {
namespace {

bool canOpen(const std::string& path, int flags) {
  const int file = open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0666);
  if (file < 0) return false;
  close(file);
  return true;
}

int remountAttack(const Arguments&) {
  Attempts attempts;
  for (const char* place : {"/", "/usr/bin", "/usr/lib", "/usr", "/proc", "/attack"}) {
    attempts.add(std::string("remount rw,bind ") + place,
                 mount(nullptr, place, nullptr, MS_REMOUNT | MS_BIND, nullptr) == 0);
    attempts.add(std::string("remount rw ") + place,
                 mount(nullptr, place, nullptr, MS_REMOUNT, nullptr) == 0);
    attempts.add(std::string("unmount ") + place, umount2(place, MNT_DETACH) == 0);
    struct {
      unsigned long long set, clear, propagation, userns;
    } attributes = {0, 1 /* MOUNT_ATTR_RDONLY */, 0, 0};
    attempts.add(std::string("mount_setattr ") + place,
                 syscall(SYS_mount_setattr, AT_FDCWD, place, 0, &attributes, sizeof attributes) ==
                     0);
  }
  attempts.add("mount a tmpfs", mount("tmpfs", "/scratch", "tmpfs", 0, nullptr) == 0);
  attempts.add("bind / on /scratch", mount("/", "/scratch", nullptr, MS_BIND, nullptr) == 0);
  attempts.add("fsopen", syscall(SYS_fsopen, "tmpfs", 0) >= 0);
  attempts.add("open_tree", syscall(SYS_open_tree, AT_FDCWD, "/", 1) >= 0);
  attempts.add("pivot_root", syscall(SYS_pivot_root, "/scratch", "/scratch") == 0);
  return attempts.outcome();
}

int procAttack(const Arguments&) {
  Attempts attempts;
  for (const char* name : {"environ", "mem", "maps", "auxv", "root", "root/etc", "cwd", "exe", "fd",
                           "fdinfo", "ns/mnt", "stack", "syscall", "io"}) {
    const std::string path = std::string("/proc/1/") + name;
    attempts.add("read " + path, canOpen(path, O_RDONLY));
  }
  attempts.add("write /proc/1/mem", canOpen("/proc/1/mem", O_RDWR));
  char target[256];
  attempts.add("readlink /proc/1/exe", readlink("/proc/1/exe", target, sizeof target) >= 0);
  DIR* proc = opendir("/proc");
  while (const dirent* entry = proc ? readdir(proc) : nullptr) {
    const std::string name = entry->d_name;
    if (name.find_first_not_of("0123456789") != std::string::npos || name == "1" ||
        name == std::to_string(getpid()))
      continue;
    attempts.add("see process " + name, true);
  }
  for (const char* path : {"/proc/kcore", "/proc/kmsg", "/proc/sysrq-trigger"})
    attempts.add(std::string("open ") + path, canOpen(path, O_RDWR) || canOpen(path, O_RDONLY));
  return attempts.outcome();
}

/// Prints /proc/1/cmdline and every variable of the environment.
int revealAttack(const Arguments&) {
  if (FILE* file = std::fopen("/proc/1/cmdline", "r")) {
    std::fputs("cmdline ", stdout);
    for (int letter = 0; (letter = std::fgetc(file)) != EOF;) std::putchar(letter ? letter : ' ');
    std::fclose(file);
  }
  std::puts("");
  for (char** entry = environ; *entry; ++entry) std::printf("variable %s\n", *entry);
  return 0;
}

int readHostAttack(const Arguments& paths) {
  Attempts attempts;
  for (const std::string& path : paths) attempts.add("open " + path, canOpen(path, O_RDONLY));
  attempts.add("open ..", canOpen("/..", O_RDONLY) && canOpen("/../root", O_RDONLY));
  return attempts.outcome();
}

/// The host's load, memory and free space.
int figuresAttack(const Arguments& places) {
  Attempts attempts;
  struct sysinfo all {};
  attempts.add("sysinfo", sysinfo(&all) == 0);
  double load = 0;
  attempts.add("getloadavg", getloadavg(&load, 1) > 0);
  for (const std::string& place : places) {
    struct statfs status {};
    attempts.add("statfs " + place, statfs(place.c_str(), &status) == 0);
    const int file = open(place.c_str(), O_RDONLY | O_CLOEXEC);
    attempts.add("fstatfs " + place, fstatfs(file, &status) == 0);
  }
  return attempts.outcome();
}

/// Tries to create a file NAME in every folder given, and to change those files.
int writeOutsideAttack(const Arguments& arguments) {
  Attempts attempts;
  const std::string& name = arguments.at(0);
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string folder = arguments[i] == "/" ? "" : arguments[i];
    attempts.add("create in " + folder + "/", canOpen(folder + "/" + name, O_CREAT | O_WRONLY));
    attempts.add("mkdir in " + folder + "/",
                 mkdir((folder + "/" + name + ".d").c_str(), 0777) == 0);
    attempts.add("chmod " + folder + "/", chmod((folder + "/").c_str(), 0777) == 0);
    attempts.add("rename into " + folder, rename("/scratch", (folder + "/" + name).c_str()) == 0);
  }
  for (const char* path :
       {"/attack/attacker", "/attack/data/file", "/run/ggrade-helper", "/usr/bin/env",
        "/etc/ld.so.cache", "/proc/sys/kernel/hostname", "/proc/sys/user/max_user_namespaces"}) {
    attempts.add(std::string("write ") + path, canOpen(path, O_WRONLY));
    attempts.add(std::string("unlink ") + path, unlink(path) == 0);
    attempts.add(std::string("truncate ") + path, truncate(path, 0) == 0);
    attempts.add(std::string("touch ") + path, utimensat(AT_FDCWD, path, nullptr, 0) == 0);
  }
  return attempts.outcome();
}

int listDescriptorsAttack(const Arguments&) {
  // The highest number that a descriptor of the caller could have kept.
  for (int number = 0; number < 4096; ++number)
    if (fcntl(number, F_GETFD) >= 0) std::printf("open %d\n", number);
  return 0;
}

int writeDescriptorsAttack(const Arguments&) {
  Attempts attempts;
  bool worked = false;
  for (int number = 3; number < 4096; ++number) worked = worked || write(number, "x", 1) > 0;
  errno = EBADF;
  attempts.add("write to an inherited descriptor", worked);
  attempts.add("write to standard input", write(0, "x", 1) > 0);
  return attempts.outcome();
}

int writeInheritedAttack(const Arguments& arguments) {
  const int number = std::stoi(arguments.at(0));
  return write(number, "from inside", 11) == 11 ? 0 : 1;
}

int chrootAttack(const Arguments&) {
  Attempts attempts;
  const int outside = open("/", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  attempts.add("chroot", chroot("/scratch") == 0);
  for (int level = 0; level < 64; ++level) (void)!chdir("..");
  attempts.add("walk up", access("root", F_OK) == 0 || access("home", F_OK) == 0);
  attempts.add("walk up by descriptor", faccessat(outside, "../root", F_OK, 0) == 0);
  return attempts.outcome();
}

int setuidAttack(const Arguments&) {
  Attempts attempts;
  attempts.add("setuid 0", setuid(0) == 0);
  attempts.add("setgid 0", setgid(0) == 0);
  attempts.add("be root", geteuid() == 0);
  attempts.add("run without no_new_privs", prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) != 1);
  for (const char* folder : {"/usr/bin", "/usr/lib", "/scratch", "/tmp", "/attack"}) {
    struct statvfs status {};
    attempts.add(std::string("setuid programs in ") + folder,
                 statvfs(folder, &status) == 0 && !(status.f_flag & ST_NOSUID));
  }
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    execl("/usr/bin/su", "su", "-c", "/usr/bin/id", nullptr);
    _exit(1);
  }
  int status = 0;
  attempts.add("su", child > 0 && waitpid(child, &status, 0) == child && status == 0);
  return attempts.outcome();
}

int deviceAttack(const Arguments&) {
  Attempts attempts;
  attempts.add("mknod /scratch/mem", mknod("/scratch/mem", S_IFCHR | 0666, makedev(1, 1)) == 0);
  attempts.add("mknod /scratch/disk", mknod("/scratch/disk", S_IFBLK | 0666, makedev(254, 0)) == 0);
  for (const char* path : {"/dev/mem", "/dev/kmsg", "/dev/vda", "/dev/sda", "/dev/tty", "/dev/ptmx",
                           "/dev/zero", "/dev/shm", "/dev/fuse", "/dev/kvm", "/dev/userfaultfd"})
    attempts.add(std::string("open ") + path, canOpen(path, O_RDONLY));
  return attempts.outcome();
}

/// Makes the file to be collected something that it must not be.
int collectAttack(const Arguments& arguments) {
  const std::string& kind = arguments.at(0);
  const char* path = "/scratch/product";
  if (kind == "regular") {
    FILE* file = std::fopen(path, "w");
    std::fputs("product", file);
    std::fclose(file);
    chmod(path, 04755);
  }
  if (kind == "symlink") return symlink("/etc/ld.so.cache", path);
  if (kind == "loop") return symlink("/proc/self/environ", path);
  if (kind == "fifo") return mkfifo(path, 0666);
  if (kind == "folder") return mkdir(path, 0777);
  if (kind == "linkedFolder") return symlink("/proc/self", "/scratch/folder");
  return 0;
}

} // namespace

void addFileAttacks(Attacks& attacks) {
  attacks.insert({{"remount", remountAttack},
                  {"proc", procAttack},
                  {"reveal", revealAttack},
                  {"readHost", readHostAttack},
                  {"writeOutside", writeOutsideAttack},
                  {"figures", figuresAttack},
                  {"listDescriptors", listDescriptorsAttack},
                  {"writeDescriptors", writeDescriptorsAttack},
                  {"writeInherited", writeInheritedAttack},
                  {"chroot", chrootAttack},
                  {"setuid", setuidAttack},
                  {"device", deviceAttack},
                  {"collect", collectAttack}});
}

} // namespace attacker
