#pragma once
/// \file
/// Writes a result as the files of the contract.

#include "report/results.hpp"
#include "report/reveal.hpp"

#include <filesystem>

namespace ggrade::cli {

/// Writes results.json, junit.xml, index.html and student.html to `out`, all or none.
void writeReports(const report::Result& result, const std::filesystem::path& out,
                  report::Reveal reveal);

/// The table on stdout, or results.json.
void printResult(const report::Result& result, const std::filesystem::path& out, bool json);

} // namespace ggrade::cli
