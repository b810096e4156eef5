#pragma once
/// \file
/// What is said about a measured sweep, and the files that hold it.

#include "tradeoff/analysis.hpp"
#include "tradeoff/measure.hpp"
#include "tradeoff/summary.hpp"

namespace ggrade::tradeoff {

/// What somebody asks for.
struct Wishes {
  std::optional<double> budgetMs, error;
};

/// "5ms", "0.005s", or 5 (milliseconds). Throws UsageError.
double parseMs(const std::string& text);
/// "1%" or 0.01. Throws UsageError.
double parseError(const std::string& text);

/// The answer to a wish; no point if no setting fulfils it.
struct Advice {
  std::string wish; ///< "at most 5.00 ms"
  std::optional<std::size_t> point;
};

/// The settings of one number, or of several that were swept together.
struct Table {
  std::vector<std::string> numbers;
  std::vector<std::size_t> points; ///< indices into Measured::points

  std::string name() const; ///< of its files: "mirror_size-mirror_clip"
};

/// A number alone: how error and cost change with it.
struct Curve {
  Number number;
  Table table;
  std::string fall;             ///< in words, with the number's note
  std::optional<Growth> growth; ///< of cost, if the number is an amount
};

/// A setting that has a name of its own.
struct Compared {
  std::string name;
  std::size_t point = 0;
};

struct Findings {
  std::vector<std::size_t> front;
  std::vector<Compared> compared; ///< as the sweep asks for them
  std::vector<Preset> presets;
  std::vector<Advice> advice;
  std::vector<Table> tables; ///< those of the curves first
  std::vector<Curve> curves;
};

Findings findingsOf(const Measured& measured, const Wishes& wishes);

/// RFC 4180: the table's numbers; the cost in milliseconds, the ends of its interval, the whole
/// frame; the errors by name.
std::string csvOf(const Measured& measured, const Table& table);
/// The same, and what the scene was.
json jsonOf(const Measured& measured, const Findings& findings, const Table& table);
/// Front, presets, advice, sentences.
json jsonOf(const Measured& measured, const Findings& findings);
json jsonOf(const GrowthRow& row);
json jsonOf(const SavedRow& row);

/// {"ms", "low", "high", "frame_ms", "narrow"}, and back.
json jsonOf(const Cost& cost);
Cost costFrom(const json& row);

/// "2 of 40 settings ...": where the rounds ended before an interval was narrow. Empty if
/// all are. In the language that was chosen.
std::string roundsText(const std::vector<Point>& points, const Effort& effort);

/// `{"quality": {...}}`: what to paste into scene.json.
json pasteOf(const json& setting);

/// The presets of the parts: part to preset to `{"quality": ..., "rule": ...}`; the numbers of a
/// part's several scenes stand together, each as the first scene that sweeps it has it.
json presetsJson(const std::vector<Measured>& all, const std::vector<Findings>& findings);

/// For the terminal.
std::string textOf(const Measured& measured, const Findings& findings);
std::string textOf(const std::vector<GrowthRow>& rows);
std::string textOf(const std::vector<SavedRow>& rows);

} // namespace ggrade::tradeoff
