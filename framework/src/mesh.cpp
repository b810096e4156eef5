#include <gg/mesh.hpp>

#include <cstddef>
#include <stdexcept>

#include <glm/common.hpp>

#include <gg/platform.hpp>
#include <gg/text_file.hpp>

namespace gg {

namespace {

struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec2 uv;
  glm::vec4 tangent;
};

void attribute(GLuint location, GLint components, std::size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                        reinterpret_cast<const void*>(offset));
}

} // namespace

Mesh::Mesh(const MeshData& data) : indexCount_(static_cast<GLsizei>(data.indices.size())) {
  const std::size_t count = data.positions.size();
  if (data.normals.size() != count || data.uvs.size() != count || data.tangents.size() != count)
    throw std::invalid_argument("a mesh needs as many normals, uvs and tangents as positions");
  if (count > 0) lowest_ = highest_ = data.positions[0];
  for (const glm::vec3& position : data.positions) {
    lowest_ = glm::min(lowest_, position);
    highest_ = glm::max(highest_, position);
  }
  std::vector<Vertex> vertices(count);
  for (std::size_t i = 0; i < count; ++i)
    vertices[i] = {data.positions[i], data.normals[i], data.uvs[i], data.tangents[i]};

  glBindVertexArray(vertexArray_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * sizeof(Vertex)), vertices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(data.indices.size() * sizeof(std::uint32_t)),
               data.indices.data(), GL_STATIC_DRAW);
  attribute(0, 3, offsetof(Vertex, position));
  attribute(1, 3, offsetof(Vertex, normal));
  attribute(2, 2, offsetof(Vertex, uv));
  attribute(3, 4, offsetof(Vertex, tangent));
  glBindVertexArray(0);
}

void Mesh::draw() const {
  glBindVertexArray(vertexArray_);
  glDrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

Mesh loadMesh(const std::string& name) {
  return loadMeshData(name, toUtf8(programFolder()));
}

} // namespace gg
