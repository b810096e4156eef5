#pragma once

#include <string>

namespace gg::detail {

/// Prints a line on stderr, unless it was printed before in this window's time: what comes every
/// frame is news once.
void printOnce(const std::string& line);
void forgetPrinted();

/// Where the program itself called OpenGL last, as " (floor.cpp:12)"; empty if it never did.
std::string lastPlace();

} // namespace gg::detail
