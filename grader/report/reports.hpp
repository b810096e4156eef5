#pragma once
/// \file
/// The files of one graded submission.

#include "report/reveal.hpp"

#include <filesystem>
#include <future>

namespace ggrade::report {

/// Writes results.json, junit.xml, index.html and student.html to `folder`, which is made if
/// missing. All four are composed before the first is written, and each is complete or absent.
/// `how` as in resultPages.
/// \throws std::runtime_error naming the path, the cause and the remedy.
void writeReports(const std::filesystem::path& folder, const Result& result,
                  Reveal reveal = Reveal::names, std::launch how = std::launch::async);

} // namespace ggrade::report
