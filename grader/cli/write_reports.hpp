#pragma once
/// \file
/// Writes a result as the files of the contract.

#include "report/results.hpp"
#include "report/reveal.hpp"

#include <filesystem>

namespace ggrade::cli {

/// The file that says that a folder holds an earlier result of `grade`, and may be replaced.
inline constexpr char kResultMarker[] = "results.json";

/// Writes results.json, junit.xml, index.html and student.html to `out`, all or none.
void writeReports(const report::Result& result, const std::filesystem::path& out,
                  report::Reveal reveal);

/// The table on stdout, or results.json.
void printResult(const report::Result& result, const std::filesystem::path& out, bool json);

} // namespace ggrade::cli
