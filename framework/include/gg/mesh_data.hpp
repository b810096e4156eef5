#pragma once
/// \file
/// Triangle meshes as plain data, made by formula or read from a Wavefront OBJ file.
///
/// Front faces are counterclockwise seen from outside; y is up. File names are UTF-8.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace gg {

/// Vertices (four arrays of equal length) and triangles (three indices each).
struct MeshData {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals; ///< unit length
  std::vector<glm::vec2> uvs;     ///< (0,0) is the image's bottom left
  std::vector<glm::vec4>
      tangents; ///< unit direction of +u; w is 1 or -1: bitangent = w cross(n, t)
  std::vector<std::uint32_t> indices;
};

/// A trefoil knot standing on y = 0, 1 high, in the middle of x and z, facing +z. No turn makes it
/// its own mirror image, so a reflection cannot pass for a rotation.
///   along, around: number of segments along the knot and around its tube, at least 3
MeshData torusKnot(int along = 160, int around = 16);

/// A cube of side 1 standing on y = 0 in the middle of x and z.
MeshData box();

/// A rectangle in y = 0 that faces +y, centred at the origin; u runs along +x, v along -z.
MeshData plane(float width, float depth);

/// A mesh file in the Wavefront OBJ format, in the file's own units. Polygons are cut into
/// triangles, normals are computed where the file has none, triangles without area are dropped.
/// Throws FileError with file and line.
MeshData readObj(const std::string& file);
/// The same from text; `name` stands in messages.
MeshData readObjText(const std::string& text, const std::string& name);

/// "torus_knot", "box", "plane" (1 by 1), or a path to an OBJ file, to which standOnFloor is done.
///   folder: where a relative path starts
/// Throws FileError.
MeshData loadMeshData(const std::string& name, const std::string& folder);

/// Scales and moves a mesh to be 1 high (1 at its widest if it is flat), to stand on y = 0 and in
/// the middle of x and z.
void standOnFloor(MeshData& mesh);
/// Tangents from uvs and normals, which must be there. Where uvs say nothing, any tangent.
void computeTangents(MeshData& mesh);

} // namespace gg
