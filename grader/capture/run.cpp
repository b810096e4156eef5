#include "capture/run.hpp"

#include "capture/channel_writer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <unistd.h>

namespace ggrade::capture {
namespace {

constexpr double kFrameSeconds = 1.0 / 60;
constexpr double kCallSeconds = 1e-6;
constexpr double kNanoseconds = 1e9;

// How long a program may go on after the window has asked to close. Polling is cheap and a program
// that waits for the clock in a polling loop needs 33,333 polls for a thirtieth of a second.
constexpr std::uint32_t kMaxSwapsIgnored = 3;
constexpr std::uint32_t kMaxPollsIgnored = 100'000;
constexpr std::uint32_t kMaxWaitsIgnored = 1000;
// A loop that draws to the window, asks whether to close, and never swaps.
constexpr std::uint32_t kMaxRoundsUnswapped = 60;

/// Frames after which the window asks to close; 0 for never.
std::uint32_t frameLimit() {
  static const std::uint32_t limit = [] {
    if (plan()) return plan()->frameCount;
    const char* const text = std::getenv("GG_CAPTURE_FRAMES");
    return text ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : 0U;
  }();
  return limit;
}

} // namespace

Run& run() {
  static Run instance;
  return instance;
}

std::uint32_t Run::frame() const {
  const std::lock_guard lock(mutex_);
  return frame_;
}

Size Run::plannedSize(Size asked) const {
  const std::lock_guard lock(mutex_);
  if (!plan()) return asked;
  // After the last frame nothing changes any more.
  const channel::PlannedFrame& planned = plan()->frames[std::min(frame_, plan()->frameCount - 1)];
  return {planned.width ? static_cast<int>(planned.width) : asked.width,
          planned.height ? static_cast<int>(planned.height) : asked.height};
}

double Run::scheduled(std::uint32_t frame) const {
  if (!plan()) return frame * kFrameSeconds;
  const std::uint32_t lastPlanned = plan()->frameCount - 1;
  if (frame <= lastPlanned) return plan()->frames[frame].time;
  return plan()->frames[lastPlanned].time + (frame - lastPlanned) * kFrameSeconds;
}

double Run::now() {
  return scheduled(frame_) + static_cast<double>(clockCalls_++) * kCallSeconds;
}

double Run::time() {
  const std::lock_guard lock(mutex_);
  return now() + offset_;
}

std::uint64_t Run::timerValue() {
  const std::lock_guard lock(mutex_);
  return static_cast<std::uint64_t>(std::llround(now() * kNanoseconds));
}

void Run::setTime(double seconds) {
  const std::lock_guard lock(mutex_);
  offset_ = frame_ == 0 ? seconds : seconds - scheduled(frame_);
}

bool Run::last() const {
  return frameLimit() != 0 && frame_ >= frameLimit();
}

bool Run::endFrame() {
  const std::lock_guard lock(mutex_);
  if (closing_) expectClose(swapsIgnored_, kMaxSwapsIgnored);
  ++frame_;
  clockCalls_ = 0;
  pollsIgnored_ = 0;
  waitsIgnored_ = 0;
  drawsAsked_ = 0;
  roundsUnswapped_ = 0;
  if (closing_ || !last()) return false;
  closing_ = true;
  return true;
}

void Run::polled() {
  const std::lock_guard lock(mutex_);
  expectClose(pollsIgnored_, kMaxPollsIgnored);
}

void Run::waited() {
  const std::lock_guard lock(mutex_);
  expectClose(waitsIgnored_, kMaxWaitsIgnored);
}

void Run::asked(std::uint32_t windowDraws) {
  const std::lock_guard lock(mutex_);
  if (windowDraws > drawsAsked_ && ++roundsUnswapped_ >= kMaxRoundsUnswapped)
    endProgram("the program drew in many rounds of its loop without glfwSwapBuffers; it was ended");
  drawsAsked_ = windowDraws;
}

void Run::expectClose(std::uint32_t& count, std::uint32_t limit) {
  if (closing_ && ++count >= limit)
    endProgram("the program went on after the window had asked to close; it was ended");
}

void Run::endProgram(const char* why) {
  say(why);
  writeEndedByCapture();
  std::cout.flush();
  std::clog.flush();
  std::fflush(nullptr);
  _exit(0);
}

} // namespace ggrade::capture
