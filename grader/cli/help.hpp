#pragma once
/// \file
/// The frame of a command's `--help` in the student's language.

#include "words/words.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace ggrade::cli {

/// Names the help's headings and its own option; to be called before options are added.
inline void sayHelp(CLI::App& command) {
  auto formatter = std::make_shared<CLI::Formatter>();
  formatter->label("Usage", gg::say("Usage"));
  formatter->label("Positionals", gg::say("Arguments"));
  formatter->label("OPTIONS", gg::say("OPTIONS"));
  formatter->label("REQUIRED", gg::say("(required)"));
  command.formatter(formatter);
  command.option_defaults()->group(gg::say("Options"));
  command.set_help_flag("-h,--help", gg::say("Print this and exit"));
}

/// Of the whole program, for a command line that CLI11 refuses.
inline void sayErrors(CLI::App& app) {
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return gg::say("{}\nRun with --help for more information.\n", error.what());
  });
}

} // namespace ggrade::cli
