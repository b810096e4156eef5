#include "capture/recorder/gl_calls.hpp"

namespace ggrade::capture::recorder {

const GlCalls& gl() {
  static const GlCalls calls;
  return calls;
}

} // namespace ggrade::capture::recorder
