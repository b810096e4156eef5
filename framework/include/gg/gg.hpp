#pragma once
/// \file
/// All that a student's program needs, in one header that is compiled once and reused.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <gg/gl.hpp>
#include <gg/math.hpp>

#include <gg/app.hpp>
#include <gg/error.hpp>
#include <gg/exit_code.hpp>
#include <gg/handle.hpp>
#include <gg/light.hpp>
#include <gg/mesh.hpp>
#include <gg/mesh_data.hpp>
#include <gg/program.hpp>
#include <gg/scene.hpp>
#include <gg/texture.hpp>
#include <gg/uniform_buffer.hpp>
#include <gg/window.hpp>

// After all of the framework's own functions: what follows are the program's own calls.
#include <gg/call_place.hpp>
#include <glad/placed.h>
