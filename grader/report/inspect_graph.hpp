#pragma once
/// \file
/// Which pass of a frame reads what from which.

#include "trace/trace.hpp"

#include <span>
#include <string>
#include <vector>

namespace ggrade::report {

/// A pass reads what another (or, in a feedback loop, itself) drew last. Passes are indices in the
/// trace.
struct PassRead {
  std::uint32_t writer = 0, reader = 0;
  std::uint32_t attachment = 0; ///< of the writer; trace::kNone when it can't be told
};

/// The passes of one frame. Holds a reference to the trace.
class FrameGraph {
public:
  /// A trace without frames counts as one unfinished frame of all its passes.
  FrameGraph(const trace::Trace& trace, std::size_t frame);

  const trace::Trace& trace() const { return trace_; }
  std::uint32_t first() const { return first_; }
  std::uint32_t count() const { return count_; }
  bool holds(std::uint32_t pass) const { return pass >= first_ && pass - first_ < count_; }
  const trace::PassRecord& pass(std::uint32_t index) const { return trace_.passes[index]; }
  /// As people count: 1 for the frame's first.
  std::uint32_t number(std::uint32_t pass) const { return pass - first_ + 1; }

  /// Every pair once, by reader; writers of earlier frames are left out.
  std::span<const PassRead> reads() const { return reads_; }
  std::vector<PassRead> readsOf(std::uint32_t pass) const;
  std::vector<PassRead> readersOf(std::uint32_t pass) const;
  /// Is the next pass that draws with one of its images one that doesn't clear it first?
  bool isDrawnOver(std::uint32_t pass) const;

  /// The pass of this frame that wrote this attachment of `pass` last before it; kNone: none did.
  std::uint32_t writerBefore(std::uint32_t pass, std::uint32_t attachment) const;

private:
  const trace::Trace& trace_;
  std::uint32_t first_ = 0, count_ = 0;
  std::vector<PassRead> reads_;
};

bool drawsToWindow(const trace::PassRecord& pass);

} // namespace ggrade::report
