#pragma once
/// \file
/// The parts of the filmstrip page as data for templates/inspect.mustache.

#include "report/inspect.hpp"
#include "report/inspect_graph.hpp"
#include "report/inspect_notes.hpp"
#include "report/inspect_pixels.hpp"
#include "report/page.hpp"

#include <map>
#include <vector>

namespace ggrade::report {

/// All that the parts are made from.
struct FilmParts {
  const InspectedFrame& frame;
  FrameGraph graph;
  PagePixelsOfFrame pixels;
  std::vector<std::vector<Note>> notes; ///< of each pass of the frame, in order

  FilmParts(const InspectedFrame& inspected, const InspectLimits& limits);
  std::vector<const PagePixels*> pixelsOf(std::uint32_t pass) const;
  double totalSeconds() const;
};

/// A pass that is linked to: its number and words such as "pass 1's depth".
Data passLink(const FrameGraph& graph, std::uint32_t pass, std::string_view words);
Data notesData(const std::vector<Note>& notes);

/// The cards of the strip, with what each shows.
Data cardsOf(const FilmParts& parts);
/// `arcs` and their drawing's size: who reads what, as lines under the cards.
void addArcs(const FilmParts& parts, Data& page);
/// One pass in full.
Data passOf(const FilmParts& parts, std::uint32_t pass);
/// Steps with state, textures and matrices.
Data stepsOf(const FilmParts& parts, std::uint32_t pass);

} // namespace ggrade::report
