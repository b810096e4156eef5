#include <gg/mesh_data.hpp>

#include "framework_temporary_folder.hpp"
#include "framework_throws.hpp"
#include <gg/error.hpp>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>

namespace {

std::string messageFor(const std::string& text) {
  return messageOf<gg::FileError>([&] { gg::readObjText(text, "a.obj"); });
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, APolygonIsCutIntoTrianglesThatShareCorners) {
  const gg::MeshData mesh = gg::readObjText(kSquare + "f 1 2 3 4\n", "a.obj");
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.indices.size(), 6u);
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(Obj, AConcavePolygonKeepsItsArea) {
  const gg::MeshData mesh =
      gg::readObjText("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n", "a.obj");
  float area = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                    c = mesh.positions[mesh.indices[i + 2]];
    EXPECT_GT(glm::cross(b - a, c - a).z, 0);
    area += glm::cross(b - a, c - a).z / 2;
  }
  EXPECT_NEAR(area, 10, 1e-5); // the square's 16 less the notch's 6
}

TEST(Obj, GivenNormalsAndUvsAreKept) {
  const gg::MeshData mesh =
      gg::readObjText(kSquare + "vt 0 0\nvt 0.25 0.75\nvn 0 3 4\nf 1/1/1 2/2/1 3/2/1\n", "a.obj");
  ASSERT_EQ(mesh.normals.size(), 3u);
  EXPECT_NEAR(mesh.normals[0].y, 0.6, 1e-6);
  EXPECT_NEAR(mesh.normals[0].z, 0.8, 1e-6);
  EXPECT_EQ(mesh.uvs[1], glm::vec2(0.25, 0.75));
}

TEST(Obj, ComputedNormalsAreSmoothAcrossUvSeams) {
  // Two faces of a roof that share an edge but not its texture coordinates.
  const gg::MeshData mesh = gg::readObjText("v 0 0 -1\nv 0 0 1\nv 1 -1 0\nv -1 -1 0\n"
                                            "vt 0 0\nvt 1 1\n"
                                            "f 1/1 2/1 3/1\nf 2/2 1/2 4/2\n",
                                            "a.obj");
  EXPECT_EQ(mesh.positions.size(), 6u);
  int ridge = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].x != 0) continue;
    ++ridge;
    EXPECT_NEAR(mesh.normals[i].y, 1, 1e-6);
  }
  EXPECT_EQ(ridge, 4);
}

TEST(Obj, NegativeIndicesCountFromTheEnd) {
  const gg::MeshData mesh = gg::readObjText(kSquare + "f -4 -3 -2\nv 9 9 9\n", "a.obj");
  EXPECT_EQ(mesh.positions[2], glm::vec3(1, 1, 0));
}

TEST(Obj, TrianglesWithoutAreaAreDropped) {
  const gg::MeshData mesh =
      gg::readObjText(kSquare + "v 0.5 0 0\nf 1 1 2\nf 1 2 5\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(mesh.indices.size(), 3u);
  EXPECT_EQ(messageFor(kSquare + "f 1 1 2\n"), "a.obj: has no face with an area");
}

TEST(Obj, TinyTrianglesAreNotTakenForFlatOnes) {
  EXPECT_EQ(gg::readObjText("v 0 0 0\nv 1e-6 0 0\nv 0 1e-6 0\nf 1 2 3\n", "a.obj").indices.size(),
            3u);
}

TEST(Obj, ForeignLineEndsCommentsAndMarksAreRead) {
  const gg::MeshData mesh = gg::readObjText(
      "\xEF\xBB\xBF# made elsewhere\r\nmtllib none.mtl\r\no thing\r\nv 0 0 0 # origin\r\n"
      "v 1 0 0\r\nv 0 1 0\r\nusemtl red\r\ns off\r\nf 1 2 3\r\n",
      "a.obj");
  EXPECT_EQ(mesh.indices.size(), 3u);
}

TEST(Obj, MistakesHaveALine) {
  EXPECT_EQ(messageFor("v 0 0 0\nv 1 0\n"), "a.obj:2: needs 3 numbers");
  EXPECT_EQ(messageFor("\nv 0 zero 0\n"), "a.obj:2: \"zero\" is not a number that a mesh can use");
  EXPECT_EQ(messageFor("v 0 1e99 0\n"), "a.obj:1: \"1e99\" is not a number that a mesh can use");
  EXPECT_EQ(messageFor("v nan 0 0\n"), "a.obj:1: \"nan\" is not a number that a mesh can use");
  EXPECT_EQ(messageFor("v 1.5x 0 0\n"), "a.obj:1: \"1.5x\" is not a number that a mesh can use");
  EXPECT_EQ(messageFor(kSquare + "f 1 2\n"), "a.obj:5: a face needs at least three corners");
  EXPECT_EQ(messageFor(kSquare + "f 1 2 9\n"), "a.obj:5: there is no vertex 9 (so far 4)");
  EXPECT_EQ(messageFor(kSquare + "f 0 1 2\n"), "a.obj:5: there is no vertex 0 (so far 4)");
  EXPECT_EQ(messageFor(kSquare + "f -5 1 2\n"), "a.obj:5: there is no vertex -5 (so far 4)");
  EXPECT_EQ(messageFor(kSquare + "f 1/1 2 3\n"),
            "a.obj:5: there is no texture coordinate 1 (so far 0)");
  EXPECT_EQ(messageFor(kSquare + "f 1//2 2 3\n"), "a.obj:5: there is no normal 2 (so far 0)");
  EXPECT_EQ(messageFor(kSquare + "f 1/ 2 3\n"), "a.obj:5: \"\" is not a corner of a face");
  EXPECT_EQ(messageFor(kSquare + "f 1 2 x\n"), "a.obj:5: \"x\" is not a corner of a face");
  EXPECT_EQ(messageFor(kSquare + "f 1 2 99999999999999999999\n"),
            "a.obj:5: \"99999999999999999999\" is not a corner of a face");
  EXPECT_EQ(messageFor(kSquare + "f 1/1/1/1 2 3\n").substr(0, 7), "a.obj:5");
}

// tinyobjloader wants a space or tab after the keyword.
TEST(Obj, ALineThatTheReaderSeesDifferentlyIsAnErrorAndNoCrash) {
  EXPECT_EQ(messageFor(kSquare + "vn\v0 0 1\nf 1//1 2//1 3//1\n"),
            "a.obj: a face has a corner that is not in the file");
}

TEST(Obj, AnEmptyOrForeignFileHasNoFaces) {
  EXPECT_EQ(messageFor(""), "a.obj: has no face with an area");
  EXPECT_EQ(messageFor("{\"not\": \"an obj\"}\n"), "a.obj: has no face with an area");
}

TEST(Obj, AFileIsNamedWithoutItsFolder) {
  const TemporaryFolder folder;
  const std::string file = folder.write("bad.obj", "v x\n").string();
  EXPECT_EQ(messageOf<gg::FileError>([&] { gg::readObj(file); }),
            "bad.obj:1: \"x\" is not a number that a mesh can use");
}

} // namespace
