#pragma once
/// \file
/// How far long work is.

#include <cstddef>
#include <functional>
#include <string>

namespace ggrade::grading {

/// Called with what is being done and how far it is, for people.
using Progress = std::function<void(const std::string& what, std::size_t done, std::size_t total)>;

} // namespace ggrade::grading
