#pragma once

namespace ggrade::capture {

/// Forgets the monitor's user pointer, gamma ramp and callback (glfwTerminate).
void resetMonitor();

} // namespace ggrade::capture
