#include "sandbox.hpp"

#include "bwrap_arguments.hpp"
#include "helper_plan.hpp"
#include "seccomp_filter.hpp"
#include "supervisor.hpp"
#include "worker_uid.hpp"

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/stat.h>

namespace ggrade::sandbox {
namespace {
namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& text) {
  throw std::runtime_error(text + ": " + std::strerror(errno));
}

/// The helper program is built next to the program that runs it.
fs::path helperProgram() {
  static const fs::path path =
      fs::read_symlink("/proc/self/exe").parent_path() / "ggrade-sandbox-helper";
  if (!fs::exists(path))
    throw std::runtime_error(path.string() + " is missing: build ggrade again");
  return path;
}

/// Moves a descriptor out of the way of 0, 1 and 2, which the helper's own go to. One that could
/// not be opened stays so, with its errno.
Descriptor aboveStandard(Descriptor file) {
  if (!file || file.get() > 2) return file;
  Descriptor moved(fcntl(file.get(), F_DUPFD_CLOEXEC, 3));
  if (!moved) fail("cannot duplicate a descriptor");
  return moved;
}

struct Pipe {
  Descriptor read, write;
};

Pipe makePipe(bool readSideIsOurs = true) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail("cannot make a pipe");
  Pipe pipe{Descriptor(ends[0]), Descriptor(ends[1])};
  pipe.read = aboveStandard(std::move(pipe.read));
  pipe.write = aboveStandard(std::move(pipe.write));
  if (readSideIsOurs) fcntl(pipe.read.get(), F_SETFL, O_NONBLOCK);
  return pipe;
}

