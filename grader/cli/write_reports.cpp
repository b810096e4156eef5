#include "cli/write_reports.hpp"

#include "cli/terminal.hpp"
#include "grading/workspace.hpp"
#include "report/reports.hpp"
#include "report/results_json.hpp"
#include "report/terminal.hpp"
#include "report/text.hpp"

#include <fmt/format.h>

#include <iostream>

namespace ggrade::cli {

namespace fs = std::filesystem;

void writeReports(const report::Result& result, const fs::path& out, report::Reveal reveal) {
  // Beside the destination, so that it can be moved there in one step.
  grading::TemporaryFolder work(fs::absolute(out).lexically_normal().parent_path());
  report::writeReports(work.path(), result, reveal);
  work.publish(out);
}

void printResult(const report::Result& result, const fs::path& out, bool json) {
  if (json) {
    std::cout << report::resultsJson(result, report::Reveal::details);
    return;
  }
  report::TerminalStyle style;
  style.colour = wantsColour();
  std::cout << report::terminalTable(result, style)
            << fmt::format("\n{}\n", report::sanitizeLine((out / "index.html").string(), 4096));
}

} // namespace ggrade::cli
