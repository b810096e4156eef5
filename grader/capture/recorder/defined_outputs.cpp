#include "capture/recorder/defined_outputs.hpp"

#include "capture/context_state.hpp"
#include "capture/gl_hooks.hpp"
#include "capture/recorder/gl_calls.hpp"
#include "capture/recorder/programs.hpp"

namespace ggrade::capture::recorder {

namespace {

bool isInDisplayList() {
  const bool isCore = integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT;
  return !isCore && integer(GL_LIST_INDEX) != 0;
}

} // namespace

DefinedOutputs::DefinedOutputs() {
  const GLint program = integer(GL_CURRENT_PROGRAM);
  if (!currentState() || program == 0) return;
  const std::uint32_t outputs = outputsOf(GLuint(program));
  const GLuint buffers = integer(GL_DRAW_FRAMEBUFFER_BINDING) == 0 ? 1 : trace::kColors;
  for (GLuint i = 0; i < buffers; ++i) {
    if (outputs >> i & 1 || integer(GL_DRAW_BUFFER0 + i) == GL_NONE) continue;
    if (masks_.empty() && isInDisplayList()) return;
    auto& [buffer, mask] = masks_.emplace_back();
    buffer = i;
    gl().getBooleani_v(GL_COLOR_WRITEMASK, i, mask.data());
    gl().colorMaski(i, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
}

DefinedOutputs::~DefinedOutputs() {
  for (const auto& [buffer, mask] : masks_)
    gl().colorMaski(buffer, mask[0], mask[1], mask[2], mask[3]);
}

} // namespace ggrade::capture::recorder
