#pragma once
/// \file
/// Tapes of our own programs, and whose work what they differ in is.

#include "grading/owners.hpp"

#include <mutex>

namespace ggrade::grading {

/// Made when first asked for, and kept in the cache. May be asked by several threads.
class OwnTapes {
public:
  OwnTapes(const Target& target, std::filesystem::path solutionFolder,
           const References& references);

  /// The reference's, in a scene of the plan.
  const tape::Tape& reference(std::size_t scene);

  const Owners& owners();

  /// What the solution with this patch differs in from the solution, in the first scene, and what
  /// it has there (see Difference::own). Empty, if that program has no tape.
  const std::map<repair::Unit, std::string>& unitsOf(const std::filesystem::path& patch);

private:
  const Target& target_;
  const std::filesystem::path solutionFolder_;
  const References& references_;
  std::mutex mutex_, patches_, learning_;
  std::map<std::size_t, tape::Tape> reference_;
  std::optional<Owners> owners_;
  std::map<std::filesystem::path, std::map<repair::Unit, std::string>> unitsOf_;
};

} // namespace ggrade::grading
