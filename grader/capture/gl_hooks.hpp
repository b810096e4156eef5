#pragma once
/// \file
/// From the name of a GL function to the function that serves it: one of ours that stands before
/// it, if there is any. Every way that a program has to a function (linked, glfwGetProcAddress,
/// glXGetProcAddress, dlsym) leads through these.
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

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>

namespace ggrade::capture {

using GlFunction = void (*)();

/// What a program gets when it asks for `name`: the outermost hook, else the context's function,
/// else (a GL function that it lacks, a GLX function) one that says so once and returns 0. Null
/// when no GL or GLX function has that name. All ways to a function give the same address's
/// behaviour.
GlFunction glFunction(const char* name);

/// The context's own function (context.hpp), past all hooks. Null when there is none.
GlFunction realGlFunction(const char* name);

/// `real<decltype(&glFinish)>("glFinish")()`.
template <typename Function> Function real(const char* name) {
  return reinterpret_cast<Function>(realGlFunction(name));
}

/// A number of the current context's state (GLint, GLenum), asked of the context itself.
int integer(unsigned int name);

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

std::span<const Hook> debugHooks();
std::span<const Hook> drawHooks();
std::span<const Hook> errorHooks();
std::span<const Hook> glxHooks();
std::span<const Hook> imageHooks();
std::span<const Hook> queryHooks();
std::span<const Hook> shaderTimeHooks();
std::span<const Hook> tapeHooks();
std::span<const Hook> windowBufferHooks();

// Hooks that are made from a function of our own, so that a list of names is all that a file of
// hooks needs.

/// A GL function's name as a template argument, so that each name gets a hook of its own.
template <std::size_t size> struct Name {
  char text[size];
  consteval Name(const char (&from)[size]) { // NOLINT(google-explicit-constructor)
    std::copy_n(from, size, text);
  }
};

/// Calls `before` with the GL function's arguments, then the function. What `before` returns, if
/// anything, lives until the function has returned.
template <Name name, auto before, typename Function> struct Around;
template <Name name, auto before, typename Result, typename... Arguments>
struct Around<name, before, Result(Arguments...)> {
  static inline Result (*next)(Arguments...) = nullptr;
  static Result call(Arguments... arguments) {
    if constexpr (std::is_void_v<decltype(before(arguments...))>) {
      before(arguments...);
      return next(arguments...);
    } else {
      [[maybe_unused]] const auto scope = before(arguments...);
      return next(arguments...);
    }
  }
};

} // namespace ggrade::capture

/// `GG_AROUND(glFinish, countFinish)` with `constexpr auto countFinish = [] { ++finishes; };`. A
/// lambda in its place would be two.
#define GG_AROUND(name, ...)                                                                       \
  ::ggrade::capture::Hook {                                                                        \
#name,                                                                                         \
        reinterpret_cast <::ggrade::capture::GlFunction>(                                          \
            &::ggrade::capture::Around<#name, __VA_ARGS__, decltype(::name)>::call),               \
        [](::ggrade::capture::GlFunction function) {                                               \
          using This = ::ggrade::capture::Around<#name, __VA_ARGS__, decltype(::name)>;            \
          This::next = reinterpret_cast<decltype(This::next)>(function);                           \
        }   \
  }
