#include "intake/unpack.hpp"

#include "assignment/usage_error.hpp"
#include "intake/bundle.hpp"
#include "intake/contents.hpp"
#include "intake/files.hpp"
#include "intake/layouts.hpp"
#include "intake/names.hpp"
#include "intake/packed.hpp"
#include "words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace ggrade::intake {

namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

/// Reads the sources of one upload, one after the other.
class Collector {
public:
  Collector(const fs::path& folder, sandbox::Isolation isolation, const std::atomic<bool>* cancel)
      : folder_(folder), isolation_(isolation), cancel_(cancel) {}

  void add(const Source& source) {
    const Kind kind = kindAt(source.path);
    if (kind == Kind::folder)
      addFolder(source.path, "", 1);
    else
      addEntry(source.path, source.name, kind, true);
  }

  Contents contents{kUploadLimits};

private:
  void addFolder(const fs::path& folder, const std::string& prefix, std::size_t depth) {
    std::vector<fs::path> paths;
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
      paths.push_back(entry->path());
      if (paths.size() > kUploadLimits.clutter)
        throw UploadProblem(gg::say("holds more than {} files and folders", kUploadLimits.clutter));
    }
    if (error == std::errc::permission_denied)
      contents.refuse(safePath(prefix + '.').shown, gg::say("can't be read: {}", error.message()));
    else if (error)
      throw std::system_error(error, gg::say("can't read {}", folder.string()));
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) {
      const std::string name = prefix + path.filename().string();
      const Kind kind = kindAt(path);
      if (kind == Kind::folder && clutterIn(name).empty()) {
        contents.add({.name = name, .kind = kind});
        if (depth < kDeepest)
          addFolder(path, name + '/', depth + 1);
        else
          contents.refuse(safePath(name).shown, gg::say("more than {} folders deep", kDeepest));
      } else {
        addEntry(path, name, kind, depth == 1);
      }
    }
  }

  /// \param opens whether an archive is taken apart here
  void addEntry(const fs::path& path, const std::string& name, Kind kind, bool opens) {
    if (const std::string_view clutter = clutterIn(name); !clutter.empty())
      return contents.add({.name = clutter, .kind = Kind::clutter});
    const std::string shown = safePath(name).shown;
    if (kind == Kind::file && isOtherArchive(name))
      return contents.refuse(shown,
                             gg::say("only zip and tar files (gz, bz2, xz, zst) are unpacked"));
    if (kind == Kind::file && !archiveSuffix(name).empty()) {
      if (!opens) return contents.refuse(shown, gg::say("an archive in a folder is not unpacked"));
      return addArchive(path, shown);
    }
    Entry entry{.name = name, .kind = kind};
    std::string bytes;
    if (kind == Kind::file) {
      entry.size = fs::file_size(path);
      if (entry.size > kUploadLimits.fileBytes) {
        entry.kind = Kind::tooLarge;
      } else {
        try {
          bytes = readRegular(path, kUploadLimits.fileBytes).bytes;
        } catch (const std::system_error& error) {
          if (error.code() != std::errc::permission_denied) throw;
          return contents.refuse(shown, gg::say("can't be read: {}", error.code().message()));
        } catch (const std::runtime_error& error) {
          return contents.refuse(shown, error.what());
        }
      }
    }
    entry.bytes = bytes;
    contents.add(entry);
  }

  void addArchive(const fs::path& path, const std::string& shown) {
    try {
      if (++archives_ > kMostArchives)
        throw UploadProblem(
            gg::say("is one archive too many: an upload may have {}", kMostArchives));
      const std::string bundle = bundleOf(path, folder_, kUploadLimits, isolation_, cancel_);
      for (const Entry& entry : entriesOf(bundle, kUploadLimits)) addPacked(entry);
    } catch (const UploadProblem& problem) {
      throw UploadProblem(shown + " " + problem.what());
    }
  }

  void addPacked(const Entry& entry) {
    const bool packed = !archiveSuffix(entry.name).empty() || isOtherArchive(entry.name);
    if (entry.kind == Kind::file && packed)
      return contents.refuse(safePath(entry.name).shown,
                             gg::say("an archive in an archive is not unpacked"));
    contents.add(entry);
  }

  const fs::path& folder_;
  sandbox::Isolation isolation_;
  const std::atomic<bool>* cancel_;
  std::size_t archives_ = 0;
};

