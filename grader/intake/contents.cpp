#include "intake/contents.hpp"

#include "intake/names.hpp"
#include "intake/packed.hpp"
#include "report/text.hpp"
#include "words/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ggrade::intake {

using gg::say;

namespace {

constexpr std::size_t kLongestShown = 160; ///< code points of a name in a message

bool isDrive(std::string_view path) {
  return path.size() >= 2 && path[1] == ':' &&
         ((path[0] >= 'a' && path[0] <= 'z') || (path[0] >= 'A' && path[0] <= 'Z'));
}

std::string reasonFor(const Entry& entry, const Limits& limits) {
  switch (entry.kind) {
  case Kind::tooLarge:
    return say("{} bytes or more, a file may have {} MiB", entry.size, limits.fileBytes >> 20);
  case Kind::encrypted:
    return say("is encrypted: ask for an upload without a password");
  case Kind::damaged:
    return say("is damaged, or compressed in a way that is not read");
  case Kind::symbolicLink:
    return say("is a symbolic link");
  case Kind::hardLink:
    return say("is a hard link");
  case Kind::device:
    return say("is a device");
  case Kind::fifo:
    return say("is a FIFO");
  case Kind::socket:
    return say("is a socket");
  default:
    return {};
  }
}

} // namespace

SafePath safePath(std::string_view bytes) {
  const std::optional<std::string> name = decodeName(bytes);
  SafePath result;
  result.shown = report::sanitizeLine(name ? *name : decodeOrEscape(bytes), kLongestShown);
  const auto refuse = [&](std::string reason) {
    result.refused = std::move(reason);
    return result;
  };
  if (bytes.empty()) {
    result.shown = say("(no name)");
    return refuse(say("has no name"));
  }
  if (!name) return refuse(say("its name is neither UTF-8 nor Shift_JIS (CP932)"));
  if (hasControl(*name)) return refuse(say("its name holds a control character"));
  // Decoded first: the second byte of a character may be a backslash in CP932.
  std::string path = *name;
  std::replace(path.begin(), path.end(), '\\', '/');
  if (path.front() == '/') return refuse(say("is an absolute path"));
  if (isDrive(path)) return refuse(say("names a drive"));
  std::size_t depth = 0;
  for (std::size_t start = 0, end = 0; end != path.npos; start = end + 1) {
    end = path.find('/', start);
    const std::string component = path.substr(start, end == path.npos ? end : end - start);
    if (component.empty() || component == ".") continue;
    if (component == "..") return refuse(say("leads out of its folder"));
    if (component.size() > kLongestComponent)
      return refuse(say("a name of {} bytes, {} are allowed", component.size(), kLongestComponent));
    if (++depth > kDeepest) return refuse(say("more than {} folders deep", kDeepest));
    result.path += (result.path.empty() ? "" : "/") + component;
  }
  if (result.path.empty()) return refuse(say("has no name"));
  return result;
}

void Contents::add(const Entry& entry) {
  if (entry.kind == Kind::clutter) {
    if (++clutterCount_ > limits_.clutter)
      throw UploadProblem(say("holds more than {} files and folders", limits_.clutter));
    ++clutter_[std::string(entry.name)];
    return;
  }
  if (++entries_ > limits_.entries)
    throw UploadProblem(say("holds more than {} files and folders", limits_.entries));
  if (entry.kind == Kind::folder) return; // made for the files in it
  const SafePath name = safePath(entry.name);
  std::string reason = reasonFor(entry, limits_);
  if (reason.empty()) reason = name.refused.empty() ? conflict(name.path) : name.refused;
  if (!reason.empty()) return refuse(name.shown, reason);

  bytes_ += entry.bytes.size();
  if (bytes_ > limits_.bytes)
    throw UploadProblem(say("holds more than {} MiB of files", limits_.bytes >> 20));
  files_.push_back({name.path, std::string(entry.bytes), entry.modified});
}

void Contents::refuse(std::string_view shownName, std::string_view reason) {
  refused_.push_back(fmt::format("{}: {}", shownName, reason));
}

std::string Contents::conflict(const std::string& path) {
  const std::string folded = case_ == Case::ignored ? caseFolded(path) : path;
  const auto [before, isNew] = taken_.try_emplace(folded, path);
  if (!isNew && before->second == path) return say("is there twice: the first counts");
  if (!isNew) return say("differs from {} in case only: the first counts", before->second);
  if (folders_.count(folded)) {
    taken_.erase(before);
    return say("is a folder, too: that counts");
  }
  std::vector<std::string> above;
  for (std::size_t end = folded.find('/'); end != folded.npos; end = folded.find('/', end + 1)) {
    above.push_back(folded.substr(0, end));
    if (!taken_.count(above.back())) continue;
    taken_.erase(before);
    return say("{} is a file, too: that counts", path.substr(0, path.rfind('/')));
  }
  folders_.insert(above.begin(), above.end());
  return {};
}

std::string Contents::clutterRemark() const {
  if (clutter_.empty()) return {};
  std::vector<std::string> names;
  for (const auto& [name, count] : clutter_) names.push_back(name);
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  return clutterCount_ == 1 ? say("passed over 1 entry: {}", all)
                            : say("passed over {} entries: {}", clutterCount_, all);
}

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
