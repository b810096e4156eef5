#pragma once
/// \file
/// From the name of a GL function to the function that serves it.

namespace ggrade::capture {

using GlFunction = void (*)();

/// What a program gets when it asks for `name`: the outermost hook, else OSMesa's function, else (a
/// GL function that OSMesa lacks, a GLX function) one that says so once and returns 0. Null when no
/// GL or GLX function has that name. All ways to a function give the same address's behaviour.
GlFunction glFunction(const char* name);

/// OSMesa's own function, past all hooks. Null when OSMesa lacks it.
GlFunction realGlFunction(const char* name);

/// `real<decltype(&glFinish)>("glFinish")()`.
template <typename Function> Function real(const char* name) {
  return reinterpret_cast<Function>(realGlFunction(name));
}

/// A number of the current context's state (GLint, GLenum), asked of OSMesa itself.
int integer(unsigned int name);

} // namespace ggrade::capture
