#pragma once
/// \file
/// What the names in a folder of uploads mean.

#include <optional>
#include <string>
#include <string_view>

namespace ggrade::intake {

/// `Full Name_IDENTIFIER_assignsubmission_file_`, with the file's name behind it where the download
/// is not in folders. Moodle 4's mod/assign/locallib.php makes these names.
struct MoodleName {
  std::string name;
  std::string identifier; ///< digits; "Participant IDENTIFIER" in the grading worksheet
  std::string file;       ///< empty for a folder
  bool onlineText = false;
};

/// \param entry valid UTF-8; nothing where it is no such name
std::optional<MoodleName> parseMoodle(std::string_view entry);

/// `lastfirst_[LATE_]USER_ATTACHMENT_file.ext`: the numbers are Canvas' IDs of the student and of
/// the file.
struct CanvasName {
  std::string name;
  std::string user;
  std::string file;
  bool late = false;
};

/// \param entry valid UTF-8; nothing where it is no such name
std::optional<CanvasName> parseCanvas(std::string_view entry);

/// `floor-2.cpp` (Canvas), `floor (2).cpp` and `floor(2).cpp` (browsers): the name before the
/// number was added, and the number; the name itself and 0 for others.
struct Numbered {
  std::string name;
  unsigned number = 0;
};
Numbered splitNumber(std::string_view file);

/// The lower-case end of a name that says it is an archive which is unpacked (".tar.gz"), or empty.
std::string_view archiveSuffix(std::string_view file);

/// Is it packed in a way that is not unpacked (7z, rar, lzh, gz of a single file)?
bool isOtherArchive(std::string_view file);

} // namespace ggrade::intake
