#include "report/reports.hpp"

#include "report/page.hpp"
#include "report/picture.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace ggrade::report {

using nlohmann::json;

namespace {

json rowOf(const Summary& summary) {
  const double share = summary.maxScore > 0 ? summary.score / summary.maxScore : 0;
  return {{"state", stateOf(summary)},
          {"outcome", name(summary.outcome)},
          {"outcomeWords", spaced(name(summary.outcome))},
          {"submission", summary.submission.empty() ? "(no name)" : summary.submission},
          {"link", encodePath(summary.link)},
          {"thumbnail", pngDataUri(summary.thumbnail)},
          {"pictureAlt", "What " + summary.submission + " drew"},
          {"hasScore", summary.outcome != results::Outcome::notGradable},
          {"score", summary.score},
          {"maxScore", summary.maxScore},
          {"bonus", summary.bonus > 0 ? number(summary.bonus) : ""},
          {"share", number(std::clamp(share, 0.0, 1.0) * 100, 1)},
          {"headline", sanitizeLine(summary.headline)},
          {"first", summary.reason == summary.headline ? "" : sanitizeLine(summary.reason)}};
}

} // namespace

std::string overviewPage(std::string_view title, std::string_view intro,
                         std::span<const Summary> results) {
  json rows = json::array();
  for (const Summary& summary : results) rows.push_back(rowOf(summary));
  return renderPage(
      {templates::k_overview_mustache, templates::k_page_js, templates::k_page_js_sha256, ""},
      {{"title", sanitizeLine(title)},
       {"intro", intro},
       {"tally", tallyOf(results)},
       {"rows", std::move(rows)},
       {"footer", fmt::format("{} submission{}.", results.size(), results.size() == 1 ? "" : "s")}},
      title);
}

} // namespace ggrade::report
