#pragma once
/// \file
/// What every HTML page shares: the head, the style, the script, and how text gets into a template.

#include <kainjow/mustache.hpp>

#include <string>
#include <string_view>

namespace ggrade::report {

using Data = kainjow::mustache::data;

inline Data makeList() {
  return Data(Data::type::list);
}

/// Untrusted text for `{{name}}`: sanitized here, escaped by the template. False when empty, so
/// that
/// `{{#name}}` asks whether there is any (to mustache an empty string is true).
Data line(std::string_view text);
Data text(std::string_view text);

/// Lets a page that students read say its texts in the chosen language: `{{#say}}English{{/say}}`.
void addLanguage(Data& page);

/// What makes one kind of page differ from the others.
struct PageKind {
  std::string_view body;         ///< a file of templates/
  std::string_view script;       ///< its one script
  std::string_view scriptSha256; ///< of the script, 64 hexadecimal digits
  std::string_view style;        ///< after the sheet that all pages share; may be empty
};

/// Renders `kind.body` with `data`, adding the head, the styles and the script.
/// \throws std::logic_error if the template doesn't parse.
std::string renderPage(const PageKind& kind, Data data, std::string_view title);

/// Renders `body` (a file of templates/) with `data`, adding the head, the style and the script.
/// A name that an inner context lacks is looked up outside it, so every list entry sets all of its
/// names. \throws std::logic_error if the template doesn't parse.
std::string renderPage(std::string_view body, Data data, std::string_view title);

} // namespace ggrade::report
