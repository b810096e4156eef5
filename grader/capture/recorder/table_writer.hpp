#pragma once
/// \file
/// Fills the channel's tables. Keeps its own counts: what stands in the shared memory is never
/// read back. Not for several threads at once.

#include "trace/records.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ggrade::capture::recorder {

class TableWriter {
public:
  TableWriter();

  /// Index of the new pass; kNone, and counted as lost, when the table is full.
  std::uint32_t addPass(const trace::PassRecord& record);
  void setPass(std::uint32_t index, const trace::PassRecord& record);
  std::uint32_t passes() const { return counts_.passes; }

  // A step and its matrices and samples are written when its pass ends, so that they stand next to
  // each other however many threads draw. Until then there is room kept for them.
  /// False, and counted as lost, when the table is full.
  bool keepStep() { return keep(steps_); }
  bool keepMatrix() { return keep(matrices_); }
  bool keepSample() { return keep(samples_); }
  /// Writes what room was kept for; returns its first index.
  std::uint32_t addStep(const trace::StepRecord& record);
  std::uint32_t addMatrices(std::span<const trace::MatrixRecord> records);
  std::uint32_t addSamples(std::span<const trace::SampleRecord> records);

  /// Room for the pixels of a copy, or null (counted as lost) when there isn't enough or no record
  /// is left. Only the latest room can be given back or taken.
  std::byte* roomForCopy(std::uint64_t bytes);
  /// Index of the copy, whose pixels are in the latest room.
  std::uint32_t addCopy(trace::CopyRecord record);
  void setStepOfCopy(std::uint32_t copy, std::uint32_t step);
  void loseCopy();

private:
  struct Table {
    const char* name;
    std::uint32_t limit;
    std::uint32_t& lost;
    std::uint32_t kept = 0;
    bool said = false;
  };
  bool keep(Table& table);
  void lose(Table& table);
  template <typename Record>
  std::uint32_t append(std::span<const Record> records, Record* table, std::uint32_t& count);
  void publish();

  trace::Counts counts_{};
  trace::Tables* tables_;
  std::byte* copies_;
  std::uint64_t copyRoom_;
  Table passes_{"passes", trace::kMaxPasses, counts_.passesLost};
  Table steps_{"steps", trace::kMaxSteps, counts_.stepsLost};
  Table matrices_{"matrices", trace::kMaxMatrices, counts_.matricesLost};
  Table samples_{"sampled textures", trace::kMaxSamples, counts_.samplesLost};
  Table copiesTable_{"copies", trace::kMaxCopies, counts_.copiesLost};
  bool saidRoom_ = false;
};

} // namespace ggrade::capture::recorder
