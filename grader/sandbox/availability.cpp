#include "sandbox.hpp"

#include "bwrap_arguments.hpp"
#include "helper_plan.hpp"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <linux/capability.h>
#include <sstream>
#include <unistd.h>

namespace ggrade::sandbox {
namespace {

std::string setting(const char* path) {
  std::string value;
  std::ifstream(path) >> value;
  return value;
}

/// Root in a container may lack single rights. By this one the processes of a run are measured,
/// which belong to another user then.
bool rootMayNotTrace() {
  if (geteuid() != 0) return false;
  std::ifstream status("/proc/self/status");
  for (std::string key; status >> key;)
    if (std::uint64_t rights = 0; key == "CapEff:" && status >> std::hex >> rights)
      return !(rights >> CAP_SYS_PTRACE & 1);
  return false;
}

/// The most likely reason why bwrap does not work here, with its remedy.
std::string diagnose(const std::string& detail) {
  if (setting("/proc/sys/kernel/apparmor_restrict_unprivileged_userns") == "1")
    return "AppArmor keeps bwrap from making a user namespace (Ubuntu 23.10 and later). Remedy: "
           "install an AppArmor profile for " +
           std::string(kBwrap) +
           " that grants `userns,` (package apparmor-profiles has bwrap-userns-restrict), or "
           "sysctl kernel.apparmor_restrict_unprivileged_userns=0";
  if (setting("/proc/sys/kernel/unprivileged_userns_clone") == "0")
    return "unprivileged user namespaces are off. Remedy: sysctl "
           "kernel.unprivileged_userns_clone=1";
  if (setting("/proc/sys/user/max_user_namespaces") == "0")
    return "user namespaces are off. Remedy: sysctl user.max_user_namespaces=10000";
  for (const char* mark : {"/.dockerenv", "/run/.containerenv"})
    if (access(mark, F_OK) == 0)
      return "this container may not make namespaces (" + detail +
             "). Remedy: run it as an ordinary user (--user 1000:1000) with --security-opt "
             "seccomp=unconfined --security-opt systempaths=unconfined; docs/class.md says more";
  return "the sandbox does not work here: " + detail;
}

} // namespace

SelfTest selfTest() {
  const auto fails = [](std::string why) { return SelfTest{std::move(why), {}}; };
  if (!isInstalled())
    return fails(std::string(kBwrap) + " is missing. Remedy: apt-get install bubblewrap");
  // By it a run's processes are found, so that limits hold for all of them together.
  if (access("/proc/thread-self/children", R_OK) != 0)
    return fails("this kernel doesn't list the children of a process (CONFIG_PROC_CHILDREN), or "
                 "/proc is not mounted. Remedy: a kernel of a distribution, with /proc");
  if (rootMayNotTrace())
    return fails(
        "root may not see the processes of other users here (CAP_SYS_PTRACE). Remedy: run "
        "it as an ordinary user; in a container --user 1000:1000, or --cap-add SYS_PTRACE");
  Command command;
  command.arguments = {kHelperInside, "probe"};
  command.limits.wallSeconds = 10;
  const Result result = run(command, Isolation::bwrap);
  if (result.end == End::setupFailed) return fails(diagnose(result.detail));
  if (result.end != End::exited) return fails("the sandbox's self-test failed: " + result.detail);
  SelfTest test;
  std::string allowed;
  std::istringstream lines(result.standardOutput);
  for (std::string verdict, what; lines >> verdict >> std::ws && std::getline(lines, what);) {
    if (verdict == "refused")
      test.refused.push_back(what);
    else
      allowed += (allowed.empty() ? "" : ", ") + what;
  }
  if (result.exitCode != 0) return fails("the sandbox leaks: it allowed " + allowed);
  return test;
}

bool isInstalled() {
  return access(kBwrap, X_OK) == 0;
}

const std::string& version() {
  static const std::string text = [] {
    std::string line = "bubblewrap";
    if (std::FILE* const said =
            popen((std::string(kBwrap) + " --version 2>/dev/null").c_str(), "r")) {
      char block[100] = {};
      if (std::fgets(block, sizeof block, said) && std::string_view(block).starts_with(line))
        line = std::string(block, std::strcspn(block, "\n"));
      pclose(said);
    }
    return line;
  }();
  return text;
}

std::vector<std::pair<std::string, std::string>> protections() {
  const Limits usual;
  std::ostringstream limits;
  limits << "of each run: time, memory " << (usual.memoryBytes >> 20) << " MiB, " << usual.processes
         << " processes and threads, " << (usual.scratchBytes >> 20) << " MiB of files, "
         << (usual.outputBytes >> 20) << " MiB of output";
  std::vector<std::pair<std::string, std::string>> all = {
      {"namespaces", "users, files, processes, network, shared memory, host name and control "
                     "groups of its own for each run; no capabilities, the system read only"},
      {"system calls", "a seccomp filter that allows a list and refuses all else"},
      {"limits", limits.str()}};
  // Distributions also mend older versions, which the number doesn't tell.
  if (int major = 0, minor = 0;
      std::sscanf(version().c_str(), "bubblewrap %d.%d", &major, &minor) == 2 &&
      std::pair(major, minor) < std::pair(0, 12))
    all.emplace_back(version(), "older than 0.12.0, which mends CVE-2026-87766: setting up a mount "
                                "in a folder that the sandboxed one controls could write outside. "
                                "Nothing is mounted in such a folder here; update it all the same");
  return all;
}

} // namespace ggrade::sandbox
