#pragma once
/// \file
/// The list of system calls that a sandboxed command may make.

#include <string>

namespace ggrade::sandbox {

/// The filter as a BPF program for `bwrap --seccomp`, made once a process. What is not allowed
/// fails with EPERM when it is known to be an attack's tool and with ENOSYS otherwise, so that
/// programs fall back as they would on an old kernel. Calls of a foreign architecture kill.
/// `pipes`: compilers need them; the number that a new one gets counts those of the whole machine.
/// Throws std::runtime_error when libseccomp refuses.
const std::string& seccompFilter(bool pipes);

} // namespace ggrade::sandbox
