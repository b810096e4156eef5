#pragma once
/// \file
/// The frame of a command's `--help`, and why a command line is refused, in the student's language.

#include "words/words.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

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

/// What `text` has where `pattern` has "{}", four values at most; nothing if the rest differs.
inline std::optional<std::array<std::string_view, 4>> valuesIn(std::string_view text,
                                                               std::string_view pattern) {
  std::array<std::string_view, 4> values;
  for (std::string_view& value : values) {
    const std::size_t place = std::min(pattern.find("{}"), pattern.size());
    if (!text.starts_with(pattern.substr(0, place))) return std::nullopt;
    text.remove_prefix(place);
    pattern.remove_prefix(place);
    if (pattern.empty()) break;
    pattern.remove_prefix(2);
    const std::string_view next = pattern.substr(0, pattern.find("{}"));
    const std::size_t end = next.empty() ? text.size() : text.find(next);
    if (end == text.npos) return std::nullopt;
    value = text.substr(0, end);
    text.remove_prefix(end);
  }
  if (text != pattern) return std::nullopt;
  return values;
}

/// CLI11's own sentence (2.3: Error.hpp, Validators.hpp) in the student's language; as it is where
/// it isn't known.
inline std::string sayRefusal(const CLI::Error& error) {
  constexpr std::string_view kSentences[] = {
      gg::tag("The following argument was not expected: {}"),
      gg::tag("The following arguments were not expected: {}"),
      gg::tag("A subcommand is required"),
      gg::tag("{} is required"),
      gg::tag("Could not convert: {} = {}"),
      gg::tag("{}: Value {} not in range {} to {}"),
      gg::tag("{}: {} required {} missing"),
      gg::tag("{}: {} not in {}"),
      gg::tag("{} requires {}"),
  };
  const std::string text = error.what();
  for (const std::string_view sentence : kSentences)
    if (const auto values = valuesIn(text, sentence))
      return fmt::vformat(gg::words(sentence), fmt::make_format_args((*values)[0], (*values)[1],
                                                                     (*values)[2], (*values)[3]));
  return text;
}

/// Of the whole program, for a command line that CLI11 refuses.
inline void sayErrors(CLI::App& app) {
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return gg::say("{}\nRun with --help for more information.\n", sayRefusal(error));
  });
}

} // namespace ggrade::cli
