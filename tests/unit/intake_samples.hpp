#pragma once
/// \file
/// What tests of uploads share.

#include "framework_temporary_folder.hpp"
#include "intake/find_uploads.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace ggrade::intake {

inline std::string textOf(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Paths of all files below `folder`, in order.
inline std::vector<std::string> filesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (!entry.is_directory()) names.push_back(entry.path().lexically_relative(folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

/// An upload that is this file or folder.
inline Upload uploadOf(const std::filesystem::path& path) {
  Upload upload;
  upload.sources = {{path, path.filename().string()}};
  return upload;
}

inline const std::vector<std::string> kWanted = {"floor.cpp", "mirror.vert", "tile.vert"};

} // namespace ggrade::intake
