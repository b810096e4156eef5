#pragma once
/// \file
/// What a program's exit status says about how it ended.

namespace gg {

enum class ExitCode : int {
  ok = 0,        ///< the window was closed
  exception = 1, ///< app() threw something that has no code of its own
  scene = 2,     ///< SceneError: a scene or assignment file that can't be used
  shader = 3,    ///< ShaderError: a shader that doesn't compile or link, or isn't there
  window = 4,    ///< WindowError: no window or no OpenGL 4.1
  usage = 5,     ///< wrong arguments on the command line
};

} // namespace gg
