#pragma once
/// \file
/// One look at a part of a student's program, and what page, terminal and JSON say of it alike.

#include "check/hints.hpp"
#include "check/places.hpp"

#include <map>

namespace ggrade::check {

/// One part that was looked at.
struct Looked {
  const Part* part = nullptr;
  const Expected* expected = nullptr;
  std::string handout;          ///< its file, from the kit's root: "assignments/floor/mirror.md"
  std::filesystem::path folder; ///< of the student's files
  Checked checked;
  std::vector<Place> places; ///< of the TODO to look at now
  /// The first places of the others that are as likely, by their IDs.
  std::map<std::string, Place> otherPlaces;
  Level level = Level::where; ///< so much of the fault is told on the terminal
  bool canAsk = false;        ///< is this the part of which asking tells more?
};

/// The TODO to look at now: the wrong one, else of those that may be the likely one or the last,
/// else the first that isn't done; none where nothing was drawn or all is done.
const Row* rowToLookAt(const Checked& checked);
/// That one, and those that may be wrong as well, in their order; where one is the likely one, it
/// alone.
std::vector<const Row*> rowsToLookAt(const Checked& checked);

/// Are there rows that are wrong?
bool hasWrong(const Checked& checked);

/// What to do about a wrong picture of which no cause is known; empty for everything else.
std::string unknownCause(const Checked& checked);

const Todo& todoOf(const Part& part, const std::string& id);

/// "done", "wrong", "not begun" and so on, in the chosen language.
std::string nameOf(State state);

std::size_t doneRows(const Checked& checked);
/// "5 of 7 done", or why nothing is known.
std::string headline(const Checked& checked);

/// Beside a row: what is not sure of it; often empty.
std::string noteOf(const Checked& checked, const Row& row);
/// What a row that is done was for: the titles of the rubric's items that it earns, else its own.
std::string purposeOf(const Looked& looked, const Row& row);

/// Which scene is spoken of; empty for the public one.
std::string sceneOf(const Looked& looked, std::size_t scene);
/// "First wrong picture", or that it only differs.
std::string pictureHeading(const Checked& checked);
/// Of the first wrong picture.
std::string pictureOf(const Looked& looked);

/// What a person has to know of a run that showed nothing, or not all.
std::string outcomeOf(const Checked& checked);

/// The file and the heading of the handout's step to read now: that of `rowToLookAt`, or the
/// numbers of several that are as likely; what to do when all is done, of the last part that was
/// looked at; else empty.
std::string stepToRead(const Looked& looked, bool isLast);

/// The places of `rowToLookAt`, as an editor lists them; the first one says what it is.
std::vector<Problem> todoProblems(const Looked& looked);

} // namespace ggrade::check
