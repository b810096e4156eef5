#pragma once
/// \file
/// Gradings that are kept, so that a measurement that was broken off goes on where it was.

#include "calibration/programs.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>

namespace ggrade::calibration {

nlohmann::json toJson(const Score& score);
/// Throws nlohmann::json::exception for anything that toJson didn't write.
Score scoreFrom(const nlohmann::json& json);

/// One grading's file; nothing if it isn't there or isn't whole.
std::optional<Score> loadScore(const std::filesystem::path& file);
/// Appears whole or not at all. Throws UsageError when the disk is full.
void saveScore(const std::filesystem::path& file, const Score& score);

} // namespace ggrade::calibration
