#pragma once
/// \file
/// Folders as zip archives.

#include <filesystem>
#include <string>

namespace ggrade::authoring {

/// Packs all files under `folder`, sorted, with their permissions and no times or owners: the same
/// files make the same archive. `top`: the folder that they unpack into; empty: none. Written whole
/// or not at all. Throws std::runtime_error with the path and the cause.
void writeZip(const std::filesystem::path& folder, const std::string& top,
              const std::filesystem::path& file);

} // namespace ggrade::authoring