/// A file in memory that holds `bytes`, to be read from its start.
Descriptor makeFile(const std::string& bytes) {
  Descriptor file(memfd_create("ggrade", MFD_CLOEXEC));
  if (!file) fail("cannot make a file in memory");
  file = aboveStandard(std::move(file));
  if (pwrite(file.get(), bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    fail("cannot fill a file in memory");
  return file;
}

/// The collected file under a temporary name, so that nobody ever sees half of it.
class CollectedFile {
public:
  explicit CollectedFile(const fs::path& target) : target_(target) {
    name_ = target_.string() + ".XXXXXX";
    file_ = Descriptor(mkostemp(name_.data(), O_CLOEXEC));
    if (!file_)
      throw std::runtime_error("cannot write " + target_.string() + ": " + std::strerror(errno));
    file_ = aboveStandard(std::move(file_));
  }
  CollectedFile(const CollectedFile&) = delete;
  CollectedFile& operator=(const CollectedFile&) = delete;
  ~CollectedFile() {
    if (!name_.empty()) unlink(name_.c_str());
  }
  int get() const { return file_.get(); }
  /// Moves the file into place. The mode is ours to set: the helper may not own the file.
  void keep(bool executable) {
    fchmod(file_.get(), executable ? 0755 : 0644);
    if (rename(name_.c_str(), target_.c_str()) != 0) fail("cannot write " + target_.string());
    name_.clear();
  }

private:
  fs::path target_;
  std::string name_;
  Descriptor file_;
};

void check(const Command& command, Isolation isolation) {
  const auto refuse = [](const std::string& why) { throw std::runtime_error(why); };
  if (command.arguments.empty() || command.arguments[0].substr(0, 1) != "/")
    refuse("the command must be an absolute path");
  if (command.collect.size() > 8) refuse("at most 8 files can be collected");
  if (command.inheritedDescriptor >= 0 && command.inheritedDescriptor < 3)
    refuse("descriptors 0 to 2 cannot be inherited");
  if (command.inheritedDescriptor >= 3 && fcntl(command.inheritedDescriptor, F_GETFD) < 0)
    refuse("the inherited descriptor is not open");
  for (const std::string& argument : command.arguments)
    if (argument.find('\0') != std::string::npos) refuse("an argument holds a NUL byte");
  if (isolation == Isolation::bwrap) return;
  if (!command.privateCopies.empty()) refuse("without a sandbox there are no private copies");
  for (const Mount& mount : command.mounts)
    if (mount.host != mount.inside)
      refuse("without a sandbox " + mount.host.string() + " cannot appear as " +
             mount.inside.string());
}

HelperPlan planFor(const Command& command, Isolation isolation) {
  HelperPlan plan;
  plan.parent = getpid();
  plan.arguments = command.arguments;
  for (const auto& [name, value] : command.environment)
    plan.environment.push_back(name + "=" + value);
  plan.workingDirectory = command.workingDirectory;
  plan.inherited = command.inheritedDescriptor;
  for (const Collect& file : command.collect) plan.collect.push_back(file.inside);
  plan.collectLimit = command.limits.fileBytes;
  plan.cpuSeconds = static_cast<std::uint64_t>(std::ceil(command.limits.cpuSeconds));
  plan.addressSpaceBytes = command.limits.addressSpaceBytes;
  plan.fileBytes = command.limits.fileBytes;
  // The helper counts as one. Without a namespace the limit would count all of the user's
  // processes.
  if (isolation == Isolation::bwrap) plan.processes = command.limits.processes + 1;
  return plan;
}

class SpawnActions {
public:
  SpawnActions() { posix_spawn_file_actions_init(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  void move(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
  posix_spawn_file_actions_t actions_;
};

/// Starts the helper in a session of its own (Ctrl-C reaches only us) with default signals and an
/// empty environment. `kept` stay open under their numbers.
pid_t spawnHelper(const fs::path& helper, int plan, const std::vector<std::int64_t>& kept,
                  int standardOutput, int standardError) {
  const Descriptor empty = aboveStandard(Descriptor(open("/dev/null", O_RDONLY | O_CLOEXEC)));
  if (!empty) fail("cannot open /dev/null");
  SpawnActions actions;
  actions.move(empty.get(), 0);
  actions.move(standardOutput, 1);
  actions.move(standardError, 2);
  // Onto itself: only clears close-on-exec, and only in the child.
  for (const std::int64_t number : kept)
    actions.move(static_cast<int>(number), static_cast<int>(number));
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t all, none;
  sigfillset(&all);
  sigemptyset(&none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSID);
  const std::string number = std::to_string(plan);
  const char* argv[] = {"ggrade-sandbox-helper", "outside", number.c_str(), nullptr};
  const char* environment[] = {nullptr};
  pid_t pid = -1;
  const int error = posix_spawn(&pid, helper.c_str(), actions.get(), &attributes,
                                const_cast<char**>(argv), const_cast<char**>(environment));
  posix_spawnattr_destroy(&attributes);
  if (error)
    throw std::runtime_error("cannot start " + helper.string() + ": " + std::strerror(error));
  return pid;
}

Result runOrThrow(const Command& command, Isolation isolation, const std::atomic<bool>* cancel) {
  check(command, isolation);
  const fs::path helper = helperProgram();
  const bool inNamespace = isolation == Isolation::bwrap;
  HelperPlan plan = planFor(command, isolation);

  std::optional<WorkerUid> worker;
  if (inNamespace && geteuid() == 0) plan.uid = worker.emplace().get();

  Pipe out = makePipe(), err = makePipe(), reports = makePipe(), info = makePipe();
  Pipe lifeline = makePipe(false);
  std::deque<CollectedFile> collected;
  for (const Collect& file : command.collect) collected.emplace_back(file.into);
  plan.report = reports.write.get();
  plan.lifeline = lifeline.read.get();
  for (const CollectedFile& file : collected) plan.collectInto.push_back(file.get());

  View view;
  Descriptor filter, arguments;
  if (inNamespace) {
    filter = makeFile(seccompFilter(command.systemFiles.empty()));
    view = composeView(command, helper, worker.has_value(), filter.get(), info.write.get());
    std::string bytes;
    for (const std::string& argument : view.arguments) bytes.append(argument).push_back('\0');
    arguments = makeFile(bytes);
    plan.bwrap = kBwrap;
    plan.bwrapArguments = arguments.get();
    plan.copies = view.copies;
    if (worker) plan.staged = view.sources;
  }

  // The plan's own descriptor comes first in the list that it holds, so its number is fixed first.
  Descriptor planFile = makeFile("");
  plan.kept = {planFile.get()};
  for (const int number : {reports.write.get(), lifeline.read.get(), info.write.get(), filter.get(),
                           arguments.get(), command.inheritedDescriptor})
    if (number >= 0) plan.kept.push_back(number);
  plan.kept.insert(plan.kept.end(), plan.collectInto.begin(), plan.collectInto.end());
  const std::string bytes = encode(plan);
  if (pwrite(planFile.get(), bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    fail("cannot write the plan");

  const pid_t pid =
      spawnHelper(helper, planFile.get(), plan.kept, out.write.get(), err.write.get());
  for (Descriptor* end : {&out.write, &err.write, &reports.write, &info.write, &lifeline.read})
    end->close();
  Connections connections{std::move(out.read), std::move(err.read), std::move(reports.read),
                          std::move(info.read), std::move(lifeline.write)};
  Supervisor supervisor(command.limits, std::move(connections), pid, inNamespace,
                        std::move(view.writableFolders));
  Result result = supervisor.watch(cancel);
  for (std::size_t n = 0; result.collected && n < collected.size(); ++n)
    collected[n].keep(supervisor.wasExecutable(n));
  return result;
}

} // namespace

Result run(const Command& command, Isolation isolation, const std::atomic<bool>* cancel) {
  try {
    return runOrThrow(command, isolation, cancel);
  } catch (const std::exception& error) {
    Result result;
    result.detail = error.what();
    return result;
  }
}

} // namespace ggrade::sandbox
