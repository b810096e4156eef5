// GLX: there is no X server here, so only the way to GL functions works. The rest returns 0 (and
// says so once, see gl_hooks.cpp), apart from what loaders such as GLEW ask before they go on.

#include "capture/context.hpp"
#include "capture/gl_hooks.hpp"

#include <cstdint>

namespace ggrade::capture {
namespace {

GlFunction getProcAddress(const unsigned char* name) {
  return glFunction(reinterpret_cast<const char*>(name));
}

void* getCurrentContext() {
  return contextLibrary().current();
}

/// GLEW gives up without a display. Whoever reads Xlib's private fields out of this one finds
/// zeros.
void* getCurrentDisplay() {
  static std::uint64_t nothing[512];
  return contextLibrary().current() ? nothing : nullptr;
}

int queryVersion(void* /*display*/, int* major, int* minor) {
  *major = 1;
  *minor = 4;
  return 1;
}

const char* noString(void* /*display*/, int /*screenOrName*/) {
  return "";
}
const char* noServerString(void* /*display*/, int /*screen*/, int /*name*/) {
  return "";
}

const Hook kGlxHooks[] = {
    {"glXGetProcAddress", reinterpret_cast<GlFunction>(getProcAddress), nullptr},
    {"glXGetProcAddressARB", reinterpret_cast<GlFunction>(getProcAddress), nullptr},
    {"glXGetCurrentContext", reinterpret_cast<GlFunction>(getCurrentContext), nullptr},
    {"glXGetCurrentDisplay", reinterpret_cast<GlFunction>(getCurrentDisplay), nullptr},
    {"glXQueryVersion", reinterpret_cast<GlFunction>(queryVersion), nullptr},
    {"glXGetClientString", reinterpret_cast<GlFunction>(noString), nullptr},
    {"glXQueryExtensionsString", reinterpret_cast<GlFunction>(noString), nullptr},
    {"glXQueryServerString", reinterpret_cast<GlFunction>(noServerString), nullptr},
};

} // namespace

std::span<const Hook> glxHooks() {
  return kGlxHooks;
}

} // namespace ggrade::capture

// libGLX exports these two for libGL alone. They are here because the names must be.
extern "C" {
[[gnu::visibility(
    "default")]] char __GLXGL_CORE_FUNCTIONS[8] = {}; // NOLINT(bugprone-reserved-identifier)
[[gnu::visibility("default")]] void*
__glXGLLoadGLXFunction(const char*, void*, void*); // NOLINT(bugprone-reserved-identifier)
void* __glXGLLoadGLXFunction(const char* /*name*/, void* /*slot*/, void* /*mutex*/) {
  return nullptr;
}
}
