#pragma once
/// \file
/// From an upload to a plain folder of files.

#include "intake/find_uploads.hpp"
#include "intake/limits.hpp"

namespace ggrade::intake {

/// Archives in one upload; see limits.hpp for what each may hold, and all together.
inline constexpr std::size_t kMostArchives = 4;

struct Unpacked {
  std::vector<std::string> refused; ///< "name: reason"
  std::string problem; ///< why the upload can't be used as a whole; `into` is empty then
  std::vector<std::string> remarks; ///< what was changed, and what was passed over
};

/// Writes an upload's files to `into`, which must be new or empty: regular files of mode 0644,
/// within kUploadLimits, no archive in an archive. Archives are taken apart in the sandbox.
///
/// The shallowest folder that holds one of `wanted` becomes the top; of several, the one with more
/// of them. A wanted file under a name of other case, or with a browser's number
/// (`floor (1).cpp`), gets its own name; so does a single file `student1.cpp`, if only one wanted
/// file ends in `.cpp`. Sources in Shift_JIS (CP932) become UTF-8. Byte-order marks and CRLF stay:
/// compilers read them.
/// \param wanted names of the files that students edit
/// \param cancel as in sandbox::run; look at it when the call is over
/// Throws UsageError if `into` can't be used, and std::runtime_error where the sandbox doesn't
/// start; neither is the student's fault.
Unpacked unpack(const Upload& upload, const std::vector<std::string>& wanted,
                const std::filesystem::path& into, sandbox::Isolation isolation,
                const std::atomic<bool>* cancel = nullptr);

} // namespace ggrade::intake
