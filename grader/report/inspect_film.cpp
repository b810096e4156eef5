#include "report/inspect_parts.hpp"

#include "report/inspect_words.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ggrade::report {

using namespace trace;
using gg::say;

namespace {

// As in templates/inspect.css.
constexpr int kCardWidth = 220, kCardGap = 16;
constexpr int kLaneHeight = 8, kLanes = 12;
constexpr int kRadius = 5;

/// One read as a line from under the writer's card to under the reader's.
struct Arc {
  std::uint32_t from, to; ///< cards, counted from 0
  int lane = 0;           ///< 0 is nearest to the cards
};

/// Short lines nearest to the cards; lines that share a stretch in different lanes.
std::vector<Arc> arcsOf(const FrameGraph& graph) {
  std::vector<Arc> arcs;
  for (const PassRead& read : graph.reads())
    if (read.writer < read.reader &&
        (arcs.empty() || arcs.back().from != read.writer - graph.first() ||
         arcs.back().to != read.reader - graph.first()))
      arcs.push_back({read.writer - graph.first(), read.reader - graph.first()});
  std::ranges::stable_sort(arcs, {}, [](const Arc& arc) { return arc.to - arc.from; });
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    unsigned taken = 0;
    for (std::size_t k = 0; k < i; ++k)
      if (arcs[k].from < arcs[i].to && arcs[i].from < arcs[k].to) taken |= 1U << arcs[k].lane;
    while (arcs[i].lane < kLanes - 1 && (taken >> arcs[i].lane & 1)) ++arcs[i].lane;
  }
  return arcs;
}

std::string pathOf(const Arc& arc) {
  constexpr int kStep = kCardWidth + kCardGap;
  // A line leaves right of the card's middle and arrives left of it.
  const int x0 = int(arc.from) * kStep + kCardWidth / 2 + 14;
  const int x1 = int(arc.to) * kStep + kCardWidth / 2 - 14;
  const int y = 14 + arc.lane * kLaneHeight;
  return fmt::format("M{0} 0V{2}q0 {4} {4} {4}H{3}q{4} 0 {4} -{4}V6", x0, x1, y - kRadius,
                     x1 - kRadius, kRadius);
}

} // namespace

Data cardsOf(const FilmParts& parts) {
  Data cards = makeList();
  for (std::uint32_t i = 0; i < parts.graph.count(); ++i) {
    const std::uint32_t index = parts.graph.first() + i;
    const PassRecord& pass = parts.graph.pass(index);
    const auto pixels = parts.pixelsOf(index);
    const auto shown =
        std::ranges::find_if(pixels, [](const PagePixels* p) { return !p->thumbnail.empty(); });
    Data card(Data::type::object);
    card["number"] = Data(std::to_string(i + 1));
    card["title"] = line(passTitle(pass));
    card["thumbnail"] = shown == pixels.end() ? Data(false) : Data((*shown)->thumbnail);
    card["small"] =
        Data(shown != pixels.end() && (*shown)->copy->width < std::uint32_t(kCardWidth));
    card["draws"] = Data(drawCount(pass.draws));
    card["milliseconds"] =
        pass.seconds > 0 ? Data(fmt::format("{:.2f} ms", pass.seconds * 1e3)) : Data(false);
    const auto& notes = parts.notes[i];
    const bool wrong =
        std::ranges::any_of(notes, [](const Note& note) { return note.kind == Note::Kind::wrong; });
    const auto count = std::size_t(std::ranges::count_if(
        notes, [](const Note& note) { return note.kind != Note::Kind::fact; }));
    card["noteCount"] =
        count == 0 ? Data(false) : Data(count == 1 ? say("1 note") : say("{} notes", count));
    card["state"] = Data(std::string(wrong ? "none" : "part"));
    std::string reads;
    for (const PassRead& read : parts.graph.readsOf(index))
      reads += (reads.empty() ? "" : ", ") + readWords(parts.graph, read);
    card["reads"] = reads.empty() ? Data(false) : line(say("reads {}", reads));
    cards.push_back(card);
  }
  return cards;
}

void addArcs(const FilmParts& parts, Data& page) {
  Data list = makeList();
  int lanes = 0;
  for (const Arc& arc : arcsOf(parts.graph)) {
    Data data(Data::type::object);
    data["from"] = Data(std::to_string(arc.from + 1));
    data["to"] = Data(std::to_string(arc.to + 1));
    data["path"] = Data(pathOf(arc));
    list.push_back(data);
    lanes = std::max(lanes, arc.lane + 1);
  }
  page["arcs"] = std::move(list);
  page["arcsHeight"] = Data(std::to_string(lanes == 0 ? 0 : 14 + lanes * kLaneHeight));
  page["stripWidth"] =
      Data(std::to_string(int(parts.graph.count()) * (kCardWidth + kCardGap) - kCardGap));
}

} // namespace ggrade::report
