// Scenarios of what programs sample and of their matrices.
#include "recorded.hpp"

#include <vector>

GLuint blockProgram() {
  return makeProgram(R"(#version 410 core
    layout(std140) uniform Camera {
      vec4 before;
      mat4 uColumns;
      layout(row_major) mat4 uRows;
      mat4 uSeveral[2];
    };
    uniform mat4 uOwn;
    uniform mat4 uBones[2];
    void main() {
      vec2 corner = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
      gl_Position = before + uColumns * uRows * uSeveral[0] * uSeveral[1] * uOwn * uBones[0] *
                             uBones[1] * vec4(corner, 0, 1);
    })",
                     R"(#version 410 core
    out vec4 oColor;
    void main() { oColor = vec4(1); })");
}

void setMatrix(GLuint program, const char* name, float first) {
  float values[16];
  for (int i = 0; i < 16; ++i) values[i] = first + static_cast<float>(i);
  glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, values);
}

const Scenarios kScenarios = {
    // Each frame draws to one of two textures, sampling the other, then shows it.
    {"ping_pong",
     [] {
       const GLuint textures[] = {makeTexture(GL_RGBA8), makeTexture(GL_RGBA8)};
       const GLuint framebuffers[] = {makeFramebuffer(textures[0]), makeFramebuffer(textures[1])};
       const std::vector<unsigned char> pixels(4 * 64, 99);
       const GLuint uploaded = makeTexture(GL_RGBA8);
       glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
       const GLuint program = makeProgram(kFullScreen, R"(#version 410 core
         uniform sampler2D uLast;
         uniform sampler2D uUploaded;
         out vec4 oColor;
         void main() { oColor = texture(uLast, vec2(0.5)) + texture(uUploaded, vec2(0.5)); })");
       const GLuint show = textureProgram();
       glUseProgram(program);
       glUniform1i(glGetUniformLocation(program, "uUploaded"), 5);
       return [=](int frame) {
         const int to = frame % 2;
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[to]);
         glUseProgram(program);
         glActiveTexture(GL_TEXTURE5);
         glBindTexture(GL_TEXTURE_2D, uploaded);
         glActiveTexture(GL_TEXTURE0);
         glBindTexture(GL_TEXTURE_2D, textures[1 - to]);
         drawFull();
         glBindFramebuffer(GL_FRAMEBUFFER, 0);
         glUseProgram(show);
         glBindTexture(GL_TEXTURE_2D, textures[to]);
         drawFull();
       };
     }},
    // Two textures one after another into one attachment: two steps.
    {"added",
     [] {
       const GLuint a = makeTexture(GL_RGBA8);
       const GLuint b = makeTexture(GL_RGBA8);
       const GLuint program = textureProgram();
       return [=](int) {
         glUseProgram(program);
         glBindTexture(GL_TEXTURE_2D, a);
         drawFull();
         drawFull();
         glBindTexture(GL_TEXTURE_2D, b);
         drawFull();
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
         drawFull();
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
       };
     }},
    {"settings",
     [] {
       const GLuint texture = makeTexture(GL_DEPTH_COMPONENT24);
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_GREATER);
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
       GLuint sampler = 0;
       glGenSamplers(1, &sampler);
       glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
       glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
       glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
       const GLuint program = makeProgram(kFullScreen, R"(#version 410 core
         uniform sampler2DShadow uMaps[2];
         out vec4 oColor;
         void main() { oColor = vec4(texture(uMaps[0], vec3(0.5)) + texture(uMaps[1], vec3(0.5))); })");
       glUseProgram(program);
       glUniform1i(glGetUniformLocation(program, "uMaps[0]"), 3);
       glUniform1i(glGetUniformLocation(program, "uMaps[1]"), 3);
       return [=](int) {
         glActiveTexture(GL_TEXTURE3);
         glBindTexture(GL_TEXTURE_2D, texture);
         drawFull();
         glBindSampler(3, sampler);
         drawFull();
         glBindSampler(3, 0);
       };
     }},
    // Nothing bound; no mipmaps where they are wanted; a format that cannot be filtered.
    {"incomplete",
     [] {
       const GLuint plain = makeTexture(GL_RGBA8);
       const GLuint whole = makeTexture(GL_RGBA8, 8, 4);
       const GLuint integers = [] {
         GLuint name = 0;
         glGenTextures(1, &name);
         glBindTexture(GL_TEXTURE_2D, name);
         glTexImage2D(GL_TEXTURE_2D, 0, GL_R32UI, 8, 8, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      nullptr);
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
         return name;
       }();
       GLuint empty = 0;
       glGenTextures(1, &empty);
       const GLuint program = textureProgram();
       return [=](int) {
         glUseProgram(program);
         for (const GLuint texture : {0U, empty, plain, whole, integers}) {
           glBindTexture(GL_TEXTURE_2D, texture);
           glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
           if (texture == plain) glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1000);
           drawFull();
         }
       };
     }},
    {"feedback",
     [] {
       const GLuint texture = makeTexture(GL_RGBA8, 8, 2);
       const GLuint framebuffer = makeFramebuffer(texture);
       const GLuint program = textureProgram();
       return [=](int) {
         glUseProgram(program);
         glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
         attach(texture, 0);
         glBindTexture(GL_TEXTURE_2D, texture);
         drawFull();
         attach(texture, 1); // only level 0 is sampled
         drawFull();
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
         drawFull();
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
       };
     }},
    {"matrices",
     [] {
       const GLuint program = blockProgram();
       GLuint buffer = 0;
       glGenBuffers(1, &buffer);
       glBindBuffer(GL_UNIFORM_BUFFER, buffer);
       std::vector<float> values(64 + 4 + 4 * 16);
       for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
       glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(4 * values.size()), values.data(),
                    GL_STATIC_DRAW);
       glUniformBlockBinding(program, glGetUniformBlockIndex(program, "Camera"), 2);
       glUseProgram(program);
       setMatrix(program, "uOwn", 500);
       setMatrix(program, "uBones[0]", 600);
       setMatrix(program, "uBones[1]", 700);
       return [=](int) {
         // 64 floats in, which is an offset that every GL allows.
         glBindBufferRange(GL_UNIFORM_BUFFER, 2, buffer, 256,
                           static_cast<GLsizeiptr>(4 * values.size() - 256));
         setMatrix(program, "uOwn", 500);
         drawFull();
         drawFull();
         setMatrix(program, "uOwn", 501);
         drawFull();
         glBindBufferBase(GL_UNIFORM_BUFFER, 2, buffer); // another place: all of the block changes
         drawFull();
         glEnable(GL_BLEND);
         glBindBufferBase(GL_UNIFORM_BUFFER, 2, 0);
         drawFull();
         glDisable(GL_BLEND);
       };
     }},
};

int main(int argc, char** argv) {
  return runScenario(kScenarios, argc, argv);
}
