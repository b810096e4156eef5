#pragma once
/// \file
/// How a fuzzer says that something doesn't hold.

#include <cstdlib>

inline void require(bool holds) {
  if (!holds) std::abort();
}
