#pragma once
/// \file
/// The archive that a learning management system makes of a whole class.

#include "sandbox/sandbox.hpp"

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace ggrade::intake {

/// Writes the files of `archive` to the new folder `into`, with their times, uploads still packed.
/// The archive is taken apart in the sandbox, within kClassLimits. What is refused or passed over
/// goes to `remarks`. Throws UsageError with the remedy where the archive can't be used.
void unpackClass(const std::filesystem::path& archive, const std::filesystem::path& into,
                 sandbox::Isolation isolation, const std::atomic<bool>* cancel,
                 std::vector<std::string>& remarks);

} // namespace ggrade::intake
