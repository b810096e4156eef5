#include "report/page.hpp"

#include "report/picture.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <kainjow/mustache.hpp>

#include <algorithm>
#include <stdexcept>

namespace ggrade::report {

using nlohmann::json;

namespace {

using kainjow::mustache::data;

// Takes what it is given apart: pictures are most of a page and needn't be held twice.
data mustacheOf(json value) {
  switch (value.type()) {
  case json::value_t::object: {
    data object;
    for (auto& [name, entry] : value.items()) object[name] = mustacheOf(std::move(entry));
    return object;
  }
  case json::value_t::array: {
    data list(data::type::list);
    for (std::size_t i = 0; i < value.size(); ++i) list.push_back(false);
    // In place: pushed, an entry would be copied with all that is in it, at every depth again.
    for (std::size_t i = 0; i < value.size(); ++i)
      const_cast<data&>(list.list_value()[i]) = mustacheOf(std::move(value[i]));
    return list;
  }
  case json::value_t::string: {
    const std::string clean = sanitize(value.get_ref<const std::string&>());
    return clean.empty() ? data(false) : data(clean);
  }
  case json::value_t::number_float:
    return number(value.get<double>());
  case json::value_t::number_integer:
  case json::value_t::number_unsigned:
    return value.dump();
  case json::value_t::boolean:
    return value.get<bool>();
  default:
    return false;
  }
}

// The Content-Security-Policy admits this one script by its hash: markup that slipped through as
// text could not run.
std::string scriptHash(std::string_view sha256) {
  std::vector<unsigned char> bytes;
  const std::string hex(sha256);
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<unsigned char>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return "sha256-" + base64(bytes);
}

} // namespace

std::string renderPage(const PageKind& kind, json data, std::string_view title) {
  auto page = mustacheOf(std::move(data));
  page["head"] = std::string(templates::k_head_mustache);
  page["style"] = std::string(templates::k_style_css) + std::string(kind.style);
  page["script"] = std::string(kind.script);
  page["scriptHash"] = scriptHash(kind.scriptSha256);
  page["pageTitle"] = sanitizeLine(title);
  if (kind.translated) {
    page["lang"] = std::string(gg::name(gg::language()));
    page["say"] = kainjow::mustache::lambda(
        [](const std::string& english) { return std::string(gg::words(english)); });
  }
  kainjow::mustache::mustache mustache{std::string(kind.body)};
  std::string html = mustache.render(page);
  if (!mustache.is_valid()) throw std::logic_error("page template: " + mustache.error_message());
  return html;
}

json linesOf(const std::vector<std::string>& lines) {
  json list = json::array();
  for (const std::string& line : lines) list.push_back(sanitizeLine(line));
  return list;
}

json tallyOf(std::span<const Summary> results) {
  struct Entry {
    std::string word, state;
    std::size_t count = 0;
  };
  std::vector<Entry> entries = {{"complete", "full"}, {"lost points", "part"}};
  for (const Summary& summary : results) {
    const std::string word = summary.perfect           ? "complete"
                             : scored(summary.outcome) ? "lost points"
                                                       : std::string(name(summary.outcome));
    auto entry = std::ranges::find(entries, word, &Entry::word);
    if (entry == entries.end())
      entry = entries.insert(entry, {word, std::string(stateOf(summary))});
    ++entry->count;
  }
  json tally = json::array();
  for (const Entry& entry : entries)
    if (entry.count > 0)
      tally.push_back(
          {{"word", spaced(entry.word)}, {"state", entry.state}, {"count", entry.count}});
  return tally;
}

} // namespace ggrade::report
