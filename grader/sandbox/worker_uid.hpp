#pragma once
/// \file
/// An unused user id for one run, distinct from that of every other run on the machine.

#include "descriptor.hpp"

#include <sys/types.h>

namespace ggrade::sandbox {

/// Claims a uid while it lives. The range 60578 to 61183 belongs to nobody by systemd's and
/// Debian's conventions and is below 65536, so that it exists in containers too.
class WorkerUid {
public:
  /// Takes the first free one. Throws std::runtime_error when all 606 are in use.
  WorkerUid();
  uid_t get() const { return uid_; }

private:
  uid_t uid_ = 0;
  // Holding an abstract socket name is the claim: the kernel drops it however this process ends.
  Descriptor claim_;
};

} // namespace ggrade::sandbox
