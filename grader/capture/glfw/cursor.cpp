// Cursors exist as handles; nothing shows them.

#include "capture/glfw/library.hpp"

#include <algorithm>

using namespace ggrade::capture;

namespace {

GLFWcursor* newCursor() {
  return library().cursors.emplace_back(std::make_unique<GLFWcursor>()).get();
}

} // namespace

extern "C" {

GLFWcursor* glfwCreateCursor(const GLFWimage* image, int /*xHot*/, int /*yHot*/) {
  GG_REQUIRE_INIT_OR(nullptr);
  if (image->width <= 0 || image->height <= 0) {
    reportError(GLFW_INVALID_VALUE, "Invalid image dimensions for cursor");
    return nullptr;
  }
  return newCursor();
}

GLFWcursor* glfwCreateStandardCursor(int shape) {
  GG_REQUIRE_INIT_OR(nullptr);
  switch (shape) {
  case GLFW_ARROW_CURSOR:
  case GLFW_IBEAM_CURSOR:
  case GLFW_CROSSHAIR_CURSOR:
  case GLFW_HAND_CURSOR:
  case GLFW_HRESIZE_CURSOR:
  case GLFW_VRESIZE_CURSOR:
    return newCursor();
  default:
    reportError(GLFW_INVALID_ENUM, "Invalid standard cursor 0x%08X", static_cast<unsigned>(shape));
    return nullptr;
  }
}

void glfwDestroyCursor(GLFWcursor* cursor) {
  GG_REQUIRE_INIT();
  std::erase_if(library().cursors, [cursor](const auto& known) { return known.get() == cursor; });
}

void glfwSetCursor(GLFWwindow* /*window*/, GLFWcursor* /*cursor*/) {
  GG_REQUIRE_INIT();
}

} // extern "C"
