// Any bytes as an assignment's declarations and a scene. Only SceneError may be thrown, with a
// message of one line, and every value that is taken keeps to what its key allows.
#include "require.hpp"

#include <gg/declarations.hpp>
#include <gg/error.hpp>
#include <gg/scene.hpp>

#include <cmath>
#include <cstdint>
#include <string>

namespace {

constexpr std::string_view kDeclared = R"({
  "materials": ["object", "floor"],
  "scene": {
    "effects.mirror": {"type": "boolean", "default": false, "about": "does the floor reflect?"},
    "mesh": {"type": "text", "default": "torus_knot", "about": "what stands on it"},
    "ring.count": {"type": "integer", "range": [0, 10000], "default": 6, "about": "objects"},
    "ring.radius": {"type": "real", "range": [0, 1e7], "default": 1.5, "about": "of the ring"}
  }
})";

/// Scene, as far as it keeps promises.
void lookAt(const gg::Scene& scene, const gg::Declarations& declared) {
  require(scene.size.x >= 1 && scene.size.y >= 1);
  for (int i = 0; i < 3; ++i) require(std::isfinite(scene.background[i]));
  for (const std::string& material : declared.materials()) scene.material(material);
  for (const auto& [key, declaration] : declared.keys()) require(scene.has(key));
  scene.flag("effects.mirror");
  scene.text("mesh");
  const int count = scene.integer("ring.count");
  require(count >= 0 && count <= 10000);
  const double radius = scene.number("ring.radius");
  require(radius >= 0 && radius <= 1e7);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    if (data[0] % 4 == 0) {
      gg::Declarations::fromText(text, "assignment.json");
    } else {
      static const gg::Declarations declared =
          gg::Declarations::fromText(kDeclared, "assignment.json");
      lookAt(gg::Scene::fromText(text, "scene.json", declared), declared);
    }
  } catch (const gg::SceneError& error) {
    const std::string message = error.what();
    require(!message.empty() && message.find('\n') == message.npos);
  }
  return 0;
}
