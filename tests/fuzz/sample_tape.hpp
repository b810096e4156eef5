#pragma once
/// \file
/// A small tape: objects are drawn into a texture, then into the window.

#include "replay/tape.hpp"

#include <string>

namespace sample {

inline const char* const kShader = R"(#version 410 core
uniform float uBias; // not part of a function
// float commented(float x) { return x; }
float visibility(vec3 p) {
  if (p.z < uBias) { return 1.0; }
  return 0.0; /* } */
}
out vec4 oColor;
void main() { oColor = vec4(visibility(vec3(0))); }
)";

inline std::vector<std::byte> blob(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

inline nlohmann::json window() {
  return {{"window", true}, {"drawBuffer", true}};
}

inline nlohmann::json texture(int image) {
  return {{"attachments", {{"color0", {{"image", image}, {"level", 0}}}}}, {"drawBuffers", {0}}};
}

inline nlohmann::json clear(const nlohmann::json& target, int side) {
  return {{"op", "clear"},
          {"target", target},
          {"state", {{"viewport", {0, 0, side, side}}, {"depthTest", true}}},
          {"colors", true},
          {"color", {0, 0, 0, 1}},
          {"depths", true},
          {"depth", 1},
          {"stencils", false},
          {"stencil", 0}};
}

/// A draw of the mesh that lies in this blob; the shader is blob 0.
inline nlohmann::json draw(const nlohmann::json& target, int side, int mesh, float light = 1) {
  return {{"op", "draw"},
          {"target", target},
          {"state", {{"viewport", {0, 0, side, side}}, {"depthTest", true}}},
          {"mode", 4},
          {"instances", 1},
          {"calls", {{{"first", 0}, {"count", 3}}}},
          {"program",
           {{"stages", {{{"stage", "fragment"}, {"blob", 0}}}},
            {"attributes", nlohmann::json::object()},
            {"outputs", nlohmann::json::object()}}},
          {"uniforms", {{"uLight", {{"type", 5126}, {"values", {light}}}}}},
          {"textures", nlohmann::json::object()},
          {"blocks", nlohmann::json::object()},
          {"attributes", {{"position", {{{"blob", mesh}}}}}}};
}

inline nlohmann::json image(int id, int format) {
  return {{"op", "image"},
          {"id", id},
          {"kind", "texture"},
          {"target", 3553},
          {"levels", {{{"level", 0}, {"format", format}, {"width", 8}, {"height", 8}}}}};
}

/// Objects into a texture, then into the window: the reference.
inline ggrade::tape::Tape reference(float light = 1) {
  ggrade::tape::Tape tape;
  tape.blobs = {blob(kShader), blob("mesh"), blob("floor")};
  tape.commands = {{{"op", "context"}},           image(0, 32856),     clear(texture(0), 8),
                   draw(texture(0), 8, 1, light), clear(window(), 16), draw(window(), 16, 1),
                   draw(window(), 16, 2),         {{"op", "swap"}}};
  return tape;
}

} // namespace sample
