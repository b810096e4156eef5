// Wavefront OBJ files. tinyobjloader reads them; it takes what it cannot read for 0, so the lines
// that matter are checked first, where their numbers are still known.

#include <gg/mesh_data.hpp>

#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

#include "words/words.hpp"
#include <fmt/format.h>
#include <gg/error.hpp>
#include <gg/text_file.hpp>
#include <glm/geometric.hpp>
#include <tiny_obj_loader.h>

namespace gg {

namespace {

[[noreturn]] void fail(const std::string& name, long line, const std::string& what) {
  throw FileError(fmt::format("{}:{}: {}", name, line, what));
}

// How many vertices, uvs and normals the lines so far have defined.
struct Counts {
  long position = 0, uv = 0, normal = 0;
};

void checkNumbers(const std::string& name, long line, std::istringstream& words, int needed) {
  std::string word;
  for (int i = 0; i < needed; ++i) {
    if (!(words >> word)) fail(name, line, say("needs {} numbers", needed));
    std::istringstream stream(word);
    stream.imbue(std::locale::classic());
    double value = 0;
    if (!(stream >> value) || stream.peek() != EOF || !std::isfinite(static_cast<float>(value)))
      fail(name, line, say("\"{}\" is not a number that a mesh can use", word));
  }
}

// `what` refers to one of `count` things: from 1 on, or -1 for the latest.
void checkIndex(const std::string& name, long line, std::string_view digits, long count,
                std::string_view what) {
  long index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (error != std::errc() || end != digits.data() + digits.size())
    fail(name, line, say("\"{}\" is not a corner of a face", digits));
  if (index == 0 || index > count || index < -count)
    fail(name, line, say("there is no {} {} (so far {})", what, index, count));
}

void checkFace(const std::string& name, long line, std::istringstream& words,
               const Counts& counts) {
  int corners = 0;
  for (std::string corner; words >> corner; ++corners) {
    std::string_view rest = corner;
    const struct {
      long count;
      std::string_view what;
    } kinds[] = {{counts.position, gg::words("vertex")},
                 {counts.uv, gg::words("texture coordinate")},
                 {counts.normal, gg::words("normal")}};
    int kind = 0;
    for (bool more = true; more; ++kind) {
      if (kind == 3) fail(name, line, say("\"{}\" is not a corner of a face", corner));
      const std::size_t slash = rest.find('/');
      more = slash != rest.npos;
      const std::string_view digits = rest.substr(0, slash);
      // v//n: only the texture coordinate may be left out.
      if (!(digits.empty() && kind == 1 && more))
        checkIndex(name, line, digits, kinds[kind].count, kinds[kind].what);
      if (more) rest.remove_prefix(slash + 1);
    }
  }
  if (corners < 3) fail(name, line, say("a face needs at least three corners"));
}

void checkLines(const std::string& text, const std::string& name) {
  Counts counts;
  std::istringstream lines(text);
  long number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
    std::istringstream words(line.substr(0, line.find('#')));
    std::string keyword;
    words >> keyword;
    if (keyword == "v") {
      checkNumbers(name, number, words, 3);
      ++counts.position;
    } else if (keyword == "vt") {
      checkNumbers(name, number, words, 1);
      ++counts.uv;
    } else if (keyword == "vn") {
      checkNumbers(name, number, words, 3);
      ++counts.normal;
    } else if (keyword == "f") {
      checkFace(name, number, words, counts);
    }
  }
}

// Gathers the corners of a file's faces into vertices that triangles share.
class Builder {
public:
  explicit Builder(const tinyobj::attrib_t& attributes) : attributes_(attributes) {}

  // Do the corner's indices lie within what the file defines?
  bool isComplete(const tinyobj::index_t& corner) const {
    const auto within = [](int index, std::size_t count) {
      return static_cast<std::size_t>(index) < count;
    };
    return within(corner.vertex_index, attributes_.vertices.size() / 3) &&
           (corner.texcoord_index < 0 ||
            within(corner.texcoord_index, attributes_.texcoords.size() / 2)) &&
           (corner.normal_index < 0 || within(corner.normal_index, attributes_.normals.size() / 3));
  }

