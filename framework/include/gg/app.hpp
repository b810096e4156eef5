#pragma once
/// \file
/// The one function that a student's program defines. The framework's `main` calls it.

namespace gg {
class Scene;
}

/// Opens the window, makes what it draws with, and loops until the window is closed.
///   scene: what to draw, as read from scene.json
/// What it throws is printed as `name: what happened`, and ends the program (see exit_code.hpp).
void app(const gg::Scene& scene);
