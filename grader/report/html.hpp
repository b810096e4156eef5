#pragma once
/// \file
/// The HTML pages: one file each that needs nothing else, no network and no server.

#include "report/reveal.hpp"
#include "report/summary.hpp"

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
Pages resultPages(const Result& result, Reveal reveal, std::launch how = std::launch::async);

/// A list of results, in the order given, with a thumbnail and a link each.
/// \param intro one or two sentences under the title; may be empty
std::string overviewPage(std::string_view title, std::string_view intro,
                         std::span<const Summary> results);

} // namespace ggrade::report
