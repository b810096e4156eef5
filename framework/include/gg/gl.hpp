#pragma once
/// \file
/// OpenGL 4.1 core's functions and GLFW, in the order in which they must be included.

#include <glad/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
