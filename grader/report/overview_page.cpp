#include "report/html.hpp"

#include "report/page_parts.hpp"
#include "report/picture.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ggrade::report {
namespace {

Data rowOf(const Summary& summary) {
  const bool hasScore = summary.outcome != Outcome::notGradable;
  const double share = summary.maxScore > 0 ? summary.score / summary.maxScore : 0;
  Data row;
  row["state"] = Data(std::string(stateOf(summary)));
  row["outcome"] = Data(std::string(name(summary.outcome)));
  row["outcomeWords"] = Data(words(name(summary.outcome)));
  row["submission"] = Data(summary.submission.empty() ? "(no name)" : summary.submission);
  row["link"] = summary.link.empty() ? Data(false) : Data(encodePath(summary.link));
  const std::string uri = pngDataUri(summary.thumbnail);
  row["thumbnail"] = uri.empty() ? Data(false) : Data(uri);
  row["pictureAlt"] = Data("What " + summary.submission + " drew");
  row["hasScore"] = Data(hasScore);
  row["score"] = Data(number(summary.score));
  row["maxScore"] = Data(number(summary.maxScore));
  row["bonus"] = summary.bonus > 0 ? Data(number(summary.bonus)) : Data(false);
  row["share"] = Data(number(std::clamp(share, 0.0, 1.0) * 100, 1));
  row["headline"] = line(summary.headline);
  row["first"] = summary.reason == summary.headline ? Data(false) : line(summary.reason);
  return row;
}

} // namespace

Data tallyOf(std::span<const Summary> results) {
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
  Data tally = makeList();
  for (const Entry& entry : entries) {
    if (entry.count == 0) continue;
    Data chip;
    chip["word"] = Data(words(entry.word));
    chip["state"] = Data(entry.state);
    chip["count"] = Data(std::to_string(entry.count));
    tally << chip;
  }
  return tally;
}

std::string overviewPage(std::string_view title, std::string_view intro,
                         std::span<const Summary> results) {
  Data data, rows = makeList();
  for (const Summary& summary : results) rows << rowOf(summary);
  data["title"] = line(title);
  data["intro"] = text(intro);
  data["tally"] = tallyOf(results);
  data["rows"] = std::move(rows);
  data["footer"] =
      Data(fmt::format("{} submission{}.", results.size(), results.size() == 1 ? "" : "s"));
  return renderPage(templates::k_overview_mustache, data, title);
}

} // namespace ggrade::report
