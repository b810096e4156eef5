#pragma once
/// \file
/// The frame doctor: watches a program's OpenGL calls for a frame, and says what would explain a
/// window that stays empty. It needs no KHR_debug: the loader's functions can be watched.

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "doctor_state.hpp"

namespace gg::detail {

/// Watches every call from now on until frameEnds(): before the first frame (`fromStart`) also
/// those by which the program makes its objects. Does nothing if GG_DOCTOR=0 is in the environment.
void watchFrame(bool fromStart);

/// If the frame was watched, prints on stderr what is wrong at its end, each message once, and ends
/// the watch. To be called before the buffers are swapped.
///   window: pixels
/// Returns the framebuffer objects that were drawn into or cleared, in the order in which they were
/// first.
std::vector<GLuint> frameEnds(const glm::ivec2& window);

/// All textures that were bound while calls were watched.
const TextureTargets& knownTextures();

/// Says so if no frame is shown within 3 seconds though the window is cleared again and again, or
/// within 10 seconds whatever happens. Does nothing if GG_DOCTOR=0 is in the environment.
class FirstFrameWatch {
public:
  FirstFrameWatch();
  ~FirstFrameWatch();
  FirstFrameWatch(const FirstFrameWatch&) = delete;
  FirstFrameWatch& operator=(const FirstFrameWatch&) = delete;

  void shown();

private:
  void wait();

  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread thread_;
};

} // namespace gg::detail
