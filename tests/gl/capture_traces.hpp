#pragma once
/// \file
/// Runs a test program with its passes recorded, and says in one line what a pass, step or sampled
/// texture is, so that a test compares lines.

#include "capture_run.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace ggrade::test {

/// Passes with copies of everything, of every frame.
trace::Request everything();

/// Runs `program` with `scenario` as its argument and a window of 8 x 8 pixels. Fails the test
/// when the program or the channel went wrong.
CaptureRun record(const std::string& program, const std::string& scenario, int frames = 1,
                  const trace::Request& request = everything());

/// "draw color0=texture 1 RGBA8 8x8; 2 draws; drawn color0; cleared color0; written color0": the
/// images (of the window only its colour), draws, draw buffers, and masks that aren't empty.
std::string line(const trace::PassRecord& pass);
std::vector<std::string> lines(const std::vector<trace::PassRecord>& passes);

/// "uTexture unit 0: texture 1 RGBA8 8x8, writer 2"
std::string line(const trace::SampleRecord& sample);
std::vector<std::string> samplesOf(const trace::Trace& trace, std::uint32_t step);

/// The components of a copy's pixel as numbers, x and y counted from the top left.
std::vector<double> valueOf(const trace::Trace& trace, const trace::CopyRecord& copy,
                            std::uint32_t x, std::uint32_t y);
/// Of the attachment's copy after a whole pass; empty if there is none.
std::vector<double> valueAfter(const trace::Trace& trace, std::uint32_t pass,
                               std::uint32_t attachment, std::uint32_t x = 0, std::uint32_t y = 0);

} // namespace ggrade::test
