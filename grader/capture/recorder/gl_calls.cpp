#include "capture/recorder/gl_calls.hpp"

namespace ggrade::capture::recorder {

const GlCalls& gl() {
  static const GlCalls calls;
  return calls;
}

GLint integer(GLenum name) {
  GLint value = 0;
  gl().getIntegerv(name, &value);
  return value;
}

} // namespace ggrade::capture::recorder
