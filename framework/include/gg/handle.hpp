#pragma once
/// \file
/// Owners of OpenGL names. Each deletes its object once, when it goes out of scope.

#include <utility>

#include <gg/gl.hpp>

namespace gg {

/// Owns one OpenGL name. Made at construction, so the window must exist; moved, never copied; what
/// was moved from holds 0, which is never deleted. Converts to GLuint, so that it stands in any GL
/// call.
///   Traits: `static GLuint create()` and `static void destroy(GLuint)`
template <class Traits> class Handle {
public:
  Handle() : name_(Traits::create()) {}
  ~Handle() {
    if (name_ != 0) Traits::destroy(name_);
  }
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      if (name_ != 0) Traits::destroy(name_);
      name_ = std::exchange(other.name_, 0);
    }
    return *this;
  }

  operator GLuint() const { return name_; }

private:
  GLuint name_;
};

namespace detail {
// clang-format off
struct TextureTraits      { static GLuint create(); static void destroy(GLuint name); };
struct RenderbufferTraits { static GLuint create(); static void destroy(GLuint name); };
struct FramebufferTraits  { static GLuint create(); static void destroy(GLuint name); };
struct BufferTraits       { static GLuint create(); static void destroy(GLuint name); };
struct VertexArrayTraits  { static GLuint create(); static void destroy(GLuint name); };
struct SamplerTraits      { static GLuint create(); static void destroy(GLuint name); };
struct ProgramTraits      { static GLuint create(); static void destroy(GLuint name); };
// clang-format on
} // namespace detail

using Texture = Handle<detail::TextureTraits>;           ///< glGenTextures
using Renderbuffer = Handle<detail::RenderbufferTraits>; ///< glGenRenderbuffers
using Framebuffer = Handle<detail::FramebufferTraits>;   ///< glGenFramebuffers
using Buffer = Handle<detail::BufferTraits>;             ///< glGenBuffers
using VertexArray = Handle<detail::VertexArrayTraits>;   ///< glGenVertexArrays
using Sampler = Handle<detail::SamplerTraits>;           ///< glGenSamplers

} // namespace gg
