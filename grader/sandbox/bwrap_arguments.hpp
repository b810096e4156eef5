#pragma once
/// \file
/// What a command sees of the file system.

#include "sandbox.hpp"

namespace ggrade::sandbox {

inline constexpr char kBwrap[] = "/usr/bin/bwrap";

/// bwrap's view of one command.
struct View {
  std::vector<std::string> arguments;       ///< for `bwrap --args`
  std::vector<std::string> sources;         ///< host paths that are mounted, in stage order
  std::vector<std::string> copies;          ///< source, destination, ... as seen inside
  std::vector<std::string> writableFolders; ///< every tmpfs, as seen inside
};

/// Composes the view. `staged`: sources are named by their number on the stage instead of by path.
/// `seccompFd` and `infoFd` go to --seccomp and --info-fd.
/// Throws std::runtime_error for a mount that is relative, missing, or would cover the system.
View composeView(const Command& command, const std::filesystem::path& helper, bool staged,
                 int seccompFd, int infoFd);

} // namespace ggrade::sandbox
