// Plays a tape: draws again what a program drew, without the program, and swaps where it swapped.
//
//     ggrade-play --scene FOLDER/scene.json
//
// FOLDER/tape is the tape. scene.json has "patches": a list of JSON patches (RFC 6902) of the
// tape's commands; each is played from the start, for "frames" frames. Who runs it sees the frames
// and passes as those of any program.
#include "replay/gl_state.hpp"
#include "replay/player/objects.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace ggrade::player {

Function functionOf(const char* name) {
  const Function function = glfwGetProcAddress(name);
  if (!function) throw std::runtime_error(std::string("this OpenGL has no ") + name);
  return function;
}

namespace {

class Player {
public:
  Player(GLFWwindow* window, const tape::Tape& tape)
      : window_(window), images_(tape), framebuffers_(images_), buffers_(tape), programs_(tape) {
    gl().pixelStorei(GL_UNPACK_ALIGNMENT, 1);
  }

  /// The first `frames` frames of these commands, as if nothing had been played before: an image
  /// that is never cleared holds nothing.
  void play(const json& commands, int frames) {
    framebuffers_.forget();
    images_.forget();
    for (const json& command : commands) {
      if (frames == 0) return;
      if (command.contains("before"))
        for (const json& other : command["before"]) playOne(other);
      const std::string op = command.at("op");
      if (op == "swap") {
        glfwSwapBuffers(window_);
        glfwPollEvents();
        --frames;
      } else {
        playOne(command);
      }
    }
  }

private:
  void playOne(const json& command) {
    if (command.value("skip", false)) return;
    const std::string op = command.at("op");
    if (op == "image") {
      images_.define(command);
    } else if (op == "draw") {
      draw(command);
    } else if (op == "clear") {
      clear(command);
    } else if (op == "clearBuffer") {
      clearBuffer(command);
    } else if (op == "blit") {
      blit(command);
    } else if (op == "copy") {
      copy(command);
    } else if (op == "copyImage") {
      copyImage(command);
    } else if (op == "mipmap") {
      mipmap(command);
    } else if (op != "context" && op != "program") {
      throw std::runtime_error("a command of an unknown kind: " + op);
    }
  }

  void prepare(const json& command) {
    framebuffers_.bindDraw(command.at("target"));
    applyState(command.at("state"));
  }

  void sample(const json& one) {
    const auto unit = one.at("unit").get<GLuint>();
    const GLenum target = one.at("target");
    gl().activeTexture(GL_TEXTURE0 + unit);
    gl().bindSampler(unit, 0);
    if (!one.contains("image")) return gl().bindTexture(target, 0);
    gl().bindTexture(target, images_.at(one["image"]).name);
    if (!one.value("samplerObject", false)) return applyParameters(target, one);
    applyOwnParameters(target, one);
    GLuint& sampler = samplers_[one.dump()];
    if (!sampler) gl().genSamplers(1, &sampler);
    for (const auto& [name, parameter] : tape::kSampling)
      gl().samplerParameteri(sampler, parameter, one.at(name));
    for (const auto& [name, parameter] : tape::kSamplingFloats)
      gl().samplerParameterf(sampler, parameter, one.at(name));
    const auto border = one.at("borderColor").get<std::array<GLfloat, 4>>();
    gl().samplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, border.data());
    gl().bindSampler(unit, sampler);
  }

