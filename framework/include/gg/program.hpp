#pragma once
/// \file
/// A shader program made from files beside the student's program.

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

#include <gg/handle.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace gg {

namespace detail {
struct ProgramState;
}

/// A linked program.
///
/// A file's ending names its stage: .vert .tesc .tese .geom .frag. `#include "name"` is looked up
/// in the program's folder, then among the framework's own shaders (gg/lighting.glsl); a file is
/// included once a stage, however often it is named. Blocks called Light and Material are bound to
/// kLightBinding and kMaterialBinding.
///
/// While the window is open, a file that is saved is compiled again at the end of a frame; the
/// program keeps its name and its uniforms. One that doesn't compile goes on as it was.
class Program {
public:
  /// Compiles and links. Throws ShaderError with file, line, column, the line itself and a caret.
  ///   folder: where the files are (UTF-8); empty is the program's own folder
  explicit Program(std::initializer_list<const char*> files, const std::string& folder = {});
  ~Program();
  Program(Program&&) noexcept;
  Program& operator=(Program&&) noexcept;

  /// glUseProgram.
  void use() const;

  /// Sets a uniform, whether or not the program is in use (glProgramUniform). A name that the
  /// shaders don't have, or a value of another type, is reported once on stderr. A uniform that is
  /// written in the shaders but has no effect there is left alone silently.
  void set(std::string_view name, bool value) const;
  void set(std::string_view name, int value) const;
  void set(std::string_view name, float value) const;
  void set(std::string_view name, double value) const { set(name, static_cast<float>(value)); }
  void set(std::string_view name, const glm::vec2& value) const;
  void set(std::string_view name, const glm::vec3& value) const;
  void set(std::string_view name, const glm::vec4& value) const;
  void set(std::string_view name, const glm::mat3& value) const;
  void set(std::string_view name, const glm::mat4& value) const;
  /// A sampler takes the number of a texture unit (an int), not the name of a texture.
  void set(std::string_view name, GLuint value) const = delete;

  operator GLuint() const;

private:
  /// Location of a uniform that takes a value of type `given`; -1 if there is none.
  GLint find(std::string_view name, GLenum given) const;
  void complain(std::string_view name, const std::string& text) const;

  std::shared_ptr<detail::ProgramState> state_; // shared with who reloads it
};

} // namespace gg
