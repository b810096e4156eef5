#pragma once
/// \file
/// Runs the rubric in a process of its own, so that a crash there keeps what was judged before.

#include "assignment/assignment.hpp"

namespace ggrade::grading {

/// An item as declared, with nothing earned yet.
report::Item unjudgedItem(const ItemDeclaration& declared);

/// The items of `target`, filled in from the lines that a judge appended to `results`.
std::vector<report::Item> readItems(const Target& target, const std::filesystem::path& results);

/// Fills in the items of `target` from the judge's results in `work`. An item that the judge never
/// reached stays unjudged and `problem` says why.
std::vector<report::Item> judge(const Target& target, const std::filesystem::path& evidence,
                                const std::filesystem::path& work,
                                const std::vector<std::string>& arguments, std::string& problem);

} // namespace ggrade::grading
