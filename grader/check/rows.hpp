#pragma once
/// \file
/// How far a program has come, TODO by TODO.

#include "check/expected.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ggrade::check {

/// Of a window's pixels. What the catalogue's right answers with another bias, filter or map size
/// change is at most 1.6%; a change of that size that no known mistake makes is not called wrong.
inline constexpr double kNearly = 0.02;

/// A little in a handed-out scene may be another right way where another scene has so many times
/// as much.
inline constexpr double kMuchMore = 10;

enum class State {
  notBegun,
  done,    ///< as far as the scenes that were drawn can show it
  wrong,   ///< the first one that isn't right
  waits,   ///< for one before it; may be right or wrong
  nearly,  ///< a little of a window differs and nothing known explains it: a detail that isn't
           ///< right, or another right way
  differs, ///< a pass differs, nothing known explains it, and all windows are as they should be:
           ///< wrong in a way that only later steps show, or another right way
  maybe    ///< it draws what is wrong, but nothing tells whether it is wrong, or another one that
           ///< does, or what it stands on
};

/// One TODO.
struct Row {
  std::string todo; ///< ID
  State state = State::notBegun;
  bool seen = true; ///< false: no scene that was drawn shows anything of it
  /// The TODO with which the last of the known mistakes in this one shows, where that is yet to be
  /// done; else empty.
  std::string showsWith{};
  bool isFirst = false; ///< of those in doubt the one that pictures speak of most
};

/// Is all that was begun done?
bool allRight(const std::vector<Row>& rows);

/// What a program showed in the first scenes of `Expected`; nothing for one that was not drawn.
using Shown = std::vector<std::optional<diagnosis::SceneViews>>;

/// Where a mistake may lie.
struct Suspect {
  std::string todo;          ///< empty: nothing is known
  bool isExplained = false;  ///< is it known what is wrong? Then little is wrong, too
  bool isGuess = false;      ///< others may be wrong instead, by what pictures tell
  bool isSure = false;       ///< also where a step before it was left out
  bool showsNothing = false; ///< all is as before it
  /// First frames are right, so pictures don't tell whose fault later ones are.
  bool isLater = false;
  std::set<std::string> also{};     ///< TODOs that are as likely
  std::set<std::string> spoiling{}; ///< those with known mistakes that spoil such a picture first
  std::set<std::string> drawing{};  ///< those that change the pass that is wrong first
  /// Those that bind what the window is drawn with: of another scene right passes don't tell.
  std::set<std::string> binding{};
};

/// One row a TODO. A program whose windows are those after some step is judged by these alone,
/// however its passes are made; else each TODO by the first picture of a frame that it changes.
/// \param begun TODOs whose places in the text have changed
std::vector<Row> rows(const Expected& expected, const Shown& shown,
                      const std::set<std::string>& begun, const Suspect& suspect = {});

/// Are the windows that were drawn those after `step` TODOs, but for little, or those of a finished
/// program that is right in another way?
bool windowsPass(const Expected& expected, const Shown& shown, std::size_t step);

/// TODOs that are done for all to see: the first picture of a frame that one changes is as after it
/// or a later one, and as after none before it.
std::set<std::string> doneInPictures(const Expected& expected, const Shown& shown);

/// Passes that a program draws in one scene and that it has after none of the steps, such as one
/// into a texture of another size.
std::vector<diagnosis::Slot> ownPasses(const Expected& expected, const diagnosis::SceneViews& shown,
                                       std::size_t scene);

/// How many TODOs the program after which `shown` should look has done: up to the last that is
/// begun.
std::size_t expectedStep(const Expected& expected, const std::set<std::string>& begun);

} // namespace ggrade::check
