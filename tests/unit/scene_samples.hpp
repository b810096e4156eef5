#pragma once
/// \file
/// A small assignment and a scene for it, of one key a line so that line numbers are easy to see.

#include <string>

#include <gg/declarations.hpp>

inline const std::string kSampleAssignment = R"({
  "materials": ["object"],
  "scene": {
    "effects.mirror": { "type": "boolean", "default": true },
    "mesh": { "type": "text", "default": "torus_knot" },
    "ring.count": { "type": "integer", "range": [0, 100], "default": 6, "about": "how many" },
    "ring.radius": { "type": "real", "range": [0, 1e7] }
  }
})";

inline const std::string kSampleScene = R"({
  "camera": {
    "position": [0, 3, 8],
    "target": [0, 1, 0],
    "fov": 0.5,
    "near": 1,
    "far": 15
  },
  "light": { "position": [1, 4, 2] },
  "materials": {
    "object": {
      "ambient": [0.1, 0.2, 0.3],
      "diffuse": [0.4, 0.5, 0.6],
      "specular": [0.7, 0.8, 0.9],
      "shininess": 40
    }
  },
  "ring": {
    "radius": 1.5
  }
}
)";

inline gg::Declarations sampleDeclarations() {
  return gg::Declarations::fromText(kSampleAssignment, "assignment.json");
}

/// The sample scene with the first occurrence of `from` replaced.
inline std::string sampleSceneWith(const std::string& from, const std::string& to) {
  std::string text = kSampleScene;
  return text.replace(text.find(from), from.size(), to);
}
