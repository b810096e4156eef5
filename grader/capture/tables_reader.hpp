#pragma once
/// \file
/// The judging side of the recorded passes.

#include "capture/checker.hpp"
#include "trace/trace.hpp"

namespace ggrade::channel {

/// Checks the records that have been copied out of the tables against each other, and makes their
/// names safe to print. `frames` is how many were swapped, `copyBytes` how many bytes of copies
/// there are. False with `check.error` for the first that is impossible.
bool checkTables(Checker& check, trace::Trace& tables, std::uint32_t frames,
                 std::uint64_t copyBytes);

/// Turns the rows of every copy over: the top row comes first from now on.
void turnCopies(trace::Trace& trace);

} // namespace ggrade::channel
