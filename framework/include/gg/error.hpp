#pragma once
/// \file
/// What the framework throws. Each message names what was wrong and where.

#include <stdexcept>

namespace gg {

/// A scene or assignment file that can't be used: `scene.json:12: camera.fov: must be ...`.
struct SceneError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A shader that doesn't compile or link: `object.frag:12:5: error: ...`, the line and a caret.
struct ShaderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// No window, or no OpenGL 4.1 in it. The message names the driver that was found.
struct WindowError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A mesh or image file that can't be used: `bunny.obj:7: face needs three corners`.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

} // namespace gg
