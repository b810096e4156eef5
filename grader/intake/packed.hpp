#pragma once
/// \file
/// Archives that we don't trust, taken apart in the sandbox.

#include "intake/bundle.hpp"
#include "sandbox/sandbox.hpp"

#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace ggrade::intake {

/// An upload can't be used as a whole; the message says why.
struct UploadProblem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The bundle (see bundle.hpp) of the archive at `path`, made by ggrade-unpack in the sandbox.
/// Throws UploadProblem with half a sentence about the archive ("holds more than ..."), and
/// std::runtime_error where the sandbox doesn't start.
/// \param folder exists; a few files of ours stand there meanwhile
std::string bundleOf(const std::filesystem::path& path, const std::filesystem::path& folder,
                     const Limits& limits, sandbox::Isolation isolation,
                     const std::atomic<bool>* cancel);

/// `readBundle`, with UploadProblem where the bundle makes no sense.
std::vector<Entry> entriesOf(std::string_view bundle, const Limits& limits);

/// From the archive that a learning management system makes of a whole class: writes the files of
/// `archive` to the new folder `into`, with their times, uploads still packed. The archive is taken
/// apart in the sandbox, within kClassLimits. What is refused goes to `refused`, what is passed
/// over to `remarks`. Throws UsageError with the remedy where the archive can't be used.
void unpackClass(const std::filesystem::path& archive, const std::filesystem::path& into,
                 sandbox::Isolation isolation, const std::atomic<bool>* cancel,
                 std::vector<std::string>& refused, std::vector<std::string>& remarks);

} // namespace ggrade::intake
