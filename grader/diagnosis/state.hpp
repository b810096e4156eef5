#pragma once
/// \file
/// States of OpenGL in which drawing shows nothing, as the recorder saw them.

#include "trace/trace.hpp"

#include <set>
#include <string>
#include <vector>

namespace ggrade::diagnosis {

/// One sentence on each state that explains a window without a picture: a closed colour mask, an
/// empty scissor or viewport, a depth test that nothing passes, a clear after the last draw, ...
/// For a program whose picture is wrong: a right one may have reasons for some of them.
std::vector<std::string> stateFaults(const trace::Trace& trace);

/// Names of the samplers that read a texture in the first frame.
std::set<std::string> samplersWithTexture(const trace::Trace& trace);

} // namespace ggrade::diagnosis
