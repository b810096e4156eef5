#include "cli/commands.hpp"

#include "rubric/rubric.hpp"

namespace ggrade::cli {

void addJudge(CLI::App& app) {
  // Not listed: `grade` starts this in a process of its own.
  auto* command = app.add_subcommand("judge", "Judges rendered frames (used by grade)")->group("");
  struct Options {
    std::string evidence, results;
  };
  auto options = std::make_shared<Options>();
  command->add_option("EVIDENCE", options->evidence)->required();
  command->add_option("RESULTS", options->results)->required();
  command->callback(
      [options] { exitCode = rubric::runJudge(options->evidence, options->results, afterDashes); });
}

} // namespace ggrade::cli
