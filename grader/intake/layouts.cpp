#include "intake/layouts.hpp"

#include <algorithm>

namespace ggrade::intake {
namespace {

constexpr std::string_view kDigits = "0123456789";

/// Takes digits and the `_` behind them off the front of `rest`; empty where there are none.
std::string_view takeNumber(std::string_view& rest) {
  const std::size_t end = rest.find_first_not_of(kDigits);
  if (end == 0 || end == rest.npos || rest[end] != '_') return {};
  const std::string_view number = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return number;
}

bool endsWith(std::string_view file, std::string_view suffix) {
  return file.size() > suffix.size() &&
         std::equal(suffix.begin(), suffix.end(), file.end() - std::ptrdiff_t(suffix.size()),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b + 32 : b); });
}

} // namespace

std::optional<MoodleName> parseMoodle(std::string_view entry) {
  constexpr std::string_view kMark = "_assignsubmission_";
  // The first mark: a file's name, which the student chose, may hold another one.
  const std::size_t mark = entry.find(kMark);
  if (mark == entry.npos) return std::nullopt;
  const std::string_view person = entry.substr(0, mark);
  const std::size_t bar = person.rfind('_');
  if (bar == person.npos || bar + 1 == person.size()) return std::nullopt;
  const std::string_view identifier = person.substr(bar + 1);
  if (identifier.find_first_not_of(kDigits) != identifier.npos) return std::nullopt;

  MoodleName result{std::string(person.substr(0, bar)), std::string(identifier), ""};
  std::string_view rest = entry.substr(mark + kMark.size());
  result.onlineText = rest.starts_with("onlinetext");
  const std::string_view kind = result.onlineText ? "onlinetext" : "file";
  if (!rest.starts_with(kind)) return std::nullopt;
  rest.remove_prefix(kind.size());
  if (!rest.empty() && rest.front() != '_') return std::nullopt;
  if (!rest.empty()) result.file = rest.substr(1);
  return result;
}

std::optional<CanvasName> parseCanvas(std::string_view entry) {
  // The first place where the numbers fit: Canvas keeps _123_ out of people's names.
  for (std::size_t bar = entry.find('_', 1); bar != entry.npos; bar = entry.find('_', bar + 1)) {
    constexpr std::string_view kLate = "LATE_";
    std::string_view rest = entry.substr(bar + 1);
    const bool late = rest.starts_with(kLate);
    if (late) rest.remove_prefix(kLate.size());
    const std::string_view user = takeNumber(rest);
    if (user.empty() || takeNumber(rest).empty() || rest.empty()) continue;
    return CanvasName{std::string(entry.substr(0, bar)), std::string(user), std::string(rest),
                      late};
  }
  return std::nullopt;
}

Numbered splitNumber(std::string_view file) {
  const std::string_view suffix = archiveSuffix(file);
  const std::size_t dot = suffix.empty() ? file.rfind('.') : file.size() - suffix.size();
  const std::string_view end = dot == file.npos ? "" : file.substr(dot);
  std::string_view stem = file.substr(0, file.size() - end.size());
  const bool brackets = stem.ends_with(')');
  if (brackets) stem.remove_suffix(1);
  const std::size_t last = stem.find_last_not_of(kDigits);
  const std::string_view digits = last == stem.npos ? "" : stem.substr(last + 1);
  if (digits.empty() || digits.size() > 4 || stem[last] != (brackets ? '(' : '-'))
    return {std::string(file)};
  stem = stem.substr(0, last);
  if (brackets && stem.ends_with(' ')) stem.remove_suffix(1);
  if (stem.empty()) return {std::string(file)};
  return {std::string(stem) + std::string(end),
          static_cast<unsigned>(std::stoul(std::string(digits)))};
}

std::string_view archiveSuffix(std::string_view file) {
  for (const std::string_view suffix : {".zip", ".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tbz2",
                                        ".tar.xz", ".txz", ".tar.zst", ".tzst"})
    if (endsWith(file, suffix)) return suffix;
  return {};
}

bool isOtherArchive(std::string_view file) {
  if (!archiveSuffix(file).empty()) return false;
  for (const std::string_view suffix :
       {".7z", ".rar", ".lzh", ".lha", ".gz", ".bz2", ".xz", ".zst", ".cab", ".iso"})
    if (endsWith(file, suffix)) return true;
  return false;
}

} // namespace ggrade::intake