  /// What the program takes that is in use.
  void give(GLuint program, const json& command) {
    for (const auto& [name, uniform] : command.at("uniforms").items())
      if (const GLint at = gl().getUniformLocation(program, name.c_str()); at >= 0)
        setUniform(at, uniform.at("type"), uniform.at("values"));
    for (const auto& [name, all] : command.at("textures").items()) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string element = tape::elementName(name, int(i));
        const GLint at = gl().getUniformLocation(program, element.c_str());
        if (at >= 0) gl().uniform1i(at, all[i].at("unit"));
        sample(all[i]);
      }
    }
    GLuint binding = 0;
    for (const auto& [name, block] : command.at("blocks").items()) {
      const GLuint index = gl().getUniformBlockIndex(program, name.c_str());
      if (index == GL_INVALID_INDEX || block.is_null()) continue;
      gl().uniformBlockBinding(program, index, binding);
      gl().bindBufferBase(GL_UNIFORM_BUFFER, binding++, buffers_.at(block.at("blob")));
    }
  }

  void attributes(GLuint program, const json& command) {
    for (const auto& [name, columns] : command.at("attributes").items()) {
      const GLint first = gl().getAttribLocation(program, name.c_str());
      if (first < 0) continue;
      GLuint at = GLuint(first);
      for (const json& one : columns) attribute(at++, one);
    }
  }

  void attribute(GLuint at, const json& one) {
    if (one.contains("value")) {
      const auto value = one["value"].get<std::array<GLfloat, 4>>();
      gl().vertexAttrib4fv(at, value.data());
      return;
    }
    gl().bindBuffer(GL_ARRAY_BUFFER, buffers_.at(one.at("blob")));
    const auto* offset = reinterpret_cast<const void*>(one.at("offset").get<std::uintptr_t>());
    if (one.at("integer").get<bool>())
      gl().vertexAttribIPointer(at, one.at("size"), one.at("type"), one.at("stride"), offset);
    else
      gl().vertexAttribPointer(at, one.at("size"), one.at("type"), one.at("normalized").get<bool>(),
                               one.at("stride"), offset);
    gl().vertexAttribDivisor(at, one.at("divisor"));
    gl().enableVertexAttribArray(at);
  }

  void draw(const json& command) {
    prepare(command);
    const GLuint program = programs_.at(command.at("program"));
    gl().useProgram(program);
    give(program, command);
    GLuint vertexArray = 0;
    gl().genVertexArrays(1, &vertexArray);
    gl().bindVertexArray(vertexArray);
    attributes(program, command);
    if (command.contains("indices"))
      gl().bindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_.at(command["indices"].at("blob")));
    if (command.contains("patchVertices"))
      gl().patchParameteri(GL_PATCH_VERTICES, command["patchVertices"]);
    const GLenum mode = command.at("mode");
    const GLsizei instances = command.at("instances");
    const GLuint base = command.at("baseInstance");
    for (const json& call : command.at("calls")) {
      if (call.contains("type"))
        gl().drawElementsInstancedBaseVertexBaseInstance(
            mode, call.at("count"), call.at("type"),
            reinterpret_cast<const void*>(call.at("offset").get<std::uintptr_t>()), instances,
            call.at("baseVertex"), base);
      else
        gl().drawArraysInstancedBaseInstance(mode, call.at("first"), call.at("count"), instances,
                                             base);
    }
    gl().bindVertexArray(0);
    gl().deleteVertexArrays(1, &vertexArray);
  }

  void clear(const json& command) {
    prepare(command);
    const auto color = command.at("color").get<std::array<GLfloat, 4>>();
    gl().clearColor(color[0], color[1], color[2], color[3]);
    gl().clearDepth(command.at("depth").get<double>());
    gl().clearStencil(command.at("stencil"));
    GLbitfield mask = 0;
    if (command.at("colors").get<bool>()) mask |= GL_COLOR_BUFFER_BIT;
    if (command.at("depths").get<bool>()) mask |= GL_DEPTH_BUFFER_BIT;
    if (command.at("stencils").get<bool>()) mask |= GL_STENCIL_BUFFER_BIT;
    gl().clear(mask);
  }

  void clearBuffer(const json& command) {
    prepare(command);
    const GLenum buffer = command.at("buffer");
    const GLint at = command.at("drawBuffer");
    const std::string type = command.at("type");
    const json& values = command.at("values");
    if (type == "b") return gl().clearBufferfi(buffer, at, values.at(0), values.at(1).get<GLint>());
    if (type == "i")
      gl().clearBufferiv(buffer, at, values.get<std::array<GLint, 4>>().data());
    else if (type == "u")
      gl().clearBufferuiv(buffer, at, values.get<std::array<GLuint, 4>>().data());
    else
      gl().clearBufferfv(buffer, at, values.get<std::array<GLfloat, 4>>().data());
  }

  void blit(const json& command) {
    prepare(command);
    framebuffers_.bindRead(command.at("from"));
    framebuffers_.bindDraw(command.at("target")); // a new one to read from was bound in its place
    const auto at = command.at("corners").get<std::array<GLint, 8>>();
    gl().blitFramebuffer(at[0], at[1], at[2], at[3], at[4], at[5], at[6], at[7], command.at("mask"),
                         command.at("filter"));
  }

  void copy(const json& command) {
    framebuffers_.bindRead(command.at("from"));
    const Images::Image& image = images_.at(command.at("image"));
    const GLenum target = command.at("target");
    gl().activeTexture(GL_TEXTURE0);
    gl().bindTexture(image.target, image.name);
    (command.at("state").at("framebufferSrgb").get<bool>() ? gl().enable
                                                           : gl().disable)(GL_FRAMEBUFFER_SRGB);
    const GLint level = command.at("level");
    const auto to = command.at("to").get<std::array<GLint, 3>>();
    const auto from = command.at("area").get<std::array<GLint, 4>>();
    if (const GLenum format = command.at("format"); format != 0)
      gl().copyTexImage2D(target, level, format, from[0], from[1], from[2], from[3], 0);
    else if (target == GL_TEXTURE_3D || target == GL_TEXTURE_2D_ARRAY)
      gl().copyTexSubImage3D(target, level, to[0], to[1], to[2], from[0], from[1], from[2],
                             from[3]);
    else
      gl().copyTexSubImage2D(target, level, to[0], to[1], from[0], from[1], from[2], from[3]);
  }

  void copyImage(const json& command) {
    const json &from = command.at("from"), &to = command.at("to");
    const Images::Image &source = images_.at(from.at("image")), &drawn = images_.at(to.at("image"));
    const auto target = [](const Images::Image& image) {
      return image.isTexture ? image.target : GLenum(GL_RENDERBUFFER);
    };
    const auto a = from.at("corner").get<std::array<GLint, 3>>(),
               b = to.at("corner").get<std::array<GLint, 3>>(),
               size = command.at("size").get<std::array<GLint, 3>>();
    gl().copyImageSubData(source.name, target(source), from.at("level"), a[0], a[1], a[2],
                          drawn.name, target(drawn), to.at("level"), b[0], b[1], b[2], size[0],
                          size[1], size[2]);
  }

  void mipmap(const json& command) {
    const Images::Image& image = images_.at(command.at("image"));
    gl().activeTexture(GL_TEXTURE0);
    gl().bindTexture(image.target, image.name);
    gl().texParameteri(image.target, GL_TEXTURE_BASE_LEVEL, command.at("baseLevel"));
    gl().texParameteri(image.target, GL_TEXTURE_MAX_LEVEL, command.at("maxLevel"));
    gl().generateMipmap(image.target);
  }

  GLFWwindow* window_;
  Images images_;
  Framebuffers framebuffers_;
  Buffers buffers_;
  Programs programs_;
  std::map<std::string, GLuint> samplers_;
};

