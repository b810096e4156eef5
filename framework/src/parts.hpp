#pragma once
/// \file
/// The parts of an assignment, each with scene settings of its own.

#include <filesystem>
#include <string>

namespace gg::detail {

/// The text of `folder`/scene.json with the scene settings of a part merged over it (RFC 7396), or
/// those of all parts, in order, if `part` is empty. Reads `folder`/assignment.json. Throws
/// SceneError for files that can't be read, std::invalid_argument for a part that there isn't.
std::string sceneOfPart(const std::filesystem::path& folder, const std::string& part);

} // namespace gg::detail
