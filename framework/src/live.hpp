#pragma once
/// \file
/// What a window does for whoever works on the program that draws in it: the frame doctor, shaders
/// that are saved, and a few keys.

#include <memory>
#include <optional>
#include <string>

#include "doctor.hpp"
#include "overlay.hpp"

namespace gg::detail {

/// Keys: T shows every texture of the frame; space stops the time, the arrow keys step it by a
/// tenth of a second; F12 saves the picture.
class Live {
public:
  /// The window's context must be current, and its functions loaded.
  Live(GLFWwindow* window, std::string title);

  void keyPressed(int key);
  /// Before and after the buffers are swapped. `size`: pixels
  void frameEnds(const glm::ivec2& size);
  void frameBegins();

private:
  void showErrors(const std::string& errors, const glm::ivec2& size);
  void save(const glm::ivec2& size);
  Overlay& overlay();

  GLFWwindow* window_;
  std::string title_, shownErrors_;
  FirstFrameWatch firstFrame_;
  std::unique_ptr<Overlay> overlay_;
  std::optional<double> stoppedAt_; ///< seconds
  bool tiles_ = false, save_ = false;
};

} // namespace gg::detail
