#pragma once
/// \file
/// The run as a whole: which frame it is, what time and size that frame has, and when the program
/// is to stop. Any thread. Scheduled by the plan of the channel, else 60 frames a second for ever
/// (or GG_CAPTURE_FRAMES).

#include <cstdint>
#include <mutex>

namespace ggrade::capture {

/// Of a window's framebuffer, in pixels.
struct Size {
  int width = 0;
  int height = 0;
  friend bool operator==(const Size&, const Size&) = default;
};

class Run {
public:
  /// Frames handed over so far, which is also the number of the frame being drawn.
  std::uint32_t frame() const;

  /// Size of the frame being drawn when the program asks for `asked`.
  Size plannedSize(Size asked) const;

  /// Seconds of the program's clock: the frame's scheduled time, plus a microsecond for every
  /// earlier call in this frame.
  double time();
  /// The same clock in nanoseconds, which `setTime` does not move.
  std::uint64_t timerValue();
  /// From now on the clock goes on from `seconds`. In frame 0 the scheduled times count from there,
  /// so that a program that starts its clock at 0 sees the plan's times.
  void setTime(double seconds);

  /// The frame has been handed over. True when the window should ask to close now.
  bool endFrame();

  /// The program looked for events. These end a program that was asked to close and doesn't.
  void polled();
  void waited();

  /// The program asked whether to close; `windowDraws` calls have drawn to the window since the
  /// last swap. Ends a program whose loop goes round and round without ever swapping.
  void asked(std::uint32_t windowDraws);

private:
  // Private members expect `mutex_` to be held.
  double scheduled(std::uint32_t frame) const;
  double now();
  bool last() const;
  void expectClose(std::uint32_t& count, std::uint32_t limit);
  [[noreturn]] static void endProgram(const char* why);

  mutable std::mutex mutex_;
  std::uint32_t frame_ = 0;
  std::uint64_t clockCalls_ = 0; ///< in this frame
  double offset_ = 0;
  bool closing_ = false;
  std::uint32_t swapsIgnored_ = 0;
  std::uint32_t pollsIgnored_ = 0;
  std::uint32_t waitsIgnored_ = 0;
  std::uint32_t drawsAsked_ = 0; ///< to the window, when the program last asked
  std::uint32_t roundsUnswapped_ = 0;
};

Run& run();

} // namespace ggrade::capture
