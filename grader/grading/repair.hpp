#pragma once
/// \file
/// One fault, one loss: where a submission lost points, what it drew is drawn again with one thing
/// after the other as the reference has it (grader/repair), until the smallest set of things is
/// found that makes it right. That is the cause, proved by drawing it; each costs what it costs
/// when all else is right.

#include "grading/judge.hpp"
#include "grading/own_tapes.hpp"

namespace ggrade::grading {

struct Graded;

/// Were points lost by a program that ran?
bool isWorthRepair(const results::Result& result);

/// Is one of them that something isn't drawn at all? Then nothing is given back: the reference's
/// draws would bring the work of other steps with them.
bool areUnfinished(const std::vector<results::ProvedCause>& causes);

/// Finds the causes and gives back what they cost more than once. Nothing: no set of causes makes
/// it right, and the items stay as they are. Throws Interrupted.
/// \param threads scenes are drawn so many at a time
/// \param why the reason where nothing was found
std::vector<results::ProvedCause> repairFaults(const Target& target, OwnTapes& own, Judge& judge,
                                               Graded& graded, unsigned threads, std::string& why);

} // namespace ggrade::grading
