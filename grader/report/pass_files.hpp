#pragma once
/// \file
/// What `ggrade render --passes` writes besides the frames.

#include "trace/trace.hpp"

namespace ggrade::report {

/// Writes a picture of every copy as `folder`/frame-F/pass-PP-ATTACHMENT.png, of one after a step
/// as pass-PP-step-S-ATTACHMENT.png: P is the pass's index in trace.json, S the step's in its pass.
/// `raw`: its values too, as width x height x channels 4-byte floats, little endian, top row first,
/// in files that end in .f32. Names in the result are relative to `folder`. Throws
/// std::runtime_error with the path and the cause.
std::vector<trace::CopyFiles> writePassFiles(const trace::Trace& trace,
                                             const std::filesystem::path& folder, bool raw);

} // namespace ggrade::report
