#pragma once
/// \file
/// What handouts and scenes use of a measurement. `ggrade tradeoff ID --adopt` keeps it in
/// solutions/<id>/tradeoff: figures.json (an assignment's entry of tradeoff.json) and a chart a
/// sweep. `ggrade derive` makes tables, pictures and presets.json from that.
///
/// figures.json says its "format". Without one it is of the first: costs were differences of two
/// medians by the clock on the wall, had no intervals, and stand there until they are measured
/// again.

#include "tradeoff/page.hpp"
#include "words/words.hpp"

namespace ggrade::tradeoff {

/// What is written now: costs have "low", "high" and "frame_ms".
inline constexpr int kFormat = 2;

/// "tradeoff-mirror-sharp.svg", in Japanese "tradeoff-mirror-sharp.ja.svg": the chart of a part's
/// sweep in the handout's folder. What is kept is in English.
std::string chartFile(const std::string& part, const std::string& sweep,
                      gg::Language language = gg::Language::english);

/// The chart of the front with the presets named, as a file that stands alone.
std::string chartSvg(const Measured& measured, const Findings& findings);

/// A chart that was kept in English, its axes named in the language that was chosen.
std::string chartInWords(const std::string& svg);

/// presets.json of an assignment from its figures: preset to the numbers of all its parts, each as
/// the first scene of its part that sweeps it has it. Of two parts that have a number in common the
/// later one decides.
json adoptedPresets(const json& figures);

/// Markdown: a part's presets with time and error, its charts, what each number does. With no part:
/// how the cost of all parts grows, and what a scene doesn't need. Empty if the part was not
/// measured. In the language that was chosen.
std::string handoutText(const json& figures, const std::string& part);

} // namespace ggrade::tradeoff
