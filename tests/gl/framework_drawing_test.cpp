// Meshes and textures, by the pixels that they make.

#include "framework_window.hpp"
#include <gg/math.hpp>
#include <gg/mesh.hpp>
#include <gg/texture.hpp>
#include <gmock/gmock.h>

namespace {

using testing::ElementsAre;

class Drawing : public FrameworkWindow {
protected:
  // Turns the plane y = 0 so that it fills the window, +z to its bottom.
  const glm::mat4 kFromAbove = glm::rotate(glm::mat4(1), glm::radians(90.0f), {1, 0, 0});
};

TEST_F(Drawing, APlaneFillsWhatItShould) {
  const gg::Program p = coloring("vec4(1, 0.6, 0.2, 1)");
  const gg::Mesh mesh = gg::plane(1, 1); // the middle half of the window in x and y
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_CULL_FACE);
  p.use();
  p.set("uClip", kFromAbove);
  mesh.draw();
  glDisable(GL_CULL_FACE);
  int count = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) count += pixel(x, y)[0] == 255;
  EXPECT_EQ(count, kSide * kSide / 4);
  EXPECT_THAT(pixel(8, 8), ElementsAre(255, 153, 51, 255));
  EXPECT_THAT(pixel(23, 23), ElementsAre(255, 153, 51, 255));
  EXPECT_THAT(pixel(7, 8), ElementsAre(0, 0, 255, 255));
  EXPECT_THAT(pixel(24, 23), ElementsAre(0, 0, 255, 255));
}

TEST_F(Drawing, FrontFacesAreThoseThatLookOutward) {
  const gg::Program p = coloring("vec4(gl_FrontFacing ? 1 : 0, 0, 0, 1)");
  p.use();
  glEnable(GL_DEPTH_TEST);
  for (const gg::MeshData& data : {gg::box(), gg::torusKnot()}) {
    const gg::Mesh mesh = data;
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glm::mat4 clip = glm::scale(glm::mat4(1), {1, 1, -0.5f}); // the nearest is what +z looks at
    clip = glm::translate(clip, {0, -0.5f, 0});
    p.set("uClip", clip);
    mesh.draw();
    int front = 0, back = 0;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        front += pixel(x, y)[0] == 255;
        back += pixel(x, y)[0] == 0 && pixel(x, y)[1] == 0;
      }
    }
    EXPECT_GT(front, 100);
    EXPECT_LE(back, 2); // edges seen from the side
  }
  glDisable(GL_DEPTH_TEST);
}

TEST_F(Drawing, AttributesArriveAtTheirLocations) {
  const gg::Mesh mesh = gg::plane(2, 2);
  const gg::Program normals = coloring("vec4(vNormal * 0.5 + 0.5, 1)");
  normals.use();
  normals.set("uClip", kFromAbove);
  mesh.draw();
  EXPECT_THAT(pixel(5, 5), ElementsAre(128, 255, 128, 255));

  const gg::Program uvs = coloring("vec4(vUv, 0, 1)");
  uvs.use();
  uvs.set("uClip", kFromAbove);
  mesh.draw();
  EXPECT_THAT(pixel(0, 31), ElementsAre(4, 251, 0, 255)); // (0.5, 31.5) / 32

  gg::MeshData mirrored = gg::plane(2, 2); // u runs against x, so the handedness is -1
  for (glm::vec2& uv : mirrored.uvs) uv.x = -uv.x;
  gg::computeTangents(mirrored);
  const gg::Program tangents = coloring("vTangent * 0.5 + 0.5");
  tangents.use();
  tangents.set("uClip", kFromAbove);
  gg::Mesh(mirrored).draw();
  EXPECT_THAT(pixel(5, 5), ElementsAre(0, 128, 128, 0));
}

TEST_F(Drawing, AMeshOfUnequalArraysIsRefused) {
  gg::MeshData data = gg::box();
  data.uvs.pop_back();
  EXPECT_THROW(gg::Mesh{data}, std::invalid_argument);
}

TEST_F(Drawing, ATextureStandsUprightAndHasMipmaps) {
  gg::Image image = gg::checkerImage(2, 2, {1, 0, 0}, {0, 0, 1});
  const gg::Texture texture = gg::makeTexture(image);
  const gg::Mesh mesh = gg::plane(2, 2);
  const gg::Program p =
      coloring("textureLod(uMap, vUv, uLevel)", "uniform sampler2D uMap; uniform float uLevel;");
  p.use();
  p.set("uClip", kFromAbove);
  p.set("uMap", 0);
  glBindTexture(GL_TEXTURE_2D, texture);
  mesh.draw();
  EXPECT_THAT(pixel(7, 7), ElementsAre(240, 0, 15, 255)); // half a pixel from a texel's centre
  EXPECT_THAT(pixel(24, 7), ElementsAre(15, 0, 240, 255));
  p.set("uLevel", 1.0f);
  mesh.draw();
  for (int channel : {0, 2}) EXPECT_NEAR(pixel(7, 7)[channel], 128, 1);
}

TEST_F(Drawing, HandlesDeleteTheirObjects) {
  GLuint texture = 0, buffer = 0, framebuffer = 0, renderbuffer = 0, vertexArray = 0, sampler = 0;
  {
    gg::Texture t;
    glBindTexture(GL_TEXTURE_2D, t);
    gg::Buffer b;
    glBindBuffer(GL_ARRAY_BUFFER, b);
    gg::Framebuffer f;
    glBindFramebuffer(GL_FRAMEBUFFER, f);
    gg::Renderbuffer r;
    glBindRenderbuffer(GL_RENDERBUFFER, r);
    gg::VertexArray v;
    glBindVertexArray(v);
    gg::Sampler s;
    texture = t, buffer = b, framebuffer = f, renderbuffer = r, vertexArray = v, sampler = s;
    EXPECT_TRUE(glIsTexture(texture) && glIsBuffer(buffer) && glIsFramebuffer(framebuffer) &&
                glIsRenderbuffer(renderbuffer) && glIsVertexArray(vertexArray) &&
                glIsSampler(sampler));
  }
  EXPECT_FALSE(glIsTexture(texture));
  EXPECT_FALSE(glIsBuffer(buffer));
  EXPECT_FALSE(glIsFramebuffer(framebuffer));
  EXPECT_FALSE(glIsRenderbuffer(renderbuffer));
  EXPECT_FALSE(glIsVertexArray(vertexArray));
  EXPECT_FALSE(glIsSampler(sampler));
}

} // namespace
