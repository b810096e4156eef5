#include "repair/own_value.hpp"

#include "results/results.hpp"
#include "trace/trace.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

namespace ggrade::repair {

using nlohmann::json;

namespace {

constexpr std::size_t kMostNumbers = 4; ///< a matrix tells nobody anything

/// What a tape calls what is switched on and off, and OpenGL.
const std::map<std::string, const char*> kSwitches = {
    {"cull", "GL_CULL_FACE"},
    {"depthTest", "GL_DEPTH_TEST"},
    {"depthClamp", "GL_DEPTH_CLAMP"},
    {"stencilTest", "GL_STENCIL_TEST"},
    {"scissorTest", "GL_SCISSOR_TEST"},
    {"polygonOffsetFill", "GL_POLYGON_OFFSET_FILL"},
    {"framebufferSrgb", "GL_FRAMEBUFFER_SRGB"},
    {"clipDistance0", "GL_CLIP_DISTANCE0"}};

/// What is set to a constant.
const std::set<std::string> kConstants = {"cullFace",  "frontFace", "depthFunc",
                                          "minFilter", "magFilter", "wrapS",
                                          "wrapT",     "wrapR",     "compareMode"};

std::string numbers(const json& values) {
  if (!values.is_array() || values.size() > kMostNumbers) return {};
  std::string text;
  for (const json& one : values) {
    if (!one.is_number()) return {};
    text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", one.get<double>());
  }
  return text;
}

std::string constant(const json& value) {
  const std::string name = trace::glName(value.get<std::uint32_t>());
  return name.starts_with("0x") ? std::string() : "GL_" + name;
}

/// Of a texture its first level.
std::string storage(const json& image) {
  const bool isTexture = image.contains("levels");
  if (isTexture && image["levels"].empty()) return {};
  const json& one = isTexture ? image["levels"][0] : image;
  return fmt::format("{}x{}, {}", one.at("width").get<int>(), one.at("height").get<int>(),
                     constant(one.at("format")));
}

} // namespace

std::string ownValue(const std::string& unit, const std::string& key, const json& value) {
  if (unit == "viewport" || key == "scissor") return numbers(value);
  if (unit.starts_with("uniform ")) return numbers(value.at("values"));
  if (unit == "storage") return storage(value);
  if (kConstants.contains(key)) return constant(value);
  if (key == "depthMask")
    return fmt::format("glDepthMask({})", value.get<bool>() ? "GL_TRUE" : "GL_FALSE");
  if (const auto name = kSwitches.find(key); name != kSwitches.end())
    return fmt::format("{}({})", value.get<bool>() ? "glEnable" : "glDisable", name->second);
  return {};
}

std::string ownTexture(const json& textures, const json& target) {
  if (textures.empty()) return {};
  const json& one = textures[0];
  if (!one.contains("image")) return results::kNoTexture;
  if (target.contains("window")) return {};
  for (const auto& [point, attached] : target.at("attachments").items())
    if (attached.at("image") == one["image"]) return results::kDrawnInto;
  return {};
}

} // namespace ggrade::repair
