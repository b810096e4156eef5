#pragma once
/// \file
/// Runs a program in which one system call fails, or at which it is killed. The calls are seen
/// where the kernel sees them (seccomp and ptrace), so none is missed, whatever library makes it.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace failing_calls {

/// The program that is run, or one that it starts.
enum class Role { parent, worker };
enum class Call { open, read, write, rename, mkdir, sync, fork, map };

inline constexpr Role kRoles[] = {Role::parent, Role::worker};
inline constexpr Call kCalls[] = {Call::open,  Call::read, Call::write, Call::rename,
                                  Call::mkdir, Call::sync, Call::fork,  Call::map};

const char* name(Role role);
const char* name(Call call);
/// What the call may fail with, `errno` values, for which it makes sense.
std::vector<int> errorsOf(Call call);

inline constexpr int kKilled = 0;

/// The call `number` (from 1) of `role` fails with `error`, or the process is killed there.
/// `lasts`: so does every later one, but for those on standard input, output and error, as on a
/// disk that stays full.
struct Fault {
  Role role = Role::parent;
  Call call = Call::open;
  std::size_t number = 1;
  int error = kKilled;
  bool lasts = false;

  std::string text() const; ///< "parent: open 12: ENOSPC", "... ENOSPC from then on"
};

struct Ended {
  int exitCode = -1, signal = 0;
  std::string out, errors;
  /// How many calls each role has made: several workers count together.
  std::map<std::pair<Role, Call>, std::size_t> counts;
  bool struck = false; ///< did the fault come?
};

/// Counting begins in each process when it calls this: not the loader's calls, but `main`'s.
void beginHere();

/// Runs `arguments` with `environment` added, to the end of all processes that it starts. One that
/// hangs is ended by SIGALRM after a minute.
Ended run(const std::vector<std::string>& arguments,
          const std::vector<std::pair<std::string, std::string>>& environment,
          const std::optional<Fault>& fault = {});

/// Can it be done here? Only on x86-64, and where nobody forbids ptrace.
bool possible();

} // namespace failing_calls
