// The shadow volume's mesh on the GPU, and whether a scene can show it.
#pragma once

#include "volume.hpp"

#include <gg/gg.hpp>

// Vertex array and buffers. volume.vert receives location 0 aPosition, 1 aPlane.
class VolumeBuffer {
public:
  VolumeBuffer() {
    glBindVertexArray(vertexArray_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    const auto attribute = [](GLuint location, GLint components, std::size_t offset) {
      glEnableVertexAttribArray(location);
      glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, sizeof(VolumeVertex),
                            reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(VolumeVertex, position));
    attribute(1, 4, offsetof(VolumeVertex, plane));
    glBindVertexArray(0);
  }

  void load(const VolumeMesh& mesh) {
    glBindVertexArray(vertexArray_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(VolumeVertex)),
                 mesh.vertices.data(), GL_DYNAMIC_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                 mesh.indices.data(), GL_DYNAMIC_DRAW);
    glBindVertexArray(0);
    count_ = static_cast<GLsizei>(mesh.indices.size());
  }

  void draw() const {
    glBindVertexArray(vertexArray_);
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
  }

private:
  gg::VertexArray vertexArray_;
  gg::Buffer vertices_, indices_;
  GLsizei count_ = 0;
};

// Remembers, between the parts of a mesh that has several (countableParts()), which pixels lie in a
// volume: the stencil's uppermost bit.
struct CountMemory {
  gg::Program program{{"screen.vert", "volume.frag"}};
  gg::VertexArray noVertices; // screen.vert makes its own corners

  // Where the count isn't 0, sets the bit and the count to 0.
  void remember() const {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NOTEQUAL, 0x80, 0x7f); // compares the lower seven bits, writes 0x80
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glStencilMask(0xff);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDisable(GL_DEPTH_TEST);
    program.use();
    glBindVertexArray(noVertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilMask(0x7f);
    glDisable(GL_STENCIL_TEST);
  }
};

// Throws gg::WindowError unless the window's stencil buffer has 8 bits.
inline void requireStencil() {
  GLint type = GL_NONE, bits = 0;
  glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_STENCIL,
                                        GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  if (type != GL_NONE)
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_STENCIL,
                                          GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, &bits);
  if (bits < 8)
    throw gg::WindowError(
        "shadow volumes are counted in a stencil buffer of 8 bits; this window has " +
        std::to_string(bits) +
        ".\nAsk for them before the window is opened: "
        "glfwWindowHint(GLFW_STENCIL_BITS, 8). If they were asked for, update the "
        "graphics driver.");
}

// Can this scene show a shadow? Not if the effect is off, nothing can throw one, or the light has
// nothing that a shadow could take away.
inline bool showsShadow(const gg::Scene& scene, const ClosedMesh& caster) {
  if (!scene.flag("effects.shadow")) return false;
  if (scene.flag("debug.draw_all_passes")) return true;
  const bool lit = glm::vec3(scene.light.diffuse) != glm::vec3(0) ||
                   glm::vec3(scene.light.specular) != glm::vec3(0);
  return lit && !caster.faces.empty();
}
