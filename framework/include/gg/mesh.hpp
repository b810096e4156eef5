#pragma once
/// \file
/// A mesh on the GPU.

#include <string>

#include <gg/handle.hpp>
#include <gg/mesh_data.hpp>

namespace gg {

/// Vertex array and buffers of a mesh. Shaders receive
///   location 0 aPosition (vec3, or vec4 with w = 1), 1 aNormal (vec3), 2 aUv (vec2),
///   3 aTangent (vec4, w is the handedness).
class Mesh {
public:
  /// Not explicit, so that `gg::Mesh floor = gg::plane(6, 6);` reads as it should.
  Mesh(const MeshData& data);

  /// Draws all triangles with the program in use. Calls glBindVertexArray, glDrawElements.
  void draw() const;

  GLuint vertexArray() const { return vertexArray_; }
  GLsizei indexCount() const { return indexCount_; }

  /// Corners of the box around it, in its own space.
  const glm::vec3& lowest() const { return lowest_; }
  const glm::vec3& highest() const { return highest_; }

private:
  VertexArray vertexArray_;
  Buffer vertices_;
  Buffer indices_;
  GLsizei indexCount_ = 0;
  glm::vec3 lowest_{0}, highest_{0};
};

/// The mesh of this name or file (see loadMeshData); paths start at the program's folder.
Mesh loadMesh(const std::string& name);

} // namespace gg
