#pragma once
/// \file
/// Recorded passes, read as rubrics, reports and the diagnosis read them.

#include "require.hpp"

#include "trace/trace.hpp"

#include <cstring>

namespace ggrade {

inline void lookAt(const trace::Trace& trace) {
  for (std::size_t i = 0; i < trace.frames.size(); ++i)
    for (const trace::PassRecord& pass : trace.passesOf(i))
      for (const trace::StepRecord& step : trace.stepsOf(pass)) {
        for (const trace::MatrixRecord& matrix : trace.matricesOf(step))
          require(std::memchr(matrix.name, 0, sizeof matrix.name));
        for (const trace::SampleRecord& sample : trace.samplesOf(step))
          require(sample.writer == trace::kNone || sample.writer < trace.passes.size());
      }
  for (const trace::CopyRecord& copy : trace.copies)
    require(trace.image(copy).pixelCount() == std::size_t{copy.width} * copy.height);
  trace::toJson(trace);
}

} // namespace ggrade