  void addTriangle(const tinyobj::index_t* corners) {
    glm::vec3 p[3];
    for (int i = 0; i < 3; ++i) p[i] = position(corners[i].vertex_index);
    const glm::vec3 a = p[1] - p[0], b = p[2] - p[0];
    const float twiceArea = glm::length(glm::cross(a, b));
    if (!(twiceArea > 1e-7f * std::max(glm::dot(a, a), glm::dot(b, b)))) return;
    for (int i = 0; i < 3; ++i) mesh_.indices.push_back(vertex(corners[i]));
  }

  MeshData finish() {
    computeMissingNormals();
    computeTangents(mesh_);
    return std::move(mesh_);
  }

  bool empty() const { return mesh_.indices.empty(); }

private:
  glm::vec3 position(int index) const {
    const float* p = &attributes_.vertices[3 * static_cast<std::size_t>(index)];
    return {p[0], p[1], p[2]};
  }

  std::uint32_t vertex(const tinyobj::index_t& corner) {
    const auto key = std::tuple(corner.vertex_index, corner.texcoord_index, corner.normal_index);
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [known, isNew] = vertices_.try_emplace(key, next);
    if (!isNew) return known->second;

    mesh_.positions.push_back(position(corner.vertex_index));
    glm::vec2 uv(0);
    if (corner.texcoord_index >= 0) {
      const float* t = &attributes_.texcoords[2 * static_cast<std::size_t>(corner.texcoord_index)];
      uv = {t[0], t[1]};
    }
    mesh_.uvs.push_back(uv);
    glm::vec3 normal(0);
    if (corner.normal_index >= 0) {
      const float* n = &attributes_.normals[3 * static_cast<std::size_t>(corner.normal_index)];
      normal = {n[0], n[1], n[2]};
    }
    const float length = glm::length(normal);
    mesh_.normals.push_back(length > 0 ? normal / length : glm::vec3(0));
    sources_.push_back(corner.vertex_index);
    return next;
  }

  // Smooth over all faces at a position, even where their texture coordinates differ.
  void computeMissingNormals() {
    std::map<int, glm::vec3> sums;
    for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3) {
      const std::uint32_t* corner = &mesh_.indices[i];
      const glm::vec3& origin = mesh_.positions[corner[0]];
      const glm::vec3 twiceArea =
          glm::cross(mesh_.positions[corner[1]] - origin, mesh_.positions[corner[2]] - origin);
      for (int k = 0; k < 3; ++k)
        sums.try_emplace(sources_[corner[k]], 0.0f).first->second += twiceArea;
    }
    for (std::size_t i = 0; i < mesh_.normals.size(); ++i) {
      if (mesh_.normals[i] != glm::vec3(0)) continue;
      const glm::vec3 sum = sums[sources_[i]];
      const float length = glm::length(sum);
      mesh_.normals[i] = length > 0 ? sum / length : glm::vec3(0, 1, 0);
    }
  }

  const tinyobj::attrib_t& attributes_;
  MeshData mesh_;
  std::map<std::tuple<int, int, int>, std::uint32_t> vertices_;
  std::vector<int> sources_; // position index in the file, of each vertex
};

} // namespace

MeshData readObjText(const std::string& text, const std::string& name) {
  checkLines(text, name);
  std::istringstream stream(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warnings, errors;
  constexpr bool kTriangulate = true;
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warnings, &errors, &stream, nullptr,
                        kTriangulate))
    throw FileError(name + ": " + errors);

  Builder builder(attributes);
  for (const tinyobj::shape_t& shape : shapes) {
    const auto& corners = shape.mesh.indices;
    // Where the line check and the reader see an odd line differently, the reader's word counts.
    for (const tinyobj::index_t& corner : corners)
      if (!builder.isComplete(corner))
        throw FileError(say("{}: a face has a corner that is not in the file", name));
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) builder.addTriangle(&corners[i]);
  }
  if (builder.empty()) throw FileError(say("{}: has no face with an area", name));
  return builder.finish();
}

MeshData readObj(const std::string& file) {
  const std::filesystem::path path = fromUtf8(file);
  return readObjText(readFile(path), toUtf8(path.filename()));
}

} // namespace gg
