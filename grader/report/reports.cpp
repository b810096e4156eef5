#include "report/reports.hpp"

#include "report/results_json.hpp"
#include "report/text.hpp"
#include "report/write_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <vector>

namespace ggrade::report {
namespace {

struct Suite {
  std::string part;
  std::vector<const results::Item*> items;
};

// "mirror.shading" is an item of the part "mirror".
std::string partOf(const results::Result& result, const results::Item& item) {
  const auto dot = item.id.find('.');
  return dot == std::string::npos ? result.part : item.id.substr(0, dot);
}

std::vector<Suite> suites(const results::Result& result) {
  std::vector<Suite> all;
  for (const results::Item& item : result.items) {
    const std::string part = partOf(result, item);
    auto suite =
        std::find_if(all.begin(), all.end(), [&](const Suite& s) { return s.part == part; });
    if (suite == all.end()) suite = all.insert(all.end(), {part, {}});
    suite->items.push_back(&item);
  }
  if (all.empty()) all.push_back({result.part, {}});
  return all;
}

bool bonusOpen(const results::Item& item) {
  return item.kind == results::ItemKind::bonus && item.judged && standing(item) != Standing::full;
}

bool isFailure(const results::Item& item) {
  return item.judged && item.kind != results::ItemKind::bonus && standing(item) != Standing::full;
}

std::string body(const results::Result& result, const results::Item& item) {
  const std::string points = pointsText(item);
  if (!item.judged)
    return fmt::format("<error type=\"{}\" message=\"{}\"/>", name(result.outcome),
                       escapeXml(explanation(result.outcome)));
  if (bonusOpen(item))
    return fmt::format("<skipped message=\"bonus {}: {}\"/>", points,
                       escapeXml(sanitizeLine(item.message)));
  if (!isFailure(item)) return "";
  std::string text = sanitizeLine(item.message) + "\n";
  if (!item.where.empty()) text += "Where: " + sanitizeLine(item.where) + "\n";
  if (!item.cause.empty()) text += "Likely cause: " + sanitizeLine(item.cause) + "\n";
  if (!item.step.empty()) text += "Read again: " + sanitizeLine(item.step) + "\n";
  for (const auto& [scene, credit, isPublic] : item.credits)
    text += fmt::format("{}: {}\n", sanitizeLine(scene), percent(credit));
  return fmt::format("<failure type=\"points\" message=\"{}: {}\">{}</failure>", points,
                     escapeXml(sanitizeLine(item.message)), escapeXml(text));
}

std::string properties(const results::Result& result) {
  std::string xml = "    <properties>\n";
  const auto add = [&](std::string_view key, std::string_view text) {
    xml += fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", escapeXml(key),
                       escapeXml(text));
  };
  add("outcome", name(result.outcome));
  add("detail", result.detail);
  add("submission", sanitizeLine(result.submission));
  add("seed", std::to_string(result.seed));
  add("score", number(result.score));
  add("bonus", number(result.bonus));
  add("max_score", number(result.maxScore));
  add("sandbox", result.sandbox);
  for (const auto& [key, text] : result.fingerprint) add("fingerprint." + key, text);
  return xml + "    </properties>\n";
}

std::string suiteXml(const results::Result& result, const Suite& suite) {
  const std::string classname = escapeXml(result.assignment + "." + suite.part);
  std::string cases;
  std::size_t tests = suite.items.size(), failures = 0, errors = 0, skipped = 0;
  for (const results::Item* item : suite.items) {
    failures += isFailure(*item);
    errors += !item->judged;
    skipped += bonusOpen(*item);
    cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\">{}</testcase>\n",
                         classname, escapeXml(item->id), body(result, *item));
  }
  if (suite.items.empty() && result.outcome != results::Outcome::graded) {
    tests = errors = 1; // a run that never got as far as the items must not look like success
    cases =
        fmt::format("    <testcase classname=\"{}\" name=\"outcome\" time=\"0\"><error type=\"{}\" "
                    "message=\"{}\"/></testcase>\n",
                    classname, name(result.outcome), escapeXml(explanation(result.outcome)));
  }
  return fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" "
                     "skipped=\"{}\" time=\"{:.3f}\">\n{}{}  </testsuite>\n",
                     classname, tests, failures, errors, skipped, totalSeconds(result),
                     properties(result), cases);
}

} // namespace

std::string junit(const results::Result& result) {
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"ggrade\">\n";
  for (const Suite& suite : suites(result)) xml += suiteXml(result, suite);
  return xml + "</testsuites>\n";
}

void writeReports(const std::filesystem::path& folder, const results::Result& result, Reveal reveal,
                  std::launch how) {
  makeFolder(folder);
  const Pages pages = resultPages(result, reveal, how);
  const std::string json = resultsJson(result, reveal), xml = junit(result);
  writeFile(folder / "index.html", pages.index);
  writeFile(folder / "student.html", pages.student);
  writeFile(folder / "junit.xml", xml);
  writeFile(folder / "results.json", json); // last: where it stands, everything stands
}

} // namespace ggrade::report
