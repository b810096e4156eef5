#pragma once
/// \file
/// A uniform block's contents.

#include <gg/handle.hpp>
#include <gg/light.hpp>

namespace gg {

namespace detail {
void createUniformBuffer(GLuint buffer, GLuint binding, GLsizeiptr bytes);
void loadUniformBuffer(GLuint buffer, GLuint binding, GLsizeiptr bytes, const void* data);
} // namespace detail

/// A buffer that holds one block, bound to its binding point at construction.
///   T: a struct laid out as the block is (std140), such as Light or Material
template <class T> class UniformBuffer {
public:
  explicit UniformBuffer(GLuint binding) : binding_(binding) {
    detail::createUniformBuffer(buffer_, binding_, sizeof(T));
  }

  /// What is drawn from now on sees this value. Calls glBindBufferBase, glBufferSubData.
  void load(const T& value) const {
    detail::loadUniformBuffer(buffer_, binding_, sizeof(T), &value);
  }

  operator GLuint() const { return buffer_; }

private:
  Buffer buffer_;
  GLuint binding_;
};

} // namespace gg
