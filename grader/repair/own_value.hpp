#pragma once
/// \file
/// What a submission has itself where it differs: a number or a constant that its author wrote, in
/// OpenGL's own words.

#include <nlohmann/json.hpp>

#include <string>

namespace ggrade::repair {

/// "0, 0, 640, 480", "GL_REPEAT", "640x480, GL_RGBA8", "glDisable(GL_CULL_FACE)". Empty: not to be
/// said in a few words.
/// \param unit see Unit::name
/// \param key what the tape calls the value: the last word of its path
/// Throws nlohmann::json::exception for a value that isn't made as a tape's.
std::string ownValue(const std::string& unit, const std::string& key, const nlohmann::json& value);

/// What a sampler reads where it is no image that another pass made: results::kNoTexture or
/// kDrawnInto; else empty.
/// \param textures of the sampler, as a draw of a tape has them
/// \param target of that draw
/// Throws nlohmann::json::exception for what isn't made as a tape's.
std::string ownTexture(const nlohmann::json& textures, const nlohmann::json& target);

} // namespace ggrade::repair
