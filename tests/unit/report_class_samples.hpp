#pragma once
/// \file
/// Classes as batch grading makes them: for the tests of the class page, and to look at.

#include "report/class_page.hpp"

#include <cstddef>

namespace ggrade::report::samples {

/// Graded, 60 of 100: two gain items, one keep item and one bonus item.
ClassRow student(const std::string& name, double finalScore = 60);

/// Names in several scripts, every outcome, overrides, late submissions, changes and remarks;
/// without thumbnails. The same every time.
ClassPage wholeClass(std::size_t students);

/// Gives some rows a picture.
void addThumbnails(ClassPage& page);

} // namespace ggrade::report::samples
