#include "cli/commands.hpp"

#include "image/compare.hpp"
#include "rubric/rubric.hpp"

namespace ggrade::cli {

void addJudge(CLI::App& app) {
  // Not listed: `grade` starts this in a process of its own.
  auto* command =
      app.add_subcommand("judge", "Judges rendered frames (used by grade and calibrate)")
          ->group("");
  struct Options {
    std::string evidence, results;
  };
  auto options = std::make_shared<Options>();
  command->add_option("EVIDENCE", options->evidence)->required();
  command->add_option("RESULTS", options->results, "Without it, requests come on stdin");
  // What a comparison allows, for who wants to know what another tolerance would do.
  command->add_option("--tolerance", tolerances().tolerance);
  command->add_option("--radius", tolerances().radius);
  command->callback([options] {
    exitCode = options->results.empty()
                   ? rubric::serveJudge(options->evidence)
                   : rubric::runJudge(options->evidence, options->results, afterDashes);
  });
}

} // namespace ggrade::cli
