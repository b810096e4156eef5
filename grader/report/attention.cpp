#include "report/attention.hpp"

#include "report/class_figures.hpp"
#include "report/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ggrade::report {

std::vector<Attention> needingAPerson(std::span<const ClassRow> rows) {
  std::vector<Attention> all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ClassRow& row = rows[i];
    Attention one;
    one.row = i;
    if (!row.lookAlikes.empty())
      one.reasons.push_back(
          fmt::format("Looks like {}: which one counts? No gradebook has a grade of theirs.",
                      fmt::join(row.lookAlikes, ", ")));
    if (!hasScore(row))
      one.reasons.push_back("Not gradable, our fault" +
                            (row.reason.empty() ? "." : ": " + sanitizeLine(row.reason)));
    one.lacksScore = !one.reasons.empty();
    for (const Adjustment& adjustment : row.adjustments)
      if (!adjustment.beyond.empty())
        one.reasons.push_back(fmt::format("Is this override meant? {} ({}); they count.",
                                          sanitizeLine(adjustment.beyond),
                                          sanitizeLine(adjustment.who, 60)));
    if (!one.reasons.empty()) all.push_back(std::move(one));
  }
  return all;
}

} // namespace ggrade::report
