#include "bwrap_arguments.hpp"

#include "helper_plan.hpp"

#include <algorithm>
#include <stdexcept>

namespace ggrade::sandbox {
namespace {
namespace fs = std::filesystem;

// Not all of /usr: /usr/local and /usr/src belong to the machine's owner, who may keep anything
// there.
constexpr const char* kSystemFolders[] = {"/usr/bin",     "/usr/lib",    "/usr/lib32",
                                          "/usr/lib64",   "/usr/libx32", "/usr/libexec",
                                          "/usr/include", "/usr/share"};
constexpr const char* kSystemLinks[] = {"bin", "lib", "lib32", "lib64", "libx32"};
// What the loader and Debian's `g++` link need; no accounts, no host names.
constexpr const char* kSettings[] = {"/etc/ld.so.cache", "/etc/alternatives"};
// No /dev/zero: a shared mapping of it is memory that belongs to no process.
constexpr const char* kDevices[] = {"/dev/null", "/dev/full", "/dev/random", "/dev/urandom"};

class Composer {
public:
  Composer(View& view, bool staged) : view_(view), staged_(staged) {}

  void add(std::initializer_list<std::string> arguments) {
    view_.arguments.insert(view_.arguments.end(), arguments);
  }
  void bind(const char* kind, const fs::path& host, const std::string& inside) {
    const std::string source =
        staged_ ? std::string(kStage) + "/" + std::to_string(view_.sources.size()) : host.string();
    view_.sources.push_back(host.string());
    add({kind, source, inside});
  }
  void writable(const std::string& inside, std::uint64_t bytes) {
    add({"--size", std::to_string(bytes), "--tmpfs", inside});
    view_.writableFolders.push_back(inside);
  }

private:
  View& view_;
  bool staged_;
};

void check(const Mount& mount) {
  if (!mount.inside.is_absolute() || mount.inside.lexically_normal() != mount.inside ||
      !mount.inside.has_filename())
    throw std::runtime_error("mount point " + mount.inside.string() +
                             " is not a plain absolute path");
  for (const char* taken : {"/usr", "/etc", "/proc", "/dev", "/run", "/scratch", "/tmp"})
    if (mount.inside == taken)
      throw std::runtime_error("mount point " + mount.inside.string() + " is the sandbox's own");
  std::error_code error;
  if (!fs::exists(mount.host, error))
    throw std::runtime_error("cannot mount " + mount.host.string() + ": it does not exist");
}

} // namespace

View composeView(const Command& command, const fs::path& helper, bool staged, int seccompFd,
                 int infoFd) {
  View view;
  Composer compose(view, staged);
  compose.add({"--unshare-all", "--unshare-user", "--disable-userns", "--uid", "1000", "--gid",
               "1000", "--cap-drop", "ALL", "--die-with-parent", "--new-session", "--as-pid-1",
               "--clearenv", "--hostname", "sandbox", "--seccomp", std::to_string(seccompFd),
               "--info-fd", std::to_string(infoFd)});
  for (const fs::path& file : command.systemFiles) compose.bind("--ro-bind", file, file.string());
  for (const char* folder : kSystemFolders)
    if (command.systemFiles.empty() && fs::exists(folder))
      compose.bind("--ro-bind", folder, folder);
  for (const std::string link : kSystemLinks)
    if (fs::is_symlink("/" + link)) compose.add({"--symlink", "usr/" + link, "/" + link});
  for (const char* file : kSettings)
    if (fs::exists(file) && (command.systemFiles.empty() || fs::is_regular_file(file)))
      compose.bind("--ro-bind", file, file);
#ifdef __SANITIZE_ADDRESS__
  compose.add({"--proc", "/proc", "--remount-ro", "/proc"}); // sanitized programs look for it
#else
  // The real one tells the host's paths, load and memory. Nothing of it is needed but the program's
  // own place.
  compose.add({"--dir", "/proc/self", "--symlink", command.arguments[0], "/proc/self/exe"});
#endif
  for (const char* device : kDevices) compose.bind("--dev-bind", device, device);
  compose.bind("--ro-bind", helper, kHelperInside);

  const std::uint64_t size = std::max<std::uint64_t>(command.limits.scratchBytes, 4096);
  compose.writable("/scratch", size);
  compose.writable("/tmp", size);
  for (std::size_t i = 0; i < command.privateCopies.size(); ++i) {
    const Mount& copy = command.privateCopies[i];
    check(copy);
    const std::string original = "/run/originals/" + std::to_string(i);
    compose.bind("--ro-bind", copy.host, original);
    compose.writable(copy.inside.string(), size);
    view.copies.insert(view.copies.end(), {original, copy.inside.string()});
  }
  for (const Mount& mount : command.mounts) {
    check(mount);
    // A folder from outside may hold links that somebody made to lead bubblewrap astray while it
    // makes the place for a mount in it (CVE-2026-87766, mended in 0.12.0).
    for (const Mount& other : command.mounts)
      if (const fs::path rest = mount.inside.lexically_relative(other.inside);
          &other != &mount && !rest.empty() && *rest.begin() != "..")
        throw std::runtime_error("mount point " + mount.inside.string() + " is in " +
                                 other.inside.string() + ", which is mounted, too");
    compose.bind("--ro-bind", fs::absolute(mount.host), mount.inside.string());
  }
  // Last, when every mount point exists: / with /dev, /etc, /proc and /run is one tmpfs.
  compose.add({"--remount-ro", "/"});
  return view;
}

} // namespace ggrade::sandbox
