// No joystick is ever connected.

#include "capture/glfw/library.hpp"

#include <cstring>

using namespace ggrade::capture;

namespace {

GLFWjoystickfun joystickCallback = nullptr;

/// False after reporting what is wrong.
bool valid(int joystick) {
  if (!requireInit()) return false;
  if (joystick >= GLFW_JOYSTICK_1 && joystick <= GLFW_JOYSTICK_LAST) return true;
  reportError(GLFW_INVALID_ENUM, "Invalid joystick ID %i", joystick);
  return false;
}

template <typename Value> const Value* noValues(int joystick, int* count) {
  *count = 0;
  valid(joystick);
  return nullptr;
}

} // namespace

extern "C" {

int glfwJoystickPresent(int joystick) {
  valid(joystick);
  return GLFW_FALSE;
}

const float* glfwGetJoystickAxes(int joystick, int* count) {
  return noValues<float>(joystick, count);
}

const unsigned char* glfwGetJoystickButtons(int joystick, int* count) {
  return noValues<unsigned char>(joystick, count);
}

const unsigned char* glfwGetJoystickHats(int joystick, int* count) {
  return noValues<unsigned char>(joystick, count);
}

const char* glfwGetJoystickName(int joystick) {
  valid(joystick);
  return nullptr;
}

const char* glfwGetJoystickGUID(int joystick) {
  valid(joystick);
  return nullptr;
}

void glfwSetJoystickUserPointer(int joystick, void* /*pointer*/) {
  valid(joystick);
}

void* glfwGetJoystickUserPointer(int joystick) {
  valid(joystick);
  return nullptr;
}

int glfwJoystickIsGamepad(int joystick) {
  valid(joystick);
  return GLFW_FALSE;
}

GLFWjoystickfun glfwSetJoystickCallback(GLFWjoystickfun callback) {
  GG_REQUIRE_INIT_OR(nullptr);
  return exchange(joystickCallback, callback);
}

int glfwUpdateGamepadMappings(const char* /*mappings*/) {
  GG_REQUIRE_INIT_OR(GLFW_FALSE);
  return GLFW_TRUE;
}

const char* glfwGetGamepadName(int joystick) {
  valid(joystick);
  return nullptr;
}

int glfwGetGamepadState(int joystick, GLFWgamepadstate* state) {
  std::memset(state, 0, sizeof(*state));
  valid(joystick);
  return GLFW_FALSE;
}

} // extern "C"
