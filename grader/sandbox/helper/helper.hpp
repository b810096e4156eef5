#pragma once
/// \file
/// The stages of the helper program. It is linked statically and does little, because every run
/// pays for it.

#include "../helper_plan.hpp"

namespace ggrade::sandbox::helper {

/// Sends one message to the supervisor; `error`, an errno, is spelled out behind `text`.
void report(const HelperPlan& plan, HelperReport::Kind kind, const std::string& text, int error = 0,
            int value = 0);

/// Sheds privileges and descriptors, then becomes bwrap, or goes on with `runInside`. Returns the
/// exit code of the helper.
int runOutside(const HelperPlan& plan);

/// Starts the command, waits, ends everything that it left running, hands back the collected files.
int runInside(const HelperPlan& plan);

/// Copies every file and folder under `source` into the existing folder `destination`, writable.
/// Returns an empty string or what went wrong.
std::string copyTree(const std::string& source, const std::string& destination);

/// Hands the files of `plan.collect` back to the supervisor and reports the outcome.
void collect(const HelperPlan& plan);

/// Tries, from inside, what the sandbox must refuse, and prints a line for each: "refused WHAT" or
/// "allowed WHAT". Exit code 0 when all is refused.
int probe();

} // namespace ggrade::sandbox::helper