/// The wanted file that the only file of an upload counts as; empty if that isn't clear.
std::string onlyChoice(const std::string& path, const Names& wanted) {
  const std::string extension = fs::path(path).extension().string();
  const auto fits = [&](const std::string& name) {
    return fs::path(name).extension().string() == extension;
  };
  if (extension.empty() || std::count_if(wanted.begin(), wanted.end(), fits) != 1) return {};
  return *std::find_if(wanted.begin(), wanted.end(), fits);
}

/// Gives files that stand alone the wanted file's name where only a number tells them apart, or
/// where the only file of the upload can be nothing else.
void renameLoose(std::vector<File>& files, const Names& wanted, Names& remarks) {
  const auto isThere = [&](const std::string& name) {
    return std::any_of(files.begin(), files.end(),
                       [&](const File& file) { return caseFolded(file.path) == caseFolded(name); });
  };
  for (File& file : files) {
    if (!wantedName(file.path, wanted).empty()) continue;
    std::string name = wantedName(splitNumber(file.path).name, wanted);
    if (name.empty() && files.size() == 1) name = onlyChoice(file.path, wanted);
    if (name.empty() || isThere(name)) continue;
    remarks.push_back(gg::say("{} counts as {}", displayName(file.path), name));
    file.path = name;
  }
}

void toUtf8(File& file, const Names& wanted, Names& remarks) {
  constexpr std::string_view kSources[] = {".cpp",  ".hpp",  ".h",    ".vert",
                                           ".frag", ".geom", ".glsl", ".txt"};
  const std::string extension = fs::path(file.path).extension().string();
  const bool isSource = std::count(wanted.begin(), wanted.end(), file.path) > 0 ||
                        std::count(std::begin(kSources), std::end(kSources), extension) > 0;
  if (!isSource || isUtf8(file.bytes)) return;
  if (std::optional<std::string> text = fromCp932(file.bytes)) {
    file.bytes = std::move(*text);
    remarks.push_back(gg::say("{} was Shift_JIS (CP932)", displayName(file.path)));
  } else {
    remarks.push_back(gg::say("{} is neither UTF-8 nor Shift_JIS (CP932): save it as UTF-8",
                              displayName(file.path)));
  }
}

void requireFresh(const fs::path& into) {
  std::error_code error;
  fs::create_directories(into, error);
  if (error)
    throw UsageError(fmt::format("can't make the folder {}: {}", into.string(), error.message()));
  if (!fs::is_empty(into))
    throw UsageError(fmt::format("{} is not empty: name a new folder", into.string()));
}

void write(const std::vector<File>& files, const fs::path& into) {
  for (const File& file : files) {
    const fs::path path = into / file.path;
    fs::create_directories(path.parent_path());
    writeNew(path, file.bytes);
  }
}

} // namespace

Unpacked unpack(const Upload& upload, const Names& wanted, const fs::path& into,
                sandbox::Isolation isolation, const std::atomic<bool>* cancel) {
  requireFresh(into);
  Unpacked result;
  Collector collector(into, isolation, cancel);
  try {
    for (const Source& source : upload.sources) collector.add(source);
    std::vector<File> files = collector.contents.takeFiles();
    if (std::none_of(files.begin(), files.end(),
                     [](const File& file) { return file.path.find('/') != std::string::npos; }))
      renameLoose(files, wanted, result.remarks);
    TopFolder top = takeTopFolder(std::move(files), wanted);
    for (const std::string& remark : top.remarks) result.remarks.push_back(remark);
    for (const std::string& outside : top.outside) collector.contents.refuse(outside, top.reason);
    for (File& file : top.files) toUtf8(file, wanted, result.remarks);
    write(top.files, into);
  } catch (const UploadProblem& problem) {
    result.problem = problem.what();
  }
  result.refused = collector.contents.refused();
  if (const std::string clutter = collector.contents.clutterRemark(); !clutter.empty())
    result.remarks.push_back(clutter);
  return result;
}

} // namespace ggrade::intake
