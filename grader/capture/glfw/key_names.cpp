// Names and scancodes of a US keyboard. Scancodes are the key numbers themselves.

#include "capture/glfw/library.hpp"

#include <array>

using namespace ggrade::capture;

namespace {

bool known(int key) {
  return key >= GLFW_KEY_SPACE && key <= GLFW_KEY_LAST;
}

/// One-letter strings for every ASCII character.
const char* letter(int character) {
  static const auto table = [] {
    std::array<std::array<char, 2>, 128> letters{};
    for (std::size_t i = 0; i < letters.size(); ++i) letters[i] = {static_cast<char>(i), 0};
    return letters;
  }();
  return table[static_cast<std::size_t>(character)].data();
}

/// As GLFW: printable keys and the key pad's have names, the space bar has none.
const char* nameOf(int key) {
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return letter(key - 'A' + 'a');
  if (key > GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT) return letter(key);
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return letter('0' + key - GLFW_KEY_KP_0);
  switch (key) {
  case GLFW_KEY_KP_DECIMAL:
    return letter('.');
  case GLFW_KEY_KP_DIVIDE:
    return letter('/');
  case GLFW_KEY_KP_MULTIPLY:
    return letter('*');
  case GLFW_KEY_KP_SUBTRACT:
    return letter('-');
  case GLFW_KEY_KP_ADD:
    return letter('+');
  case GLFW_KEY_KP_EQUAL:
    return letter('=');
  default:
    return nullptr;
  }
}

} // namespace

extern "C" {

const char* glfwGetKeyName(int key, int scancode) {
  GG_REQUIRE_INIT_OR(nullptr);
  return nameOf(key == GLFW_KEY_UNKNOWN ? scancode : key);
}

int glfwGetKeyScancode(int key) {
  GG_REQUIRE_INIT_OR(-1);
  if (known(key)) return key;
  reportError(GLFW_INVALID_ENUM, "Invalid key %i", key);
  return GLFW_RELEASE;
}

} // extern "C"
