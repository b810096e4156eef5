#include "intake/find_uploads.hpp"

#include "assignment/usage_error.hpp"
#include "intake/bundle.hpp"
#include "intake/contents.hpp"
#include "intake/files.hpp"
#include "intake/layouts.hpp"
#include "intake/names.hpp"
#include "intake/packed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <set>

#include <sys/stat.h>

namespace ggrade::intake {

namespace fs = std::filesystem;

namespace {

/// One entry of the folder of uploads.
struct Found {
  fs::path path;
  std::string name; ///< valid UTF-8
  Kind kind = Kind::file;
};

using Remarks = std::vector<std::string>;

std::vector<Found> listEntries(const fs::path& folder, Remarks& refused, Remarks& remarks) {
  std::vector<Found> all;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string bytes = entry.path().filename().string();
    const Found found{entry.path(), decodeOrEscape(bytes), kindAt(entry.path())};
    const std::string shown = displayName(found.name);
    if (!clutterIn(bytes).empty())
      remarks.push_back(shown + ": passed over, no student's");
    else if (found.kind == Kind::symbolicLink)
      refused.push_back(shown + ": a symbolic link is not followed");
    else if (found.kind != Kind::file && found.kind != Kind::folder)
      refused.push_back(shown + ": neither a file nor a folder");
    else
      all.push_back(found);
  }
  std::sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.path < b.path; });
  return all;
}

bool isMoodle(const Found& found) {
  return parseMoodle(found.name).has_value();
}
bool isCanvas(const Found& found) {
  return found.kind == Kind::file && parseCanvas(found.name).has_value();
}

/// What most of the names are: a student may choose one that looks like another layout's.
Layout layoutOf(const std::vector<Found>& entries) {
  const auto areMost = [&](const auto& is) {
    return 2 * std::size_t(std::ranges::count_if(entries, is)) > entries.size();
  };
  if (areMost(isMoodle)) return Layout::moodle;
  return areMost(isCanvas) ? Layout::canvas : Layout::plain;
}

Upload startUpload(const std::string& student, const std::string& name, const std::string& folder) {
  Upload upload;
  upload.student = student;
  upload.name = displayName(name);
  upload.folder = folder;
  return upload;
}

std::vector<Upload> plainUploads(const std::vector<Found>& entries, Remarks& remarks) {
  const auto stemOf = [](const Found& found) {
    if (found.kind == Kind::folder) return found.name;
    const std::string_view suffix = archiveSuffix(found.name);
    return suffix.empty() ? fs::path(found.name).stem().string()
                          : found.name.substr(0, found.name.size() - suffix.size());
  };
  std::map<std::string, std::size_t> counts;
  for (const Found& found : entries) ++counts[stemOf(found)];
  std::vector<Upload> uploads;
  for (const Found& found : entries) {
    // ada.zip beside ada: which of them counts is not for us to say.
    const bool unclear = counts[stemOf(found)] > 1;
    const std::string name = unclear ? found.name : stemOf(found);
    if (unclear)
      remarks.push_back(
          fmt::format("{}: graded under its whole name, since {} uploads are called {}",
                      displayName(found.name), counts[stemOf(found)], displayName(stemOf(found))));
    uploads.push_back(startUpload(displayName(stemOf(found)), name, folderName(name)));
    uploads.back().given = name;
    uploads.back().sources = {{found.path, found.name}};
  }
  return uploads;
}

/// Newest time of modification of a file, or of the files in a folder, seconds since 1970.
std::int64_t newest(const fs::path& path) {
  std::int64_t time = 0;
  const auto look = [&](const fs::path& file) {
    struct stat status = {};
    if (lstat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode))
      time = std::max<std::int64_t>(time, status.st_mtim.tv_sec);
  };
  look(path);
  if (kindAt(path) == Kind::folder)
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(path, fs::directory_options::skip_permission_denied))
      look(entry.path());
  return time;
}