std::vector<char> fileOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

GLFWwindow* windowOf(const json& context) {
  if (!glfwInit()) throw std::runtime_error("GLFW does not start");
  const bool core = context.at("core");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, context.at("version").at(0));
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, context.at("version").at(1));
  if (core) glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_DEPTH_BITS, context.at("depthBits"));
  glfwWindowHint(GLFW_STENCIL_BITS, context.at("stencilBits"));
  GLFWwindow* const window = glfwCreateWindow(context.at("window").at(0),
                                              context.at("window").at(1), "", nullptr, nullptr);
  if (!window) throw std::runtime_error("no window");
  glfwMakeContextCurrent(window);
  return window;
}

void run(const std::string& scenePath) {
  const std::vector<char> text = fileOf(scenePath);
  const json scene = json::parse(text.begin(), text.end());
  const std::vector<char> bytes = fileOf(scenePath.substr(0, scenePath.rfind('/')) + "/tape");
  const tape::Tape tape = tape::read(std::as_bytes(std::span(bytes)));
  if (tape.commands.empty() || tape.commands[0].at("op") != "context")
    throw std::runtime_error("the tape doesn't begin with its context");
  Player player(windowOf(tape.commands[0]), tape);
  for (const json& patch : scene.at("patches"))
    player.play(patch.empty() ? tape.commands : tape.commands.patch(patch), scene.at("frames"));
}

} // namespace
} // namespace ggrade::player

int main(int count, char** arguments) {
  try {
    if (count != 3) throw std::runtime_error("ggrade-play --scene FOLDER/scene.json");
    ggrade::player::run(arguments[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ggrade-play: %s\n", error.what());
    return 1;
  }
}
