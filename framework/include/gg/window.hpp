#pragma once
/// \file
/// The window and its OpenGL context.

#include <memory>
#include <string>

#include <gg/gl.hpp>
#include <glm/vec2.hpp>

namespace gg {

namespace detail {
class Live;
}

/// A window with an OpenGL 4.1 core context, current as long as the window lives.
///
/// `while (window) { ...; window.swapBuffers(); }` draws until it is closed; Esc closes it. T shows
/// every texture that the frame draws into, space stops the time and the arrow keys step it, F12
/// saves the picture. When its size changes, the viewport is set to the whole of it, at the end of
/// swapBuffers().
class Window {
public:
  /// Opens it and loads the GL functions. Throws WindowError, which names the driver that was found
  /// and what helps.
  ///   title: UTF-8;  size: width and height in screen coordinates (on most displays pixels)
  Window(const std::string& title, const glm::ivec2& size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Go on drawing?
  explicit operator bool() const;

  /// Shows what was drawn and reads what the user did (glfwSwapBuffers, glfwPollEvents).
  void swapBuffers();

  int width() const;  ///< pixels, at least 1
  int height() const; ///< pixels, at least 1
  float aspect() const { return static_cast<float>(width()) / static_cast<float>(height()); }

  GLFWwindow* handle() const { return window_; }

private:
  GLFWwindow* window_ = nullptr;
  std::unique_ptr<detail::Live> live_;
};

} // namespace gg
