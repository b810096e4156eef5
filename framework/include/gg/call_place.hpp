#pragma once
/// \file
/// Where in the program the OpenGL function is called that runs now, for messages about it.

namespace gg::detail {

struct CallPlace {
  const char* file = nullptr; ///< as the compiler knows it; null: not called yet
  int line = 0;
  bool isNow = false; ///< of the call that runs now, not of one before it
};

/// Of the last call that the program made itself; those of the framework have no place.
inline CallPlace lastCallPlace;

inline void callFrom(const char* file, int line) {
  lastCallPlace = {file, line, true};
}

} // namespace gg::detail

#define GG_PLACED(function) (::gg::detail::callFrom(__FILE__, __LINE__), function)
