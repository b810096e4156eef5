#include "cli/commands.hpp"

#include "image/compare.hpp"
#include "rubric/rubric.hpp"

namespace ggrade::cli {

void addJudge(CLI::App& app) {
  // Not listed: whoever grades starts this in a process of its own.
  auto* command =
      app.add_subcommand("judge", "Judges what submissions drew, as stdin names them")->group("");
  struct Options {
    std::string evidence;
    bool many = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("EVIDENCE", options->evidence)->required();
  command->add_flag("--many", options->many);
  // What a comparison allows, for who wants to know what another tolerance would do.
  command->add_option("--tolerance", tolerances().tolerance);
  command->add_option("--radius", tolerances().radius);
  command->callback([options] { exitCode = rubric::serveJudge(options->evidence, options->many); });
}

} // namespace ggrade::cli
