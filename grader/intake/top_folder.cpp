#include "intake/top_folder.hpp"

#include "intake/names.hpp"
#include "intake/packed.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ggrade::intake {
namespace {

using Names = std::vector<std::string>;

/// "homework/part1/" of "homework/part1/floor.cpp", "" of "floor.cpp".
std::string folderOf(const std::string& path) {
  return path.substr(0, path.rfind('/') + 1);
}

/// Which wanted file a path is, in whatever folder.
std::string wantedAt(const std::string& path, const Names& wanted) {
  return wantedName(std::string_view(path).substr(path.rfind('/') + 1), wanted);
}

std::string topOf(const std::vector<File>& files, const Names& wanted) {
  struct Candidate {
    std::string folder;
    std::ptrdiff_t depth = 0;
    std::size_t count = 0;
  };
  std::map<std::string, std::size_t> counts;
  for (const File& file : files)
    if (!wantedAt(file.path, wanted).empty()) ++counts[folderOf(file.path)];
  if (counts.empty())
    throw UploadProblem(
        gg::say("the upload holds none of {}", fmt::format("{}", fmt::join(wanted, ", "))));
  std::vector<Candidate> candidates;
  for (const auto& [folder, count] : counts)
    candidates.push_back({folder, std::count(folder.begin(), folder.end(), '/'), count});
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.count > b.count;
  });
  if (candidates.size() > 1 && candidates[0].depth == candidates[1].depth &&
      candidates[0].count == candidates[1].count)
    throw UploadProblem(gg::say("{} and {} both hold the assignment's files: which one counts?",
                                displayName(candidates[0].folder),
                                displayName(candidates[1].folder)));
  return candidates[0].folder;
}

} // namespace

std::string wantedName(std::string_view name, const Names& wanted) {
  const std::string folded = caseFolded(name);
  const auto found = std::find_if(wanted.begin(), wanted.end(), [&](const std::string& candidate) {
    return caseFolded(candidate) == folded;
  });
  return found == wanted.end() ? "" : *found;
}

TopFolder takeTopFolder(std::vector<File> files, const Names& wanted) {
  const std::string top = topOf(files, wanted);
  TopFolder result;
  result.reason = gg::say("is outside {}, where the assignment's files are", displayName(top));
  for (File& file : files) {
    if (!file.path.starts_with(top)) {
      result.outside.push_back(displayName(file.path));
      continue;
    }
    file.path.erase(0, top.size());
    const std::string name = wantedName(file.path, wanted);
    if (!name.empty() && name != file.path) {
      result.remarks.push_back(gg::say("{} counts as {}", displayName(file.path), name));
      file.path = name;
    }
    result.files.push_back(std::move(file));
  }
  return result;
}

} // namespace ggrade::intake
