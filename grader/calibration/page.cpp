#include "calibration/page.hpp"

#include "calibration/plot.hpp"
#include "image/compare.hpp"
#include "report/page.hpp"
#include "report/page_parts.hpp"
#include "report/templates.hpp"
#include "report/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace ggrade::calibration {

using report::Data;
using report::line;
using report::makeList;
using report::number;

namespace {

Data cellsOf(const std::vector<std::string>& texts) {
  Data cells = makeList();
  for (const std::string& text : texts) {
    Data cell;
    cell["cell"] = line(text);
    cells << cell;
  }
  return cells;
}

Data sectionOf(const Section& section) {
  Data data, rows = makeList();
  data["sectionTitle"] = line(section.title);
  data["sectionText"] = report::text(section.text);
  data["columns"] = cellsOf(section.columns);
  for (const auto& cells : section.rows) {
    Data row;
    row["cells"] = cellsOf(cells);
    rows << row;
  }
  data["sectionRows"] = std::move(rows);
  data["hasTable"] = Data(!section.columns.empty());
  data["chart"] = report::optional(section.chart);
  return data;
}

Data rowOf(const Row& row) {
  Data data;
  const bool graded = row.gradings > 0;
  data["name"] = line(row.name);
  data["kind"] = Data(std::string(name(row.kind)));
  data["about"] = line(row.title);
  data["graded"] = Data(graded);
  data["lowest"] = Data(number(row.lowest, 1));
  data["mean"] = Data(number(row.mean, 1));
  data["highest"] = Data(number(row.highest, 1));
  data["item"] = line(row.item);
  data["itemLoss"] =
      row.itemLoss < 0 ? Data(false) : Data(fmt::format("{:.0f}%", 100 * row.itemLoss));
  data["margin"] = graded && std::isfinite(row.margin) ? Data(number(row.margin, 1)) : Data(false);
  data["state"] = Data(row.failures.empty() ? "full" : "none");
  data["verdict"] = Data(row.failures.empty() ? "holds" : "fails");
  Data failures = makeList();
  for (const std::string& text : row.failures) {
    Data failure;
    failure["failure"] = report::text(text);
    failures << failure;
  }
  data["failures"] = std::move(failures);
  return data;
}

Data partOf(const PagePart& part) {
  const Verdicts& verdicts = part.verdicts;
  const auto& confusion = verdicts.confusion;
  Data data, rows = makeList(), sections = makeList();
  std::size_t gradings = 0;
  for (const Row& row : verdicts.rows) {
    rows << rowOf(row);
    gradings += row.gradings;
  }
  for (const Section& section : part.sections) sections << sectionOf(section);
  const std::size_t broken = verdicts.failures().size();
  data["id"] = line(verdicts.part);
  data["partTitle"] = line(part.title);
  data["measured"] = Data(!verdicts.rows.empty());
  data["partState"] = Data(broken == 0 ? "full" : "none");
  if (verdicts.rows.empty())
    data["partVerdict"] = line(part.alone + " alone");
  else
    data["partVerdict"] = Data(broken == 0 ? std::string("all of it holds")
                                           : fmt::format("{} of it doesn't hold", broken));
  data["summary"] = Data(fmt::format(
      "{} programs and sets of pictures, graded with {} seed{} each: {} gradings.{}",
      verdicts.rows.size(), verdicts.seeds.size(), verdicts.seeds.size() == 1 ? "" : "s", gradings,
      verdicts.pairs ? fmt::format(" {} of the programs have two mistakes at once.", verdicts.pairs)
                     : std::string()));
  data["hasBoth"] =
      Data(std::isfinite(verdicts.lowestRight) && std::isfinite(verdicts.highestWrong));
  data["lowestRight"] = Data(number(verdicts.lowestRight, 1));
  data["highestWrong"] = Data(number(verdicts.highestWrong, 1));
  data["rightAccepted"] = Data(std::to_string(confusion[0][0]));
  data["rightRejected"] = Data(std::to_string(confusion[0][1]));
  data["wrongAccepted"] = Data(std::to_string(confusion[1][0]));
  data["wrongRejected"] = Data(std::to_string(confusion[1][1]));
  data["falseRight"] = Data(confusion[0][1] ? "none" : "full");
  data["falseWrong"] = Data(confusion[1][0] ? "none" : "full");
  data["plot"] = Data(plotOf(verdicts, part.measured));
  data["seedList"] = Data(fmt::format("{}", fmt::join(verdicts.seeds, ", ")));
  data["rows"] = std::move(rows);
  data["sections"] = std::move(sections);
  return data;
}

} // namespace

std::string calibrationPage(const std::vector<PagePart>& parts, const std::string& figures) {
  Data data, list = makeList();
  std::size_t gradings = 0, wrong = 0, broken = 0;
  for (const PagePart& part : parts) {
    list << partOf(part);
    const auto& confusion = part.verdicts.confusion;
    gradings += confusion[0][0] + confusion[0][1] + confusion[1][0] + confusion[1][1];
    wrong += confusion[0][1] + confusion[1][0];
    broken += part.verdicts.failures().size();
  }
  data["parts"] = std::move(list);
  data["state"] = Data(broken == 0 ? "full" : "none");
  if (gradings == 0)
    data["verdict"] = line(fmt::format("Only {} was measured this time.", parts.at(0).alone));
  else
    data["verdict"] = Data(
        broken == 0 ? fmt::format("None of {} gradings was wrong.", gradings)
                    : fmt::format("{} of {} gradings were wrong; {} thing{} below must hold and "
                                  "do{} not.",
                                  wrong, gradings, broken, broken == 1 ? "" : "s",
                                  broken == 1 ? "es" : ""));
  data["figures"] = line(figures);
  data["rightScore"] = Data(number(kRightScore));
  data["spread"] = Data(number(kSpread));
  data["itemLoss"] = Data(number(100 * kItemLoss));
  data["requiredCost"] = Data(number(kRequiredCost));
  data["tolerance"] = Data(number(kTolerance * 255));
  data["radius"] = Data(std::to_string(kRadius));
  data["window"] = Data(std::to_string(kWindowSide));
  return report::renderPage({report::templates::k_calibration_mustache,
                             report::templates::k_page_js, report::templates::k_page_js_sha256,
                             report::templates::k_calibration_css},
                            data, "How this grader was measured");
}

} // namespace ggrade::calibration