std::string isoTime(std::int64_t seconds) {
  const std::time_t time = seconds;
  std::tm parts = {};
  gmtime_r(&time, &parts);
  char text[32] = {};
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

/// What one attempt brought: a folder, or all the files beside each other.
struct Attempt {
  std::vector<Source> sources;
  std::int64_t modified = 0;
};

std::vector<Upload> moodleUploads(const std::vector<Found>& entries, Remarks& refused) {
  struct Student {
    std::string name;
    std::vector<Attempt> folders;
    Attempt files;
  };
  std::map<std::string, Student> students;
  for (const Found& found : entries) {
    const std::optional<MoodleName> name = parseMoodle(found.name);
    Student& student = students[name->identifier];
    student.name = name->name;
    if (name->onlineText) {
      refused.push_back(displayName(found.name) + ": online text, not a file");
      continue;
    }
    const std::int64_t modified = newest(found.path);
    if (found.kind == Kind::folder) {
      student.folders.push_back({{{found.path, found.name}}, modified});
    } else {
      student.files.sources.push_back({found.path, name->file.empty() ? found.name : name->file});
      student.files.modified = std::max(student.files.modified, modified);
    }
  }
  std::vector<Upload> uploads;
  for (auto& [identifier, student] : students) {
    std::vector<Attempt>& attempts = student.folders;
    if (!student.files.sources.empty()) attempts.push_back(student.files);
    const auto last =
        std::max_element(attempts.begin(), attempts.end(),
                         [](const auto& a, const auto& b) { return a.modified < b.modified; });
    Upload upload = startUpload(identifier, student.name, folderName(student.name, identifier));
    if (last != attempts.end()) upload.sources = last->sources; // else nothing but online text
    if (attempts.size() > 1)
      upload.remarks.push_back(fmt::format("{} attempts: the one of {} counts", attempts.size(),
                                           isoTime(last->modified)));
    uploads.push_back(std::move(upload));
  }
  return uploads;
}

/// Of files that are versions of one, as Canvas numbers them, the one with the highest number.
std::vector<Source> latestVersions(const std::vector<Source>& files,
                                   const std::vector<std::string>& wanted, Remarks& remarks) {
  struct Versions {
    std::size_t count = 0;
    unsigned highest = 0;
    Source source;
  };
  std::map<std::string, Versions> byName;
  for (const Source& file : files) {
    Numbered numbered = splitNumber(file.name);
    // blur-1.frag and blur-2.frag may well be two files of the student's own.
    const bool isVersion =
        wantedName(file.name, wanted).empty() &&
        (!archiveSuffix(file.name).empty() || !wantedName(numbered.name, wanted).empty());
    if (!isVersion) numbered = {file.name};
    Versions& versions = byName[numbered.name];
    if (++versions.count > 1 && numbered.number < versions.highest) continue;
    versions.highest = numbered.number;
    versions.source = {file.path, numbered.name};
  }
  std::vector<Source> latest;
  for (const auto& [name, versions] : byName) {
    latest.push_back(versions.source);
    if (versions.count > 1)
      remarks.push_back(fmt::format("{} versions of {}: number {} counts", versions.count,
                                    displayName(name), versions.highest));
  }
  return latest;
}

std::vector<Upload> canvasUploads(const std::vector<Found>& entries,
                                  const std::vector<std::string>& wanted) {
  struct Student {
    std::string name;
    bool late = false;
    std::vector<Source> files;
  };
  std::map<std::string, Student> students;
  for (const Found& found : entries) {
    const std::optional<CanvasName> name = parseCanvas(found.name);
    Student& student = students[name->user];
    student.name = name->name;
    student.late |= name->late;
    student.files.push_back({found.path, name->file});
  }
  std::vector<Upload> uploads;
  for (const auto& [user, student] : students) {
    uploads.push_back(startUpload(user, student.name, folderName(student.name, user)));
    if (student.late) uploads.back().remarks.push_back("Canvas marks it as late");
    uploads.back().sources = latestVersions(student.files, wanted, uploads.back().remarks);
  }
  return uploads;
}

/// Numbers folders that would be one where case is ignored, then sorts by folder.
void makeUnique(std::vector<Upload>& uploads) {
  std::set<std::string> taken;
  for (Upload& upload : uploads) {
    const std::string base = upload.folder;
    for (unsigned number = 2; !taken.insert(caseFolded(upload.folder)).second; ++number) {
      const std::string end = fmt::format("-{}", number);
      upload.folder = std::string(cut(base, kLongestFolderName - end.size())) + end;
    }
  }
  std::sort(uploads.begin(), uploads.end(),
            [](const Upload& a, const Upload& b) { return a.folder < b.folder; });
}

} // namespace

Intake findUploads(const fs::path& source, const std::vector<std::string>& wanted,
                   const fs::path& work, sandbox::Isolation isolation,
                   const std::atomic<bool>* cancel) {
  Intake intake;
  fs::path folder = source;
  if (!fs::exists(source))
    throw UsageError(
        fmt::format("there is no {}: name the folder or archive of uploads", source.string()));
  if (!fs::is_directory(source)) {
    folder = work / "class";
    unpackClass(source, folder, isolation, cancel, intake.refused, intake.remarks);
  }
  std::vector<Found> entries = listEntries(folder, intake.refused, intake.remarks);
  intake.layout = layoutOf(entries);
  // Names of the layout first. Whoever has another name is graded all the same, and has a row.
  const bool moodle = intake.layout == Layout::moodle, canvas = intake.layout == Layout::canvas;
  const auto others = std::stable_partition(entries.begin(), entries.end(), [&](const Found& one) {
    return (moodle && isMoodle(one)) || (canvas && isCanvas(one));
  });
  const std::vector<Found> named(entries.begin(), others), plain(others, entries.end());
  if (moodle) intake.uploads = moodleUploads(named, intake.refused);
  if (canvas) intake.uploads = canvasUploads(named, wanted);
  if (moodle || canvas)
    for (const Found& one : plain)
      intake.remarks.push_back(fmt::format("{}: not a name of {}, graded under its own",
                                           displayName(one.name), moodle ? "Moodle's" : "Canvas'"));
  for (Upload& upload : plainUploads(plain, intake.remarks))
    intake.uploads.push_back(std::move(upload));
  if (intake.uploads.empty())
    throw UsageError(fmt::format("{} holds no upload: name the folder with a folder, an archive or "
                                 "a file for each student",
                                 source.string()));
  makeUnique(intake.uploads);
  std::sort(intake.refused.begin(), intake.refused.end());
  std::sort(intake.remarks.begin(), intake.remarks.end());
  return intake;
}

} // namespace ggrade::intake
