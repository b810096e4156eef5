#include "capture/glfw/library.hpp"

#include <cmath>

using namespace ggrade::capture;

namespace {
constexpr double kLongestTime = 18446744073.0; // GLFW's own limit
} // namespace

extern "C" {

double glfwGetTime() {
  GG_REQUIRE_INIT_OR(0.0);
  return run().time();
}

void glfwSetTime(double time) {
  GG_REQUIRE_INIT();
  if (std::isnan(time) || time < 0.0 || time > kLongestTime) {
    reportError(GLFW_INVALID_VALUE, "Invalid time %f", time);
    return;
  }
  run().setTime(time);
}

uint64_t glfwGetTimerValue() {
  GG_REQUIRE_INIT_OR(0);
  return run().timerValue();
}

uint64_t glfwGetTimerFrequency() {
  GG_REQUIRE_INIT_OR(0);
  return 1'000'000'000;
}

} // extern "C"
