#pragma once
/// \file
/// Several runs at a time.

#include <cstddef>
#include <functional>

namespace ggrade::grading {

/// How many runs go at a time: one a core.
unsigned workers();

/// Runs task(0) ... task(count - 1) on `workers` threads. The first exception is thrown on when all
/// have ended.
void inParallel(std::size_t count, unsigned workers, const std::function<void(std::size_t)>& task);

} // namespace ggrade::grading
