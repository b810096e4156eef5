#pragma once
/// \file
/// The mistakes of the catalogue that show the same as a student's program.

#include "check/rows.hpp"

namespace ggrade::check {

/// The catalogue held against one program. Keeps references to all that it is given.
class KnownMistakes {
public:
  /// \param begun TODOs that were begun
  /// \param step how many TODOs the program should have done
  KnownMistakes(const Expected& expected, const Shown& shown, const std::set<std::string>& begun,
                std::size_t step)
      : expected_(expected), shown_(shown), begun_(begun), step_(step) {}

  /// Those that show the same in one scene, or, where none does, are like it: of ones made just
  /// now, else of ones in the finished program (whose window may be like an unfinished one's that
  /// is right). The latest step's come first; of those of one group there is one.
  std::vector<const Fault*> like(std::size_t scene) const;

  /// Does this one show the very same in that scene?
  bool isExactly(const Fault& fault, std::size_t scene) const;

  /// TODOs of those of which, in a program that has come as far, such a picture is the first wrong
  /// one of some scene: that of a pass, or, if nothing, the window. Not those of mistakes that
  /// spoil a scene, or the window of one, in which this program is right, nor of those that don't
  /// spoil this one.
  std::set<std::string> spoiling(const diagnosis::FirstWrong& first) const;

  /// TODOs before the last one of those that show nothing of it in the public scene: all is as if
  /// it weren't there.
  std::set<std::string> hidingTheStep() const;

private:
  std::vector<const Fault*> like(std::size_t scene, std::size_t step) const;
  diagnosis::SceneViews viewsOf(const Fault& fault, std::size_t scene) const;
  bool isWrongBefore(const Fault& fault, std::size_t scene) const;
  bool isWrongIn(std::size_t scene) const;
  bool isRuledOut(const Fault& fault) const;
  bool isWrongWhere(const Fault& fault) const;
  void keepLikeliest(std::vector<const Fault*>& faults) const;

  mutable std::map<std::size_t, bool> wrong_; // by scene that was asked for
  const Expected& expected_;
  const Shown& shown_;
  const std::set<std::string>& begun_;
  std::size_t step_;
};

} // namespace ggrade::check
