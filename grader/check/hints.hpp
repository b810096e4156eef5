#pragma once
/// \file
/// What is told of a fault, one level after the other, so that a student is not given the whole
/// answer at once.

#include "check/check.hpp"

#include <filesystem>
#include <string>

namespace ggrade::check {

/// How much is told: where something is wrong, what to look at, and why.
enum class Level { where = 1, look = 2, why = 3 };

/// The levels that there are of what a check found: `where` alone for a fault of which nothing is
/// known, and for one that isn't told bit by bit (see `Checked::isPuzzle`).
Level lastLevel(const Checked& checked);

/// Of `Level::look`, a line each: the cause; of several mistakes that look alike their titles, too.
std::string lookOf(const Checked& checked);

/// What tells a fault from another one: its TODO and its cause. Empty: there is nothing to hint at.
std::string identityOf(const Checked& checked);

/// How much was told of each part's fault, kept in a file so that asking again tells more.
class Told {
public:
  /// Anything but what this has written counts as nothing.
  explicit Told(std::filesystem::path file);

  /// `where`, if it was another fault that was told of.
  Level of(const std::string& part, const Checked& checked) const;
  /// Tells one level more, up to the last. A fault that was told of before is forgotten.
  void tellMore(const std::string& part, const Checked& checked);
  /// Once all of a part is right nothing was told of it. A program that doesn't draw may still have
  /// the fault, so that what was told of it holds.
  void settle(const std::string& part, const Checked& checked);

private:
  void save() const;

  std::filesystem::path file_;
  nlohmann::json told_; ///< by part: {"fault": "...", "level": 2}
};

} // namespace ggrade::check
