#pragma once

#include <stdexcept>

namespace ggrade {

/// A fault in what an instructor or author wrote, or in how the tool was called. The message names
/// the file, the value and the remedy.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

} // namespace ggrade
