#include "capture/recorder/table_writer.hpp"

#include "capture/channel_writer.hpp"

#include <algorithm>

namespace ggrade::capture::recorder {
namespace {

// Copies begin where their largest values, 4-byte floats in fours, may begin.
constexpr std::uint64_t kCopyAlignment = 16;

constexpr std::uint64_t aligned(std::uint64_t offset) {
  return (offset + kCopyAlignment - 1) / kCopyAlignment * kCopyAlignment;
}

} // namespace

TableWriter::TableWriter()
    : tables_(recordTables()), copies_(recordCopies()), copyRoom_(plan()->trace.copyBytes) {}

bool TableWriter::keep(Table& table) {
  if (table.kept < table.limit) {
    ++table.kept;
    return true;
  }
  lose(table);
  return false;
}

void TableWriter::lose(Table& table) {
  if (table.lost != UINT32_MAX) ++table.lost;
  if (!table.said) {
    say("the run has more than %u %s; no more are recorded", table.limit, table.name);
    table.said = true;
  }
  publish();
}

void TableWriter::publish() {
  tables_->counts = counts_;
}

template <typename Record>
std::uint32_t TableWriter::append(std::span<const Record> records, Record* table,
                                  std::uint32_t& count) {
  const std::uint32_t first = count;
  std::copy(records.begin(), records.end(), table + first);
  count += static_cast<std::uint32_t>(records.size());
  publish();
  return first;
}

std::uint32_t TableWriter::addPass(const trace::PassRecord& record) {
  if (!keep(passes_)) return trace::kNone;
  return append(std::span(&record, 1), tables_->passes, counts_.passes);
}

void TableWriter::setPass(std::uint32_t index, const trace::PassRecord& record) {
  tables_->passes[index] = record;
}

std::uint32_t TableWriter::addStep(const trace::StepRecord& record) {
  return append(std::span(&record, 1), tables_->steps, counts_.steps);
}

std::uint32_t TableWriter::addMatrices(std::span<const trace::MatrixRecord> records) {
  return append(records, tables_->matrices, counts_.matrices);
}

std::uint32_t TableWriter::addSamples(std::span<const trace::SampleRecord> records) {
  return append(records, tables_->samples, counts_.samples);
}

std::byte* TableWriter::roomForCopy(std::uint64_t bytes) {
  if (counts_.copies == trace::kMaxCopies) {
    lose(copiesTable_);
    return nullptr;
  }
  const std::uint64_t offset = aligned(counts_.copyBytes);
  if (offset > copyRoom_ || bytes > copyRoom_ - offset) {
    if (!saidRoom_) {
      say("the copies of the passes need more than %llu bytes; some are left out",
          static_cast<unsigned long long>(copyRoom_));
      saidRoom_ = true;
    }
    loseCopy();
    return nullptr;
  }
  return copies_ + offset;
}

std::uint32_t TableWriter::addCopy(trace::CopyRecord record) {
  record.offset = aligned(counts_.copyBytes);
  counts_.copyBytes = record.offset + record.bytes;
  return append(std::span<const trace::CopyRecord>(&record, 1), tables_->copies, counts_.copies);
}

void TableWriter::setStepOfCopy(std::uint32_t copy, std::uint32_t step) {
  tables_->copies[copy].step = step;
}

void TableWriter::loseCopy() {
  if (counts_.copiesLost != UINT32_MAX) ++counts_.copiesLost;
  publish();
}

} // namespace ggrade::capture::recorder
