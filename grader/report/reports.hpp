#pragma once
/// \file
/// The reports of one graded submission, and the list of several. A page is one file that needs
/// nothing else, no network and no server.

#include "report/reveal.hpp"
#include "report/summary.hpp"

#include <filesystem>
#include <future>
#include <span>
#include <string>
#include <string_view>

namespace ggrade::report {

struct Pages {
  std::string index;   ///< the instructor's: everything
  std::string student; ///< what studentView() leaves
};

/// Both pages of one result; each picture is encoded once. `how`: on threads, or one after another
/// for who has no processor to spare.
Pages resultPages(const results::Result& result, Reveal reveal,
                  std::launch how = std::launch::async);

/// A list of results, in the order given, with a thumbnail and a link each.
/// \param intro one or two sentences under the title; may be empty
std::string overviewPage(std::string_view title, std::string_view intro,
                         std::span<const Summary> results);

/// JUnit XML for continuous integration: one testsuite a part, one testcase an item (classname
/// `assignment.part`). Lost points are a failure with the message; an item that was never judged is
/// an error that says why; a bonus not earned is skipped. Outcome, seed, score and sandbox stand in
/// the properties. The instructor's file: it holds everything. Well-formed XML 1.0 whatever the
/// texts hold.
std::string junit(const results::Result& result);

/// Writes results.json, junit.xml, index.html and student.html to `folder`, which is made if
/// missing. All four are composed before the first is written, and each is complete or absent.
/// `how` as in resultPages.
/// \throws std::runtime_error naming the path, the cause and the remedy.
void writeReports(const std::filesystem::path& folder, const results::Result& result,
                  Reveal reveal = Reveal::names, std::launch how = std::launch::async);

} // namespace ggrade::report
