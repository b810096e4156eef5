#pragma once
/// \file
/// From what an instructor downloaded to a list of uploads.

#include "sandbox/sandbox.hpp"

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace ggrade::intake {

enum class Layout {
  plain,  ///< every entry is a student: a folder, an archive or a single file
  moodle, ///< assignment > "Download all submissions", in folders or not
  canvas  ///< assignment > "Download submissions"
};

/// A file or folder of an upload, and the name that the student gave it.
struct Source {
  std::filesystem::path path;
  std::string name; ///< valid UTF-8, NFC
};

/// What one student handed in last.
struct Upload {
  std::string student; ///< in gradebooks: Moodle's identifier, Canvas' user ID, else the name
  std::string name;    ///< to show, see displayName
  std::string folder;  ///< for results, see folderName; unique, also when case is ignored
  std::vector<Source> sources;
  std::vector<std::string> remarks; ///< "2 attempts: ... counts"
  std::string given; ///< where `student` is made of the name: that, with all of its characters
};

struct Intake {
  Layout layout = Layout::plain;
  std::vector<Upload> uploads;      ///< by `folder`
  std::vector<std::string> refused; ///< "name: why it is no upload"
  std::vector<std::string> remarks; ///< what else is to be said of a name
};

/// Finds the uploads in `source`, a folder, or the archive of a whole class, which is unpacked to
/// `work`/class first. Links, devices and FIFOs are never followed or opened.
///
/// - Plain: the student is the entry's name without the archive's suffix. Nothing is guessed from
///   numbers in names; `ada` and `ada.zip` are two uploads of one student, for a person to choose.
/// - Moodle: where a student is there more than once, the latest time of modification counts.
/// - Canvas: `floor-1.cpp` and `floor-2.cpp` are later versions of `floor.cpp`, if that is one of
///   `wanted` or an archive; the highest number counts.
///
/// \param wanted names of the files that students edit
/// \param work exists, and no `class` in it
/// \param cancel as in sandbox::run; look at it when the call is over
/// Throws UsageError with the remedy when there is nothing to grade, and std::runtime_error where
/// the sandbox doesn't start.
Intake findUploads(const std::filesystem::path& source, const std::vector<std::string>& wanted,
                   const std::filesystem::path& work, sandbox::Isolation isolation,
                   const std::atomic<bool>* cancel = nullptr);

} // namespace ggrade::intake
