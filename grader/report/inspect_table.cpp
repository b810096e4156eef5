#include "report/inspect.hpp"

#include "report/inspect_words.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ggrade::report {

using namespace trace;
using gg::say;

namespace {

using Row = std::array<std::string, 7>;

Row rowOf(const FrameGraph& graph, std::uint32_t index) {
  const PassRecord& pass = graph.pass(index);
  const auto targets = mainAttachments(pass);
  std::string into, size, formats, reads;
  for (const std::uint32_t target : targets) {
    const ImageRef& image = pass.images[target];
    into += (into.empty() ? "" : " + ") + imageWords(image);
    if (image.format) formats += (formats.empty() ? "" : " + ") + glName(image.format);
  }
  if (!targets.empty()) size = sizeWords(pass.images[targets[0]]);
  for (const PassRead& read : graph.readsOf(index))
    reads += (reads.empty() ? "" : ", ") + readWords(graph, read);
  return {std::to_string(graph.number(index)),
          into.empty() ? say("nothing") : into,
          size,
          formats,
          grouped(pass.draws),
          pass.seconds > 0 ? fmt::format("{:.2f}", pass.seconds * 1e3) : "",
          reads};
}

} // namespace

std::string inspectTable(const InspectedFrame& frame) {
  const FrameGraph graph(frame.trace, frame.frame);
  std::vector<Row> rows = {{say("pass"), say("draws into"), say("size"), say("format"),
                            say("draws"), "ms", say("reads")}};
  for (std::uint32_t i = 0; i < graph.count(); ++i) rows.push_back(rowOf(graph, graph.first() + i));
  std::array<std::size_t, 7> widths{};
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c)
      widths[c] = std::max(widths[c], displayWidth(row[c]));
  std::string text;
  for (const Row& row : rows) {
    std::string one;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string space(widths[c] - displayWidth(row[c]), ' ');
      const bool isNumber = c == 0 || c == 4 || c == 5;
      one += (c ? "  " : "") + (isNumber ? space + row[c] : row[c] + space);
    }
    one.erase(one.find_last_not_of(' ') + 1);
    text += one + '\n';
  }
  return text;
}

} // namespace ggrade::report
