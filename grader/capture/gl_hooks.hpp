#pragma once
/// \file
/// Functions of ours that stand before GL functions. Every way that a program has to a function
/// (linked, glfwGetProcAddress, glXGetProcAddress, dlsym) leads through them.
///
/// A file of hooks declares one `next` pointer and one function a name, and lists them:
/// \code
/// decltype(&glFinish) nextFinish;
/// void APIENTRY hookFinish() { ++finishes; nextFinish(); }
/// const Hook kHooks[] = {GG_HOOK(glFinish, hookFinish, nextFinish)};
/// \endcode
/// `next` is set before the hook can be called, and not before: the library's own code calls
/// `real`. Several files may hook one name: a later file's hook is called first, and its `next` is
/// the earlier file's hook. The order of files stands in gl_hooks.cpp.

#include "capture/gl_forward.hpp"

#include <span>

namespace ggrade::capture {

struct Hook {
  const char* name;
  GlFunction function;
  void (*setNext)(GlFunction); ///< null when the hook calls nothing on
};

#define GG_HOOK(name, hook, next)                                                                  \
  ::ggrade::capture::Hook {                                                                        \
#name, reinterpret_cast < ::ggrade::capture::GlFunction>(hook),                                \
        [](::ggrade::capture::GlFunction                                                           \
               function) { (next) = reinterpret_cast<decltype(next)>(function); }                  \
  }

/// The outermost hook of `name`, or null. A name that OSMesa lacks has only hooks without a `next`.
GlFunction hookedGlFunction(const char* name);

std::span<const Hook> debugHooks();
std::span<const Hook> drawHooks();
std::span<const Hook> errorHooks();
std::span<const Hook> glxHooks();
std::span<const Hook> imageHooks();
std::span<const Hook> queryHooks();
std::span<const Hook> shaderTimeHooks();
std::span<const Hook> windowBufferHooks();

} // namespace ggrade::capture
