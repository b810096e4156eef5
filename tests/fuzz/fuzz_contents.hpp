#pragma once
/// \file
/// What the trusted process does with a bundle, and what must hold whatever stands in it.

#include "require.hpp"

#include "intake/contents.hpp"
#include "intake/names.hpp"
#include "intake/packed.hpp"

#include <cstdlib>

namespace ggrade::intake {

inline constexpr Limits kFuzzLimits = {
    .entries = 50, .clutter = 50, .bytes = 1 << 20, .fileBytes = 1 << 18, .expandedBytes = 1 << 22};

/// Takes the entries as an upload's, and ends the program where a path is unsafe.
inline void takeAsUpload(const std::vector<Entry>& entries) {
  Contents contents(kFuzzLimits);
  std::vector<TopFolder> top;
  try {
    for (const Entry& entry : entries) contents.add(entry);
    for (const std::string& line : contents.refused()) require(isUtf8(line) && !hasControl(line));
    top.push_back(takeTopFolder(contents.takeFiles(), {"floor.cpp", "mirror.vert"}));
  } catch (const UploadProblem&) {
    return;
  }
  std::set<std::string> paths;
  for (const File& file : top[0].files) {
    const std::string path = '/' + file.path + '/';
    require(!file.path.empty() && isUtf8(file.path) && !hasControl(file.path));
    for (const char* bad : {"//", "/./", "/../", "\\"}) require(path.find(bad) == path.npos);
    require(paths.insert(file.path).second);
    const std::string folder = folderName(displayName(file.path));
    require(!folder.empty() && folder.size() <= kLongestFolderName);
    require(folder.find_first_of("/.\\") == folder.npos && folder[0] != '-');
  }
}

} // namespace ggrade::intake
