#pragma once
/// \file
/// Hooks that are made from a function of our own, so that a list of names is all that a file of
/// hooks needs.

#include "capture/gl_hooks.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace ggrade::capture {

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
