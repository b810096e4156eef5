#pragma once
/// \file
/// Results with synthetic pictures, as grading makes them: for the tests of the reports, and to
/// look at.

#include "results/results.hpp"

namespace ggrade::report::samples {

/// What is wrong with the picture of a reflecting floor.
enum class Fault { none, noReflection, flatReflection, shiftedReflection };

/// Six balls in a ring over a reflecting, chequered floor: `width x height` RGBA, 0 to 1.
Image picture(Fault fault, double time, double turn = 0, int width = 640, int height = 480);

/// Everything full, the bonus too. One public scene and two hidden ones, two frames each.
results::Result perfect(int width = 640, int height = 480);
/// Loses points in the hidden scenes; some of its texts name a hidden scene and a position.
results::Result partial(int width = 640, int height = 480);
/// Compiler output with two errors and a warning, no frames.
results::Result buildFailed();
/// A crash in the first scene.
results::Result crashed();
/// Never swapped buffers.
results::Result noFrame();
/// Every text holds markup, quotes, escape sequences, a right-to-left override or bytes that aren't
/// UTF-8, and the outputs are 1 MB long.
results::Result hostile();

/// How often `word` stands in `text`.
std::size_t count(const std::string& text, const std::string& word);

} // namespace ggrade::report::samples
