#include "grading/submitted.hpp"

#include <algorithm>

namespace ggrade::grading {

diagnosis::Facts factsOf(const channel::Capture& capture, const std::filesystem::path& folder) {
  diagnosis::Facts facts;
  for (const channel::CapturedFrame& frame : capture.frames)
    facts.frames.push_back({frame.windowDraws, frame.boundFramebuffer});
  for (const trace::PassRecord& pass : trace::load(folder).passes) {
    if (pass.framebuffer == 0 || pass.framebuffer == trace::kNone || pass.draws == 0) continue;
    const std::string status = trace::glName(pass.status);
    if (status != "FRAMEBUFFER_COMPLETE" &&
        std::ranges::find(facts.incomplete, status) == facts.incomplete.end())
      facts.incomplete.push_back(status);
  }
  return facts;
}

} // namespace ggrade::grading
