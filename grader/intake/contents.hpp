#pragma once
/// \file
/// The files of an upload, whatever it came in, what was refused, and which folder holds the
/// assignment's files.

#include "intake/bundle.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace ggrade::intake {

/// A path inside an upload: relative, `/` between components, NFC; or why there is none.
struct SafePath {
  std::string path;
  std::string refused; ///< half a sentence; empty if `path` is safe to write to
  std::string shown;   ///< for messages, printable
};

/// \param bytes a name as an archive or a file system has it
SafePath safePath(std::string_view bytes);

struct File {
  std::string path; ///< safe
  std::string bytes;
  std::int64_t modified = 0; ///< seconds since 1970
};

/// Are names that differ only in case one? So they are where most students and instructors work.
enum class Case { ignored, kept };

class Contents {
public:
  explicit Contents(const Limits& limits, Case names = Case::ignored)
      : limits_(limits), case_(names) {}

  /// Takes a file, refuses something else by name, counts clutter. Of equal names the first
  /// counts. Throws UploadProblem beyond the limits.
  void add(const Entry& entry);
  void refuse(std::string_view shownName, std::string_view reason);

  const std::vector<File>& files() const { return files_; }
  std::vector<File> takeFiles() { return std::move(files_); }
  const std::vector<std::string>& refused() const { return refused_; } ///< "name: reason"
  /// "3 entries were passed over: .DS_Store, __MACOSX"; empty if there are none.
  std::string clutterRemark() const;

private:
  /// Why no file may stand at `path`, or "".
  std::string conflict(const std::string& path);

  Limits limits_;
  Case case_;
  std::vector<File> files_;
  std::vector<std::string> refused_;
  std::map<std::string, std::size_t> clutter_;
  std::map<std::string, std::string> taken_; ///< path by `case_`'s key, of files
  std::set<std::string> folders_;            ///< of files, as keys
  std::size_t entries_ = 0;
  std::size_t clutterCount_ = 0;
  std::uint64_t bytes_ = 0;
};

/// The name in `wanted` that `name` equals, case ignored; empty if there is none.
std::string wantedName(std::string_view name, const std::vector<std::string>& wanted);

struct TopFolder {
  std::vector<File> files;          ///< below the top, with paths from there
  std::vector<std::string> outside; ///< printable names of the rest
  std::string reason;               ///< why the rest doesn't count
  std::vector<std::string> remarks; ///< files that got the wanted name's case
};

/// The shallowest folder that holds one of `wanted` (case ignored) becomes the top; of several, the
/// one with more of them. Throws UploadProblem if none does, or if two do equally.
TopFolder takeTopFolder(std::vector<File> files, const std::vector<std::string>& wanted);

} // namespace ggrade::intake
