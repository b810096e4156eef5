#include <gg/uniform_buffer.hpp>

namespace gg::detail {

void createUniformBuffer(GLuint buffer, GLuint binding, GLsizeiptr bytes) {
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
  glBufferData(GL_UNIFORM_BUFFER, bytes, nullptr, GL_DYNAMIC_DRAW);
}

// Bound anew each time, so that two buffers for one binding point can take turns.
void loadUniformBuffer(GLuint buffer, GLuint binding, GLsizeiptr bytes, const void* data) {
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
  glBufferSubData(GL_UNIFORM_BUFFER, 0, bytes, data);
}

} // namespace gg::detail
