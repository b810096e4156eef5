#pragma once
/// \file
/// What every HTML page shares: the head, the style, the script, and how JSON gets into a template.

#include "report/summary.hpp"

#include <nlohmann/json.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ggrade::report {

/// What makes one kind of page differ from the others.
struct PageKind {
  std::string_view body;         ///< a file of templates/
  std::string_view script;       ///< its one script
  std::string_view scriptSha256; ///< of the script, 64 hexadecimal digits
  std::string_view style;        ///< after the sheet that all pages share; may be empty
  /// Says its texts in the chosen language: `{{#say}}English{{/say}}`. Others are English.
  bool translated = false;
};

/// Renders `kind.body`, a Mustache template, with the object `data`, adding the head, the styles
/// and the script. `{{name}}` is escaped, `{{{name}}}` is not; both are sanitized (see text.hpp).
/// An empty string is false, so that `{{#name}}` asks whether there is any text; a number is text
/// as `number` writes it, and never false. A name that an inner object lacks is looked up outside
/// it, so every entry of a list has all of its names.
///
///     renderPage(kPage, {{"who", name}, {"rows", {{{"id", 1}}, {{"id", 2}}}}}, "Two rows");
///
/// \throws std::logic_error if the template doesn't parse.
std::string renderPage(const PageKind& kind, nlohmann::json data, std::string_view title);

/// Each on one line, for `{{#lines}}{{.}}{{/lines}}`.
nlohmann::json linesOf(const std::vector<std::string>& lines);

/// "2 complete", "3 lost points", "1 crash": what one wants to know of a class at once.
nlohmann::json tallyOf(std::span<const Summary> results);

} // namespace ggrade::report
