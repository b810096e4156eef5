#pragma once
/// \file
/// One program with many attacks; `attacker NAME [ARGUMENT...]` runs one. Every attack runs only
/// inside limits that the tests set first.

#include <cerrno>
#include <map>
#include <string>
#include <vector>

namespace attacker {

/// Exit codes beyond those that an attack chooses itself.
inline constexpr int kRefused = 0;  ///< everything that was tried failed
inline constexpr int kEscaped = 42; ///< something worked; standard output says what

using Arguments = std::vector<std::string>;
using Attack = int (*)(const Arguments&);
using Attacks = std::map<std::string, Attack>;

/// Collects attempts. An attempt that works is printed as `ESCAPED what`.
class Attempts {
public:
  /// `worked`: the attempt did what it must not; errno tells why it did not.
  void add(const std::string& what, bool worked);
  /// kRefused or kEscaped.
  int outcome() const { return escaped_ ? kEscaped : kRefused; }

private:
  bool escaped_ = false;
};

void addFileAttacks(Attacks& attacks);
void addMemoryAttacks(Attacks& attacks);
void addProcessAttacks(Attacks& attacks);
void addKernelAttacks(Attacks& attacks);

} // namespace attacker
