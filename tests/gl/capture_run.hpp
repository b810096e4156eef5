#pragma once
/// \file
/// Runs a test program under the capture library and hands back everything that came of it.

#include "capture/channel_reader.hpp"

#include <string>
#include <utility>
#include <vector>

namespace ggrade::test {

struct CaptureRun {
  channel::Capture capture;
  int exitCode = -1; ///< -1 if a signal ended it
  int signal = 0;
  std::string output;
  std::string errors; ///< stderr
};

struct CaptureOptions {
  std::vector<std::string> arguments;
  std::vector<std::pair<std::string, std::string>> environment;
  trace::Request trace{}; ///< what to record of the passes
  std::vector<channel::PassPixels> replacements{};
};

/// `program` is a name in the folder of test programs, or a path. It is killed after a minute.
CaptureRun runCaptured(const std::string& program, const std::vector<channel::PlannedFrame>& frames,
                       const CaptureOptions& options = {});

/// As above with any descriptor under GG_CAPTURE_FD; -1 for none. Leaves `capture` empty.
CaptureRun runWithDescriptor(const std::string& program, int descriptor,
                             const CaptureOptions& options = {});

/// RGBA of a pixel, counted from the top left.
std::vector<int> pixel(const channel::CapturedFrame& frame, std::uint32_t x, std::uint32_t y);

/// Texts of the messages of one kind, in order of their first coming.
std::vector<std::string> texts(const channel::Capture& capture, channel::MessageKind kind);

} // namespace ggrade::test
